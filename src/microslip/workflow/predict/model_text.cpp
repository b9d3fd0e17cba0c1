// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/model_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "microslip/base/plausibility.hpp"
#include "microslip/documents/response/march_file.hpp"
#include "microslip/documents/response/response_file.hpp"
#include "microslip/dynamics/harmonic/missing_modes.hpp"
#include "microslip/dynamics/harmonic/truncation.hpp"
#include "microslip/dynamics/structure/damping_twice.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/joint/covered_range.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

const std::string kModesRemedy =
    "Give the model more modes, or their residual as [structure.residual]; static_attachments = 0 "
    "in [structure] states that there is none.";

/// Linear damping used and identified, which differ where the model specifies its own. Empty
/// where there is neither.
std::string damping_of(const ModelFile& model, std::size_t j) {
  const double used = model.structure.joints()[j].linear_damping;
  double identified = 0.0;
  if (j < model.identified_damping.size()) identified = model.identified_damping[j].value_or(0.0);
  if (used == 0.0 && identified == 0.0) return "";
  if (used == identified) return damping_text(used) + ", as identified";
  if (identified == 0.0) return damping_text(used) + ", as the model specifies";
  return fmt::format("{}, as the model specifies; identified are {:.6g} J/m^2",
                     used == 0.0 ? "none" : damping_text(used), identified);
}

}  // namespace

std::string heading_of(std::string_view command, const ModelFile& model) {
  std::string text = heading_of(command);
  for (std::size_t j = 0; j < model.structure.joints().size(); ++j) {
    const std::string damping = damping_of(model, j);
    if (damping.empty()) continue;
    text += fmt::format("\nlinear damping of '{}': {}", model.structure.joints()[j].name, damping);
  }
  return text;
}

std::string damping_text(double linear_damping) {
  if (linear_damping == 0.0) return "";
  return fmt::format("{:.6g} J/m^2 beside slip", linear_damping);
}

std::string stuck_frequencies_text(const JointedStructure& structure) {
  constexpr std::size_t kMost = 5;
  const std::vector<double> omega = structure.stuck_frequencies();
  std::string text;
  for (std::size_t i = 0; i < std::min(omega.size(), kMost); ++i) {
    text += fmt::format("{}{:.5g}", i == 0 ? "" : ", ", omega[i] / (2.0 * std::numbers::pi));
  }
  return text + (omega.size() > kMost ? ", ... Hz" : " Hz");
}

std::string describe_model(const std::string& file, const JointedStructure& structure) {
  const std::size_t extra = structure.linear().static_modes();
  return line("model", fmt::format("{}, {}{}, {}", input_name(file),
                                   counted(structure.linear().vibrations(), "mode"),
                                   extra == 0 ? "" : fmt::format(" and {} static", extra),
                                   counted(structure.joints().size(), "joint"))) +
         line("stuck resonances", stuck_frequencies_text(structure));
}

std::string describe_damping(const ModelFile& model) {
  std::string text;
  for (std::size_t j = 0; j < model.structure.joints().size(); ++j) {
    const std::string damping = damping_of(model, j);
    if (damping.empty()) continue;
    text +=
        line("linear damping", fmt::format("'{}': {}", model.structure.joints()[j].name, damping));
  }
  return text;
}

namespace {

/// Whether a joint that was not measured may be one without units, as of a textbook, which moves by
/// metres: none is moved by a thousand times the displacement at which all of it has slipped.
bool may_lack_units(const Joint& joint, double amplitude) {
  constexpr double kFar = 1e3;
  return amplitude < kFar * joint.density().largest_slip_force() / joint.stiffness();
}

/// Of a joint that moves by this amplitude, m, and was identified up to kA, N.
std::vector<Warning> reach_warnings(const Joint& joint, double amplitude,
                                    std::optional<double> covered_to) {
  std::vector<Warning> warnings;
  if (auto far = beyond_identification(joint, amplitude, covered_to)) {
    warnings.push_back(*std::move(far));
  }
  if (!covered_to && may_lack_units(joint, amplitude)) return warnings;
  if (auto large = implausible_value("the joint", kLength, amplitude)) {
    warnings.push_back(*std::move(large));
  }
  return warnings;
}

std::vector<Warning> residual_warnings(const ModelFile& model) {
  const auto warning = large_residual_warning(model.structure);
  return warning ? std::vector<Warning>{*warning} : std::vector<Warning>{};
}

}  // namespace

