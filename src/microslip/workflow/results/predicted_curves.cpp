// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/predicted_curves.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/text/table_cells.hpp"

namespace microslip {
namespace {

/// The least and the largest that may be meant become one curve: from the lower edge of the one to
/// the upper edge of the other.
void join_edges(std::vector<EnsembleCurve>& curves) {
  constexpr std::string_view kLower = "_lower";
  for (std::size_t i = 0; i + 1 < curves.size(); ++i) {
    EnsembleCurve& low = curves[i];
    if (!low.output.ends_with(kLower)) continue;
    const std::string stem = low.output.substr(0, low.output.size() - kLower.size());
    const EnsembleCurve& high = curves[i + 1];
    if (high.group != low.group || high.output != stem + "_upper" || high.at != low.at) continue;
    low.output = stem;
    low.band.upper = high.band.upper;
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
}

/// Quantity of a column of a march: "NAME force" of a joint, "force at POINT", "velocity".
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
  const bool shaken = table.has("base_acceleration");
  const Dimension drive = shaken ? kAcceleration : kForce;
  PredictedResponse response{.frequency = table.numbers("frequency", kFrequency),
                             .force = table.numbers(shaken ? "base_acceleration" : "force", drive),
                             .displacement = table.numbers("displacement", kLength),
                             .phase = table.numbers("phase", kAngle),
                             .shaken = shaken};
  response.band = band_columns(table, "", is_same_all_along(response.force) ? kLength : drive);
  return response;
}

PredictedBackbone predicted_backbone(const CsvTable& table) {
  return {.displacement = table.numbers("displacement", kLength),
          .frequency = table.numbers("frequency", kFrequency),
          .damping_ratio = table.numbers("damping_ratio", kDimensionless),
          .frequency_band = band_columns(table, "frequency", kFrequency),
          .damping_band = band_columns(table, "damping_ratio", kDimensionless)};
}

ShockSpectrum shock_spectrum(const CsvTable& table) {
  return {.frequency = table.numbers("frequency", kFrequency),
          .maximax = table.numbers("maximax", kAcceleration),
          .positive = table.numbers("positive", kAcceleration),
          .negative = table.numbers("negative", kAcceleration)};
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

std::vector<EnsembleCurve> ensemble_curves(const CsvTable& table) {
  std::vector<EnsembleCurve> curves;
  if (!table.has("median")) return curves;
  const std::vector<std::string> group = table.text("group");
  const std::vector<std::string> output = table.text("output");
  const std::vector<std::string> unit = table.text("unit");
  const std::vector<std::string> axis = table.text("axis");
  const std::vector<double> at = numbers_or_empty(table, "at");
  const std::vector<double> median = numbers_or_empty(table, "median");
  const std::vector<double> lower = numbers_or_empty(table, "lower");
  const std::vector<double> upper = numbers_or_empty(table, "upper");
  const std::vector<double> count = numbers_or_empty(table, "count");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool same =
        !curves.empty() && curves.back().group == group[row] && curves.back().output == output[row];
    if (!same) {
      const auto [name, axis_unit] = name_and_unit(axis[row]);
      curves.push_back({group[row], output[row], unit[row], name, axis_unit});
    }
    EnsembleCurve& curve = curves.back();
    curve.at.push_back(at[row]);
    curve.median.push_back(median[row]);
    curve.band.lower.push_back(lower[row]);
    curve.band.upper.push_back(upper[row]);
    curve.count.push_back(count[row]);
  }
  join_edges(curves);
  return curves;
}

}  // namespace microslip
