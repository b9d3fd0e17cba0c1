// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/modal_levels_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/tables/column_rules.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {
namespace {

/// Quantities of single joints, whose name follows.
constexpr std::array<std::string_view, 2> kOfJoints = {"amplitude_", "dissipation_"};

std::vector<std::size_t> read_modes(const CsvTable& table, std::size_t modes) {
  std::vector<std::size_t> numbers;
  const std::vector<double> values = table.numbers("mode", kDimensionless);
  for (std::size_t row = 0; row < values.size(); ++row) {
    const bool whole = std::floor(values[row]) == values[row];
    if (!whole || values[row] < 1.0 || values[row] > static_cast<double>(modes)) {
      table.reject(row, "mode",
                   fmt::format("a mode of the model, from 1 to {}, by frequency with all joints "
                               "stuck",
                               modes));
    }
    numbers.push_back(static_cast<std::size_t>(values[row]) - 1);
  }
  return numbers;
}

std::vector<double> non_negative_column(const CsvTable& table, const std::string& name,
                                        const Dimension& dimension) {
  std::vector<double> values = table.numbers_if_present(name, dimension);
  require_non_negative(table, name, values);
  return values;
}

JointLevels read_joint_columns(const CsvTable& table, const std::string& joint) {
  JointLevels levels{.name = joint};
  const std::string amplitude = "amplitude_" + joint;
  const std::string dissipation = "dissipation_" + joint;
  levels.amplitude = table.numbers_if_present(amplitude, kLength);
  require_positive(table, amplitude, levels.amplitude);
  levels.amplitude_std = non_negative_column(table, amplitude + "_std", kLength);
  levels.dissipation = non_negative_column(table, dissipation, kEnergy);
  levels.dissipation_std = non_negative_column(table, dissipation + "_std", kEnergy);
  return levels;
}

/// amplitude_x_std is of x, or the amplitude of a joint x_std: ambiguous.
void check_names_apart(const CsvTable& table, std::span<const std::string> joints) {
  for (const std::string& joint : joints) {
    const std::string other = joint + "_std";
    if (std::ranges::find(joints, other) == joints.end()) continue;
    for (const std::string_view quantity : kOfJoints) {
      const std::string column = std::string(quantity) + other;
      if (std::ranges::find(table.columns(), column, &CsvColumn::name) == table.columns().end()) {
        continue;
      }
      throw FormatError({table.file()}, "a column that belongs to one joint of the model",
                        fmt::format("{}, of joint {} or the standard deviation of {}",
                                    in_quotes(column), in_quotes(other), in_quotes(joint)),
                        "Rename one of the joints in the model.");
    }
  }
}

/// dissipation_std is that of all joints together: none may be called std.
void check_not_std(const CsvTable& table, std::span<const std::string> joints) {
  if (!table.has("dissipation_std") || std::ranges::find(joints, "std") == joints.end()) return;
  throw FormatError({table.file()}, "a column that belongs to one joint of the model",
                    "'dissipation_std', the loss of joint 'std' or a standard deviation",
                    "Rename the joint in the model.");
}

/// A column of a joint that the model does not have would be left alone in silence.
void check_joint_names(const CsvTable& table, std::span<const std::string> joints) {
  const std::vector<std::string_view> known(joints.begin(), joints.end());
  for (const CsvColumn& column : table.columns()) {
    for (const std::string_view quantity : kOfJoints) {
      if (!column.name.starts_with(quantity) || column.name == "dissipation_std") continue;
      std::string name = column.name.substr(quantity.size());
      if (name.ends_with("_std")) name.erase(name.size() - 4);
      if (std::ranges::find(joints, name) != joints.end()) continue;
      const std::string_view closest = closest_name(name, known);
      throw FormatError({table.file()},
                        fmt::format("columns of joints of the model: {}", fmt::join(joints, ", ")),
                        fmt::format("{} of joint {}", in_quotes(column.name), in_quotes(name)),
                        closest.empty() ? "Name the column after a joint, or remove it."
                                        : fmt::format("Did you mean {}{}?", quantity, closest));
    }
  }
}

void check_loss(const CsvTable& table, const ModalLevels& levels) {
  const bool of_joint = std::ranges::any_of(
      levels.joints, [](const JointLevels& joint) { return !joint.dissipation.empty(); });
  if (!levels.dissipation.empty() || !levels.damping_ratio.empty() || of_joint) return;
  throw FormatError(
      {table.file()}, "a column 'dissipation [J]' or 'damping_ratio [1]'", "neither",
      "dissipation is that of all joints together, damping_ratio includes the structure too.");
}

ModalLevels modal_levels_in(const CsvTable& table, std::span<const std::string> joints,
                            std::size_t modes) {
  ModalLevels levels;
  levels.mode = read_modes(table, modes);
  levels.displacement = table.numbers("displacement", kLength);
  require_positive(table, "displacement", levels.displacement, kRemedyForNoMotion);
  levels.displacement_std = non_negative_column(table, "displacement_std", kLength);
  levels.frequency = table.numbers_if_present("frequency", kFrequency);
  require_positive(table, "frequency", levels.frequency,
                   "Where it is not known at every level, remove the column.");
  levels.frequency_std = non_negative_column(table, "frequency_std", kFrequency);
  levels.dissipation = non_negative_column(table, "dissipation", kEnergy);
  levels.dissipation_std = non_negative_column(table, "dissipation_std", kEnergy);
  levels.damping_ratio = non_negative_column(table, "damping_ratio", kDimensionless);
  levels.damping_ratio_std = non_negative_column(table, "damping_ratio_std", kDimensionless);
  check_joint_names(table, joints);
  check_names_apart(table, joints);
  check_not_std(table, joints);
  for (const std::string& joint : joints) {
    JointLevels found = read_joint_columns(table, joint);
    if (!found.amplitude.empty() || !found.dissipation.empty()) {
      levels.joints.push_back(std::move(found));
    }
  }
  check_loss(table, levels);
  return levels;
}

std::vector<std::string> text_if_present(const CsvTable& table, std::string_view name) {
  return table.has(name) ? table.text(name) : std::vector<std::string>{};
}

}  // namespace

ModalLevels parse_modal_levels(std::string text, std::string_view file,
                               std::span<const std::string> joints, std::size_t modes) {
  return modal_levels_in(CsvTable(std::move(text), file), joints, modes);
}

LabelledModalLevels parse_labelled_modal_levels(std::string text, std::string_view file,
                                                std::span<const std::string> joints,
                                                std::size_t modes) {
  const CsvTable table(std::move(text), file);
  return {modal_levels_in(table, joints, modes), text_if_present(table, "source"),
          text_if_present(table, "flags")};
}

}  // namespace microslip