std::vector<Warning> reach_warnings(const ModelFile& model, const std::vector<double>& amplitude) {
  std::vector<Warning> warnings;
  for (std::size_t j = 0; j < std::min(amplitude.size(), model.covered_to.size()); ++j) {
    const StructuralJoint& joint = model.structure.joints()[j];
    for (Warning& warning : reach_warnings(joint.joint, amplitude[j], model.covered_to[j])) {
      warning.text = fmt::format("'{}': {}", joint.name, warning.text);
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

void add_model_warnings(const ModelFile& model, ResponseCurve& curve) {
  std::ranges::move(residual_warnings(model), std::back_inserter(curve.warnings));
  std::ranges::copy(damping_twice(model.structure), std::back_inserter(curve.warnings));
  std::vector<double> amplitude(model.structure.joints().size(), 0.0);
  for (const SteadyVibration& point : curve.points) {
    for (std::size_t j = 0; j < amplitude.size(); ++j) {
      const JointCycle& joint = point.joints[j];
      const double mean = joint.displacement.empty() ? 0.0 : std::abs(joint.displacement[0]);
      amplitude[j] = std::max(amplitude[j], mean + joint.amplitude);  // from where it was virgin
    }
  }
  std::ranges::copy(reach_warnings(model, amplitude), std::back_inserter(curve.warnings));
}

std::vector<Warning> mode_warnings(const ModelFile& model) {
  if (model.static_attachments) return residual_warnings(model);
  const auto warning = missing_modes_warning(missing_compliance(model.structure), kModesRemedy);
  return warning ? std::vector<Warning>{*warning} : std::vector<Warning>{};
}

namespace {

/// ", 3 peaks not": of a curve with very many.
std::string left_out_text(const CurveChange& change) {
  if (change.peaks_left_out == 0) return "";
  return fmt::format(", {} not", counted(change.peaks_left_out, "peak"));
}

std::string change_text(const CurveChange& change) {
  return fmt::format("{:.2g} % of a dissipation, {:.2g} % of the level, {} checked{}",
                     100.0 * change.dissipation, 100.0 * change.level,
                     counted(change.points, "point"), left_out_text(change));
}

std::string add_missing_modes(const HarmonicBalance& balance, Quantity kept, ResponseCurve& curve) {
  const std::optional<CurveChange> change = judge_missing_modes(balance, curve, kept);
  if (!change) return "";
  if (auto warning = changed_curve_warning(*change, kModesRemedy)) {
    curve.warnings.push_back(std::move(*warning));
  }
  if (change->points == 0 || change->frequency > kMissingModesFar) return "";
  return line("modes above", fmt::format("estimated: {:.2g} % of the frequency, {}",
                                         100.0 * change->frequency, change_text(*change)));
}

std::string add_missing_harmonics(const HarmonicBalance& balance, Quantity kept,
                                  ResponseCurve& curve) {
  const std::optional<Truncation> truncation = judge_truncation(balance, curve, kept);
  if (!truncation) return "";
  if (auto warning = truncation_warning(*truncation)) {
    if (warning->code == "truncated") {
      warning->text += fmt::format(" (`harmonics {}`)", truncation->harmonics);
    }
    curve.warnings.push_back(std::move(*warning));
  }
  if (truncation->points == 0) return "";
  return line("harmonics above",
              fmt::format("up to {}: {}", truncation->harmonics, change_text(*truncation)));
}

}  // namespace

std::string add_truncation(const HarmonicBalance& balance, const ModelFile& model, Quantity kept,
                           ResponseCurve& curve) {
  std::string text = add_missing_harmonics(balance, kept, curve);
  if (!model.static_attachments) text += add_missing_modes(balance, kept, curve);
  return text;
}

std::string describe_warnings(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += wrapped("  warning: ", warning.text, 11);
  return text;
}

std::vector<Warning> reach_warnings(const JointFile& file, double amplitude) {
  return reach_warnings(file.joint, amplitude, covered_to(file));
}

std::string describe_ending(const Summary& summary) {
  return wrapped(fmt::format("  {:<20} ", "ended"),
                 fmt::format("{}{}", summary.converged() ? "" : "NOT CONVERGED: ", summary.reason),
                 23);
}

std::string describe_curve(const HarmonicBalance& balance, const ResponseCurve& curve,
                           const std::string& file) {
  std::string text = describe_model(file, balance.structure());
  text += line("method", fmt::format("{}, {}, {}", curve.summary.method,
                                     counted(balance.options().harmonics, "harmonic"),
                                     counted(balance.options().samples, "sample")));
  return text + describe_ending(curve.summary);
}

namespace {

/// "m", "m/s^2", "N": of what a curve is high in.
std::string height_unit(const HarmonicBalance& balance, bool of_force) {
  return of_force ? si_unit(drive_column(balance).dimension)
                  : std::string(unit_of(balance.response().kind));
}

std::string describe_peaks(const HarmonicBalance& balance, const ResponseCurve& curve,
                           bool of_force) {
  std::string text;
  for (const SteadyVibration& peak : curve.peaks) {
    // Far from a lag of a quarter, as in a superharmonic resonance, the losses are not those of a
    // mode.
    const bool in_resonance = std::abs(std::sin(peak.phase_lag)) > 0.5;
    const std::string damping = in_resonance ? fmt::format("damping {:.4g}", peak.damping_ratio())
                                             : "not in phase resonance";
    text += line(of_force ? "resonance" : "peak",
                 fmt::format("{:.6g} Hz, {:.5g} {}, lag {:.4g} rad, {}", peak.frequency(),
                             of_force ? peak.force_amplitude : peak.response,
                             height_unit(balance, of_force), peak.phase_lag, damping));
  }
  for (const std::size_t i : curve.turning_points) {
    if (i >= curve.points.size()) continue;
    text += line("turns back", fmt::format("at {:.6g} Hz, {:.5g} {}", curve.points[i].frequency(),
                                           curve.points[i].response, height_unit(balance, false)));
  }
  return text;
}

std::string describe_energy(const MarchEnergy& energy) {
  std::string text = line("input", fmt::format("{:.5g} J", energy.input));
  text += line("linear dissipation", fmt::format("{:.5g} J", energy.linear_dissipation));
  for (const JointEnergy& joint : energy.joints) {
    std::string lost = fmt::format("{:.5g} J dissipated", joint.dissipation);
    if (joint.linear_dissipation > 0.0) {
      lost += fmt::format(" by slip, {:.5g} J by linear damping", joint.linear_dissipation);
    }
    text += line(joint.joint, fmt::format("{}, {:.5g} J stored at the end", lost, joint.stored));
  }
  text += line("at the end",
               fmt::format("{:.5g} J kinetic, {:.5g} J elastic", energy.kinetic, energy.elastic));
  return text + line("energy imbalance", fmt::format("{:.2g}", energy.imbalance()));
}

}  // namespace

void add_response_warnings(const HarmonicBalance& balance, const ModelFile& model,
                           ResponseCurve& curve) {
  add_model_warnings(model, curve);
  if (!curve.summary.converged() || !curve.peaks.empty()) return;
  curve.warnings.push_back(
      {"no_resonance", fmt::format("no resonance in the range. With all joints stuck the structure "
                                   "is resonant at {}; slip lowers that.",
                                   stuck_frequencies_text(balance.structure()))});
}

std::string judge_response(const HarmonicBalance& balance, const ModelFile& model, Quantity kept,
                           ResponseCurve& curve) {
  std::string truncation = add_truncation(balance, model, kept, curve);
  add_response_warnings(balance, model, curve);
  return truncation;
}

std::string judge_backbone(const HarmonicBalance& balance, const ModelFile& model,
                           ResponseCurve& curve) {
  std::string truncation = add_truncation(balance, model, Quantity::kPhaseLag, curve);
  add_model_warnings(model, curve);
  return truncation;
}

std::string describe_response(const std::string& file, const HarmonicBalance& balance,
                              const ResponseCurve& curve, bool of_force) {
  const SteadyVibration& first = curve.points.front();
  const bool base = balance.structure().base_driven();
  std::string text =
      of_force ? fmt::format("{} for a response of {:g} {}\n", base ? "Base acceleration" : "Force",
                             first.response, height_unit(balance, false))
               : fmt::format("Frequency response at {:g} {}\n", first.force_amplitude,
                             height_unit(balance, true));
  text += describe_curve(balance, curve, file);
  const auto [lowest, highest] =
      std::ranges::minmax(curve.points, {}, &SteadyVibration::angular_frequency);
  text += line("range", fmt::format("{:.6g} to {:.6g} Hz, {} points", lowest.frequency(),
                                    highest.frequency(), curve.points.size()));
  const auto [least, most] = std::ranges::minmax(
      curve.points, {}, of_force ? &SteadyVibration::force_amplitude : &SteadyVibration::response);
  text += of_force ? line(base ? "base acceleration" : "force",
                          fmt::format("{:.5g} to {:.5g} {}", least.force_amplitude,
                                      most.force_amplitude, height_unit(balance, true)))
                   : line("displacement",
                          fmt::format("{:.5g} to {:.5g} m{}", least.response, most.response,
                                      base ? ", relative to the base" : ""));
  return text + describe_peaks(balance, curve, of_force);
}

std::string describe_backbone(const std::string& file, const HarmonicBalance& balance,
                              const ResponseCurve& curve, std::size_t mode) {
  const SteadyVibration& first = curve.points.front();
  const SteadyVibration& last = curve.points.back();
  const auto span = [&](std::string_view name, double from, double to, std::string_view unit) {
    return line(name, fmt::format("{:.6g} to {:.6g}{}{}", from, to, unit.empty() ? "" : " ", unit));
  };
  std::string text =
      fmt::format("Backbone of mode {}{}\n", mode,
                  balance.options().forcing == Forcing::kModal ? ", modal forcing" : "");
  text += describe_curve(balance, curve, file);
  text += line("points", fmt::format("{}", curve.points.size()));
  for (const std::size_t i : curve.turning_points) {
    text += line("turns back", fmt::format("at {:.6g} m, {:.6g} Hz", curve.points[i].response,
                                           curve.points[i].frequency()));
  }
  text += span("displacement", first.response, last.response, "m");
  const CurveHeight drive = drive_column(balance);
  text += span(drive.dimension == kForce ? "force" : "base acceleration", first.force_amplitude,
               last.force_amplitude, si_unit(drive.dimension));
  text += span("frequency", first.frequency(), last.frequency(), "Hz");
  text += span("damping ratio", first.damping_ratio(), last.damping_ratio(), "");
  const auto most = std::ranges::max_element(curve.points, {}, &SteadyVibration::damping_ratio);
  return text + line("largest damping",
                     fmt::format("{:.4g} at {:.5g} m", most->damping_ratio(), most->response));
}

std::vector<Warning> march_warnings(const ModelFile& model, const std::vector<double>& reach) {
  std::vector<Warning> warnings = damping_twice(model.structure);
  std::ranges::move(mode_warnings(model), std::back_inserter(warnings));
  std::ranges::move(reach_warnings(model, reach), std::back_inserter(warnings));
  return warnings;
}

MarchResult judged_march(const ModelFile& model, const LoadHistory& loads,
                         const MarchOptions& options, const Progress& progress) {
  MarchResult result = march(model.structure, loads, options, progress);
  std::ranges::move(march_warnings(model, result.reach), std::back_inserter(result.warnings));
  return result;
}

MarchResult march_to_table(const std::string& path, const ModelFile& model,
                           const LoadHistory& loads, const MarchOptions& options,
                           const std::string& heading, const Progress& progress) {
  MarchTable table(path, model.structure, loads, heading);
  const auto write = [&](const MarchRow& row) { table.add(row); };
  MarchResult result = march_rows(model.structure, loads, options, write, progress);
  std::ranges::move(march_warnings(model, result.reach), std::back_inserter(result.warnings));
  table.finish(result);
  return result;
}

std::string describe_march(const std::string& file, const std::string& forces,
                           const ModelFile& model, const LoadHistory& loads,
                           const MarchResult& result, const std::string& draws) {
  std::string text = fmt::format("March from {:g} to {:g} s\n", loads.time.front(), result.reached);
  text += describe_model(file, model.structure);
  text += line("loads", fmt::format("{}, {} times", forces.empty() ? "none" : input_name(forces),
                                    loads.time.size()));
  text += line("method", result.summary.method);
  text += describe_ending(result.summary);
  text += line("steps", fmt::format("{}, {} reversals of joints, {} loops closed or slips begun",
                                    result.steps, result.reversals, result.kinks));
  if (!model.structure.static_loads().empty()) {
    text += line("begins", "at rest under the static loads of the model");
  }
  const LargestMotion& largest = result.largest.front();
  text += line("largest response",
               fmt::format("{:.5g} m, {:.5g} m/s, {:.5g} m/s^2 at '{}'", largest.displacement,
                           largest.velocity, largest.acceleration, model.response));
  if (const auto absolute = result.absolute_sizes(); !absolute.empty()) {
    text +=
        line("with its base", fmt::format("{:.5g} m, {:.5g} m/s, {:.5g} m/s^2", absolute[0].peak,
                                          absolute[1].peak, absolute[2].peak));
  }
  text += describe_energy(result.energy);
  if (result.error_estimate) {
    text += line("estimated error",
                 fmt::format("{:.2g} of the largest displacement", *result.error_estimate));
  }
  return text + draws + describe_damping(model) + describe_warnings(result.warnings);
}

}  // namespace microslip
