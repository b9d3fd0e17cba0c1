// SPDX-License-Identifier: MIT
#include "microslip/ensemble/ensemble_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "microslip/ensemble/sweep_jobs.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/io/output/write_error.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// Largest number of rows of a sweep: beyond it the values are only in the HDF5 file.
constexpr double kMostRows = 1e6;
/// Curves of a sweep with more values are in the HDF5 file alone.
constexpr std::size_t kMostValuesOfSweep = 16;
constexpr std::size_t kMostReasonsShown = 10;

/// The shortest text that reads back as the same; empty for what is none.
std::string number_text(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

/// A table of text, whose rows have units of their own.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> names)
      : names_(std::move(names)), columns_(names_.size()) {}

  void add(const std::vector<std::string>& row) {
    for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c].push_back(row[c]);
  }
  [[nodiscard]] std::size_t size() const { return columns_.front().size(); }

  void write_to(CsvWriter& table) const {
    for (std::size_t c = 0; c < columns_.size(); ++c) table.add_text(names_[c], columns_[c]);
  }

  void clear() {
    for (std::vector<std::string>& column : columns_) column.clear();
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
};

std::string axis_text(const EnsembleOutput& output) {
  if (output.axis.empty()) return "";
  return fmt::format("{} [{}]", output.axis_name, si_unit(output.axis_dimension));
}

void add_statistics(const GroupResult& group, TextTable& table) {
  std::size_t at = 0;
  for (const EnsembleOutput& output : group.group.outputs) {
    for (std::size_t i = 0; i < output.size(); ++i, ++at) {
      const ColumnStatistics& s = group.values[at];
      table.add({group.group.name, output.name, si_unit(output.dimension), axis_text(output),
                 output.axis.empty() ? "" : number_text(output.axis[i]), fmt::format("{}", s.count),
                 number_text(s.mean), number_text(s.std), number_text(s.minimum),
                 number_text(s.lower), number_text(s.median), number_text(s.upper),
                 number_text(s.maximum)});
    }
  }
}

/// Takes the text of a table piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// A table whose rows go on as soon as there is a block of them.
class BlockTable {
 public:
  BlockTable(std::vector<std::string> names, std::string comment, TextSink sink)
      : rows_(std::move(names)), comment_(std::move(comment)), sink_(std::move(sink)) {}

  void add(const std::vector<std::string>& row) {
    constexpr std::size_t kRowsOfBlock = 4096;
    rows_.add(row);
    if (rows_.size() >= kRowsOfBlock) flush();
  }

  /// The first block alone has the comment and the header.
  void flush() {
    if (rows_.size() == 0) return;
    CsvWriter block;
    if (!begun_) block.add_comment(comment_);
    rows_.write_to(block);
    const std::string text = block.str();
    sink_(begun_ ? std::string_view(text).substr(text.find('\n') + 1) : text);
    begun_ = true;
    rows_.clear();
  }

 private:
  TextTable rows_;
  std::string comment_;
  TextSink sink_;
  bool begun_ = false;
};

/// Rows of the outputs that are short.
void add_grid(const GroupResult& group, const RowPass& rows, BlockTable& table) {
  const std::vector<SweepAxis>& axes = group.group.grid;
  std::uint64_t job = 0;
  rows([&](std::span<const double> row) {
    const std::vector<double> place = values_at(axes, job++);
    std::size_t at = 0;
    for (const EnsembleOutput& output : group.group.outputs) {
      for (std::size_t i = 0; i < output.size(); ++i, ++at) {
        if (output.size() > kMostValuesOfSweep) continue;
        std::vector<std::string> cells{group.group.name, output.name, si_unit(output.dimension),
                                       axis_text(output),
                                       output.axis.empty() ? "" : number_text(output.axis[i])};
        std::ranges::transform(place, std::back_inserter(cells), number_text);
        cells.push_back(number_text(row[at]));
        table.add(cells);
      }
    }
  });
}

double rows_of_sweep(const EnsembleResult& result) {
  double rows = 0.0;
  for (const GroupResult& group : result.groups) {
    for (const EnsembleOutput& output : group.group.outputs) {
      if (output.size() > kMostValuesOfSweep) continue;
      rows += static_cast<double>(group.group.jobs) * static_cast<double>(output.size());
    }
  }
  return rows;
}

std::string failures_comment(const GroupResult& group) {
  std::string text = fmt::format("\n{}: {} jobs, {} failed", group.group.name, group.group.jobs,
                                 group.failed.count);
  for (std::size_t i = 0; i < std::min(group.failed.reasons.size(), kMostReasonsShown); ++i) {
    const FailedJobs::Reason& reason = group.failed.reasons[i];
    text += fmt::format("\nfailed: {}: {}, first number {}: {}", group.group.name, reason.count,
                        reason.first, reason.text);
  }
  return text;
}

