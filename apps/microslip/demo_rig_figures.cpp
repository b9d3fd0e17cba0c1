// SPDX-License-Identifier: MIT
#include "demo_rig_figures.hpp"

#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/dynamics/harmonic_balance.hpp"
#include "microslip/report/identification_figures.hpp"
#include "microslip/report/rig_figures.hpp"
#include "microslip/report/verification_figure.hpp"
#include "microslip/rig/rig_structure.hpp"

namespace microslip::app {
namespace {

/// Spline densities over the smoothing factors that serve levels some µm apart, and the density of
/// the inversion. [AR14 Fig. 10]
std::vector<NamedJoint> regenerated_joints(const Levels& levels, double stiffness,
                                           const Joint& by_inversion) {
  constexpr double kMicrometre = 1e-6;
  std::vector<NamedJoint> joints;
  for (const double p : {0.1, 0.5, 0.965}) {
    IdentificationOptions options;
    options.method = IdentificationMethod::kSpline;
    options.spline.smoothing = MatlabP{p, kMicrometre};
    joints.push_back(
        {fmt::format("spline, p = {}", p), identify(levels, stiffness, options).joint});
  }
  joints.push_back({"inversion", by_inversion});
  return joints;
}

/// Frequency responses at constant response, by the joint that was found and by the true one.
std::vector<NamedResponse> constant_responses(const RigDemonstration& done) {
  const StickState& state = done.verifier.reducer().state();
  const ResponsePoint point{done.rig.excitation.channel, ResponseKind::kAcceleration};
  const HarmonicBalanceOptions smooth{.largest_change = 0.05, .accuracy = 0.0};
  const double damping = done.found.linear_damping.value_or(0.0);
  const HarmonicBalance found(rig_structure(done.rig, state, done.found.joint, {1.0}, damping),
                              point, smooth);
  const HarmonicBalance truth(rig_structure(done.rig, state, done.truth), point, smooth);
  const double resonance = state.omega.front();
  std::vector<NamedResponse> responses;
  for (const double level : {0.2, 1.0, 2.0, 4.0}) {
    const double response = level * kStandardGravity;
    const auto curve = [&](const HarmonicBalance& balance) {
      return balance.constant_response(response, 0.95 * resonance, 1.01 * resonance);
    };
    responses.push_back({fmt::format("{} g", level), curve(found), curve(truth)});
  }
  return responses;
}

}  // namespace

void draw_rig(DemoFolder& folder, const std::string& name, const RigDemonstration& done,
              const Levels& levels) {
  const std::vector<ReducedLevel>& reduced = done.reduction.levels;
  folder.draw_both(name + "/resonance", resonance_figure("Resonance over level", reduced));
  folder.draw_both(name + "/force_control",
                   force_control_figure("Control of the force", done.test.levels,
                                        VirtualMeasurementOptions{}.controlled_harmonics),
                   {1500, 480});
  folder.draw_both(name + "/energies",
                   FigureGrid{"Where the energy goes",
                              2,
                              {energies_figure("Energy per cycle", reduced, &done.truth),
                               linear_share_figure("Share of the linear loss", reduced)}},
                   {1100, 480});
  folder.draw_both(name + "/dissipation",
                   dissipation_figure("Dissipation of the joint", levels, done.found));
  folder.draw_both(name + "/density",
                   density_figure("Slip-force density", done.found, &done.truth));
  folder.draw_both(
      name + "/loops",
      loops_figure(
          "Loops for several smoothing factors p of the spline (A in µm), and by the inversion",
          levels.amplitude.back(), {"truth", done.truth},
          regenerated_joints(levels, done.truth.stiffness(), done.found.joint)),
      {1100, 480});
  folder.draw_both(
      name + "/constant_response",
      constant_response_figure("Predicted at constant response; dotted: the true joint",
                               constant_responses(done), "m/s²/N"));
  const FigureGrid verification = verification_figure(done.verification.records);
  folder.draw_both(name + "/verification", verification, verification_size(verification));
}

}  // namespace microslip::app
