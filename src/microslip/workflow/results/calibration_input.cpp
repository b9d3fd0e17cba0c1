// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/calibration_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/identify/assembly_levels.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

namespace microslip {
namespace {

constexpr double kMostModes = 1e6;

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

/// A column whose name begins with `prefix` and goes on with that of a joint.
struct JointColumn {
  std::string_view prefix;
  const Dimension* dimension;
  std::vector<double> JointOverLevels::*values;
};

/// @param columns  longer prefixes before those that they begin with.
void add_joint_columns(const CsvTable& table, const std::vector<JointColumn>& columns,
                       const std::vector<std::string_view>& not_joints, LevelsOfModes& levels) {
  for (const CsvColumn& column : table.columns()) {
    if (std::ranges::find(not_joints, column.name) != not_joints.end()) continue;
    const auto is_of = [&](const JointColumn& of) {
      return column.name.starts_with(of.prefix) && column.name.size() > of.prefix.size();
    };
    const auto of = std::ranges::find_if(columns, is_of);
    if (of == columns.end()) continue;
    add_joint_column(levels.joints, column.name.substr(of->prefix.size()), of->values,
                     table.numbers(column.name, *of->dimension));
  }
}

/// Reads what was measured. @param prefix  of the names of these columns.
void read_measured(const CsvTable& table, const std::string& prefix, LevelsOfModes& levels) {
  const auto read = [&](const char* name, const Dimension& dimension) {
    return table.numbers_if_present(prefix + name, dimension);
  };
  levels.measured_frequency = read("frequency", kFrequency);
  levels.measured_frequency_std = read("frequency_std", kFrequency);
  levels.measured_dissipation = read("dissipation", kEnergy);
  levels.measured_dissipation_std = read("dissipation_std", kEnergy);
  levels.measured_damping_ratio = read("damping_ratio", kDimensionless);
  levels.measured_damping_ratio_std = read("damping_ratio_std", kDimensionless);
}

}  // namespace

LevelsOfModes calibrated_levels_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  LevelsOfModes levels = levels_with_modes(table);
  read_measured(table, "measured_", levels);
  levels.frequency = table.numbers("frequency", kFrequency);
  levels.frequency_residual = table.numbers_if_present("frequency_residual", kDimensionless);
  levels.dissipation = table.numbers("dissipation", kEnergy);
  levels.residual = table.numbers_if_present("residual", kDimensionless);
  levels.damping_ratio = table.numbers("damping_ratio", kDimensionless);
  add_joint_columns(table,
                    {{"measured_amplitude_", &kLength, &JointOverLevels::measured_amplitude},
                     {"amplitude_", &kLength, &JointOverLevels::amplitude},
                     {"dissipation_lower_", &kEnergy, &JointOverLevels::dissipation_lower},
                     {"dissipation_upper_", &kEnergy, &JointOverLevels::dissipation_upper},
                     {"dissipation_", &kEnergy, &JointOverLevels::dissipation}},
                    {}, levels);
  return levels;
}

LevelsOfModes modal_levels_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  LevelsOfModes levels = levels_with_modes(table);
  read_measured(table, "", levels);
  std::vector<std::string_view> not_joints;
  for (const CsvColumn& column : table.columns()) {
    if (column.name.ends_with("_std")) not_joints.emplace_back(column.name);
  }
  add_joint_columns(table,
                    {{"amplitude_", &kLength, &JointOverLevels::measured_amplitude},
                     {"dissipation_", &kEnergy, &JointOverLevels::measured_dissipation}},
                    not_joints, levels);
  return levels;
}

std::vector<DensityFound> densities_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  const bool of_assemblies = table.has("assembly");
  const std::vector<std::string> joint = table.text(of_assemblies ? "assembly" : "joint");
  const std::vector<double> force = table.numbers("slip_force", kForce);
  const std::vector<double> density = table.numbers("density", kPerForce);
  const std::vector<double> lower = table.numbers("lower", kPerForce);
  const std::vector<double> upper = table.numbers("upper", kPerForce);
  const std::vector<double> reduction =
      of_assemblies ? std::vector<double>{} : table.numbers("told", kDimensionless);
  std::vector<DensityFound> found;
  for (std::size_t row = 0; row < joint.size(); ++row) {
    auto of = std::ranges::find(found, joint[row], &DensityFound::name);
    if (of == found.end()) of = found.insert(found.end(), DensityFound{.name = joint[row]});
    if (!of->slip_force.empty() && !(force[row] > of->slip_force.back())) {
      table.reject(row, "slip_force", "rising slip forces of each joint");
    }
    if (lower[row] > upper[row]) table.reject(row, "lower", "at most `upper`");
    of->slip_force.push_back(force[row]);
    of->density.push_back(density[row]);
    // Of assemblies one band is looked at, which all others are in.
    if (!of_assemblies || joint[row] == kNextAssembly) {
      of->lower.push_back(lower[row]);
      of->upper.push_back(upper[row]);
    }
    if (of_assemblies) continue;
    if (!(reduction[row] >= 0.0 && reduction[row] <= 1.0)) table.reject(row, "told", "from 0 to 1");
    of->variance_reduction.push_back(reduction[row]);
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