std::string comment_of(const EnsembleResult& result, const std::string& command) {
  std::string text =
      heading_of(command) + fmt::format("\n{} of seed {}, {} % between lower and upper",
                                        result.kind, result.seed, 100.0 * result.confidence);
  for (const InputHash& input : result.inputs) {
    text += '\n' + hash_comment(input.file, input.sha256);
  }
  for (const std::string& note : result.notes) text += "\n" + note;
  for (const GroupResult& group : result.groups) text += failures_comment(group);
  return with_warnings(text, result.warnings);
}

TextTable statistics_table(const EnsembleResult& result) {
  TextTable rows({"group", "output", "unit", "axis", "at", "count", "mean", "std", "minimum",
                  "lower", "median", "upper", "maximum"});
  for (const GroupResult& group : result.groups) add_statistics(group, rows);
  return rows;
}

std::vector<std::string> grid_columns(const EnsembleResult& result) {
  std::vector<std::string> names{"group", "output", "unit", "axis", "at"};
  for (const SweepAxis& axis : result.groups.front().group.grid) {
    std::string name = axis.number;  // brackets would be those of a unit
    std::ranges::replace(name, '[', '(');
    std::ranges::replace(name, ']', ')');
    names.push_back(std::move(name));
  }
  names.emplace_back("value");
  return names;
}

void write_table(const EnsembleResult& result,
                 const std::function<RowPass(std::size_t group)>& rows_of,
                 const std::string& comment, const TextSink& sink) {
  const bool grid = !result.groups.front().group.grid.empty();
  const double rows = grid ? rows_of_sweep(result) : 0.0;
  if (grid && rows > 0.0 && rows <= kMostRows) {
    BlockTable table(grid_columns(result), comment, sink);
    for (std::size_t g = 0; g < result.groups.size(); ++g) {
      add_grid(result.groups[g], rows_of(g), table);
    }
    return table.flush();
  }
  CsvWriter table;
  table.add_comment(comment);
  if (grid) {
    table.add_comment("values of the grid are in the HDF5 file; these are over the whole grid");
  }
  statistics_table(result).write_to(table);
  sink(table.str());
}

}  // namespace

void add_ensemble_table(const EnsembleResult& result,
                        const std::function<RowPass(std::size_t group)>& rows_of,
                        const std::string& command, const std::string& path, OutputFiles& outputs) {
  const std::string comment = comment_of(result, command);
  if (path == "-") {
    std::string text;
    write_table(result, rows_of, comment, [&](std::string_view piece) { text += piece; });
    outputs.add(path, text);
    return;
  }
  try {
    FileOutput file(outputs.stage(path));
    write_table(result, rows_of, comment, [&](std::string_view piece) { file.write(piece); });
    file.close();
  } catch (const WriteError& error) {
    throw error.renamed(path);  // its own is that of a temporary file
  }
}

std::vector<Warning> ensemble_warnings(const EnsembleResult& result) {
  std::vector<Warning> warnings;
  for (const GroupResult& group : result.groups) {
    if (group.failed.count > 0) {
      warnings.push_back(
          {"jobs_failed", fmt::format("{} of {} jobs of '{}' failed and are in no quantile; the "
                                      "files give the reasons.",
                                      group.failed.count, group.group.jobs, group.group.name)});
    }
    std::size_t at = 0;
    for (const EnsembleOutput& output : group.group.outputs) {
      std::uint64_t least = group.group.jobs;
      for (std::size_t i = 0; i < output.size(); ++i) {
        least = std::min(least, group.values[at++].count);
      }
      const std::uint64_t there = group.group.jobs - group.failed.count;
      if (least < there) {
        warnings.push_back(
            {"values_missing",
             fmt::format("{} of {} jobs of '{}' have no {} somewhere: its quantiles are those of "
                         "the others.",
                         there - least, there, group.group.name, output.name)});
      }
    }
  }
  const double fewest = 2.0 / (1.0 - result.confidence);
  const auto few = std::ranges::find_if(result.groups, [&](const GroupResult& group) {
    return static_cast<double>(group.group.jobs) < fewest - 1e-6;
  });
  const bool grid = few != result.groups.end() && !few->group.grid.empty();
  if (few != result.groups.end() && !grid) {
    warnings.push_back(
        {"few_jobs", fmt::format("'{}' has {} jobs: none lies beyond its quantiles of {} %. "
                                 "Take {:.0f} or more.",
                                 few->group.name, few->group.jobs, 100.0 * result.confidence,
                                 std::ceil(fewest - 1e-6))});
  }
  return warnings;
}

}  // namespace microslip
