// SPDX-License-Identifier: MIT
#include "microslip/structure/beam_shooting.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

using Pair = BeamShooting::Pair;

/// Largest λh of an element; see the top of the header, and duncan_functions().
constexpr double kLargestStep = 2.0;

/// Terms of Duncan's series: at z = 2 the next one is 4e-21 of the first.
constexpr std::size_t kTerms = 7;

/// The ratio of term j + 1 of K_n to term j, without z⁴.
constexpr auto kRatios = [] {
  std::array<std::array<double, kTerms - 1>, 4> ratios{};
  for (std::size_t n = 0; n < 4; ++n) {
    for (std::size_t j = 0; j + 1 < kTerms; ++j) {
      const auto m = static_cast<double>(4 * j + n);
      ratios[n][j] = 1.0 / ((m + 1.0) * (m + 2.0) * (m + 3.0) * (m + 4.0));
    }
  }
  return ratios;
}();

double dot(const BeamState& a, const BeamState& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

void scale(BeamState& y, double factor) {
  for (double& value : y) value *= factor;
}

/// c·a + s·b.
BeamState combined(double c, const BeamState& a, double s, const BeamState& b) {
  return {c * a[0] + s * b[0], c * a[1] + s * b[1], c * a[2] + s * b[2], c * a[3] + s * b[3]};
}

/// The determinant of the displacements and rotations of the two solutions.
double displacement_determinant(const Pair& p) { return p.a[0] * p.b[1] - p.b[0] * p.a[1]; }

/// The diagonal of XᵀT⁻¹X̂ for one solution, up to a positive factor: X its displacement and
/// rotation before an element, X̂ behind it, T the flexibility of the element clamped behind.
double pivot_diagonal(const DuncanFunctions& k, const BeamState& before, const BeamState& behind) {
  return k[1] * before[0] * behind[0] - k[2] * (before[0] * behind[1] - before[1] * behind[0]) -
         k[3] * before[1] * behind[1];
}

/// The negative eigenvalues of the 2×2 dynamic stiffness at the node before an element, of all
/// that lies before the node and the element with its end clamped. That stiffness is congruent to
/// the symmetric XᵀT⁻¹X̂, which has no pole, and det T > 0.
std::size_t negative_pivots(const DuncanFunctions& k, const Pair& before, const Pair& behind) {
  const bool reversed =
      (displacement_determinant(before) < 0.0) != (displacement_determinant(behind) < 0.0);
  if (reversed) return 1;
  const double trace =
      pivot_diagonal(k, before.a, behind.a) + pivot_diagonal(k, before.b, behind.b);
  return trace < 0.0 ? 2 : 0;
}

/// (a b) becomes (a b)·(cos −sin; sin cos).
struct Turn {
  double cos = 1.0;
  double sin = 0.0;
};

/// Adds the shear force of a mass to the two solutions. They are first turned so that the second
/// one does not move the mass: a heavy mass makes the first one large and leaves the second its
/// digits.
Turn pass_mass(double shear_per_displacement, Pair& p) {
  const double r = std::hypot(p.a[0], p.b[0]);
  if (r == 0.0) return {};
  const Turn turn{p.a[0] / r, p.b[0] / r};
  p = {combined(turn.cos, p.a, turn.sin, p.b), combined(-turn.sin, p.a, turn.cos, p.b)};
  p.b[0] = 0.0;
  p.a[3] += shear_per_displacement * p.a[0];
  return turn;
}

/// Gram and Schmidt: the pair was the orthonormal one times (p q; 0 r).
/// @return  the turn times (p q; 0 r)⁻¹: from coordinates in the orthonormal pair back to those in
///          the pair before its turn.
std::array<double, 4> orthonormalise(const Turn& turn, Pair& pair) {
  auto& [a, b] = pair;
  const double p = std::sqrt(dot(a, a));
  scale(a, 1.0 / p);
  const double q = dot(a, b);
  b = combined(1.0, b, -q, a);
  const double r = std::sqrt(dot(b, b));
  scale(b, 1.0 / r);
  return {turn.cos / p, (-turn.cos * q / p - turn.sin) / r,  //
          turn.sin / p, (-turn.sin * q / p + turn.cos) / r};
}

}  // namespace

DuncanFunctions duncan_functions(double z) {
  const double z2 = z * z;
  const double z4 = z2 * z2;
  DuncanFunctions k = {1.0, z, z2 / 2.0, z * z2 / 6.0};
  for (std::size_t n = 0; n < 4; ++n) {
    double sum = 1.0;
    for (std::size_t j = kTerms - 1; j-- > 0;) sum = 1.0 + z4 * kRatios[n][j] * sum;
    k[n] *= sum;
  }
  return k;
}

BeamState carried(const DuncanFunctions& k, const BeamState& y) {
  return {k[0] * y[0] + k[1] * y[1] + k[2] * y[2] + k[3] * y[3],
          k[3] * y[0] + k[0] * y[1] + k[1] * y[2] + k[2] * y[3],
          k[2] * y[0] + k[3] * y[1] + k[0] * y[2] + k[1] * y[3],
          k[1] * y[0] + k[2] * y[1] + k[3] * y[2] + k[0] * y[3]};
}

