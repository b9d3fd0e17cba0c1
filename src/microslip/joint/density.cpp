// SPDX-License-Identifier: MIT
#include "microslip/joint/density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/joint/power_law.hpp"

namespace microslip {
namespace {

/// Total weight may exceed 1 by this much: decimal numbers in a file are rounded.
constexpr double kWeightTolerance = 1e-9;
/// An elastic remainder below this is rounding of a sum that should be 1.
constexpr double kRemainderTolerance = 1e-12;

// ---- The rules on a part. Names are those of the joint file. ----

class PartChecker {
 public:
  explicit PartChecker(std::size_t index) : prefix_(fmt::format("density[{}]", index)) {}

  void operator()(const UniformPart& part) const {
    check_range(part.from, part.to);
    require_non_negative("weight", part.weight);
  }

  void operator()(const PowerLawPart& part) const {
    check_range(part.from, part.to);
    require_non_negative("coefficient", part.coefficient);
    require(std::isfinite(part.exponent), "exponent", part.exponent, "must be finite");
    require(part.from > 0.0 || part.exponent > -1.0, "exponent", part.exponent,
            "must be above -1 where the power law starts at 0 N, or its area is infinite",
            "Start it above 0 N or raise the exponent.");
  }

  void operator()(const PiecewiseLinearPart& part) const {
    const std::size_t n = part.slip_force.size();
    require(n >= 2, "slip_force", static_cast<double>(n), "must have at least 2 knots");
    require(part.density.size() == n, "density", static_cast<double>(part.density.size()),
            fmt::format("must have one value per knot, {} in all", n));
    for (std::size_t i = 0; i < n; ++i) {
      require_non_negative(fmt::format("slip_force[{}]", i), part.slip_force[i]);
      require_non_negative(fmt::format("density[{}]", i), part.density[i],
                           "A slip-force density cannot be negative.");
      require(i == 0 || part.slip_force[i] > part.slip_force[i - 1],
              fmt::format("slip_force[{}]", i), part.slip_force[i],
              "must be larger than the knot before it",
              "Sort the knots; write a step as two knots close to each other.");
    }
  }

  void operator()(const AtomsPart& part) const {
    const std::size_t n = part.slip_force.size();
    require(n >= 1, "slip_force", 0.0, "must have at least one atom");
    require(part.weight.size() == n, "weight", static_cast<double>(part.weight.size()),
            fmt::format("must have one value per atom, {} in all", n));
    for (std::size_t i = 0; i < n; ++i) {
      require_positive(fmt::format("slip_force[{}]", i), part.slip_force[i]);
      require_non_negative(fmt::format("weight[{}]", i), part.weight[i]);
    }
  }

  void operator()(const FourParameterPart& part) const {
    require_positive("macroslip_force", part.macroslip_force);
    require_positive("stiffness", part.stiffness);
    require(part.chi > -1.0 && part.chi <= 0.0, "chi", part.chi, "must be in (-1, 0]");
    require_non_negative("beta", part.beta);
  }

 private:
  void require(bool holds, std::string_view field, double value, std::string_view rule,
               std::string_view remedy = {}) const {
    if (!holds) throw InputError(fmt::format("{}.{}", prefix_, field), value, rule, remedy);
  }

  void require_positive(std::string_view field, double value) const {
    require(std::isfinite(value) && value > 0.0, field, value, "must be positive and finite");
  }

  void require_non_negative(std::string_view field, double value,
                            std::string_view remedy = {}) const {
    require(std::isfinite(value) && value >= 0.0, field, value, "must be 0 or more, and finite",
            remedy);
  }

  void check_range(double from, double to) const {
    require_non_negative("from", from);
    require(std::isfinite(to) && to > from, "to", to,
            fmt::format("must be finite and larger than from = {}", from),
            "A reversed range: swap the two.");
  }

  std::string prefix_;
};

void check_parts(const std::vector<DensityPart>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (std::holds_alternative<FourParameterPart>(parts[i]) && parts.size() > 1) {
      throw InputError(fmt::format("density[{}]", i), "four_parameter",
                       "must stand alone: its area is 1 already",
                       "Remove the other parts, or write the power law and the atom as parts.");
    }
    std::visit(PartChecker(i), parts[i]);
  }
}

// ---- From parts to what they are made of: linear pieces, power laws, atoms. ----

/// φ = value + slope·(f* − from) on [from, to].
struct LinearPiece {
  double from;
  double to;
  double value;
  double slope;
};

struct Elements {
  std::vector<LinearPiece> pieces;
  std::vector<PowerLawPart> power_laws;
  AtomsPart atoms;
};

class ElementCollector {
 public:
  explicit ElementCollector(Elements& elements) : elements_(elements) {}

