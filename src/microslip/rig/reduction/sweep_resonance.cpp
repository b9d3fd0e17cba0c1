// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/sweep_resonance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "microslip/algebra/qr.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kCoarseStep = 30.0 * kDegree;
constexpr double kLeastLag = 30.0 * kDegree;     // of steps whose scatter counts, and of π less it
constexpr double kFarthestLag = 15.0 * kDegree;  // of steps for the mass, and π less it
constexpr Eigen::Index kUnknowns = 3;            // of a fit to them

/// A step of a sweep, by its dynamic stiffness Z = K + iC.
struct StiffnessStep {
  double square = 0.0;        // ω², rad²/s²
  double displacement = 0.0;  // X, m
  double phase = 0.0;         // without its sign, rad
  double elastic = 0.0;       // K, N/m; of either sign as that of the phase is a convention
  double lossy = 0.0;         // C, N/m
};

/// Two neighbours, and where K is 0 between them.
struct Passage {
  StiffnessStep before;
  StiffnessStep behind;
  double share = 0.0;     // of the distance in ω²
  std::size_t place = 0;  // of the second in the sweep
  double mass = 0.0;      // −dK/dω² far from here, where k is as much on either side, kg
  double bend = 0.0;      // possible error of ln C where it is not straight, by other steps

  /// Linear interpolation of two values.
  [[nodiscard]] double between(double a, double b) const { return std::lerp(a, b, share); }
  /// Linear interpolation of two logarithms.
  [[nodiscard]] double geometric(double a, double b) const { return a * std::pow(b / a, share); }

  [[nodiscard]] double square() const { return between(before.square, behind.square); }
  [[nodiscard]] double displacement() const {
    return geometric(before.displacement, behind.displacement);
  }
  [[nodiscard]] double lossy() const { return geometric(before.lossy, behind.lossy); }
  /// ω² that |K| takes to grow from 0 to C.
  [[nodiscard]] double half_width() const { return lossy() / mass; }
  /// Change of k, without the mass, N/m.
  [[nodiscard]] double softening() const {
    return std::abs(before.elastic - behind.elastic) - mass * (behind.square - before.square);
  }
};

/// The steps by rising frequency. The sign of the phase is a convention, and a passive structure
/// takes energy.
std::vector<StiffnessStep> stiffness_steps(const SteppedSine& sweep) {
  std::vector<StiffnessStep> steps;
  for (std::size_t i = 0; i < sweep.frequency.size(); ++i) {
    const double square = std::pow(2.0 * std::numbers::pi * sweep.frequency[i], 2);
    const double displacement = sweep.acceleration[i] / square;
    const double stiffness = sweep.force[i] / displacement;
    const double phase = std::abs(std::remainder(sweep.phase[i], 2.0 * std::numbers::pi));
    steps.push_back({square, displacement, phase, stiffness * std::sin(kQuarterTurn - phase),
                     stiffness * std::sin(phase)});  // the cosine, 0 at a quarter turn
  }
  std::ranges::stable_sort(steps, {}, &StiffnessStep::square);
  return steps;
}

/// The first and the last of the steps about a passage that are on the same sides of this resonance
/// and near enough to determine mass and losses.
std::pair<std::size_t, std::size_t> telling(const std::vector<StiffnessStep>& steps,
                                            std::size_t place) {
  const auto same = [&](std::size_t i, std::size_t side) {
    const bool below = steps[i].phase < kQuarterTurn;
    return below == (steps[side].phase < kQuarterTurn) && steps[i].phase >= kFarthestLag &&
           steps[i].phase <= std::numbers::pi - kFarthestLag;
  };
  std::size_t first = place - 1;
  while (first > 0 && same(first - 1, place - 1)) --first;
  std::size_t last = place;
  while (last + 1 < steps.size() && same(last + 1, place)) ++last;
  return {first, last};
}

/// The mass by the farthest steps: between neighbours k may change by more than mω² does.
double mass_between(const StiffnessStep& first, const StiffnessStep& last) {
  return std::abs(first.elastic - last.elastic) / (last.square - first.square);
}

