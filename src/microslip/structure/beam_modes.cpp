// SPDX-License-Identifier: MIT
#include "microslip/structure/beam_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/structure/beam_shooting.hpp"

namespace microslip {
namespace {

using std::numbers::pi;
using Index = Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t kMostModes = 1000;

/// Of two modes with wavenumbers this close, relative, each contains some of the other: rounding
/// over the distance.
constexpr double kClose = 1e-3;

/// λ_i of the clamped–clamped beam without masses, from above: masses and a softer spring lower it.
double largest_wavenumber(std::size_t mode) {
  return (static_cast<double>(mode) + 1.5) * pi + 0.02;
}

// ---- Natural frequencies. ----

/// Encloses the roots by their numbers, then refines each on the smooth defect of the shooting.
class WavenumberSearch {
 public:
  WavenumberSearch(BeamShooting& shooting, std::size_t modes)
      : shooting_(shooting), brackets_(modes) {
    for (std::size_t i = 0; i < modes; ++i) sample(largest_wavenumber(i));
  }

  double find(std::size_t mode) {
    const Bracket& bracket = brackets_[mode];
    while (!isolated(mode)) {
      const double middle = 0.5 * (bracket.low.wavenumber + bracket.high.wavenumber);
      if (resolved(bracket.low.wavenumber, bracket.high.wavenumber)) return middle;
      sample(middle);
    }
    return refined(bracket);
  }

 private:
  struct Sample {
    double wavenumber = 0.0;
    std::size_t below = 0;
    double defect = 0.0;
  };
  struct Bracket {
    Sample low;
    Sample high{.wavenumber = std::numeric_limits<double>::infinity()};
  };

  static bool resolved(double a, double b) {
    return std::abs(b - a) <= 2.0 * std::numeric_limits<double>::epsilon() * std::abs(a);
  }

  double defect(double wavenumber) {
    shooting_.march(wavenumber);
    return shooting_.defect();
  }

  /// One march serves the brackets of all modes.
  void sample(double wavenumber) {
    const double d = defect(wavenumber);
    const Sample now{wavenumber, shooting_.below(), d};
    for (std::size_t i = 0; i < brackets_.size(); ++i) {
      auto& [low, high] = brackets_[i];
      if (now.below <= i && wavenumber > low.wavenumber) low = now;
      if (now.below > i && wavenumber < high.wavenumber) high = now;
    }
  }

  /// One root between the ends, neither of them near 0, where the defect has a zero of its own.
  [[nodiscard]] bool isolated(std::size_t mode) const {
    const auto& [low, high] = brackets_[mode];
    return low.below == mode && high.below == mode + 1 && high.wavenumber <= 2.0 * low.wavenumber &&
           low.defect * high.defect <= 0.0;
  }

  double refined(const Bracket& bracket) {
    std::uintmax_t marches = 200;  // bisection alone needs 60
    const auto [a, b] = boost::math::tools::toms748_solve(
        [&](double wavenumber) { return defect(wavenumber); }, bracket.low.wavenumber,
        bracket.high.wavenumber, bracket.low.defect, bracket.high.defect, &resolved, marches);
    return 0.5 * (a + b);
  }

  BeamShooting& shooting_;
  std::vector<Bracket> brackets_;
};

// ---- Shapes and their integrals. ----

using States = std::vector<BeamState>;  // one row per mode

/// ∫₀¹ of products of shapes or slopes by Gauss's rule of 10 points per element: the products
/// are entire and change by factors of e⁴ at most, which it integrates to rounding.
class ShapeIntegrals {
 public:
  ShapeIntegrals(const BeamShooting& shooting, const std::vector<double>& wavenumbers)
      : shooting_(shooting), wavenumbers_(wavenumbers) {
    for (std::size_t i = 0; i < kHalf; ++i) {
      const double x = Rule::abscissa()[i];
      const double w = std::sqrt(0.5 * Rule::weights()[i]);
      points_.push_back({0.5 * (1.0 - x), w});
      points_.push_back({0.5 * (1.0 + x), w});
    }
  }

  /// The values of √weight·φ and √weight·φ′ (over L), one column per mode; the products
  /// of columns are the integrals. The rows behind those of the shapes are √mass·φ at the
  /// masses.
  void sample(const States& states) {
    const auto modes = static_cast<Index>(wavenumbers_.size());
    const std::size_t rows = shooting_.elements() * points_.size();
    shape_.resize(static_cast<Index>(rows + shooting_.segments().size()), modes);
    slope_.resize(static_cast<Index>(rows), modes);
    for (Index mode = 0; mode < modes; ++mode) sample_mode(states, mode);
  }

  [[nodiscard]] double mass(std::size_t i, std::size_t j) const {
    return shape_.col(static_cast<Index>(i)).dot(shape_.col(static_cast<Index>(j)));
  }
  [[nodiscard]] MatrixXd slope() const { return slope_.transpose() * slope_; }

 private:
  static constexpr std::size_t kPoints = 10;
  static constexpr std::size_t kHalf = kPoints / 2;
  using Rule = boost::math::quadrature::gauss<double, kPoints>;

  struct Point {
    double place;        // within an element, over its length
    double root_weight;  // of the rule over [0, 1]
  };