  void operator()(const UniformPart& part) const {
    elements_.pieces.push_back({part.from, part.to, part.weight / (part.to - part.from), 0.0});
  }

  void operator()(const PowerLawPart& part) const { elements_.power_laws.push_back(part); }

  void operator()(const PiecewiseLinearPart& part) const {
    for (std::size_t i = 0; i + 1 < part.slip_force.size(); ++i) {
      const double width = part.slip_force[i + 1] - part.slip_force[i];
      elements_.pieces.push_back({part.slip_force[i], part.slip_force[i + 1], part.density[i],
                                  (part.density[i + 1] - part.density[i]) / width});
    }
  }

  void operator()(const AtomsPart& part) const {
    for (std::size_t i = 0; i < part.slip_force.size(); ++i) {
      add_atom(part.slip_force[i], part.weight[i]);
    }
  }

  // With f* = K_T ψ and K_T φ df* = ρ(ψ) dψ: φ = R K_T^(−χ−2) f*^χ, and an atom of weight S/K_T.
  // Both are written through the slip force f_m = K_T ψ_max so that no power of K_T is needed.
  void operator()(const FourParameterPart& part) const {
    const double shape = part.beta + (part.chi + 1.0) / (part.chi + 2.0);
    const double largest = part.stiffness * macroslip_displacement(part);
    const double atom_weight = part.macroslip_force * part.beta / (largest * shape);
    const double coefficient =
        part.macroslip_force * (part.chi + 1.0) / (std::pow(largest, part.chi + 2.0) * shape);
    elements_.power_laws.push_back({coefficient, part.chi, 0.0, largest});
    add_atom(largest, atom_weight);
  }

 private:
  void add_atom(double slip_force, double weight) const {
    elements_.atoms.slip_force.push_back(slip_force);
    elements_.atoms.weight.push_back(weight);
  }

  Elements& elements_;
};

AtomsPart sort_and_merge(const AtomsPart& atoms) {
  std::vector<std::size_t> order(atoms.slip_force.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return atoms.slip_force[i]; });
  AtomsPart merged;
  for (const std::size_t i : order) {
    if (atoms.weight[i] == 0.0) continue;  // an atom without weight has no slip force
    if (!merged.slip_force.empty() && merged.slip_force.back() == atoms.slip_force[i]) {
      merged.weight.back() += atoms.weight[i];
    } else {
      merged.slip_force.push_back(atoms.slip_force[i]);
      merged.weight.push_back(atoms.weight[i]);
    }
  }
  return merged;
}

Elements collect(const std::vector<DensityPart>& parts) {
  Elements elements;
  for (const DensityPart& part : parts) std::visit(ElementCollector(elements), part);
  elements.atoms = sort_and_merge(elements.atoms);
  return elements;
}

// ---- From elements to segments. ----

using Segment = SlipDensity::LinearSegment;

std::vector<Segment> empty_segments(const Elements& elements) {
  std::vector<double> starts = elements.atoms.slip_force;
  starts.push_back(0.0);
  for (const LinearPiece& piece : elements.pieces) {
    starts.push_back(piece.from);
    starts.push_back(piece.to);
  }
  std::ranges::sort(starts);
  const auto duplicates = std::ranges::unique(starts);
  starts.erase(duplicates.begin(), duplicates.end());
  std::vector<Segment> segments;
  segments.reserve(starts.size());
  for (const double start : starts) segments.push_back({start, 0.0, 0.0, {}, 0.0, 0.0});
  return segments;
}

void add_piece(const LinearPiece& piece, std::vector<Segment>& segments) {
  auto segment = std::ranges::lower_bound(segments, piece.from, {}, &Segment::start);
  for (; segment->start < piece.to; ++segment) {
    segment->p += piece.value + piece.slope * (segment->start - piece.from);
    segment->q += piece.slope;
  }
}

/// Moments at s = start + t within (or at the end of) a segment, without atoms at s.
PartialMoments moments_within(const Segment& segment, double t) {
  if (segment.p == 0.0 && segment.q == 0.0) return segment.moments;  // t may be infinite
  const auto& [start, p, q, at_start, deficit, energy] = segment;
  // ∫₀ᵗ τⁿ(p + qτ) dτ for n = 0, 1, 2, then the binomial of (start + τ)ⁿ.
  const double local0 = t * (p + 0.5 * q * t);
  const double local1 = t * t * (p / 2.0 + q * t / 3.0);
  const double local2 = t * t * t * (p / 3.0 + q * t / 4.0);
  return {at_start.zeroth + local0, at_start.first + start * local0 + local1,
          at_start.second + start * (start * local0 + 2.0 * local1) + local2};
}

/// Its second derivative in t is φ, its slope at the start Φ0.
double force_deficit_within(const Segment& segment, double t) {
  const double curvature = segment.p / 2.0 + segment.q * t / 6.0;
  return segment.force_deficit + t * (segment.moments.zeroth + t * curvature);
}

