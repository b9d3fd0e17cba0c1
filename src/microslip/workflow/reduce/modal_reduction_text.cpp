// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/modal_reduction_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

std::vector<Warning> flags_of_modal(const std::vector<ModalLevel>& levels,
                                    std::size_t source_width) {
  std::vector<FlaggedRecord> records;
  for (const ModalLevel& level : levels) records.push_back({level.source, level.flags});
  return kinds_of(records, "levels", source_width);
}

std::vector<Warning> modal_levels_left_out(const ModalReductionBatch& batch) {
  std::vector<Warning> found;
  const auto negative = std::ranges::count_if(
      batch.levels, [](const ModalLevel& level) { return level.has_flag(kNegativeDissipation); });
  if (negative > 0) {
    found.push_back(
        {"levels_not_written", fmt::format("Not written because D is negative: {}", negative)});
  }
  for (const RejectedRecord& record : batch.rejected) {
    found.push_back({"left_out", "Left out: " + record.reason});
  }
  return found;
}

std::string share_text(const Measured& value) {
  return value.std > 0.0 ? fmt::format("{:.1g}", 100.0 * value.std / std::abs(value.value)) : "-";
}

std::string describe_modal_level(const ModalLevel& level) {
  constexpr std::size_t kWidth = 18;
  std::string text =
      fmt::format("  {:<{}} {:>4} {:9.4f} {:9.4g} {:10.4g} {:>5}", shortened(level.source, kWidth),
                  kWidth, level.mode, level.frequency.value, 1e6 * level.displacement.value,
                  1e6 * level.dissipation.value, share_text(level.dissipation));
  for (const JointLevel& joint : level.joints) {
    text += fmt::format(" {:9.4g} {:10.4g} {:>5}", 1e6 * joint.amplitude.value,
                        1e6 * joint.dissipation.value, share_text(joint.dissipation));
  }
  return text +
         fmt::format(" {:>5}\n", level.flags.empty() ? "" : std::to_string(level.flags.size()));
}

std::string describe_modes(const ModalReducer& reducer, const std::vector<ModalLevel>& levels) {
  std::string text;
  for (std::size_t mode = 1; mode <= reducer.stuck_frequencies().size(); ++mode) {
    const auto count =
        static_cast<std::size_t>(std::ranges::count(levels, mode, &ModalLevel::mode));
    if (count == 0) continue;
    text += line(fmt::format("mode {}", mode),
                 fmt::format("{}, {:.6g} Hz with stuck joints{}", counted(count, "level"),
                             reducer.stuck_frequencies()[mode - 1],
                             reducer.options().mode ? ", as specified" : ", the nearest"));
  }
  return text;
}

}  // namespace

std::string describe_modal_reduction(const ModalReducer& reducer,
                                     const ModalReductionBatch& batch) {
  std::string text =
      fmt::format("Reduction of {} by a model\n", counted(batch.levels.size(), "record"));
  std::string sensors;
  for (const PointSensor& sensor : reducer.test().accelerometers) {
    sensors += fmt::format("{}{} at {}", sensors.empty() ? "" : ", ", sensor.channel, sensor.point);
  }
  text += line("accelerometers", sensors);
  text += describe_modes(reducer, batch.levels);
  text += fmt::format("\n  {:<18} {:>4} {:>9} {:>9} {:>10} {:>5}", "source", "mode", "f [Hz]",
                      "x [µm]", "D [µJ]", "±[%]");
  for (const StructuralJoint& joint : reducer.test().structure.joints()) {
    text += fmt::format(" {:>9} {:>10} {:>5}", "A " + shortened(joint.name, 7), "D [µJ]", "±[%]");
  }
  text += fmt::format(" {:>5}\n", "flags");
  for (const ModalLevel& level : batch.levels) text += describe_modal_level(level);
  std::string more;
  for (const Warning& flag : flags_of_modal(batch.levels, 30)) {
    more += fmt::format("  {}\n    [{}]\n", flag.text, flag.code);
  }
  if (!more.empty()) more = "Flags\n" + more;
  for (const Warning& warning : modal_levels_left_out(batch)) more += warning.text + "\n";
  return more.empty() ? text : text + "\n" + more;
}

std::vector<Warning> modal_warnings(const ModalReductionBatch& batch) {
  std::vector<Warning> warnings = flags_of_modal(batch.levels, std::string::npos);
  std::ranges::move(modal_levels_left_out(batch), std::back_inserter(warnings));
  return warnings;
}

}  // namespace microslip
