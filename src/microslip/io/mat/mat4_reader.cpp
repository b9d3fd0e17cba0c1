// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat4_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "microslip/io/bytes/mat_text.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_numbers.hpp"
#include "microslip/io/mat/mat_variables.hpp"

namespace microslip {
namespace {

constexpr std::uint32_t kLongestName4 = 4096;

/// The header of a matrix. The digits of its type are the byte order, 0, how the numbers are stored
/// and what they are.
struct Mat4Header {
  std::uint32_t type = 0;
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  bool complex = false;
  bool swap = false;
  std::string name = {};

  [[nodiscard]] std::uint32_t storage() const { return type / 10 % 10; }
  [[nodiscard]] bool is_text() const { return type % 10 == 1; }
  [[nodiscard]] bool is_sparse() const { return type % 10 == 2; }
};

std::size_t bytes_of_storage(std::uint32_t storage) {
  constexpr std::array<std::size_t, 6> kBytes{8, 4, 4, 2, 2, 1};
  return kBytes.at(storage);
}

class Mat4Reader {
 public:
  Mat4Reader(MatFileStream& file, const MatReadOptions& options) : file_(file), options_(options) {}

  MatTree read() {
    return read_mat_variables(file_, options_, [this](MatValue& root) { read_variable(root); });
  }

 private:
  Mat4Header read_header() {
    Mat4Header header;
    header.type = read_value<std::uint32_t>(file_, false);
    // The digit of the byte order is known once the bytes are in order.
    constexpr std::uint32_t kLargestType = 5000;
    header.swap = header.type >= kLargestType;
    if (header.swap) header.type = byte_swapped(header.type);
    constexpr bool kLittle = std::endian::native == std::endian::little;
    const std::uint32_t order = header.swap == kLittle ? 1 : 0;
    if (header.type / 1000 != order || header.type / 100 % 10 != 0 || header.storage() > 5 ||
        header.type % 10 > 2) {
      file_.fail("a matrix of a MAT file of version 4", fmt::format("type {}", header.type));
    }
    header.rows = read_value<std::uint32_t>(file_, header.swap);
    header.columns = read_value<std::uint32_t>(file_, header.swap);
    header.complex = read_value<std::uint32_t>(file_, header.swap) != 0;
    const auto length = read_value<std::uint32_t>(file_, header.swap);
    if (length > kLongestName4) file_.fail("a name", fmt::format("one of {} bytes", length));
    header.name.resize(length);
    file_.read(header.name.data(), length);
    header.name = header.name.c_str();
    if (header.name.empty() || !is_plain_name(header.name)) {
      file_.fail("a name", in_quotes(header.name));
    }
    return header;
  }

  void read_variable(MatValue& root) {
    const Mat4Header header = read_header();
    names_.add(header.name, file_);
    if (names_.size() > kMostMatValues) file_.fail("a million variables at most", "more");
    const std::uint64_t count = std::uint64_t{header.rows} * header.columns;
    const std::size_t part = bytes_of_storage(header.storage());
    if (count > file_.at_most() / part / (header.complex ? 2 : 1)) {
      file_.fail_ended(fmt::format("{} × {} numbers", header.rows, header.columns));
    }
    MatValue value;
    if (options_.only && header.name != *options_.only) {
      value.sizes = {header.rows, header.columns};
      file_.skip(count * part * (header.complex ? 2 : 1));
    } else {
      value = read_content(header, count);
    }
    root.fields.push_back(header.name);
    root.children.push_back(std::move(value));
  }

  MatValue read_content(const Mat4Header& header, std::size_t count) {
    MatValue value;
    value.kind = MatValue::Kind::kNumbers;
    value.sizes = {header.rows, header.columns};
    read_numbers(header, count, value.real);
    if (header.complex) read_numbers(header, count, value.imaginary);
    if (header.is_text()) return text_of(value);
    return header.is_sparse() ? sparse_of(value) : value;
  }

  void read_numbers(const Mat4Header& header, std::size_t count, std::vector<double>& to) {
    switch (header.storage()) {
      case 0:
        return read_values<double>(file_, count, header.swap, to);
      case 1:
        return read_values<float>(file_, count, header.swap, to);
      case 2:
        return read_values<std::int32_t>(file_, count, header.swap, to);
      case 3:
        return read_values<std::int16_t>(file_, count, header.swap, to);
      case 4:
        return read_values<std::uint16_t>(file_, count, header.swap, to);
      default:
        return read_values<std::uint8_t>(file_, count, header.swap, to);
    }
  }

  MatValue text_of(const MatValue& numbers) const {
    MatValue value;
    value.kind = MatValue::Kind::kText;
    value.sizes = numbers.sizes;
    std::string bytes;
    for (const double number : numbers.real) {
      if (!(number >= 0.0 && number < 256.0)) file_.fail("characters", fmt::format("{}", number));
      bytes += static_cast<char>(static_cast<unsigned char>(number));
    }
    value.texts = text_rows_of_bytes(bytes, numbers.sizes.front());
    return value;
  }

  [[nodiscard]] std::int64_t index(double number, double most) const {
    if (number >= 0.0 && number <= most && number == std::floor(number)) {
      return static_cast<std::int64_t>(number);
    }
    file_.fail("indices of a sparse matrix", fmt::format("{}", number));
  }

  /// Rows of row, column and number, real and imaginary; the last one has the sizes.
  [[nodiscard]] MatValue sparse_of(const MatValue& table) const {
    const std::size_t lines = table.sizes[0];
    const std::size_t columns = table.sizes[1];
    if (lines == 0 || columns < 3 || columns > 4) {
      file_.fail("a sparse matrix of 3 or 4 columns", fmt::format("{} × {}", lines, columns));
    }
    const auto at = [&](std::size_t line, std::size_t column) {
      return table.real[column * lines + line];
    };
    constexpr double kLargestSize = 1 << 30;
    const std::int64_t rows = index(at(lines - 1, 0), kLargestSize);
    const std::int64_t width = index(at(lines - 1, 1), kLargestSize);
    if (width > static_cast<std::int64_t>(64 * lines + 1024)) {
      file_.fail("columns with numbers", fmt::format("{} columns", width));
    }
    MatValue value;
    value.kind = MatValue::Kind::kSparse;
    value.sizes = {static_cast<std::size_t>(rows), static_cast<std::size_t>(width)};
    value.column_start.assign(value.sizes[1] + 1, 0);
    std::vector<std::size_t> order(lines - 1);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::size_t line) { return at(line, 1); });
    for (const std::size_t line : order) {
      value.row.push_back(index(at(line, 0) - 1, static_cast<double>(rows) - 1));
      const std::int64_t column = index(at(line, 1) - 1, static_cast<double>(width) - 1);
      ++value.column_start[static_cast<std::size_t>(column) + 1];
      value.real.push_back(at(line, 2));
      if (columns == 4) value.imaginary.push_back(at(line, 3));
    }
    std::partial_sum(value.column_start.begin(), value.column_start.end(),
                     value.column_start.begin());
    const std::string fault = checked_sparse(value);
    if (!fault.empty()) file_.fail("a sparse matrix", fault);
    return value;
  }

  MatFileStream& file_;
  const MatReadOptions& options_;
  MatNames names_;
};

}  // namespace

MatTree read_mat4(MatFileStream& file, const MatReadOptions& options) {
  return Mat4Reader(file, options).read();
}

}  // namespace microslip
