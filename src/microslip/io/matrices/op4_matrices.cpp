// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/op4_matrices.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/matrices/op4_source.hpp"
#include "microslip/io/recordings/mat_tree.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kRowBits = 16;  // of a string's first integer, where it has the length, too
constexpr std::int64_t kBigRows = 65536;
constexpr std::int64_t kFormSymmetric = 6;
constexpr std::int64_t kFormIdentity = 8;  // of which no entries are there

bool is_taken(const Op4Header& header) {
  const std::int64_t rows = std::abs(header.rows);
  return header.type <= 2 && rows == header.columns && rows >= 1 &&
         rows <= static_cast<std::int64_t>(kMostDegreesOfFreedom) && header.form != kFormIdentity;
}

std::string words_of(const Op4Header& header) {
  return fmt::format("{}, {} × {}, of form {}", header.type > 2 ? "complex" : "real",
                     std::abs(header.rows), header.columns, header.form);
}

/// Reads the columns of one matrix after another.
class Op4Reader {
 public:
  explicit Op4Reader(Op4Source& source) : source_(source) {}

  /// @param keep  whether its entries are wanted.
  MatrixEntries columns(const Op4Header& header, bool keep) {
    header_ = header;
    keep_ = keep;
    entries_ = {.size = static_cast<std::size_t>(std::abs(header.rows)),
                .row = {},
                .column = {},
                .value = {}};
    std::int64_t last = 0;
    while (true) {
      const Op4Column column = source_.column();
      if (column.column > header.columns) break;
      if (column.column <= last || column.row < 0 || column.words < 0)
        fail("column", column.column);
      last = column.column;
      last_row_ = 0;
      if (column.row > 0) {
        add(column.column, column.row, source_.numbers_in(column.words, true));
      } else {
        add_strings(column);
      }
      source_.end_column();
    }
    source_.end_matrix();
    return std::move(entries_);
  }

 private:
  void add_strings(const Op4Column& column) {
    const bool big = header_.rows < 0 || header_.rows >= kBigRows;
    for (std::int64_t left = column.words; left > 0;) {
      const std::vector<std::int64_t> integers = source_.integers(big ? 2 : 1);
      const std::int64_t length = (big ? integers[0] : integers[0] >> kRowBits) - 1;
      const std::int64_t row = big ? integers[1] : integers[0] & (kBigRows - 1);
      if (length < 1 || row < 1) fail("string of column", column.column);
      left -= length + (big ? 2 : 1);
      add(column.column, row, source_.numbers_in(length, false));
    }
  }

  void add(std::int64_t column, std::int64_t row, std::size_t count) {
    const std::int64_t rows = std::abs(header_.rows);
    const auto entries = static_cast<std::int64_t>(count) / (header_.type > 2 ? 2 : 1);
    if (row <= last_row_ || row > rows || entries > rows - row + 1) fail("rows of column", column);
    last_row_ = row + entries - 1;
    const std::vector<double> values = source_.numbers(count);
    if (!keep_) return;
    for (std::size_t i = 0; i < count; ++i) {
      if (values[i] == 0.0) continue;
      entries_.row.push_back(static_cast<std::int32_t>(row - 1) + static_cast<std::int32_t>(i));
      entries_.column.push_back(static_cast<std::int32_t>(column - 1));
      entries_.value.push_back(values[i]);
    }
  }

  [[noreturn]] void fail(std::string_view what, std::int64_t column) const {
    throw FormatError(source_.place(),
                      fmt::format("matrix {} of {} columns and {} rows", header_.name,
                                  header_.columns, std::abs(header_.rows)),
                      fmt::format("{} {} beyond it", what, column),
                      "The file is damaged, or not of OUTPUT4.");
  }

  Op4Source& source_;
  Op4Header header_;
  bool keep_ = false;
  std::int64_t last_row_ = 0;  ///< of the column: strings rise
  MatrixEntries entries_ = {.size = 0, .row = {}, .column = {}, .value = {}};
};

std::unique_ptr<Op4Source> op4_source(std::string_view bytes, const std::string& file) {
  if (is_op4_binary(bytes)) return std::make_unique<Op4Binary>(bytes, file);
  return std::make_unique<Op4Text>(bytes, file);
}

SymmetricEntries symmetric_of(MatrixEntries entries, const Op4Header& header,
                              const std::string& name) {
  if (header.form == kFormSymmetric && !has_both_triangles(entries)) {
    return symmetric_of_triangle(std::move(entries), name);
  }
  return symmetric_of_both(entries, name, "A matrix of one triangle has form 6.");
}

}  // namespace

bool is_op4(std::string_view head) { return is_op4_binary(head) || is_op4_text(head); }

SymmetricEntries parse_op4(std::string_view bytes, std::string_view name, const std::string& file) {
  const std::string wanted = in_capitals(name);
  const std::unique_ptr<Op4Source> source = op4_source(bytes, file);
  Op4Reader reader(*source);
  std::vector<std::string> names;
  std::vector<std::string> taken;
  std::optional<Op4Header> chosen;
  MatrixEntries entries{.size = 0, .row = {}, .column = {}, .value = {}};
  while (const std::optional<Op4Header> header = source->header()) {
    const bool wants = wanted.empty() ? is_taken(*header) : header->name == wanted;
    names.push_back(header->name);
    if (is_taken(*header)) taken.push_back(header->name);
    if (wants && !is_taken(*header)) {
      throw InputError(fmt::format("{}: {}", file, header->name), words_of(*header),
                       header->form == kFormIdentity ? "must have its entries in the file"
                                                     : "must be real and square");
    }
    const bool first = wants && !chosen;
    if (wants && chosen && !wanted.empty()) {
      throw InputError(fmt::format("{}: {}", file, header->name), "twice", "must be there once");
    }
    MatrixEntries read = reader.columns(*header, first);
    if (!first) continue;
    chosen = *header;
    entries = std::move(read);
  }
  if (wanted.empty() && taken.size() != 1) {
    throw InputError(file, fmt::format("{} square matrices", taken.size()),
                     fmt::format("must be one; there is {}", list_of_names(names)),
                     taken.empty()
                         ? std::string()
                         : fmt::format("Name one after a colon, {}:{}.", file, taken.front()));
  }
  if (!chosen) {
    throw InputError(file, fmt::format("no matrix {}", wanted), "must be one of the file",
                     fmt::format("It has {}.", list_of_names(names)));
  }
  return symmetric_of(std::move(entries), *chosen, fmt::format("{}: {}", file, chosen->name));
}

SymmetricEntries read_op4(const std::string& path, std::string_view name) {
  const std::string bytes = read_file(path);
  return parse_op4(bytes, name, input_name(path));
}

}  // namespace microslip
