// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/requirement.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/dynamics/harmonic/amplitude_continuation.hpp"
#include "microslip/dynamics/harmonic/balance_run.hpp"
#include "microslip/dynamics/harmonic/nearby_solutions.hpp"
#include "microslip/dynamics/harmonic/resonance_curve.hpp"

namespace microslip {
namespace {

/// The equations keep dense matrices over the 2H + 1 coefficients of all joints: as much memory as
/// five of them; measured 4.9 and 4.8, of 41 and 81 joints with 11 harmonics.
void check_size(const HarmonicBalanceOptions& o, const JointedStructure& structure) {
  constexpr double kMatrices = 5.0;
  const double coefficients = 2.0 * static_cast<double>(o.harmonics) + 1.0;
  const double most = std::sqrt(kMostMemory / (kMatrices * sizeof(double))) / coefficients;
  const auto joints = static_cast<double>(structure.joints().size());
  if (joints <= most) return;
  throw InputError(
      "number of joints", joints,
      fmt::format("must be {:.0f} at most with {} harmonics: the equations keep {:.0f} "
                  "matrices of all joints' {:.0f} coefficients, and the limit is 1 GiB",
                  std::floor(most), o.harmonics, kMatrices, coefficients),
      "Take fewer joints, or fewer harmonics.");
}

void check_options(const HarmonicBalanceOptions& o, const JointedStructure& structure) {
  (void)HarmonicForce(o.harmonics, o.samples);  // throws where one is out of its range
  check_size(o, structure);
  if (o.harmonics < structure.excited_harmonics()) {
    throw InputError("harmonics", static_cast<double>(o.harmonics),
                     fmt::format("must be at least the highest of the excitation, {}",
                                 structure.excited_harmonics()));
  }
  require(o.tolerance >= 1e-14 && o.tolerance <= 1e-4, "tolerance", o.tolerance,
          "must be from 1e-14 to 1e-4");
  require(o.max_iterations >= 2, "max_iterations", o.max_iterations, "must be at least 2");
  require(o.largest_change >= 1e-6 && o.largest_change <= 1.0, "largest_change", o.largest_change,
          "must be from 1e-6 to 1");
  require(o.least_points >= 1, "least_points", o.least_points, "must be at least 1");
  require(o.max_points >= 2, "max_points", o.max_points, "must be at least 2");
  require(o.accuracy == 0.0 || (o.accuracy >= 1e-6 && o.accuracy <= 1.0), "accuracy", o.accuracy,
          "must be 0 or from 1e-6 to 1");
}

/// Checks the number of requested points of a curve. Each takes the memory of a vibration, and
/// about twice that as a step of the continuation and as a line of a table: measured with one and
/// two modes and joints.
void check_points(const char* what, std::size_t count, const JointedStructure& structure,
                  const HarmonicBalanceOptions& options) {
  constexpr double kTimesKept = 3.0;
  const std::size_t series =
      sizeof(std::vector<double>) + (options.harmonics + 1) * sizeof(std::complex<double>);
  const std::size_t bytes = sizeof(SteadyVibration) + structure.linear().modes().size() * series +
                            structure.joints().size() * (sizeof(JointCycle) + 2 * series);
  check_memory(what, static_cast<double>(count), kTimesKept * static_cast<double>(bytes),
               "Take fewer.");
}

/// A response that no excited mode takes part in cannot be a target, and has no phase.
void check_response(const JointedStructure& structure, const ResponsePoint& response) {
  const std::span<const double> shape = structure.linear().shape(response.point);
  if (std::ranges::any_of(shape, [](double value) { return value != 0.0; })) return;
  throw InputError("response point", fmt::format("'{}'", response.point),
                   "must move in at least one mode: its shape is 0 in all",
                   "Take a point that is not a node of the modes.");
}

void check_target(const Target& target) {
  const std::string_view what = to_string(target.quantity);
  if (target.quantity == Quantity::kPhaseLag) {
    require(target.value > 0.0 && target.value < std::numbers::pi, what, target.value,
            "must be above 0 and below π rad; π/2 is resonance");
  } else {
    require(std::isfinite(target.value) && target.value > 0.0, what, target.value,
            "must be positive and finite");
  }
}

/// A nonlinear mode has no force and, as nothing drives it, any phase.
void check_modal_targets(const Target& first, const Target& second) {
  for (const Target& target : {first, second}) {
    if (target.quantity != Quantity::kForceAmplitude) continue;
    throw InputError("target", to_string(target.quantity),
                     "must not be prescribed with modal forcing", "Give a response.");
  }
  if (first.quantity == Quantity::kPhaseLag || second.quantity == Quantity::kPhaseLag) return;
  throw InputError("targets",
                   fmt::format("{} and {}", to_string(first.quantity), to_string(second.quantity)),
                   "must include phase resonance with modal forcing");
}

void check_targets(const Target& first, const Target& second, Forcing forcing) {
  check_target(first);
  check_target(second);
  if (first.quantity == second.quantity) {
    throw InputError("second target", to_string(second.quantity), "must differ from the first");
  }
  if (forcing == Forcing::kModal) check_modal_targets(first, second);
}

double product(const std::vector<double>& one, std::span<const double> other) {
  return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

/// Modal forcing determines a mode by the motion of its joints, and its size by the response.
void check_modal_mode(const JointedStructure& structure, const ResponsePoint& response,
                      std::size_t mode, double stuck_frequency) {
  constexpr double kNothing = 1e-9;  // of a shape
  const std::vector<double> shape = structure.stuck_mode(mode);
  const auto takes_part = [&](std::span<const double> other) {
    const double size =
        std::sqrt(std::inner_product(other.begin(), other.end(), other.begin(), 0.0));
    return std::abs(product(shape, other)) > kNothing * size;
  };
  const std::string what = fmt::format("mode with modal forcing");
  if (!takes_part(structure.linear().shape(response.point))) {
    throw InputError(what, fmt::format("{}", mode),
                     fmt::format("must move the response point '{}'", response.point),
                     "Take another response point.");
  }
  const auto joints = structure.joints();
  if (structure.shortens() || std::ranges::any_of(joints, [&](const StructuralJoint& joint) {
        return takes_part(joint.shape);
      })) {
    return;
  }
  throw InputError(what, fmt::format("{}", mode),
                   fmt::format("must move a joint; this one is linear, with {:.9g} Hz and the "
                               "damping of the model at every response",
                               stuck_frequency / (2.0 * std::numbers::pi)),
                   "Take another mode.");
}

}  // namespace

HarmonicBalance::HarmonicBalance(JointedStructure structure, ResponsePoint response,
                                 HarmonicBalanceOptions options)
    : structure_(std::move(structure)),
      response_(std::move(response)),
      options_(std::move(options)) {
  check_options(options_, structure_);
  check_response(structure_, response_);
}

VibrationResult HarmonicBalance::solve(const Target& first, const Target& second,
                                       std::size_t mode) const {
  const Stopwatch watch;
  check_targets(first, second, options_.forcing);
  BalanceRun run(structure_, response_, options_);
  VibrationResult result = solution_of(run, run.solve(first, second, mode), first, second);
  result.summary.wall_seconds = watch.seconds();
  return result;
}

VibrationResult HarmonicBalance::solve(const Target& first, const Target& second,
                                       const SteadyVibration& start) const {
  check_targets(first, second, options_.forcing);
  const NearbyTargets targets{first, second, start};
  return std::move(nearby_solutions(structure_, response_, options_, {&targets, 1}).front());
}

ResponseCurve HarmonicBalance::follow(const Target& kept, Quantity along, double from, double to,
                                      std::size_t mode, const Progress& progress) const {
  const Stopwatch watch;
  if (along == Quantity::kPhaseLag) {
    throw InputError("quantity to follow", to_string(along), "must not be the phase lag");
  }
  check_targets(kept, {along, from}, options_.forcing);
  check_target({along, to});
  require(from != to, "end of the range", to, "must differ from its start");
  check_points("frequencies of `at`", options_.frequencies.size(), structure_, options_);
  ResponseCurve curve =
      follow_from_stuck(structure_, response_, options_, kept, along, from, to, mode, progress);
  curve.summary.wall_seconds = watch.seconds();
  return curve;
}

ResponseCurve HarmonicBalance::frequency_response(double force, double from, double to,
                                                  const Progress& progress) const {
  return follow({Quantity::kForceAmplitude, force}, Quantity::kAngularFrequency, from, to, 0,
                progress);
}

ResponseCurve HarmonicBalance::constant_response(double response, double from, double to,
                                                 const Progress& progress) const {
  return follow({Quantity::kResponse, response}, Quantity::kAngularFrequency, from, to, 0,
                progress);
}

ResponseCurve HarmonicBalance::backbone(std::span<const double> responses, std::size_t mode,
                                        const Progress& progress) const {
  const Stopwatch watch;
  require(!responses.empty(), "number of responses", 0.0, "must be at least 1");
  check_points("number of responses", responses.size(), structure_, options_);
  for (const double response : responses) check_target({Quantity::kResponse, response});
  BalanceRun run(structure_, response_, options_);
  ResponseCurve curve;
  Summary& s = curve.summary;
  s.method = "harmonic balance, backbone";
  AmplitudeContinuation walk(run.equations, run.newton_options, kPhaseResonance,
                             Quantity::kResponse);
  const Target first{Quantity::kResponse, responses.front()};
  const BalanceRun::Outcome begin =
      run.from_stuck(kPhaseResonance, first, stuck_frequency(structure_, mode));
  NewtonResult result = begin.newton;
  if (result.converged) result = walk.start_at(first.value, begin.z);
  s.iterations = begin.newton.iterations;
  for (std::size_t i = 0; i < responses.size() && result.converged; ++i) {
    result = walk.go_to(responses[i]);
    s.iterations += result.iterations;
    if (!result.converged) break;
    s.residual = std::max(s.residual, result.residual);
    run.equations.evaluate(walk.z());
    SteadyVibration vibration = run.equations.vibration();
    result.reason = energy_doubt(vibration, options_.tolerance);
    result.converged = result.reason.empty();
    if (!result.converged) break;
    curve.points.push_back(std::move(vibration));
    if (progress && !progress(i + 1, responses.size())) throw Cancelled();
  }
  s.stop = result.converged ? Stop::kConverged : Stop::kIncomplete;
  s.reason = "all responses reached";
  if (!result.converged) {
    run.equations.evaluate(begin.newton.converged ? walk.z() : begin.z);
    s.reason = fmt::format(
        "stuck at the response {:.6g} on the way to {:.6g}, at {}: {}; if phase resonance "
        "turns back there, following it over the response passes the point",
        run.equations.value(Quantity::kResponse),
        responses[std::min(curve.points.size(), responses.size() - 1)],
        describe({Quantity::kAngularFrequency, run.equations.value(Quantity::kAngularFrequency)}),
        result.reason);
  }
  if (!result.converged) s.residual = result.residual;
  s.wall_seconds = watch.seconds();
  return curve;
}

ResponseCurve HarmonicBalance::resonances(std::span<const double> responses, std::size_t mode,
                                          const Progress& progress) const {
  const Stopwatch watch;
  require(!responses.empty(), "number of responses", 0.0, "must be at least 1");
  check_points("number of responses", responses.size(), structure_, options_);
  for (std::size_t i = 0; i < responses.size(); ++i) {
    check_target({Quantity::kResponse, responses[i]});
    if (i == 0 || responses[i] > responses[i - 1]) continue;
    throw InputError(fmt::format("response[{}]", i), responses[i],
                     fmt::format("must be above the previous one, {}", responses[i - 1]));
  }
  const double stuck = stuck_frequency(structure_, mode);
  if (options_.forcing == Forcing::kModal) check_modal_mode(structure_, response_, mode, stuck);
  ResponseCurve curve =
      ResonanceCurve(structure_, response_, options_, mode, stuck).at(responses, progress);
  curve.summary.wall_seconds = watch.seconds();
  return curve;
}

}  // namespace microslip
