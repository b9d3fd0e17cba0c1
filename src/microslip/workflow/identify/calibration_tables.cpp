// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/calibration_tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/config/named_value_access.hpp"

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

/// One value or text of each.
template <typename Item, typename Read>
auto of_each(const std::vector<Item>& items, const Read& read) {
  std::vector<std::decay_t<std::invoke_result_t<Read, const Item&>>> values;
  for (const Item& item : items) values.push_back(std::invoke(read, item));
  return values;
}

/// Joint by joint, in the order of `joint`.
void add_joints_to(NamedValues& record, const CalibrationResult& found) {
  using Joint = CalibratedJoint;
  const auto add = [&](const char* key, const auto& read) {
    record.emplace_back(key, of_each(found.joints, read));
  };
  record.emplace_back("joint", list_of_texts(of_each(found.joints, &Joint::name)));
  add("stiffness_N_per_m", [](const Joint& joint) { return joint.stiffness.value; });
  add("stiffness_lower_N_per_m", [](const Joint& joint) { return joint.stiffness.lower; });
  add("stiffness_upper_N_per_m", [](const Joint& joint) { return joint.stiffness.upper; });
  add("slipping_share",
      [](const Joint& joint) { return 1.0 - joint.joint.density().elastic_remainder(); });
  add("degrees_of_freedom", &Joint::edf);
  add("loss_told", &Joint::loss_told);
  add("edges_evidence", &Joint::edges_evidence);
  add("covered_from_N",
      [](const Joint& joint) { return joint.joint.stiffness() * joint.least_amplitude; });
  add("covered_to_N",
      [](const Joint& joint) { return joint.joint.stiffness() * joint.largest_amplitude; });
}

/// Search for edges, and edge by edge those of all joints.
void add_edges_to(NamedValues& record, const CalibrationResult& found) {
  std::vector<std::string> names;
  std::vector<double> force;
  std::vector<double> deviation;
  for (const CalibratedJoint& joint : found.joints) {
    for (const DensityEdge& edge : joint.edges) {
      names.push_back(joint.name);
      force.push_back(edge.slip_force);
      deviation.push_back(edge.deviation);
    }
  }
  record.emplace_back("edges", found.edges_sought ? "sought" : "none");
  record.emplace_back("edge_joint", list_of_texts(names));
  record.emplace_back("edge_N", std::move(force));
  record.emplace_back("edge_std_N", std::move(deviation));
}

/// Modes without frequencies are left out.
void add_offsets_to(NamedValues& record, const CalibrationResult& found) {
  std::vector<double> mode;
  std::vector<double> offset;
  for (std::size_t m = 0; m < found.frequency_offset.size(); ++m) {
    if (std::isnan(found.frequency_offset[m])) continue;
    mode.push_back(static_cast<double>(m + 1));
    offset.push_back(found.frequency_offset[m]);
  }
  record.emplace_back("offset_mode", std::move(mode));
  record.emplace_back("frequency_offset", std::move(offset));
}

/// Pair by pair, and the group that is known in sum alone.
void add_pairs_to(NamedValues& record, const CalibrationResult& found) {
  const auto add_texts = [&](const char* key, const auto& items, const auto& read) {
    record.emplace_back(key, list_of_texts(of_each(items, read)));
  };
  const auto name = [&](std::size_t joint) { return found.joints[joint].name; };
  add_texts("pair_first", found.pairs, [&](const JointPair& pair) { return name(pair.first); });
  add_texts("pair_second", found.pairs, [&](const JointPair& pair) { return name(pair.second); });
  record.emplace_back("pair_correlation", of_each(found.pairs, &JointPair::correlation));
  record.emplace_back("pair_spread_alone", of_each(found.pairs, &JointPair::spread_alone));
  record.emplace_back("pair_spread_together", of_each(found.pairs, &JointPair::spread_together));
  add_texts("pair_verdict", found.pairs, [](const JointPair& pair) {
    return std::string(pair.known_only_together ? "known_only_together" : "told_apart");
  });
  add_texts("known_in_sum", found.known_in_sum, name);
}

}  // namespace

NamedValues record_of_calibration(const CalibrationResult& found) {
  NamedValues record;
  record.emplace_back("status", std::string(found.summary.status()));
  record.emplace_back("levels", static_cast<double>(found.levels.size()));
  record.emplace_back("levels_found", static_cast<double>(std::ranges::count_if(
                                          found.levels, &CalibratedLevel::found)));
  record.emplace_back("band_confidence", found.confidence);
  record.emplace_back("scatter", found.loss_scatter);
  record.emplace_back("scatter_of", found.loss_std_given ? "dissipation_std" : "dissipation");
  record.emplace_back("frequency_scatter", found.frequency_scatter);
  record.emplace_back("frequency_scatter_of",
                      found.frequency_std_given ? "frequency_std" : "frequency");
  add_joints_to(record, found);
  add_edges_to(record, found);
  add_offsets_to(record, found);
  add_pairs_to(record, found);
  add_warnings(found.warnings, record);
  return record;
}

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
  std::vector<double> told;
  for (const CalibratedJoint& joint : found.joints) {
    const double k = joint.stiffness.value;
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
  record.emplace_back("stiffness_N_per_m", joint.stiffness.value);
  record.emplace_back("band_stiffness_N_per_m",
                      std::vector<double>{joint.stiffness.lower, joint.stiffness.upper});
  record.emplace_back("elastic_stiffness_N_per_m", joint.elastic_stiffness.value);
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
  record.emplace_back("degrees_of_freedom", joint.edf);
  if (!joint.edges.empty()) {
    record.emplace_back("edges_N", of_each(joint.edges, &DensityEdge::slip_force));
    record.emplace_back("edges_std_N", of_each(joint.edges, &DensityEdge::deviation));
    record.emplace_back("edges_evidence", joint.edges_evidence);
  }
  add_warnings(found.warnings, record);
  return record;
}

}  // namespace microslip
