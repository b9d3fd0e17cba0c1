// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/calibration_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "microslip/workflow/identify/calibration_columns.hpp"

namespace microslip {
namespace {

std::vector<double> numbers_of(const std::vector<std::size_t>& counts) {
  return {counts.begin(), counts.end()};
}

/// All columns but those that are not known at some level.
template <typename Record>
void add_where_known(const Record& record, const ResultColumn<Record>& column,
                     std::string_view name, CsvWriter& table) {
  const std::vector<double>& values = record.*column.values;
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) return;
  table.add_numbers(name, column.dimension, values);
}

void append_level(const JointAtLevel& at, JointOverLevels& joint) {
  joint.amplitude.push_back(at.amplitude);
  joint.measured_amplitude.push_back(at.measured_amplitude);
  joint.dissipation.push_back(at.dissipation.value);
  joint.dissipation_lower.push_back(at.dissipation.lower);
  joint.dissipation_upper.push_back(at.dissipation.upper);
}

/// The levels that the structure has; NaN where something is not known.
LevelsOfModes levels_of_modes(const CalibrationResult& found, const ModalLevels& levels,
                              const std::vector<std::string>& joints) {
  LevelsOfModes all;
  for (const std::string& name : joints) all.joints.push_back({.name = name});
  for (std::size_t i = 0; i < found.levels.size(); ++i) {
    const CalibratedLevel& level = found.levels[i];
    if (!level.found) continue;
    all.level.push_back(i + 1);
    all.mode.push_back(levels.mode[i] + 1);
    all.displacement.push_back(levels.displacement[i]);
    all.measured_frequency.push_back(level.measured_frequency);
    all.measured_frequency_std.push_back(ModalLevels::value(levels.frequency_std, i));
    all.frequency.push_back(level.frequency);
    all.frequency_residual.push_back(level.frequency_residual);
    all.measured_dissipation.push_back(level.measured_dissipation);
    all.measured_dissipation_std.push_back(level.measured_dissipation_std);
    all.dissipation.push_back(level.dissipation);
    all.residual.push_back(level.residual);
    all.measured_damping_ratio.push_back(ModalLevels::value(levels.damping_ratio, i));
    all.measured_damping_ratio_std.push_back(ModalLevels::value(levels.damping_ratio_std, i));
    all.damping_ratio.push_back(level.damping_ratio);
    for (std::size_t j = 0; j < joints.size(); ++j) append_level(level.joints[j], all.joints[j]);
  }
  return all;
}

DensityFound density_of(const CalibratedJoint& joint) {
  const double k = joint.stiffness.value;
  DensityFound found{.name = joint.name,
                     .slip_displacement = joint.slip_displacement,
                     .lower = joint.band.lower,
                     .upper = joint.band.upper,
                     .variance_reduction = joint.variance_reduction};
  for (const double at : joint.slip_displacement) found.slip_force.push_back(k * at);
  for (const double density : joint.density) found.density.push_back(density / (k * k));
  return found;
}

}  // namespace

CsvWriter calibration_table(const CalibrationResult& found, const ModalLevels& levels,
                            const std::vector<std::string>& joints) {
  const LevelsOfModes all = levels_of_modes(found, levels, joints);
  CsvWriter table;
  table.add_numbers("level", kDimensionless, numbers_of(all.level));
  table.add_numbers("mode", kDimensionless, numbers_of(all.mode));
  table.add_numbers("displacement", kLength, all.displacement);
  for (const auto& column : kLevelColumns) {
    add_where_known(all, column, column.name, table);
  }
  for (const JointOverLevels& joint : all.joints) {
    for (const auto& column : kJointColumns) {
      add_where_known(joint, column, std::string(column.name) + joint.name, table);
    }
  }
  return table;
}

CsvWriter identifiability_table(const CalibrationResult& found) {
  std::vector<std::string> name;
  DensityFound rows;
  for (const CalibratedJoint& joint : found.joints) {
    const DensityFound one = density_of(joint);
    name.insert(name.end(), one.slip_force.size(), one.name);
    for (const auto& column : kDensityColumns) {
      std::ranges::copy(one.*column.values, std::back_inserter(rows.*column.values));
    }
  }
  CsvWriter table;
  table.add_text("joint", name);
  for (const auto& column : kDensityColumns) {
    table.add_numbers(column.name, column.dimension, rows.*column.values);
  }
  return table;
}

}  // namespace microslip
