// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_columns.hpp"

#include "microslip/base/units.hpp"

namespace microslip {

std::vector<RowColumn<SessionEffect>> session_columns(bool with_modes) {
  using Row = SessionEffect;
  std::vector<RowColumn<Row>> columns{{"session", {}, &Row::name}};
  if (with_modes) columns.push_back({"mode", kDimensionless, &Row::mode});
  for (const RowColumn<Row>& column :
       {RowColumn<Row>{"tests", kDimensionless, &Row::tests},
        RowColumn<Row>{"levels", kDimensionless, &Row::levels},
        RowColumn<Row>{"frequency_difference", kDimensionless, &Row::frequency_difference},
        RowColumn<Row>{"frequency_difference_std", kDimensionless, &Row::frequency_difference_std},
        RowColumn<Row>{"frequency_offset", kDimensionless, &Row::frequency_offset},
        RowColumn<Row>{"frequency_offset_std", kDimensionless, &Row::frequency_offset_std},
        RowColumn<Row>{"frequency_scatter", kDimensionless, &Row::frequency_scatter},
        RowColumn<Row>{"dissipation_offset", kDimensionless, &Row::dissipation_offset},
        RowColumn<Row>{"dissipation_scatter", kDimensionless, &Row::dissipation_scatter}}) {
    columns.push_back(column);
  }
  return columns;
}

std::vector<RowColumn<ConditionGroup>> condition_columns() {
  using Row = ConditionGroup;
  return {{"value", {}, &Row::value},
          {"tests", kDimensionless, &Row::tests},
          {"levels", kDimensionless, &Row::levels},
          {"least_amplitude", kLength, &Row::least},
          {"largest_amplitude", kLength, &Row::largest},
          {"dissipation_offset", kDimensionless, &Row::dissipation},
          {"frequency_offset", kDimensionless, &Row::frequency}};
}

std::vector<std::size_t> counts_in(const CsvTable& table, const std::string& name) {
  constexpr double kMost = 1e9;
  const std::vector<double> values = table.numbers(name, kDimensionless);
  std::vector<std::size_t> counts;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(values[row] >= 0.0 && values[row] <= kMost)) table.reject(row, name, "a count");
    counts.push_back(static_cast<std::size_t>(values[row]));
  }
  return counts;
}

}  // namespace microslip
