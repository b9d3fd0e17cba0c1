// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/calibration_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/config/named_value_access.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/identify/assembly_levels.hpp"
#include "microslip/workflow/results/sampled_curves.hpp"

namespace microslip {
namespace {

constexpr std::string_view kCalibrateAgain = "Write it again by microslip calibrate.";
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

/// Reads an object of a file of calibrate key by key, and names the one at fault.
class CalibrationKeys {
 public:
  /// @param object  its name in the file.
  CalibrationKeys(const NamedValues& values, const std::string& path, const char* object)
      : values_(values), path_(path), object_(object) {}

  [[nodiscard]] double number(std::string_view key) const {
    const std::optional<double> value = number_in(values_, key);
    if (!value) reject(key, "missing or not a number");
    return *value;
  }

  [[nodiscard]] std::string text(std::string_view key) const {
    const std::optional<std::string> value = text_in(values_, key);
    if (!value) reject(key, "missing or not a text");
    return *value;
  }

  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t count) const {
    std::vector<double> values = numbers_in(values_, key);
    check_count(key, values.size(), count);
    return values;
  }

  [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::size_t count) const {
    std::vector<std::string> values = texts_in(values_, key);
    check_count(key, values.size(), count);
    return values;
  }

 private:
  [[nodiscard]] std::string name_of(std::string_view key) const {
    return fmt::format("{}: {}.{}", path_, object_, key);
  }

  [[noreturn]] void reject(std::string_view key, const char* state) const {
    throw InputError(name_of(key), InputState{state}, "must be given",
                     std::string(kCalibrateAgain));
  }

  void check_count(std::string_view key, std::size_t found, std::size_t expected) const {
    if (found == expected) return;
    throw InputError(name_of(key), fmt::format("{} values", found),
                     fmt::format("must be {}, to match the other data", expected),
                     std::string(kCalibrateAgain));
  }

  const NamedValues& values_;
  const std::string& path_;
  const char* object_;
};

void add_joints(const NamedValues& values, const CalibrationKeys& keys,
                CalibrationSummary& summary) {
  const std::vector<std::string> name = texts_in(values, "joint");
  const std::size_t count = name.size();
  const std::vector<double> k = keys.numbers("stiffness_N_per_m", count);
  const std::vector<double> lower = keys.numbers("stiffness_lower_N_per_m", count);
  const std::vector<double> upper = keys.numbers("stiffness_upper_N_per_m", count);
  const std::vector<double> slipping = keys.numbers("slipping_share", count);
  const std::vector<double> freedom = keys.numbers("degrees_of_freedom", count);
  const std::vector<double> from = keys.numbers("covered_from_N", count);
  const std::vector<double> to = keys.numbers("covered_to_N", count);
  for (std::size_t j = 0; j < count; ++j) {
    summary.joints.push_back(
        {name[j], k[j], lower[j], upper[j], slipping[j], freedom[j], from[j], to[j]});
  }
}

void add_pairs(const NamedValues& values, const CalibrationKeys& keys,
               CalibrationSummary& summary) {
  const std::vector<std::string> first = texts_in(values, "pair_first");
  const std::size_t count = first.size();
  const std::vector<std::string> second = keys.texts("pair_second", count);
  const std::vector<double> correlation = keys.numbers("pair_correlation", count);
  const std::vector<double> alone = keys.numbers("pair_spread_alone", count);
  const std::vector<double> together = keys.numbers("pair_spread_together", count);
  const std::vector<std::string> verdict = keys.texts("pair_verdict", count);
  for (std::size_t i = 0; i < count; ++i) {
    summary.pairs.push_back({first[i], second[i], correlation[i], alone[i], together[i],
                             verdict[i] == "known_only_together"});
  }
}

void add_offsets(const NamedValues& values, const CalibrationKeys& keys,
                 CalibrationSummary& summary) {
  const std::vector<double> mode = numbers_in(values, "offset_mode");
  const std::vector<double> offset = keys.numbers("frequency_offset", mode.size());
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (!(mode[i] >= 1.0 && mode[i] <= kMostModes)) continue;
    summary.offsets.push_back({static_cast<std::size_t>(mode[i]), offset[i]});
  }
}

}  // namespace