/// Its second derivative in t is (start + t)φ, its slope at the start Φ1.
double slip_energy_within(const Segment& segment, double t) {
  const auto& [start, p, q, at_start, deficit, energy] = segment;
  const double curvature = start * p / 2.0 + t * ((start * q + p) / 6.0 + q * t / 12.0);
  return energy + t * (at_start.first + t * curvature);
}

/// Fills in the values of each segment at its start, from the left.
void accumulate(std::vector<Segment>& segments, const AtomsPart& atoms) {
  std::size_t atom = 0;
  for (std::size_t j = 0; j < segments.size(); ++j) {
    Segment& segment = segments[j];
    if (j > 0) {
      const Segment& previous = segments[j - 1];
      const double t = segment.start - previous.start;
      segment.moments = moments_within(previous, t);
      segment.force_deficit = force_deficit_within(previous, t);
      segment.slip_energy = slip_energy_within(previous, t);
    }
    if (atom < atoms.slip_force.size() && atoms.slip_force[atom] == segment.start) {
      const double weight = atoms.weight[atom++];
      segment.moments.zeroth += weight;
      segment.moments.first += weight * segment.start;
      segment.moments.second += weight * segment.start * segment.start;
    }
  }
}

double largest_slip_force(const Elements& elements) {
  double largest = elements.atoms.slip_force.empty() ? 0.0 : elements.atoms.slip_force.back();
  for (const LinearPiece& piece : elements.pieces) {
    if (piece.value > 0.0 || piece.slope != 0.0) largest = std::max(largest, piece.to);
  }
  for (const PowerLawPart& part : elements.power_laws) {
    if (part.coefficient > 0.0) largest = std::max(largest, part.to);
  }
  return largest;
}

}  // namespace

SlipDensity::SlipDensity(std::vector<DensityPart> parts) : parts_(std::move(parts)) {
  check_parts(parts_);
  Elements elements = collect(parts_);
  segments_ = empty_segments(elements);
  for (const LinearPiece& piece : elements.pieces) add_piece(piece, segments_);
  accumulate(segments_, elements.atoms);
  largest_slip_force_ = microslip::largest_slip_force(elements);
  power_laws_ = std::move(elements.power_laws);
  atoms_ = std::move(elements.atoms);

  total_ = moments(std::numeric_limits<double>::infinity());
  if (!(total_.zeroth <= 1.0 + kWeightTolerance)) {
    throw InputError("total weight of density", total_.zeroth, "must not exceed 1",
                     "Lower the weights: they are shares of the joint's stiffness.");
  }
  const double remainder = 1.0 - total_.zeroth;
  elastic_remainder_ = remainder > kRemainderTolerance ? remainder : 0.0;
}

const SlipDensity::LinearSegment& SlipDensity::segment_at(double s) const {
  const auto next = std::ranges::upper_bound(segments_, s, {}, &LinearSegment::start);
  return *std::prev(next);
}

double SlipDensity::density(double slip_force) const {
  if (!(slip_force >= 0.0)) return slip_force < 0.0 ? 0.0 : slip_force;
  const LinearSegment& segment = segment_at(slip_force);
  double sum = segment.p;
  if (segment.q != 0.0) sum += segment.q * (slip_force - segment.start);
  for (const PowerLawPart& part : power_laws_) {
    if (slip_force >= part.from && slip_force < part.to) {
      sum += part.coefficient * std::pow(slip_force, part.exponent);
    }
  }
  return sum;
}

PartialMoments SlipDensity::moments(double s) const {
  if (std::isnan(s)) return {s, s, s};
  if (!(s > 0.0)) return {};
  const LinearSegment& segment = segment_at(s);
  PartialMoments sum = moments_within(segment, s - segment.start);
  for (const PowerLawPart& part : power_laws_) {
    const PartialMoments m = power_law_moments(part, s);
    sum.zeroth += m.zeroth;
    sum.first += m.first;
    sum.second += m.second;
  }
  return sum;
}

double SlipDensity::slip_energy(double s) const {
  if (std::isnan(s)) return s;
  if (!(s > 0.0)) return 0.0;
  if (std::isinf(s)) return total_.first > 0.0 ? s : 0.0;
  const LinearSegment& segment = segment_at(s);
  double sum = slip_energy_within(segment, s - segment.start);
  for (const PowerLawPart& part : power_laws_) sum += power_law_slip_energy(part, s);
  return sum;
}

double macroslip_displacement(const FourParameterPart& part) {
  return part.macroslip_force * (1.0 + part.beta) /
         (part.stiffness * (part.beta + (part.chi + 1.0) / (part.chi + 2.0)));
}

}  // namespace microslip
