// SPDX-License-Identifier: MIT
#include "demo/demo_rig_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/identify/methods/density_comparison.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip::app {
namespace {

std::string row(std::string_view quantity, std::string_view truth, std::string_view estimate) {
  return fmt::format("  {:<44} {:>10} {:>10}\n", quantity, truth, estimate);
}

std::string row(std::string_view quantity, double truth, double estimate) {
  return row(quantity, fmt::format("{:.5g}", truth), fmt::format("{:.5g}", estimate));
}

std::string describe_level(const RigDemonstration& done, std::size_t i) {
  const ReducedLevel& level = done.reduction.levels[i];
  const VirtualLevel& exact = done.test.levels[i];
  const SteadyVibration& vibration = exact.controlled.vibration;
  const JointCycle& joint = vibration.joints.front();
  std::string text = fmt::format("\n  At {:.3g} m/s² ({:.3g} g)\n", exact.response,
                                 exact.response / kStandardGravity);
  text += row("resonance [Hz]", exact.resonance_frequency, level.resonance_frequency);
  text += row("joint amplitude A [µm]", 1e6 * joint.amplitude, 1e6 * level.amplitude.value);
  text += row("dissipation of the joint D [µJ]", 1e6 * joint.dissipation,
              1e6 * level.dissipation.value);
  text += row("linear loss over input [%]",
              100.0 * vibration.linear_dissipation / vibration.input_energy,
              100.0 * level.linear_dissipation / level.input_energy.value);
  if (level.secant_stiffness) {
    text += row("secant stiffness [kN/m]", 1e-3 * secant_stiffness(done.truth, joint.amplitude),
                1e-3 * level.secant_stiffness->value);
  }
  return text;
}

std::string describe_force(const RigDemonstration& done) {
  const std::size_t harmonics = VirtualMeasurementOptions{}.controlled_harmonics;
  double before = 0.0;
  double after = 0.0;
  for (const VirtualLevel& level : done.test.levels) {
    before = std::max(before, force_distortion(level.uncontrolled, harmonics));
    after = std::max(after, force_distortion(level.controlled, harmonics));
  }
  return line("force harmonics", fmt::format("at most {} of the first before control, {} after",
                                             percent_text(before), percent_text(after)));
}

std::string describe_density(const RigDemonstration& done) {
  const SlipDensity& truth = done.truth.density();
  const Identification& found = done.found;
  const double reach = found.covered_to;
  std::string text = "\n  The joint\n";
  text += row(fmt::format("area up to kA = {:.1f} N [1]", reach), truth.moments(reach).zeroth,
              found.joint.density().moments(reach).zeroth);
  for (const double share : {0.25, 0.5, 0.75}) {
    const double f = share * reach;
    text += row(fmt::format("density at {:.1f} N [1/N]", f), truth.density(f),
                found.joint.density().density(f));
  }
  text += "\n";
  text += line("density error", fmt::format("{:.2f} % (relative L2 over 5 to 95 % of the range)",
                                            100.0 * density_error(found, truth)));
  text += line("95 % band", fmt::format("contains the truth on {:.1f} % of that range",
                                        100.0 * band_coverage(found, truth)));
  return text;
}

/// The record nearest to a level.
const Verification& nearest(const RigDemonstration& done, double response) {
  return *std::ranges::min_element(done.verification.records, {}, [&](const Verification& record) {
    return std::abs(record.recorded.response_amplitude - response);
  });
}

std::string describe_predictions(const RigDemonstration& done) {
  std::string text;
  for (const double level : {0.2, 1.5}) {
    const Verification& record = nearest(done, level * kStandardGravity);
    std::string channels;
    for (const ChannelComparison& channel : record.channels) {
      channels += fmt::format("{}{} {:.2f}", channels.empty() ? "" : ", ", channel.name,
                              100.0 * channel.nrmse);
    }
    text += line(fmt::format("NRMSE at {} g [%]", level), channels);
  }
  return text;
}

}  // namespace

std::string describe_rig(const RigDemonstration& done) {
  std::string text = row("", "truth", "estimate");
  text += describe_level(done, 0);
  text += describe_level(done, done.reduction.levels.size() - 1);
  text += describe_density(done);
  text += describe_predictions(done);
  return text + describe_force(done);
}

}  // namespace microslip::app