double wavenumber(const Beam& beam, double angular_frequency) {
  return beam.length *
         std::sqrt(angular_frequency * std::sqrt(beam.mass_per_length / beam.bending_stiffness));
}

double angular_frequency(const Beam& beam, double wavenumber) {
  const double per_length = wavenumber / beam.length;
  return per_length * per_length * std::sqrt(beam.bending_stiffness / beam.mass_per_length);
}

BeamShooting::BeamShooting(const Beam& beam, double largest_wavenumber)
    : tip_stiffness_(beam.tip_stiffness * beam.length / beam.bending_stiffness) {
  std::vector<PointMass> masses = beam.masses;
  std::erase_if(masses, [&](const PointMass& m) {
    return m.mass == 0.0 || m.position == 0.0 || m.position == beam.length;
  });
  std::ranges::sort(masses, {}, &PointMass::position);
  masses.push_back({beam.length, 0.0});

  double start = 0.0;  // m
  std::size_t elements = 0;
  for (const PointMass& m : masses) {
    const double mass = m.mass / (beam.mass_per_length * beam.length);
    if (m.position == start) {  // a second mass at one place
      segments_.back().mass += mass;
      continue;
    }
    const double length = (m.position - start) / beam.length;
    const double count = std::max(1.0, std::ceil(length * largest_wavenumber / kLargestStep));
    segments_.push_back(
        {start / beam.length, length / count, static_cast<std::size_t>(count), mass});
    elements += segments_.back().elements;
    start = m.position;
  }
  nodes_.resize(elements + 1);
}

/// The solutions w″ and w‴ at the clamp.
void BeamShooting::start_march() {
  below_ = 0;
  nodes_.front() = {{{0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}}, {1.0, 0.0, 0.0, 1.0}};
}

void BeamShooting::march(double wavenumber) {
  wavenumber_ = wavenumber;
  start_march();
  auto node = nodes_.begin();
  for (const Segment& segment : segments_) {
    const DuncanFunctions k = duncan_functions(wavenumber * segment.element);
    for (std::size_t i = 1; i <= segment.elements; ++i) {
      const Node& from = *node++;
      Pair next{carried(k, from.solutions.a), carried(k, from.solutions.b)};
      below_ += negative_pivots(k, from.solutions, next);
      Turn turn;
      if (i == segment.elements && segment.mass > 0.0) {
        turn = pass_mass(segment.mass * wavenumber, next);
      }
      const std::array<double, 4> back = orthonormalise(turn, next);
      *node = {next, back};
    }
  }
  const bool reversed =
      (defect() < 0.0) != (displacement_determinant(nodes_.back().solutions) < 0.0);
  if (reversed) ++below_;
}

BeamShooting::Shares BeamShooting::shares() const {
  if (std::isinf(tip_stiffness_)) return {0.0, 1.0};
  const double sum = wavenumber_ + tip_stiffness_;
  return {wavenumber_ / sum, tip_stiffness_ / sum};
}

double BeamShooting::defect() const {
  const auto& [a, b] = nodes_.back().solutions;
  const auto [bending, spring] = shares();
  return a[0] * (bending * b[2] + spring * b[1]) - b[0] * (bending * a[2] + spring * a[1]);
}

double BeamShooting::matching_spring() const {
  const auto& [a, b] = nodes_.back().solutions;
  return -wavenumber_ * (a[0] * b[2] - b[0] * a[2]) / (a[0] * b[1] - b[0] * a[1]);
}

void BeamShooting::solution(BeamState* states) const {
  const auto& [a, b] = nodes_.back().solutions;
  const auto [bending, spring] = shares();
  // Two conditions on two coordinates, of which one is redundant: the better-conditioned one is
  // used.
  std::array<double, 2> row = {a[0], b[0]};
  const std::array<double, 2> moments = {bending * a[2] + spring * a[1],
                                         bending * b[2] + spring * b[1]};
  if (std::hypot(moments[0], moments[1]) > std::hypot(row[0], row[1])) row = moments;
  std::array<double, 2> c = {-row[1], row[0]};

  // At L, (w″/λ², w′/λ) is this multiple of (spring, −bending).
  const double size =
      c[0] * (spring * a[2] - bending * a[1]) + c[1] * (spring * b[2] - bending * b[1]);
  if (size < 0.0) c = {-c[0], -c[1]};
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    states[i] = combined(c[0], nodes_[i].solutions.a, c[1], nodes_[i].solutions.b);
    const auto& m = nodes_[i].back;
    c = {m[0] * c[0] + m[1] * c[1], m[2] * c[0] + m[3] * c[1]};
  }

  // The smaller of moment and rotation from the larger one: a stiff spring leaves a rotation of a
  // few digits, which the tuning of that spring needs.
  BeamState& end = states[nodes_.size() - 1];
  end[0] = 0.0;
  if (spring > bending) {
    end[1] = 0.0 - bending / spring * end[2];
  } else {
    end[2] = 0.0 - spring / bending * end[1];
  }
}

}  // namespace microslip
