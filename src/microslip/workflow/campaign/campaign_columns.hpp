// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/campaign/campaign_effects.hpp"
#include "microslip/workflow/text/table_cells.hpp"

/// @file
/// Columns of sessions.csv and conditions.csv, for writer and reader. Internal to workflow.

namespace microslip {

/// A column, by the member of a row that it holds. A mean has a second one, `NAME_std`.
template <typename Row>
struct RowColumn {
  std::string_view name;  ///< without unit
  Dimension dimension;    ///< of its values, in SI
  /// What it holds: a text, a count, a number, or a mean with its standard deviation.
  std::variant<std::string Row::*, std::size_t Row::*, double Row::*, ConditionMean Row::*> member;
};

/// The columns of SessionEffect, in their order. @param with_modes  of a model.
[[nodiscard]] std::vector<RowColumn<SessionEffect>> session_columns(bool with_modes);

/// Those of ConditionGroup behind the name of the condition.
[[nodiscard]] std::vector<RowColumn<ConditionGroup>> condition_columns();

/// Appends the columns to a table. Cells of NaN are empty.
template <typename Row>
void add_columns(const std::vector<RowColumn<Row>>& columns, std::span<const Row> rows,
                 CsvWriter& table) {
  const auto add = [&](const std::string& name, const Dimension& dimension, const auto& value) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(static_cast<double>(value(row)));
    table.add_numbers_or_empty(name, dimension, values);
  };
  for (const RowColumn<Row>& column : columns) {
    const std::string name(column.name);
    const auto put = [&](auto member) {
      using Value = std::remove_cvref_t<decltype(std::declval<Row>().*member)>;
      if constexpr (std::is_same_v<Value, std::string>) {
        std::vector<std::string> texts;
        for (const Row& row : rows) texts.push_back(row.*member);
        table.add_text(name, texts);
      } else if constexpr (std::is_same_v<Value, ConditionMean>) {
        add(name, column.dimension, [&](const Row& row) { return (row.*member).mean; });
        add(name + "_std", column.dimension, [&](const Row& row) { return (row.*member).sigma; });
      } else {
        add(name, column.dimension, [&](const Row& row) { return row.*member; });
      }
    };
    std::visit(put, column.member);
  }
}

/// Counts in a column. @throws FormatError  where it is missing, or a cell is no count.
[[nodiscard]] std::vector<std::size_t> counts_in(const CsvTable& table, const std::string& name);

/// Reads the columns back, one row of `Row` per row of the table. Empty cells are NaN.
/// @throws FormatError  where a column is missing or a cell wrong.
template <typename Row>
[[nodiscard]] std::vector<Row> read_columns(const std::vector<RowColumn<Row>>& columns,
                                            const CsvTable& table) {
  std::vector<Row> rows(table.rows());
  for (const RowColumn<Row>& column : columns) {
    const std::string name(column.name);
    const auto take = [&](auto member) {
      using Value = std::remove_cvref_t<decltype(std::declval<Row>().*member)>;
      const auto put = [&](const auto& values, const auto& place) {
        for (std::size_t i = 0; i < rows.size(); ++i) place(rows[i]) = values[i];
      };
      const auto whole = [&](Row& row) -> Value& { return row.*member; };
      if constexpr (std::is_same_v<Value, std::string>) {
        put(table.text(name), whole);
      } else if constexpr (std::is_same_v<Value, std::size_t>) {
        put(counts_in(table, name), whole);
      } else if constexpr (std::is_same_v<Value, double>) {
        put(numbers_or_empty(table, name), whole);
      } else {
        put(numbers_or_empty(table, name), [&](Row& row) -> double& { return (row.*member).mean; });
        put(numbers_or_empty(table, name + "_std"),
            [&](Row& row) -> double& { return (row.*member).sigma; });
      }
    };
    std::visit(take, column.member);
  }
  return rows;
}

}  // namespace microslip
