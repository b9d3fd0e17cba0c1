// SPDX-License-Identifier: MIT
#include "reduction_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "report_text.hpp"

namespace microslip::app {
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

/// Each kind of flag once, with the text of the first level that has it.
std::string describe_flags(const std::vector<ReducedLevel>& levels) {
  std::vector<std::string> codes;
  std::string text;
  for (const ReducedLevel& level : levels) {
    for (const Warning& flag : level.flags) {
      if (std::ranges::find(codes, flag.code) != codes.end()) continue;
      codes.push_back(flag.code);
      const auto count = std::ranges::count_if(
          levels, [&](const ReducedLevel& other) { return other.has_flag(flag.code); });
      text += fmt::format("  {} ({} of {} levels, first {}):\n    {}\n", flag.code, count,
                          levels.size(), shortened(level.source, 30), flag.text);
    }
  }
  return text.empty() ? text : "Flags\n" + text;
}

std::string describe_left_out(const ReductionBatch& batch) {
  std::string text;
  const auto count = [&](std::string_view code) {
    return std::ranges::count_if(batch.levels,
                                 [&](const ReducedLevel& level) { return level.has_flag(code); });
  };
  if (const auto n = count(kNegativeDissipation); n > 0) {
    text += fmt::format("Not written, for their D is negative: {}\n", n);
  }
  if (const auto n = count(kInnerReversals); n > 0) {
    text += fmt::format(
        "Written, but left out by `microslip identify` for their inner reversals: {}\n", n);
  }
  const auto without_secant = std::ranges::count_if(
      batch.levels, [](const ReducedLevel& level) { return !level.secant_stiffness; });
  if (without_secant > 0 && static_cast<std::size_t>(without_secant) < batch.levels.size()) {
    text += fmt::format("Secant stiffnesses are not written: {} of the levels {} none\n",
                        without_secant, without_secant == 1 ? "has" : "have");
  }
  for (const RejectedRecord& record : batch.rejected) {
    text += fmt::format("Left out: {}\n", record.reason);
  }
  return text;
}

}  // namespace

std::string describe_reduction(const Reducer& reducer, const ReductionBatch& batch) {
  const std::size_t count = batch.levels.size();
  std::string text = fmt::format("Reduction of {} record{}\n{}", count, count == 1 ? "" : "s",
                                 describe_method(reducer));
  text += fmt::format("\n  {:<14} {:>8} {:>8} {:>8} {:>9} {:>10} {:>5} {:>5}\n", "source", "f [Hz]",
                      "F [N]", "a[m/s²]", "A [µm]", "D [µJ]", "±[%]", "flags");
  for (const ReducedLevel& level : batch.levels) text += describe_level(level);
  const std::string flags = describe_flags(batch.levels) + describe_left_out(batch);
  return flags.empty() ? text : text + "\n" + flags;
}

}  // namespace microslip::app