/// How far ln C of a step is off the straight line over ln X through two others; 0 where these are
/// too close to each other.
double departure_of_loss(const StiffnessStep& beyond, const StiffnessStep& near,
                         const StiffnessStep& step) {
  constexpr double kLeast = 0.5;  // of the distance to the step
  const double line = std::log(near.displacement / beyond.displacement);
  const double distance = std::log(step.displacement / near.displacement);
  if (std::abs(line) < kLeast * std::abs(distance) || line == 0.0) return 0.0;
  return std::abs(std::log(step.lossy / near.lossy) -
                  std::log(near.lossy / beyond.lossy) * distance / line);
}

/// How far ln C at the resonance is off that between the two steps of the nearest displacements, on
/// whichever side: 0 where these are the two beside it.
double departure_by_displacement(std::span<const StiffnessStep> telling, const Passage& passage) {
  const double x = passage.displacement();
  const StiffnessStep* below = nullptr;
  const StiffnessStep* above = nullptr;
  for (const StiffnessStep& step : telling) {
    const double other = step.displacement;
    if (other <= x && (below == nullptr || other > below->displacement)) below = &step;
    if (other > x && (above == nullptr || other < above->displacement)) above = &step;
  }
  if (below == nullptr || above == nullptr) return 0.0;
  const double share =
      std::log(x / below->displacement) / std::log(above->displacement / below->displacement);
  return std::abs(std::lerp(std::log(below->lossy), std::log(above->lossy), share) -
                  std::log(passage.lossy()));
}

/// Possible error of ln C at a passage, by the conclusive steps.
double bend_at(std::span<const StiffnessStep> telling, const Passage& passage, std::size_t place) {
  double beside = 0.0;
  if (place > 1) beside = departure_of_loss(telling[place - 2], passage.before, passage.behind);
  if (place + 1 < telling.size()) {
    beside =
        std::max(beside, departure_of_loss(telling[place + 1], passage.behind, passage.before));
  }
  return std::max(passage.share * (1.0 - passage.share) * beside,
                  departure_by_displacement(telling, passage));
}

std::vector<Passage> passages(const std::vector<StiffnessStep>& steps) {
  std::vector<Passage> found;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const StiffnessStep& before = steps[i - 1];
    const StiffnessStep& behind = steps[i];
    if ((before.phase < kQuarterTurn) == (behind.phase < kQuarterTurn)) continue;
    const auto [first, last] = telling(steps, i);
    Passage one{before, behind, before.elastic / (before.elastic - behind.elastic), i,
                mass_between(steps[first], steps[last])};
    one.bend = bend_at(std::span(steps).subspan(first, last - first + 1), one, i - first);
    found.push_back(one);
  }
  return found;
}

/// At a phase of exactly half a turn the sine is rounding.
void check_phase_at_resonance(const SteppedSine& sweep, const StiffnessStep& step) {
  constexpr double kLeast = 1e-12;
  if (step.phase > kLeast && step.phase < std::numbers::pi - kLeast) return;
  throw InputError(sweep.source + ": phase",
                   fmt::format("{:.3g} rad beside the resonance, at {:.6g} Hz", step.phase,
                               std::sqrt(step.square) / (2.0 * std::numbers::pi)),
                   "must be between 0 and half a turn there: its sine determines the damping",
                   "Sweep in finer steps.");
}

/// How much readings scatter.
struct ReadingScatter {
  double amplitude = 0.0;  // of |Z|, relative
  double phase = 0.0;      // of θ, rad
  std::size_t freedom = 0;
};

/// How much Z of the steps scatters, relative to |Z|.
struct Scatter {
  double lossy = 0.0;    // of C
  double elastic = 0.0;  // of K
  ReadingScatter readings = {};
};

/// Residual of a least-squares fit.
Eigen::ArrayXd rest_of(const Eigen::MatrixXd& regressors, const Eigen::VectorXd& values) {
  // Terms that a constant response does not determine are left out.
  constexpr double kThreshold = 1e-3;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(regressors);
  fit.setThreshold(kThreshold);
  return (values - regressors * fit.solve(values)).array();
}

double deviation(const Eigen::ArrayXd& rest) {
  return rest.matrix().norm() / std::sqrt(static_cast<double>(rest.size() - kUnknowns));
}

