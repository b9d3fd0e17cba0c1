// SPDX-License-Identifier: MIT
#include "microslip/workflow/predicted_curves.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/csv.hpp"

namespace microslip {
namespace {

/// What a column of a march shows: "NAME force" of a joint, "force at POINT", "velocity".
HistorySignal named_signal(const std::string& column) {
  for (const std::string quantity : {"displacement", "force"}) {
    const std::string ending = " " + quantity;
    if (column.ends_with(ending)) {
      return {column.substr(0, column.size() - ending.size()), "joint " + quantity, "", {}, {}};
    }
  }
  return {column, column.starts_with("force at ") ? "force" : column, "", {}, {}};
}

/// A column of a band belongs to the one that it is a band of.
bool is_edge(const CsvTable& table, const std::string& column) {
  for (const std::string_view ending : {"_lower", "_upper"}) {
    if (column.ends_with(ending) && table.has(column.substr(0, column.size() - ending.size()))) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool is_same_all_along(const std::vector<double>& values) {
  constexpr double kSame = 1e-6;
  if (values.empty()) return true;
  const auto [lowest, highest] = std::ranges::minmax(values);
  return highest - lowest <= kSame * highest;
}

CurveBand band_columns(const CsvTable& table, const std::string& name, const Dimension& dimension) {
  const std::string prefix = name.empty() ? "" : name + "_";
  if (!table.has(prefix + "lower") && !table.has(prefix + "upper")) return {};
  CurveBand band{table.numbers(prefix + "lower", dimension),
                 table.numbers(prefix + "upper", dimension)};
  return band;
}

PredictedResponse predicted_response(const CsvTable& table) {
  PredictedResponse response{.frequency = table.numbers("frequency", kFrequency),
                             .force = table.numbers("force", kForce),
                             .displacement = table.numbers("displacement", kLength),
                             .phase = table.numbers("phase", kAngle)};
  response.band = band_columns(table, "", is_same_all_along(response.force) ? kLength : kForce);
  return response;
}

PredictedBackbone predicted_backbone(const CsvTable& table) {
  return {.displacement = table.numbers("displacement", kLength),
          .frequency = table.numbers("frequency", kFrequency),
          .damping_ratio = table.numbers("damping_ratio", kDimensionless),
          .frequency_band = band_columns(table, "frequency", kFrequency),
          .damping_band = band_columns(table, "damping_ratio", kDimensionless)};
}

DissipationCurve dissipation_curve(const CsvTable& table) {
  return {.amplitude = table.numbers("amplitude", kLength),
          .dissipation = table.numbers("dissipation", kEnergy),
          .secant_stiffness = table.numbers("secant_stiffness", kStiffness),
          .loss_factor = table.numbers("loss_factor", kDimensionless),
          .dissipation_band = band_columns(table, "dissipation", kEnergy),
          .secant_band = band_columns(table, "secant_stiffness", kStiffness),
          .loss_band = band_columns(table, "loss_factor", kDimensionless)};
}

std::vector<HistorySignal> marched_histories(const CsvTable& table) {
  std::vector<HistorySignal> signals;
  const std::vector<double> time = table.numbers("time", kTime);
  for (const CsvColumn& column : table.columns()) {
    const std::optional<Unit> unit = find_unit(column.unit.value_or(""));
    if (column.name == "time" || !unit || is_edge(table, column.name)) continue;
    HistorySignal signal = named_signal(column.name);
    signal.unit = si_unit(unit->dimension);
    signal.time = time;
    signal.values = table.numbers(column.name, unit->dimension);
    signal.band = band_columns(table, column.name, unit->dimension);
    signals.push_back(std::move(signal));
  }
  return signals;
}

}  // namespace microslip
