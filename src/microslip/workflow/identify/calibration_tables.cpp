// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/calibration_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

/// Numbers of the levels that were found.
template <typename Read>
std::vector<double> of_found(const CalibrationResult& found, const Read& read) {
  std::vector<double> values;
  for (std::size_t i = 0; i < found.levels.size(); ++i) {
    if (found.levels[i].found) values.push_back(read(i, found.levels[i]));
  }
  return values;
}

void add_where_known(CsvWriter& table, const std::string& name, const Dimension& dimension,
                     const std::vector<double>& values) {
  if (std::ranges::any_of(values, [](double value) { return std::isnan(value); })) return;
  table.add_numbers(name, dimension, values);
}

void add_joint_columns(CsvWriter& table, const CalibrationResult& found, std::size_t joint,
                       const std::string& name) {
  const auto column = [&](const std::string& label, const Dimension& dimension, const auto& read) {
    add_where_known(table, label + name, dimension,
                    of_found(found, [&](std::size_t, const CalibratedLevel& level) {
                      return read(level.joints[joint]);
                    }));
  };
  column("amplitude_", kLength, [](const JointAtLevel& at) { return at.amplitude; });
  column("measured_amplitude_", kLength,
         [](const JointAtLevel& at) { return at.measured_amplitude; });
  column("dissipation_", kEnergy, [](const JointAtLevel& at) { return at.dissipation.value; });
  column("dissipation_lower_", kEnergy,
         [](const JointAtLevel& at) { return at.dissipation.lower; });
  column("dissipation_upper_", kEnergy,
         [](const JointAtLevel& at) { return at.dissipation.upper; });
}

}  // namespace

CsvWriter calibration_table(const CalibrationResult& found, const ModalLevels& levels,
                            const std::vector<std::string>& joints) {
  CsvWriter table;
  const auto add = [&](const std::string& name, const Dimension& dimension, const auto& read) {
    add_where_known(table, name, dimension, of_found(found, read));
  };
  using Level = CalibratedLevel;
  add("level", kDimensionless,
      [](std::size_t i, const Level&) { return static_cast<double>(i + 1); });
  add("mode", kDimensionless,
      [&](std::size_t i, const Level&) { return static_cast<double>(levels.mode[i] + 1); });
  add("displacement", kLength, [&](std::size_t i, const Level&) { return levels.displacement[i]; });
  add("measured_frequency", kFrequency,
      [](std::size_t, const Level& level) { return level.measured_frequency; });
  add("measured_frequency_std", kFrequency,
      [&](std::size_t i, const Level&) { return ModalLevels::value(levels.frequency_std, i); });
  add("frequency", kFrequency, [](std::size_t, const Level& level) { return level.frequency; });
  add("frequency_residual", kDimensionless,
      [](std::size_t, const Level& level) { return level.frequency_residual; });
  add("measured_dissipation", kEnergy,
      [](std::size_t, const Level& level) { return level.measured_dissipation; });
  add("measured_dissipation_std", kEnergy,
      [](std::size_t, const Level& level) { return level.measured_dissipation_std; });
  add("dissipation", kEnergy, [](std::size_t, const Level& level) { return level.dissipation; });
  add("residual", kDimensionless, [](std::size_t, const Level& level) { return level.residual; });
  add("measured_damping_ratio", kDimensionless,
      [&](std::size_t i, const Level&) { return ModalLevels::value(levels.damping_ratio, i); });
  add("measured_damping_ratio_std", kDimensionless,
      [&](std::size_t i, const Level&) { return ModalLevels::value(levels.damping_ratio_std, i); });
  add("damping_ratio", kDimensionless,
      [](std::size_t, const Level& level) { return level.damping_ratio; });
  for (std::size_t j = 0; j < joints.size(); ++j) add_joint_columns(table, found, j, joints[j]);
  return table;
}

CsvWriter identifiability_table(const CalibrationResult& found) {
  std::vector<std::string> name;
  std::vector<double> force;
  std::vector<double> displacement;
  std::vector<double> density;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<double> reduction;
  for (const CalibratedJoint& joint : found.joints) {
    const double k = joint.stiffness.value;
    for (std::size_t i = 0; i < joint.slip_displacement.size(); ++i) {
      name.push_back(joint.name);
      force.push_back(k * joint.slip_displacement[i]);
      displacement.push_back(joint.slip_displacement[i]);
      density.push_back(joint.density[i] / (k * k));
      lower.push_back(joint.band.lower[i]);
      upper.push_back(joint.band.upper[i]);
      reduction.push_back(joint.variance_reduction[i]);
    }
  }
  CsvWriter table;
  table.add_text("joint", name);
  table.add_numbers("slip_force", kForce, force);
  table.add_numbers("slip_displacement", kLength, displacement);
  table.add_numbers("density", kPerForce, density);
  table.add_numbers("lower", kPerForce, lower);
  table.add_numbers("upper", kPerForce, upper);
  table.add_numbers("told", kDimensionless, reduction);
  return table;
}

}  // namespace microslip
