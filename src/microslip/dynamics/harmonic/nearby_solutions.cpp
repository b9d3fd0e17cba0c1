// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/nearby_solutions.hpp"

#include <fmt/format.h>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"

namespace microslip {
namespace {

using Eigen::VectorXd;

VectorXd to_unknowns(const SteadyVibration& start, const BalanceEquations& equations,
                     std::size_t harmonics) {
  const std::size_t joints = equations.structure().joints().size();
  if (start.joints.size() != joints) {
    throw InputError("joints of the start", static_cast<double>(start.joints.size()),
                     fmt::format("must be those of the structure, {}", joints));
  }
  for (const JointCycle& joint : start.joints) {
    if (joint.displacement.size() == harmonics + 1) continue;
    throw InputError("harmonics of the start", static_cast<double>(joint.displacement.size()) - 1.0,
                     fmt::format("must be those of the options, {}", harmonics));
  }
  return equations.unknowns(start);
}

}  // namespace

VibrationResult solution_of(BalanceRun& run, const BalanceRun::Outcome& outcome,
                            const Target& first, const Target& second) {
  VibrationResult result;
  run.equations.evaluate(outcome.z);
  result.vibration = run.equations.vibration();
  Summary& s = result.summary;
  s.method = "harmonic balance";
  const std::string doubt = energy_doubt(result.vibration, run.newton_options.tolerance);
  const bool converged = outcome.newton.converged && doubt.empty();
  s.stop = converged                  ? Stop::kConverged
           : outcome.newton.converged ? Stop::kDoubtful
                                      : Stop::kNoProgress;
  s.reason = outcome.newton.converged && !converged ? doubt : outcome.newton.reason;
  if (!converged) {
    const bool of_base = run.equations.structure().base_driven();
    s.reason += fmt::format(
        "; requested {} and {}, reached {:.9g} Hz, {}, response {:.6g}", describe(first, of_base),
        describe(second, of_base), result.vibration.frequency(),
        drive_text(result.vibration.force_amplitude, of_base), result.vibration.response);
  }
  s.residual = outcome.newton.residual;
  s.iterations = outcome.newton.iterations;
  return result;
}

std::vector<VibrationResult> nearby_solutions(const JointedStructure& structure,
                                              const ResponsePoint& response,
                                              const HarmonicBalanceOptions& options,
                                              std::span<const NearbyTargets> targets) {
  std::vector<VibrationResult> results;
  if (targets.empty()) return results;
  BalanceRun run(structure, response, options);
  for (const auto& [first, second, start] : targets) {
    const Stopwatch watch;
    VectorXd z = to_unknowns(start, run.equations, options.harmonics);
    const NewtonResult found = newton(run.equations, first, second, run.newton_options, z);
    results.push_back(solution_of(run, {found, z}, first, second));
    results.back().summary.wall_seconds = watch.seconds();
  }
  return results;
}

}  // namespace microslip
