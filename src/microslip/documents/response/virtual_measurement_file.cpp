// SPDX-License-Identifier: MIT
#include "microslip/documents/response/virtual_measurement_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/reduction_file.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

using FoundLevels = std::vector<const VirtualLevel*>;

FoundLevels found_levels(std::span<const VirtualLevel> levels) {
  FoundLevels found;
  for (const VirtualLevel& level : levels) {
    if (level.summary.converged()) found.push_back(&level);
  }
  if (!found.empty()) return found;
  throw InputError("levels of the test", "none found", "must have at least one",
                   levels.empty() ? "" : levels.front().summary.reason);
}

/// √(Σ_{n≥2} |F_n|²)/|F_1|, as the reduction has it.
double sum_of_distortion(const DrivenVibration& driven) {
  double square = 0.0;
  for (std::size_t n = 2; n < driven.force.size(); ++n) square += std::norm(driven.force[n]);
  return std::sqrt(square) / std::abs(driven.force[1]);
}

ReducedLevel truth_of(const VirtualLevel& level, const Joint& joint, const std::string& source) {
  const SteadyVibration& vibration = level.controlled.vibration;
  const JointCycle& cycle = vibration.joints.front();
  ReducedLevel truth;
  truth.source = source;
  truth.frequency = level.frequency;
  truth.resonance_frequency = level.resonance_frequency;
  truth.force_amplitude = vibration.force_amplitude;
  truth.response_amplitude = vibration.response;
  truth.amplitude.value = cycle.amplitude;
  truth.dissipation.value = cycle.dissipation;
  truth.input_energy.value = vibration.input_energy;
  truth.linear_dissipation = vibration.linear_dissipation;
  truth.secant_stiffness = Measured{secant_stiffness(joint, cycle.amplitude), 0.0};
  truth.force_distortion = sum_of_distortion(level.controlled);
  truth.reversals = cycle.reversals;
  truth.flags = level.warnings;
  return truth;
}

void add_missing(std::span<const VirtualLevel> levels, CsvWriter& table) {
  for (const VirtualLevel& level : levels) {
    if (level.summary.converged()) continue;
    table.add_comment(fmt::format("not found: level {}, {:.6g} m/s^2: {}", level.number,
                                  level.response, level.summary.reason));
  }
}

template <typename Value>
void add_column(CsvWriter& table, const std::string& name, const Dimension& dimension,
                const FoundLevels& levels, Value value) {
  std::vector<double> values;
  for (const VirtualLevel* level : levels) values.push_back(value(*level));
  table.add_numbers(name, dimension, values);
}

double harmonic_share(const DrivenVibration& driven, std::size_t n) {
  return n < driven.force.size() ? std::abs(driven.force[n]) / std::abs(driven.force[1]) : 0.0;
}

}  // namespace

CsvWriter truth_table(std::span<const VirtualLevel> levels, const Joint& joint,
                      std::span<const std::string> sources) {
  if (sources.size() != levels.size()) {
    throw InputError("sources", static_cast<double>(sources.size()),
                     fmt::format("must be one per level, {}", levels.size()));
  }
  const FoundLevels found = found_levels(levels);
  std::vector<ReducedLevel> truth;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].summary.converged()) truth.push_back(truth_of(levels[i], joint, sources[i]));
  }
  CsvWriter table = reduction_table(truth);
  add_column(table, "mean_displacement", kLength, found, [](const VirtualLevel& level) {
    return level.controlled.vibration.joints.front().displacement.front().real();
  });
  add_missing(levels, table);
  return table;
}

CsvWriter force_control_table(std::span<const VirtualLevel> levels, std::size_t harmonics) {
  const FoundLevels found = found_levels(levels);
  for (const VirtualLevel* level : found) {
    if (!level->uncontrolled.voltage.empty()) continue;
    throw InputError("levels of the test", "a pure force", "must have a shaker");
  }
  CsvWriter table;
  const auto add = [&](const std::string& name, const Dimension& dimension, auto value) {
    add_column(table, name, dimension, found, value);
  };
  add("level", kDimensionless,
      [](const VirtualLevel& level) { return static_cast<double>(level.number); });
  add("response_amplitude", kAcceleration,
      [](const VirtualLevel& level) { return level.controlled.vibration.response; });
  add("frequency", kFrequency, [](const VirtualLevel& level) { return level.frequency; });
  add("control_iterations", kDimensionless,
      [](const VirtualLevel& level) { return static_cast<double>(level.control_iterations); });
  add("force_before", kForce,
      [](const VirtualLevel& level) { return level.uncontrolled.vibration.force_amplitude; });
  add("force_after", kForce,
      [](const VirtualLevel& level) { return level.controlled.vibration.force_amplitude; });
  for (std::size_t n = 2; n <= harmonics; ++n) {
    add(fmt::format("before_{}", n), kDimensionless,
        [n](const VirtualLevel& level) { return harmonic_share(level.uncontrolled, n); });
  }
  for (std::size_t n = 2; n <= harmonics; ++n) {
    add(fmt::format("after_{}", n), kDimensionless,
        [n](const VirtualLevel& level) { return harmonic_share(level.controlled, n); });
  }
  add_missing(levels, table);
  return table;
}

}  // namespace microslip