LevelsOfModes calibrated_levels_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  LevelsOfModes levels = levels_with_modes(table);
  levels.measured_frequency = table.numbers_if_present("measured_frequency", kFrequency);
  levels.measured_frequency_std = table.numbers_if_present("measured_frequency_std", kFrequency);
  levels.frequency = table.numbers("frequency", kFrequency);
  levels.frequency_residual = table.numbers_if_present("frequency_residual", kDimensionless);
  levels.measured_dissipation = table.numbers_if_present("measured_dissipation", kEnergy);
  levels.measured_dissipation_std = table.numbers_if_present("measured_dissipation_std", kEnergy);
  levels.dissipation = table.numbers("dissipation", kEnergy);
  levels.residual = table.numbers_if_present("residual", kDimensionless);
  levels.measured_damping_ratio =
      table.numbers_if_present("measured_damping_ratio", kDimensionless);
  levels.measured_damping_ratio_std =
      table.numbers_if_present("measured_damping_ratio_std", kDimensionless);
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
  levels.measured_frequency = table.numbers_if_present("frequency", kFrequency);
  levels.measured_frequency_std = table.numbers_if_present("frequency_std", kFrequency);
  levels.measured_dissipation = table.numbers_if_present("dissipation", kEnergy);
  levels.measured_dissipation_std = table.numbers_if_present("dissipation_std", kEnergy);
  levels.measured_damping_ratio = table.numbers_if_present("damping_ratio", kDimensionless);
  levels.measured_damping_ratio_std = table.numbers_if_present("damping_ratio_std", kDimensionless);
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
  const std::vector<double> told =
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
    if (!(told[row] >= 0.0 && told[row] <= 1.0)) table.reject(row, "told", "from 0 to 1");
    of->told.push_back(told[row]);
  }
  return found;
}

DensityFound density_found_of(const std::string& name, const JointFile& file,
                              const std::string& path) {
  const NamedValues& said = file.identification;
  DensityFound found{.name = name, .slip_force = numbers_in(said, "band_slip_force_N")};
  const CalibrationKeys keys(said, path, "identification");
  const std::size_t count = found.slip_force.size();
  found.confidence = number_in(said, "band_confidence").value_or(found.confidence);
  if (count >= 2) {
    for (const double force : found.slip_force) {
      found.density.push_back(file.joint.density().density(force));
    }
    found.lower = keys.numbers("band_lower_per_N", count);
    found.upper = keys.numbers("band_upper_per_N", count);
    found.told = numbers_in(said, "told");
    if (!found.told.empty()) (void)keys.numbers("told", count);
    return found;
  }
  const double largest = file.joint.density().largest_slip_force();
  DensityPoints points = density_points(file.joint, 0.0, covered_to(file).value_or(largest));
  found.slip_force = std::move(points.slip_force);
  found.density = std::move(points.density);
  return found;
}

CalibrationSummary calibration_summary_of(const CalibrationFile& file, const std::string& path) {
  const NamedValues& values = file.calibration;
  const CalibrationKeys keys(values, path, "calibration");
  CalibrationSummary summary{
      .status = keys.text("status"),
      .levels = keys.number("levels"),
      .levels_found = keys.number("levels_found"),
      .confidence = keys.number("band_confidence"),
      .scatter = keys.number("scatter"),
      .scatter_is_relative = keys.text("scatter_of") == "dissipation",
      .frequency_scatter = keys.number("frequency_scatter"),
      .frequency_scatter_is_relative = keys.text("frequency_scatter_of") == "frequency",
      .known_in_sum = texts_in(values, "known_in_sum")};
  if (file.provenance) {
    summary.frequency_use = text_in(file.provenance->options, "frequency").value_or("");
  }
  add_joints(values, keys, summary);
  add_offsets(values, keys, summary);
  add_pairs(values, keys, summary);
  const std::vector<std::string> code = texts_in(values, "warnings");
  const std::vector<std::string> text = keys.texts("warning_texts", code.size());
  for (std::size_t i = 0; i < code.size(); ++i) summary.warnings.push_back({code[i], text[i]});
  return summary;
}

}  // namespace microslip
