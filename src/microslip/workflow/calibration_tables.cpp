// SPDX-License-Identifier: MIT
#include "microslip/workflow/calibration_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "microslip/io/joint_file.hpp"

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
  column("dissipation_", kEnergy, [](const JointAtLevel& at) { return at.dissipation.mean; });
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
  add("frequency", kFrequency, [](std::size_t, const Level& level) { return level.frequency; });
  add("frequency_residual", kDimensionless,
      [](std::size_t, const Level& level) { return level.frequency_residual; });
  add("measured_dissipation", kEnergy,
      [](std::size_t, const Level& level) { return level.measured_dissipation; });
  add("dissipation", kEnergy, [](std::size_t, const Level& level) { return level.dissipation; });
  add("residual", kDimensionless, [](std::size_t, const Level& level) { return level.residual; });
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
  std::vector<double> told;
  for (const CalibratedJoint& joint : found.joints) {
    const double k = joint.stiffness.mean;
    for (std::size_t i = 0; i < joint.slip_displacement.size(); ++i) {
      name.push_back(joint.name);
      force.push_back(k * joint.slip_displacement[i]);
      displacement.push_back(joint.slip_displacement[i]);
      density.push_back(joint.density[i] / (k * k));
      lower.push_back(joint.band.lower[i]);
      upper.push_back(joint.band.upper[i]);
      told.push_back(joint.told[i]);
    }
  }
  CsvWriter table;
  table.add_text("joint", name);
  table.add_numbers("slip_force", kForce, force);
  table.add_numbers("slip_displacement", kLength, displacement);
  table.add_numbers("density", kPerForce, density);
  table.add_numbers("lower", kPerForce, lower);
  table.add_numbers("upper", kPerForce, upper);
  table.add_numbers("told", kDimensionless, told);
  return table;
}

NamedValues record_of_calibration(const CalibrationResult& found, const CalibratedJoint& joint) {
  const double k = joint.joint.stiffness();
  std::vector<double> force;
  for (const double x : joint.slip_displacement) force.push_back(k * x);
  NamedValues record;
  record.emplace_back("method", "calibration");
  record.emplace_back("status", std::string(found.summary.status()));
  record.emplace_back("levels", static_cast<double>(found.levels.size()));
  record.emplace_back("covered_from_N", k * joint.least_amplitude);
  record.emplace_back("covered_to_N", k * joint.largest_amplitude);
  record.emplace_back("elastic_remainder", joint.joint.density().elastic_remainder());
  record.emplace_back("stiffness_N_per_m", joint.stiffness.mean);
  record.emplace_back("band_stiffness_N_per_m",
                      std::vector<double>{joint.stiffness.lower, joint.stiffness.upper});
  record.emplace_back("elastic_stiffness_N_per_m", joint.elastic_stiffness.mean);
  record.emplace_back(
      "band_elastic_stiffness_N_per_m",
      std::vector<double>{joint.elastic_stiffness.lower, joint.elastic_stiffness.upper});
  record.emplace_back("band_confidence", found.confidence);
  record.emplace_back("band_slip_force_N", std::move(force));
  record.emplace_back("band_lower_per_N", joint.band.lower);
  record.emplace_back("band_upper_per_N", joint.band.upper);
  record.emplace_back("band_samples", static_cast<double>(joint.draws.size()));
  record.emplace_back("told", joint.told);
  record.emplace_back("reference_exponent", joint.exponent);
  std::vector<std::string> codes;
  std::vector<std::string> texts;
  for (const Warning& warning : found.warnings) {
    codes.push_back(warning.code);
    texts.push_back(warning.text);
  }
  record.emplace_back("warnings", list_of_texts(codes));
  record.emplace_back("warning_texts", list_of_texts(texts));
  return record;
}

}  // namespace microslip