/// The steps about a passage, one after the other: of no other resonance.
std::span<const StiffnessStep> steps_near(const std::vector<StiffnessStep>& steps,
                                          const Passage& passage) {
  const auto near = [&](std::size_t i) {
    return steps[i].phase >= kLeastLag && steps[i].phase <= std::numbers::pi - kLeastLag;
  };
  std::size_t first = passage.place;
  while (first > 0 && near(first - 1)) --first;
  std::size_t last = passage.place;
  while (last < steps.size() && near(last)) ++last;
  return std::span(steps).subspan(first, last - first);
}

/// Deviation of a step from the cubic through two steps at either side: δ/√(1 + Σw²), w the weights
/// of these.
class CubicDeparture {
 public:
  /// @param near  at least 5. @param i  of the step, with two at either side.
  CubicDeparture(std::span<const StiffnessStep> near, std::size_t i) : near_(near), i_(i) {
    for (std::size_t a = 0; a < kPlaces.size(); ++a) {
      for (std::size_t b = 0; b < kPlaces.size(); ++b) {
        if (a != b)
          weights_[a] *=
              (square(0) - square(kPlaces[b])) / (square(kPlaces[a]) - square(kPlaces[b]));
      }
    }
  }

  template <typename Value>
  [[nodiscard]] double of(const Value& value) const {
    double departure = value(near_[i_]);
    double variance = 1.0;
    for (std::size_t a = 0; a < kPlaces.size(); ++a) {
      departure -= weights_[a] * value(at(kPlaces[a]));
      variance += weights_[a] * weights_[a];
    }
    return departure / std::sqrt(variance);
  }

 private:
  static constexpr std::array kPlaces{-2, -1, 1, 2};

  [[nodiscard]] const StiffnessStep& at(int place) const {
    return near_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i_) + place)];
  }
  [[nodiscard]] double square(int place) const { return at(place).square; }

  std::span<const StiffnessStep> near_;
  std::size_t i_;
  std::array<double, kPlaces.size()> weights_{1.0, 1.0, 1.0, 1.0};
};

/// Scatter of steps so close that they are smooth from one to the next, whatever the joint. NaN
/// where two are at one frequency. Departures of neighbours are of the same readings: at equal
/// distances these are fourth differences, whose correlations 4/5, 2/5, 4/35 and 1/70 leave n/(1 +
/// 2Σρ²) = n/2.63 of n degrees of freedom.
ReadingScatter scatter_among_neighbours(std::span<const StiffnessStep> near) {
  constexpr double kShareOfFreedom = 1.0 / 2.63;
  constexpr std::size_t kSides = 4;
  if (near.size() <= kSides) return {};
  double amplitude = 0.0;
  double phase = 0.0;
  for (std::size_t i = kSides / 2; i + kSides / 2 < near.size(); ++i) {
    const CubicDeparture departure(near, i);
    amplitude += std::pow(departure.of([](const StiffnessStep& step) {
      return std::log(std::hypot(step.elastic, step.lossy));
    }),
                          2);
    phase += std::pow(departure.of([](const StiffnessStep& step) { return step.phase; }), 2);
  }
  const auto count = static_cast<double>(near.size() - kSides);
  return {std::sqrt(amplitude / count), std::sqrt(phase / count),
          static_cast<std::size_t>(kShareOfFreedom * count)};
}

/// The smaller of two estimates, as what the course of the steps is not like is in both.
ReadingScatter smaller(const ReadingScatter& smooth, const ReadingScatter& local) {
  constexpr std::size_t kLeastFreedom = 3;  // of a scatter that is more informative than its error
  const bool less = std::hypot(local.amplitude, local.phase) <
                    std::hypot(smooth.amplitude, smooth.phase);  // false of NaN
  return less && local.freedom >= kLeastFreedom ? local : smooth;
}

