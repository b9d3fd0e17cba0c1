// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/config/named_value_access.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/results/found_by_records.hpp"

namespace microslip {
namespace {

constexpr std::string_view kHashMark = ": sha256 ";

/// How λ was chosen, as far as the file tells.
std::string smoothing_of(const JointFile& file) {
  const std::optional<std::string> asked =
      file.provenance ? text_in(file.provenance->options, "smoothing") : std::nullopt;
  if (!asked) return {};
  return *asked == "gcv" ? "generalised cross-validation" : "as specified";
}

/// " N" of forces; other parameters have no unit, or one that the model gives.
std::string_view unit_after(std::string_view name) {
  return name.ends_with("force") || name == "to" ? " N" : "";
}

/// fitted_NAME with std_NAME, which is 0 where the best value is at the end of its range.
std::vector<std::pair<std::string, std::string>> parameters_in(const NamedValues& record) {
  constexpr std::string_view kFitted = "fitted_";
  std::vector<std::pair<std::string, std::string>> parameters;
  for (const auto& [key, value] : record) {
    if (!key.starts_with(kFitted) || !std::holds_alternative<double>(value)) continue;
    if (key.ends_with("linear_damping")) continue;  // shown with the parameters
    const std::string name = key.substr(kFitted.size());
    const std::optional<double> error = number_in(record, "std_" + name);
    std::string text = fmt::format("{:.4g}", std::get<double>(value));
    if (error && *error > 0.0) text += fmt::format(" ± {:.2g}", *error);
    text += unit_after(name);
    if (error == 0.0) text += " (at the end of its range)";
    parameters.emplace_back(name, std::move(text));
  }
  return parameters;
}

/// The ends of a band stand over its slip forces.
void check_band(const IdentifiedJoint& joint, const std::string& path) {
  const auto check = [&](std::string_view key, std::size_t size) {
    if (size == joint.band_slip_force.size()) return;
    throw InputError(
        fmt::format("{}: identification.{}", path, key), fmt::format("{} numbers", size),
        fmt::format("must be {}, one per value of band_slip_force_N", joint.band_slip_force.size()),
        "Identify the joint again with `bands`.");
  };
  check("band_lower_per_N", joint.band_lower.size());
  check("band_upper_per_N", joint.band_upper.size());
  for (std::size_t i = 0; i < joint.band_upper.size(); ++i) {
    if (joint.band_lower[i] <= joint.band_upper[i]) continue;
    throw InputError(
        fmt::format("{}: identification.band_upper_per_N[{}]", path, i),
        fmt::format("{} 1/N", joint.band_upper[i]),
        fmt::format("must be at least band_lower_per_N there, {}", joint.band_lower[i]),
        "Identify the joint again with `bands`.");
  }
}

}  // namespace

IdentifiedJoint joint_of(const JointFile& file, const std::string& path) {
  const NamedValues& record = file.identification;
  const std::optional<double> of_dissipation = number_in(record, "scatter_dissipation");
  IdentifiedJoint joint{.joint = file.joint,
                        .method = text_in(record, "method").value_or(""),
                        .status = text_in(record, "status").value_or(""),
                        .covered_from = number_in(record, "covered_from_N"),
                        .covered_to = number_in(record, "covered_to_N"),
                        .linear_damping = number_in(record, "linear_damping_J_per_m2"),
                        .warnings = texts_in(record, "warnings"),
                        .warning_texts = texts_in(record, "warning_texts"),
                        .by_records = found_by_records(file, path),
                        .verdicts = departures_of_levels(file, path),
                        .scatter = of_dissipation ? of_dissipation : number_in(record, "scatter"),
                        .scatter_is_relative = text_in(record, "scatter_of") != "dissipation_std",
                        .secant_scatter = number_in(record, "scatter_secant"),
                        .lambda = number_in(record, "lambda"),
                        .smoothing = smoothing_of(file),
                        .degrees_of_freedom = number_in(record, "degrees_of_freedom"),
                        .band_confidence = number_in(record, "band_confidence").value_or(0.95),
                        .band_slip_force = numbers_in(record, "band_slip_force_N"),
                        .band_lower = numbers_in(record, "band_lower_per_N"),
                        .band_upper = numbers_in(record, "band_upper_per_N")};
  if (!joint.lambda) joint.lambda = number_in(record, "lambda_m3");
  if (const auto model = text_in(record, "model")) joint.method = *model;
  if (joint.status.empty()) joint.status = kStatusNotTold;
  joint.parameters = parameters_in(record);
  check_band(joint, path);
  return joint;
}

std::vector<ChannelMisfit> comparisons_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  const std::vector<std::string> source = table.text("source");
  const std::vector<std::string> channel = table.text("channel");
  const std::vector<std::string> status = table.text("status");
  const auto numbers = [&](std::string_view name, const Dimension& dimension) {
    return table.numbers(name, dimension);
  };
  const std::vector<double> frequency = numbers("frequency", kFrequency);
  const std::vector<double> response = numbers("response_amplitude", kAcceleration);
  const std::vector<double> nrmse = numbers("NRMSE", kDimensionless);
  const std::vector<double> noise = numbers("noise_share", kDimensionless);
  const std::vector<double> ratio = numbers("amplitude_ratio", kDimensionless);
  const std::vector<double> phase = numbers("phase_error", kAngle);
  const std::vector<std::string> flags =
      table.has("flags") ? table.text("flags") : std::vector<std::string>(source.size());
  std::vector<ChannelMisfit> rows;
  for (std::size_t i = 0; i < source.size(); ++i) {
    rows.push_back({source[i], channel[i], status[i], frequency[i], response[i], nrmse[i], noise[i],
                    ratio[i], phase[i], flags[i]});
  }
  return rows;
}

