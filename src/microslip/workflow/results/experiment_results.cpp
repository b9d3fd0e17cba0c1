// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/experiment_results.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_length(const char* name, std::size_t length, std::size_t levels) {
  if (length == 0 || length == levels) return;
  throw InputError(fmt::format("{}.size()", name), fmt::format("{}", length),
                   fmt::format("must be 0 or the {} of the levels", levels));
}

void check_lengths(const MeasuredLevels& test) {
  check_levels(test.levels);
  const std::size_t count = test.levels.size();
  check_length("source", test.source.size(), count);
  check_length("flags", test.flags.size(), count);
  check_length("frequency", test.frequency.size(), count);
  check_length("resonance_frequency", test.resonance_frequency.size(), count);
  check_length("force_amplitude", test.force_amplitude.size(), count);
  check_length("response_amplitude", test.response_amplitude.size(), count);
  check_length("input_energy", test.input_energy.size(), count);
  check_length("linear_dissipation", test.linear_dissipation.size(), count);
  check_length("force_distortion", test.force_distortion.size(), count);
  check_length("damping_ratio", test.damping_ratio.size(), count);
  check_length("left_out", test.left_out.size(), count);
}

void check_same(const std::string& name, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(name + ".size()", fmt::format("{}", length),
                   fmt::format("must be {}, that of the corresponding data", expected));
}

void check_lengths(const IdentifiedJoint& found) {
  check_same("band_lower", found.band_lower.size(), found.band_slip_force.size());
  check_same("band_upper", found.band_upper.size(), found.band_slip_force.size());
}

void check_lengths(const JointBackbone& backbone) {
  const std::size_t count = backbone.amplitude.size();
  check_same("backbone.frequency", backbone.frequency.size(), count);
  check_same("backbone.damping_ratio", backbone.damping_ratio.size(), count);
  if (backbone.vibration_energy.empty()) return;
  check_same("backbone.vibration_energy", backbone.vibration_energy.size(), count);
}

void check_lengths(const LevelRecord& record) {
  for (const SignalPair& signal : record.signals) {
    check_same(signal.name + ".recorded", signal.recorded.size(), signal.time.size());
    check_same(signal.name + ".other", signal.other.size(), signal.other_time.size());
  }
  for (const HarmonicsPair& channel : record.harmonics) {
    if (channel.other.empty()) continue;
    check_same(channel.name + ".other", channel.other.size(), channel.recorded.size());
  }
}

void check_lengths(const ForcePath& path) {
  const std::size_t count = path.time.size();
  check_same(path.source + ".displacement", path.displacement.size(), count);
  check_same(path.source + ".path", path.path.size(), count);
  check_same(path.source + ".force", path.force.size(), count);
  check_same(path.source + ".found", path.found.size(), count);
}

void check_lengths(const ConstantResponse& response) {
  check_same("force", response.force.size(), response.frequency.size());
  check_same("true_force", response.true_force.size(), response.true_frequency.size());
}

}  // namespace

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

void check_results(const ExperimentResults& results) {
  if (results.levels) check_lengths(*results.levels);
  if (results.true_levels) check_lengths(*results.true_levels);
  if (results.joint) check_lengths(*results.joint);
  if (results.backbone) check_lengths(*results.backbone);
  if (results.true_backbone) check_lengths(*results.true_backbone);
  for (const LevelRecord& record : results.records) check_lengths(record);
  for (const LevelRecord& record : results.predictions) check_lengths(record);
  for (const ForcePath& path : results.force_paths) check_lengths(path);
  for (const ConstantResponse& response : results.responses) check_lengths(response);
  for (const ForceControlLevel& level : results.force_control) {
    check_same("force_control.after", level.after.size(), level.before.size());
  }
}

}  // namespace microslip
