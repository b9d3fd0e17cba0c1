// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/balance_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/requirement.hpp"
#include "microslip/dynamics/harmonic/amplitude_continuation.hpp"
#include "microslip/dynamics/harmonic/continuation.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Frequency first, then phase.
void sort_targets(Target& first, Target& second) {
  const auto rank = [](const Target& t) {
    if (t.quantity == Quantity::kAngularFrequency) return 0;
    return t.quantity == Quantity::kPhaseLag ? 1 : 2;
  };
  if (rank(second) < rank(first)) std::swap(first, second);
}

}  // namespace

BalanceRun::BalanceRun(const JointedStructure& structure, const ResponsePoint& response,
                       const HarmonicBalanceOptions& options)
    : equations(structure, response, options.harmonics, options.samples, options.forcing),
      newton_options{options.tolerance, options.max_iterations} {}

BalanceRun::Outcome BalanceRun::from_stuck(const Target& kept, const Target& level,
                                           double angular_frequency) {
  VectorXd z = scaled(equations, stuck_vibration(equations, angular_frequency), level);
  NewtonResult direct = newton(equations, kept, level, newton_options, z);
  if (direct.converged) return {direct, z};
  AmplitudeContinuation walk(equations, newton_options, kept, level.quantity);
  NewtonResult result = walk.start(angular_frequency, level.value);
  if (result.converged) result = walk.go_to(level.value);
  return {result, walk.z()};
}

BalanceRun::Outcome BalanceRun::at_frequency(const Target& phase, const Target& frequency,
                                             double stuck) {
  constexpr double kRatio = 1.2;
  constexpr int kMostSteps = 150;  // a factor 1e12
  AmplitudeContinuation walk(equations, newton_options, phase, Quantity::kResponse);
  NewtonResult result = walk.start(stuck, HUGE_VAL);
  const Index n = equations.balance_count();
  const double side = walk.z()[n] - frequency.value;
  for (int step = 0; step < kMostSteps && result.converged; ++step) {
    result = walk.go_to(kRatio * walk.level());
    if (!result.converged || side * (walk.z()[n] - frequency.value) > 0.0) continue;
    const double before = walk.previous()[n] - frequency.value;
    const double after = walk.z()[n] - frequency.value;
    VectorXd z = walk.previous() + (walk.z() - walk.previous()) * (before / (before - after));
    return {newton(equations, phase, frequency, newton_options, z), z};
  }
  result.converged = false;
  result.reason = fmt::format(
      "no response up to {:.6g} has this phase there; from "
      "{} it went to {}",
      walk.level(), describe({Quantity::kAngularFrequency, stuck}),
      describe({Quantity::kAngularFrequency, walk.z()[n]}));
  return {result, walk.z()};
}

BalanceRun::Outcome BalanceRun::solve(Target first, Target second, std::size_t mode) {
  sort_targets(first, second);
  if (first.quantity == Quantity::kAngularFrequency) {
    if (second.quantity != Quantity::kPhaseLag) return from_stuck(first, second, first.value);
    return at_frequency(second, first, stuck_frequency(equations.structure(), mode));
  }
  if (first.quantity == Quantity::kPhaseLag) {
    return from_stuck(first, second, stuck_frequency(equations.structure(), mode));
  }
  throw InputError("targets", "force amplitude and response",
                   "leave two frequencies, below and above resonance, to choose from",
                   "Give a vibration near the desired one as the start.");
}

double stuck_frequency(const JointedStructure& structure, std::size_t mode) {
  const std::vector<double> frequencies = structure.stuck_frequencies();
  require(mode < frequencies.size(), "mode", static_cast<double>(mode),
          "must be below the number of modes");
  if (frequencies[mode] > 0.0) return frequencies[mode];
  throw InputError("mode", static_cast<double>(mode),
                   "must be an elastic mode; this is a rigid-body mode", "Take a higher mode.");
}

ResponseCurve follow_from_stuck(const JointedStructure& structure, const ResponsePoint& response,
                                const HarmonicBalanceOptions& options, const Target& kept,
                                Quantity along, double from, double to, std::size_t mode,
                                const Progress& progress) {
  BalanceRun run(structure, response, options);
  const BalanceRun::Outcome first = run.solve(kept, {along, from}, mode);
  ResponseCurve curve;
  curve.summary.method = "harmonic balance, continuation";
  curve.summary.residual = first.newton.residual;
  curve.summary.iterations = first.newton.iterations;
  if (first.newton.converged) {
    const ContinuationOptions steps{run.newton_options,   options.largest_change,
                                    options.least_points, options.max_points,
                                    options.accuracy,     options.frequencies};
    Continuation(run.equations, steps, kept, along, from, to).run(first.z, curve, progress);
  } else {
    curve.summary.stop = Stop::kNoProgress;
    curve.summary.reason =
        fmt::format("the first point was not found: {} with {}: {}",
                    describe({along, from}, structure.base_driven()),
                    describe(kept, structure.base_driven()), first.newton.reason);
  }
  return curve;
}

}  // namespace microslip
