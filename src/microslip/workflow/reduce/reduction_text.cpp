// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/reduction_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

std::string describe_method(const Reducer& reducer) {
  const Rig& rig = reducer.rig();
  std::string displacement = "kinematics of the beam";
  if (rig.vibrometer && reducer.options().use_vibrometer) {
    const bool axial = rig.vibrometer->measures == RigVibrometer::Measures::kAxial;
    displacement = fmt::format("channel '{}'{}", rig.vibrometer->channel,
                               axial ? ", axial, with the rotation of the beam" : "");
  } else if (rig.modes()) {
    displacement = "modes of the structure";
  }
  std::string text = fmt::format("  {:<20} {}\n", "joint displacement", displacement);
  const bool by_test = rig.beam() && rig.test && reducer.options().modes == 0;
  text += fmt::format("  {:<20} {}{} in the stick state, from {:.2f} Hz\n", "modes",
                      reducer.state().modes(), by_test ? ", as in [test] of the rig," : "",
                      natural_frequency(reducer.state(), 0.0));
  if (reducer.state().stiffness > 0.0) {
    text += fmt::format("  {:<20} {:.5g} N/m\n", "k, stuck joint", reducer.state().stiffness);
  }
  return text;
}

std::string describe_level(const ReducedLevel& level) {
  constexpr std::size_t kSourceWidth = 14;
  const Measured& d = level.dissipation;
  const std::string scatter =
      d.std > 0.0 ? fmt::format("{:.1g}", 100.0 * d.std / std::abs(d.value)) : "-";
  return fmt::format("  {:<{}} {:8.3f} {:8.3g} {:8.3g} {:9.4g} {:10.4g} {:>5} {:>5}\n",
                     shortened(level.source, kSourceWidth), kSourceWidth, level.frequency,
                     level.force_amplitude, level.response_amplitude, 1e6 * level.amplitude.value,
                     1e6 * d.value, scatter,
                     level.flags.empty() ? "" : fmt::format("{}", level.flags.size()));
}

std::vector<Warning> flags_of(const std::vector<ReducedLevel>& levels, std::size_t source_width) {
  std::vector<FlaggedRecord> records;
  for (const ReducedLevel& level : levels) records.push_back({level.source, level.flags});
  return kinds_of(records, "levels", source_width);
}

std::string describe_flags(const std::vector<ReducedLevel>& levels) {
  std::string text;
  for (const Warning& flag : flags_of(levels, 30)) {
    text += fmt::format("  {}\n    [{}]\n", flag.text, flag.code);
  }
  return text.empty() ? text : "Flags\n" + text;
}

/// Warnings on levels that are not in the table, or will not be used.
std::vector<Warning> left_out(const ReductionBatch& batch) {
  std::vector<Warning> found;
  const auto count = [&](std::string_view code) {
    return std::ranges::count_if(batch.levels,
                                 [&](const ReducedLevel& level) { return level.has_flag(code); });
  };
  if (const auto n = count(kNegativeDissipation); n > 0) {
    found.push_back(
        {"levels_not_written", fmt::format("Not written because D is negative: {}", n)});
  }
  if (const auto n = count(kInnerReversals); n > 0) {
    found.push_back(
        {"levels_with_inner_reversals",
         fmt::format("Written, but left out of an identification because of inner reversals: {}",
                     n)});
  }
  const auto without_secant = std::ranges::count_if(
      batch.levels, [](const ReducedLevel& level) { return !level.secant_stiffness; });
  if (without_secant > 0 && static_cast<std::size_t>(without_secant) < batch.levels.size()) {
    found.push_back({"secant_not_written",
                     fmt::format("Secant stiffnesses are not written: {} of the levels {} none",
                                 without_secant, without_secant == 1 ? "has" : "have")});
  }
  for (const RejectedRecord& record : batch.rejected) {
    found.push_back({"left_out", "Left out: " + record.reason});
  }
  return found;
}

std::string describe_left_out(const ReductionBatch& batch) {
  std::string text;
  for (const Warning& warning : left_out(batch)) text += warning.text + "\n";
  return text;
}

}  // namespace

std::string describe_reduction(const Reducer& reducer, const ReductionBatch& batch) {
  std::string text = fmt::format("Reduction of {}\n{}", counted(batch.levels.size(), "record"),
                                 describe_method(reducer));
  text += fmt::format("\n  {:<14} {:>8} {:>8} {:>8} {:>9} {:>10} {:>5} {:>5}\n", "source", "f [Hz]",
                      "F [N]", "a[m/s²]", "A [µm]", "D [µJ]", "±[%]", "flags");
  for (const ReducedLevel& level : batch.levels) text += describe_level(level);
  const std::string flags = describe_flags(batch.levels) + describe_left_out(batch);
  return flags.empty() ? text : text + "\n" + flags;
}

std::vector<Warning> reduction_warnings(const ReductionBatch& batch) {
  std::vector<Warning> warnings = flags_of(batch.levels, std::string::npos);
  std::ranges::move(left_out(batch), std::back_inserter(warnings));
  return warnings;
}

}  // namespace microslip
