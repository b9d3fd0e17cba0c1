// SPDX-License-Identifier: MIT
#include "microslip/dynamics/missing_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "microslip/dynamics/residual_flexibility.hpp"

namespace microslip {
namespace {

constexpr double kOrthogonal = 1e-3;  // of two shapes, relative: files may have four digits
constexpr double kFlattest = 1.5;     // q; with 1 no number of modes would be enough
constexpr double kSteepest = 8.0;     // that of the tip of a cantilever is 4
constexpr double kFirst = 0.75;       // between bars held at one end, ½, and free ones, 1
constexpr int kHalvings = 40;

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Points at masses of their own, of a structure that has no more: φ of all modes are orthogonal
/// there.
bool seems_whole(const ModalModel& linear) {
  const std::span<const ModalPoint> points = linear.points();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double own = product(points[p].shape, points[p].shape);
    for (std::size_t q = 0; q < p; ++q) {
      const double other = product(points[q].shape, points[q].shape);
      if (std::abs(product(points[p].shape, points[q].shape)) >
          kOrthogonal * std::sqrt(own * other))
        return false;
    }
  }
  return points.size() > 1;
}

/// The numbers of the elastic modes, from the slowest on.
std::vector<std::size_t> elastic_modes(std::span<const Mode> modes) {
  std::vector<std::size_t> elastic;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].angular_frequency > 0.0) elastic.push_back(i);
  }
  std::ranges::stable_sort(elastic, {}, [&](std::size_t i) { return modes[i].angular_frequency; });
  return elastic;
}

/// Σ (i − ¼)^−q of the modes number i = `first` + 1 to `last`.
double power_sum(std::size_t first, std::size_t last, double q) {
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    sum += std::pow(static_cast<double>(i) + kFirst, -q);
  }
  return sum;
}

/// The modes of a model by their number, from the slowest elastic one on, in three parts: those
/// from `first` to `middle` and from there to the last tell the trend.
struct Trend {
  std::vector<std::size_t> modes;
  std::size_t first = 0;
  std::size_t middle = 0;

  [[nodiscard]] std::size_t size() const { return modes.size(); }
  [[nodiscard]] std::span<const std::size_t> upper() const {
    return std::span(modes).subspan(middle);
  }
};

Trend trend_of(std::span<const Mode> modes) {
  Trend trend{.modes = elastic_modes(modes)};
  trend.middle = trend.size() / 2;
  trend.first = trend.middle / 2;
  return trend;
}

/// q of c_i = C (i − ¼)^−q whose sums over both parts are as those found; it falls as their ratio rises.
double slope_of(const Trend& trend, double lower, double upper) {
  if (!(lower > 0.0)) return kSteepest;
  const auto ratio = [&](double q) {
    return power_sum(trend.middle, trend.size(), q) / power_sum(trend.first, trend.middle, q);
  };
  double flat = kFlattest;
  double steep = kSteepest;
  if (ratio(flat) <= upper / lower) return flat;
  if (ratio(steep) >= upper / lower) return steep;
  for (int i = 0; i < kHalvings; ++i) {
    const double q = 0.5 * (flat + steep);
    (ratio(q) > upper / lower ? flat : steep) = q;
  }
  return 0.5 * (flat + steep);
}

/// Σ φ_i²/ω_i² of some modes, m/N.
double softness(std::span<const Mode> modes, std::span<const std::size_t> numbers,
                std::span<const double> shape) {
  double sum = 0.0;
  for (const std::size_t i : numbers) {
    const double over = shape[i] / modes[i].angular_frequency;
    sum += over * over;
  }
  return sum;
}

/// What modes beyond the last add to the compliance at a place, m/N.
double beyond(std::span<const Mode> modes, const Trend& trend, std::span<const double> shape) {
  const std::span<const std::size_t> all(trend.modes);
  const std::size_t count = trend.middle - trend.first;
  const double lower = softness(modes, all.subspan(trend.first, count), shape);
  const double upper = softness(modes, trend.upper(), shape);
  if (!(upper > 0.0)) return 0.0;
  const double q = slope_of(trend, lower, upper);
  const double end = static_cast<double>(trend.size()) + kFirst - 0.5;
  return upper / power_sum(trend.middle, trend.size(), q) * std::pow(end, 1.0 - q) / (q - 1.0);
}