  void sample_mode(const States& states, Index mode) {
    const auto m = static_cast<std::size_t>(mode);
    const double lambda = wavenumbers_[m];
    const BeamState* state = states.data() + m * (shooting_.elements() + 1);
    Index row = 0;
    Index mass_row = slope_.rows();
    for (const BeamShooting::Segment& segment : shooting_.segments()) {
      for (const Point& point : points_) {
        const DuncanFunctions k = duncan_functions(lambda * segment.element * point.place);
        const double weight = point.root_weight * std::sqrt(segment.element);
        for (std::size_t e = 0; e < segment.elements; ++e) {
          const BeamState y = carried(k, state[e]);
          shape_(row, mode) = weight * y[0];
          slope_(row, mode) = weight * lambda * y[1];
          ++row;
        }
      }
      state += segment.elements;
      shape_(mass_row++, mode) = std::sqrt(segment.mass) * (*state)[0];
    }
  }

  const BeamShooting& shooting_;
  const std::vector<double>& wavenumbers_;
  std::vector<Point> points_;
  MatrixXd shape_;
  MatrixXd slope_;
};

/// Removes from each mode the part that rounding left of a mode with almost the same frequency.
/// @return  whether there was such a pair.
bool separate_close_modes(const std::vector<double>& wavenumbers, const ShapeIntegrals& integrals,
                          States& states) {
  const std::size_t nodes = states.size() / wavenumbers.size();
  bool found = false;
  for (std::size_t i = 1; i < wavenumbers.size(); ++i) {
    for (std::size_t j = i; j-- > 0;) {
      if (wavenumbers[i] - wavenumbers[j] > kClose * wavenumbers[i]) break;
      found = true;
      const double share = integrals.mass(i, j) / integrals.mass(j, j);
      for (std::size_t n = 0; n < nodes; ++n) {
        BeamState& state = states[i * nodes + n];
        for (std::size_t k = 0; k < 4; ++k) state[k] -= share * states[j * nodes + n][k];
      }
    }
  }
  return found;
}

std::vector<double> node_places(const BeamShooting& shooting) {
  std::vector<double> places;
  places.reserve(shooting.elements() + 1);
  for (const BeamShooting::Segment& segment : shooting.segments()) {
    for (std::size_t e = 0; e < segment.elements; ++e) {
      places.push_back(segment.start + static_cast<double>(e) * segment.element);
    }
  }
  places.push_back(1.0);
  return places;
}

}  // namespace

BeamModes::BeamModes(const Beam& beam, std::size_t modes) : length_(beam.length) {
  check_beam(beam);
  if (modes < 1 || modes > kMostModes) {
    throw InputError("modes", static_cast<double>(modes),
                     fmt::format("must be from 1 to {}", kMostModes));
  }
  BeamShooting shooting(beam, largest_wavenumber(modes - 1));
  nodes_ = node_places(shooting);
  states_.resize(modes * nodes_.size());
  WavenumberSearch search(shooting, modes);
  for (std::size_t i = 0; i < modes; ++i) {
    const double lambda = search.find(i);
    wavenumbers_.push_back(lambda);
    angular_frequencies_.push_back(angular_frequency(beam, lambda));
    shooting.march(lambda);
    shooting.solution(states_.data() + i * nodes_.size());
  }

  ShapeIntegrals integrals(shooting, wavenumbers_);
  integrals.sample(states_);
  if (separate_close_modes(wavenumbers_, integrals, states_)) integrals.sample(states_);
  Eigen::VectorXd scale(static_cast<Index>(modes));
  for (std::size_t i = 0; i < modes; ++i) {
    const double factor = 1.0 / std::sqrt(beam.mass_per_length * length_ * integrals.mass(i, i));
    scale(static_cast<Index>(i)) = factor;
    const std::span states = std::span(states_).subspan(i * nodes_.size(), nodes_.size());
    for (BeamState& state : states) {
      for (double& value : state) value *= factor;
    }
    tip_slopes_.push_back(wavenumbers_[i] / length_ * states.back()[1]);
  }
  slope_integrals_.resize(modes * modes);
  Eigen::Map<MatrixXd>(slope_integrals_.data(), scale.size(), scale.size()) =
      scale.asDiagonal() * integrals.slope() * scale.asDiagonal() / length_;
}

double BeamModes::frequency(std::size_t mode) const {
  check_mode(mode);
  return angular_frequencies_[mode] / (2.0 * pi);
}

std::vector<double> BeamModes::shapes(double x) const {
  std::vector<double> values;
  values.reserve(size());
  for_each_state(x, [&](std::size_t, const BeamState& y) { values.push_back(y[0]); });
  return values;
}

std::vector<double> BeamModes::slopes(double x) const {
  std::vector<double> values;
  values.reserve(size());
  for_each_state(x, [&](std::size_t mode, const BeamState& y) {
    values.push_back(wavenumbers_[mode] / length_ * y[1]);
  });
  return values;
}

double BeamModes::slope_integral(std::size_t i, std::size_t j) const {
  check_mode(i);
  check_mode(j);
  return slope_integrals_[i * size() + j];
}

void BeamModes::check_mode(std::size_t mode) const {
  if (mode < size()) return;
  throw InputError("mode", static_cast<double>(mode),
                   fmt::format("must be below {}, the number of modes", size()));
}

/// action(mode, state at x) for all modes.
template <typename Action>
void BeamModes::for_each_state(double x, const Action& action) const {
  if (!(x >= 0.0 && x <= length_)) {
    throw InputError("x", x, fmt::format("must be on the beam, from 0 to {} m", length_));
  }
  const double place = x / length_;
  const auto next = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, place);
  const auto node = static_cast<std::size_t>(next - nodes_.begin()) - 1;
  for (std::size_t mode = 0; mode < size(); ++mode) {
    const DuncanFunctions k = duncan_functions(wavenumbers_[mode] * (place - nodes_[node]));
    action(mode, carried(k, states_[mode * nodes_.size() + node]));
  }
}

}  // namespace microslip