std::vector<ForceControlLevel> force_control_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  const std::vector<std::string> level = table.text("level");
  const std::vector<double> response = table.numbers("response_amplitude", kAcceleration);
  std::vector<ForceControlLevel> rows;
  for (std::size_t i = 0; i < level.size(); ++i) {
    rows.push_back({fmt::format("{} ({:.3g} m/s²)", level[i], response[i]), response[i], {}, {}});
  }
  for (int n = 2; table.has(fmt::format("before_{}", n)); ++n) {
    const auto before = table.numbers(fmt::format("before_{}", n), kDimensionless);
    const auto after = table.numbers(fmt::format("after_{}", n), kDimensionless);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].before.push_back(before[i]);
      rows[i].after.push_back(after[i]);
    }
  }
  return rows;
}

std::optional<std::string> told_hash_of(const NamedInput& input, std::string_view name) {
  const CsvTable table(input.text, input.path);
  for (const std::string& line : table.comments()) {
    const std::size_t mark = line.rfind(kHashMark);
    if (mark == std::string::npos) continue;
    if (file_name(std::string_view(line).substr(0, mark)) == name) {
      return line.substr(mark + kHashMark.size());
    }
  }
  return std::nullopt;
}

std::vector<std::string> hashes_in(const NamedInput& input) {
  std::vector<std::string> hashes;
  const CsvTable table(input.text, input.path);
  for (const std::string& line : table.comments()) {
    const std::size_t mark = line.rfind(kHashMark);
    if (mark != std::string::npos) hashes.push_back(line.substr(mark + kHashMark.size()));
  }
  return hashes;
}

bool is_density_of(const DensityTable& table, const Joint& joint) {
  constexpr double kBelow = 1.0 - 1e-9;
  constexpr double kRounding = 1e-6;  // of the largest: digits that a table may leave out
  const double largest = std::ranges::max(table.density);
  const std::vector<double>& f = table.slip_force;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const bool step = (i > 0 && f[i - 1] == f[i]) || (i + 1 < f.size() && f[i + 1] == f[i]);
    if (step || f[i] == 0.0) continue;  // φ may be infinite at 0
    const double expected = joint.density().density(kBelow * f[i]);
    if (!(std::abs(table.density[i] - expected) <= kRounding * largest)) return false;
  }
  return true;
}

}  // namespace microslip