/// By what the shapes of the upper half are multiplied, so that at ω_a they have what is missing.
double factor_of(std::span<const Mode> modes, const Trend& trend, std::span<const double> shape,
                 double frequency) {
  double square = 0.0;
  for (const std::size_t i : trend.upper()) square += shape[i] * shape[i];
  return square > 0.0 ? frequency * std::sqrt(beyond(modes, trend, shape) / square) : 0.0;
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

}  // namespace

std::vector<FurtherMode> likely_missing_modes(const JointedStructure& structure) {
  const std::span<const Mode> modes = structure.linear().modes();
  const Trend trend = trend_of(modes);
  if (trend.size() < 2 || seems_whole(structure.linear())) return {};
  const double frequency = static_mode_frequency(structure);
  std::vector<FurtherMode> further;
  for (const std::size_t i : trend.upper()) {
    further.push_back({.mode = {frequency, modes[i].loss_factor}});
  }
  const auto add = [&](std::span<const double> shape, auto member) {
    const double factor = factor_of(modes, trend, shape, frequency);
    for (std::size_t m = 0; m < further.size(); ++m) {
      (further[m].*member).push_back(factor * shape[trend.upper()[m]]);
    }
  };
  for (const ModalPoint& point : structure.linear().points()) {
    add(point.shape, &FurtherMode::points);
  }
  for (const StructuralJoint& joint : structure.joints()) add(joint.shape, &FurtherMode::joints);
  return further;
}

std::vector<MissingCompliance> missing_compliance(const JointedStructure& structure) {
  const std::span<const Mode> modes = structure.linear().modes();
  const Trend trend = trend_of(modes);
  if (trend.size() < 2 || seems_whole(structure.linear())) return {};
  std::vector<MissingCompliance> found;
  for (const StructuralJoint& joint : structure.joints()) {
    found.push_back({joint.name, joint.joint.stiffness(), softness(modes, trend.modes, joint.shape),
                     beyond(modes, trend, joint.shape)});
  }
  return found;
}

std::optional<CurveChange> judge_missing_modes(const HarmonicBalance& balance,
                                               const ResponseCurve& curve, Quantity kept) {
  if (curve.points.empty() || balance.structure().joints().empty()) return std::nullopt;
  const std::vector<FurtherMode> further = likely_missing_modes(balance.structure());
  if (further.empty()) return std::nullopt;
  const HarmonicBalance more(with_further_modes(balance.structure(), further), balance.response(),
                             balance.options());
  return solve_again(more, curve, kept, PointsAgain::kInResonance);
}

std::optional<Warning> missing_modes_warning(const std::vector<MissingCompliance>& missing,
                                             const std::string& remedy) {
  const auto most = std::ranges::max_element(missing, {}, &MissingCompliance::over_joint);
  if (most == missing.end() || most->over_joint() <= kMissingModesAllowed) return std::nullopt;
  return Warning{
      "modes_missing",
      fmt::format("modes beyond those of the model may add {:.2g} m/N to the {:.4g} m/N by which "
                  "the structure gives way at '{}': {} of 1/k of the joint (estimated by the last "
                  "modes). {}",
                  most->missing, most->in_modes, most->joint, percent(most->over_joint()), remedy)};
}

std::optional<Warning> changed_curve_warning(const CurveChange& change, const std::string& remedy) {
  if (change.level <= kMissingModesAllowed && change.dissipation <= kMissingModesAllowed &&
      change.frequency <= kMissingModesDetune) {
    return std::nullopt;
  }
  return Warning{"modes_missing",
                 fmt::format("modes beyond those of the model may change the level by {}, the "
                             "frequency by {} and the dissipation of a joint by {} (estimated by "
                             "the last modes). {}",
                             percent(change.level), percent(change.frequency),
                             percent(change.dissipation), remedy)};
}

}  // namespace microslip
