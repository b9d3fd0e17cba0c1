// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/calibration_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/identify/assembly_levels.hpp"
#include "microslip/workflow/identify/calibration_columns.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

namespace microslip {
namespace {

constexpr double kMostModes = 1e6;

/// Of modal_levels.csv, of each joint.
constexpr std::array kMeasuredOfJoints{
    ResultColumn<JointOverLevels>{"amplitude_", kLength, &JointOverLevels::measured_amplitude},
    ResultColumn<JointOverLevels>{"dissipation_", kEnergy, &JointOverLevels::measured_dissipation},
};

/// Numbers of modes, from 1, and the displacement that is drawn over.
LevelsOfModes levels_with_modes(const CsvTable& table) {
  LevelsOfModes levels;
  const std::vector<double> mode = table.numbers("mode", kDimensionless);
  levels.displacement = table.numbers("displacement", kLength);
  for (std::size_t row = 0; row < mode.size(); ++row) {
    if (std::floor(mode[row]) != mode[row] || mode[row] < 1.0 || mode[row] > kMostModes) {
      table.reject(row, "mode", "the number of a mode, 1 or more");
    }
    if (!(levels.displacement[row] > 0.0)) {
      table.reject(row, "displacement", "a displacement above 0");
    }
    levels.mode.push_back(static_cast<std::size_t>(mode[row]));
  }
  return levels;
}

void add_joint_column(std::vector<JointOverLevels>& joints, const std::string& name,
                      std::vector<double> JointOverLevels::*column, std::vector<double> values) {
  auto joint = std::ranges::find(joints, name, &JointOverLevels::name);
  if (joint == joints.end()) joint = joints.insert(joints.end(), JointOverLevels{.name = name});
  (*joint).*column = std::move(values);
}

/// Columns of joints, each by the longest name that it begins with.
void add_joint_columns(const CsvTable& table,
                       std::span<const ResultColumn<JointOverLevels>> columns,
                       const std::vector<std::string_view>& not_joints, LevelsOfModes& levels) {
  for (const CsvColumn& column : table.columns()) {
    if (std::ranges::find(not_joints, column.name) != not_joints.end()) continue;
    const ResultColumn<JointOverLevels>* of = nullptr;
    for (const ResultColumn<JointOverLevels>& one : columns) {
      const bool fits = column.name.starts_with(one.name) && column.name.size() > one.name.size();
      if (fits && (of == nullptr || one.name.size() > of->name.size())) of = &one;
    }
    if (of == nullptr) continue;
    add_joint_column(levels.joints, column.name.substr(of->name.size()), of->values,
                     table.numbers(column.name, of->dimension));
  }
}

/// @param rows  of all joints. @param joint  of this row, with those before.
void check_density_row(const CsvTable& table, std::size_t row, const DensityFound& rows,
                       const DensityFound& joint) {
  if (!joint.slip_force.empty() && !(rows.slip_force[row] > joint.slip_force.back())) {
    table.reject(row, "slip_force", "rising slip forces of each joint");
  }
  if (rows.lower[row] > rows.upper[row]) table.reject(row, "lower", "at most `upper`");
  if (rows.variance_reduction.empty()) return;
  const double reduction = rows.variance_reduction[row];
  if (!(reduction >= 0.0 && reduction <= 1.0)) table.reject(row, "told", "from 0 to 1");
}

}  // namespace

LevelsOfModes calibrated_levels_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  LevelsOfModes levels = levels_with_modes(table);
  for (const auto& column : kLevelColumns) {
    const std::string name(column.name);
    levels.*column.values = column.needed ? table.numbers(name, column.dimension)
                                          : table.numbers_if_present(name, column.dimension);
  }
  add_joint_columns(table, kJointColumns, {}, levels);
  return levels;
}

LevelsOfModes modal_levels_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  LevelsOfModes levels = levels_with_modes(table);
  for (const auto& column : kLevelColumns) {
    if (!column.name.starts_with(kMeasured)) continue;
    levels.*column.values = table.numbers_if_present(
        std::string(column.name.substr(kMeasured.size())), column.dimension);
  }
  std::vector<std::string_view> not_joints;
  for (const CsvColumn& column : table.columns()) {
    if (column.name.ends_with("_std")) not_joints.emplace_back(column.name);
  }
  add_joint_columns(table, kMeasuredOfJoints, not_joints, levels);
  return levels;
}

std::vector<DensityFound> densities_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  const bool of_assemblies = table.has("assembly");
  const std::vector<std::string> joint = table.text(of_assemblies ? "assembly" : "joint");
  DensityFound rows;
  for (const auto& column : kDensityColumns) {
    if (of_assemblies && !column.needed) continue;
    rows.*column.values = table.numbers(std::string(column.name), column.dimension);
  }
  std::vector<DensityFound> found;
  for (std::size_t row = 0; row < joint.size(); ++row) {
    auto of = std::ranges::find(found, joint[row], &DensityFound::name);
    if (of == found.end()) of = found.insert(found.end(), DensityFound{.name = joint[row]});
    check_density_row(table, row, rows, *of);
    // Of assemblies one band is looked at, which all others are in.
    const bool has_band = !of_assemblies || joint[row] == kNextAssembly;
    for (const auto& column : kDensityColumns) {
      const bool of_band =
          column.values == &DensityFound::lower || column.values == &DensityFound::upper;
      const std::vector<double>& values = rows.*column.values;
      if (!values.empty() && (has_band || !of_band)) ((*of).*column.values).push_back(values[row]);
    }
  }
  return found;
}

DensityFound density_found_of(const std::string& name, const IdentifiedJoint& joint) {
  DensityFound found{.name = name};
  const SlipDensity& density = joint.joint.density();
  if (joint.band_slip_force.size() < 2) {
    const double largest = density.largest_slip_force();
    const double to = joint.covered_to.value_or(0.0) > 0.0 ? *joint.covered_to : largest;
    DensityPoints points = density_points(joint.joint, 0.0, to);
    found.slip_force = std::move(points.slip_force);
    found.density = std::move(points.density);
    return found;
  }
  found.slip_force = joint.band_slip_force;
  for (const double force : found.slip_force) found.density.push_back(density.density(force));
  found.lower = joint.band_lower;
  found.upper = joint.band_upper;
  found.confidence = joint.band_confidence;
  if (joint.by_calibration) found.variance_reduction = joint.by_calibration->variance_reduction;
  return found;
}

}  // namespace microslip
