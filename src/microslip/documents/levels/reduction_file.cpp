// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/reduction_file.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "microslip/base/codes.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip {
namespace {

template <typename Value>
auto column(std::span<const ReducedLevel> levels, Value value) {
  std::vector<decltype(value(levels.front()))> values;
  values.reserve(levels.size());
  for (const ReducedLevel& level : levels) values.push_back(value(level));
  return values;
}

/// Nothing where one of them is not known.
template <typename Value>
std::vector<double> known_column(std::span<const ReducedLevel> levels, Value value) {
  std::vector<double> values = column(levels, value);
  if (!std::ranges::all_of(values, [](double v) { return v > 0.0; })) values.clear();
  return values;
}

Levels levels_of(std::span<const ReducedLevel> reduced) {
  Levels levels;
  levels.amplitude = column(reduced, [](const auto& level) { return level.amplitude.value; });
  levels.dissipation = column(reduced, [](const auto& level) { return level.dissipation.value; });
  levels.amplitude_std =
      known_column(reduced, [](const auto& level) { return level.amplitude.std; });
  levels.dissipation_std =
      known_column(reduced, [](const auto& level) { return level.dissipation.std; });
  const auto stiffness = [](const ReducedLevel& level) {
    return level.secant_stiffness.value_or(Measured{});
  };
  levels.secant_stiffness =
      known_column(reduced, [&](const auto& level) { return stiffness(level).value; });
  if (!levels.secant_stiffness.empty()) {
    levels.secant_stiffness_std =
        known_column(reduced, [&](const auto& level) { return stiffness(level).std; });
  }
  return levels;
}

std::string flags_of(const ReducedLevel& level) { return joined_codes(level.flags); }

}  // namespace

CsvWriter reduction_table(std::span<const ReducedLevel> levels) {
  CsvWriter writer = levels_table(levels_of(levels));
  const auto add = [&](std::string_view name, const Dimension& dimension, auto value) {
    writer.add_numbers(name, dimension, column(levels, value));
  };
  writer.add_text("source", column(levels, [](const auto& level) { return level.source; }));
  add("frequency", kFrequency, [](const auto& level) { return level.frequency; });
  add("resonance_frequency", kFrequency,
      [](const auto& level) { return level.resonance_frequency; });
  add("force_amplitude", kForce, [](const auto& level) { return level.force_amplitude; });
  add("response_amplitude", kAcceleration,
      [](const auto& level) { return level.response_amplitude; });
  add("input_energy", kEnergy, [](const auto& level) { return level.input_energy.value; });
  add("linear_dissipation", kEnergy, [](const auto& level) { return level.linear_dissipation; });
  const std::vector<double> damping =
      known_column(levels, [](const auto& level) { return level.damping_ratio; });
  if (!damping.empty()) writer.add_numbers("damping_ratio", kDimensionless, damping);
  add("force_distortion", kDimensionless, [](const auto& level) { return level.force_distortion; });
  add("reversals", kDimensionless,
      [](const auto& level) { return static_cast<double>(level.reversals); });
  writer.add_text("flags", column(levels, flags_of));
  return writer;
}

}  // namespace microslip