Scatter scatter_of(const std::vector<StiffnessStep>& steps, const Passage& passage) {
  const std::span<const StiffnessStep> near = steps_near(steps, passage);
  const auto count = static_cast<Eigen::Index>(near.size());
  const bool at_one_frequency = !(passage.half_width() > 0.0);
  if (count <= kUnknowns || at_one_frequency) return {};
  Eigen::MatrixXd of_lossy(count, kUnknowns);  // regressors of ln C
  Eigen::MatrixXd of_elastic(count, kUnknowns);
  Eigen::VectorXd lossy(count);
  Eigen::VectorXd elastic(count);
  Eigen::ArrayXd phase(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const StiffnessStep& step = near[static_cast<std::size_t>(i)];
    const double weight = std::sin(step.phase);  // C/|Z|
    const double elastic_weight =
        weight * passage.lossy() / step.lossy;  // that of the peak over |Z|
    of_lossy.row(i) << 1.0, (step.square - passage.square()) / passage.half_width(),
        std::log(step.displacement / passage.displacement());
    of_elastic.row(i) = elastic_weight * of_lossy.row(i);
    of_lossy.row(i) *= weight;
    lossy(i) = weight * std::log(step.lossy / passage.lossy());
    elastic(i) = elastic_weight * step.elastic / passage.lossy();
    phase(i) = step.phase;
  }
  const Eigen::ArrayXd imaginary = rest_of(of_lossy, lossy);  // of δZ/|Z|
  const Eigen::ArrayXd real = rest_of(of_elastic, elastic);
  return {.lossy = deviation(imaginary),
          .elastic = deviation(real),
          .readings = smaller({deviation(real * phase.cos() + imaginary * phase.sin()),
                               deviation(imaginary * phase.cos() - real * phase.sin()),
                               static_cast<std::size_t>(count - kUnknowns)},
                              scatter_among_neighbours(near))};
}

SweepResonance resonance_at(const Passage& passage, const Scatter& scatter) {
  const double omega = std::sqrt(passage.square());
  const double share = passage.share;
  const double weight = std::hypot((1.0 - share) / std::sin(passage.before.phase),
                                   share / std::sin(passage.behind.phase));
  const double growth = std::log(passage.behind.displacement / passage.before.displacement);
  const double chord = share * (1.0 - share) * growth * growth;
  const double half_width = passage.half_width() / (4.0 * std::numbers::pi * omega);  // Hz
  const double phase_step = std::abs(passage.behind.phase - passage.before.phase);
  // Between fine steps the scatter is more than a bend, and what seems one is scatter.
  const double bend = phase_step > kCoarseStep ? passage.bend : 0.0;
  const double softening =
      std::max(1.9 * chord, share * (1.0 - share) * std::abs(growth) *
                                std::abs(passage.softening()) / passage.lossy());
  return {.frequency = omega / (2.0 * std::numbers::pi),
          .force = passage.lossy() * passage.displacement(),
          .acceleration = passage.square() * passage.displacement(),
          .phase_step = phase_step,
          .damping_std = std::hypot(std::max(0.25 * chord, bend), weight * scatter.lossy),
          .frequency_std = half_width * std::hypot(softening, weight * scatter.elastic),
          .amplitude_std = scatter.readings.amplitude,
          .phase_std = scatter.readings.phase,
          .scatter_freedom = scatter.readings.freedom};
}

}  // namespace

std::optional<SweepResonance> resonance_of(const SteppedSine& sweep) {
  check_stepped_sine(sweep);
  const std::vector<StiffnessStep> steps = stiffness_steps(sweep);
  const std::vector<Passage> found = passages(steps);
  if (found.empty()) return std::nullopt;
  for (const Passage& passage : found) {
    check_phase_at_resonance(sweep, passage.before);
    check_phase_at_resonance(sweep, passage.behind);
  }
  const Passage& passage = *std::ranges::max_element(
      found, {}, [](const Passage& one) { return one.square() * one.displacement(); });
  SweepResonance resonance = resonance_at(passage, scatter_of(steps, passage));
  resonance.passages = found.size();
  return resonance;
}

std::vector<Warning> warnings_of(const SweepResonance& resonance) {
  std::vector<Warning> warnings;
  if (resonance.passages > 1) {
    warnings.push_back({"several_resonances",
                        fmt::format("The phase passes a quarter turn {} times: the resonance is "
                                    "the passage of the largest acceleration.",
                                    resonance.passages)});
  }
  if (resonance.phase_step > kCoarseStep) {
    warnings.push_back(
        {"coarse_steps",
         fmt::format("The phase changes by {:.0f}° between the two steps beside the resonance, "
                     "more than {:.0f}°: force over amplitude there is known to {:.2g} %, no "
                     "better than the phases of these two. Sweep in finer steps.",
                     resonance.phase_step / kDegree, kCoarseStep / kDegree,
                     100.0 * resonance.damping_std)});
  }
  return warnings;
}

}  // namespace microslip
