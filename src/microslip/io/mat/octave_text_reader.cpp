// SPDX-License-Identifier: MIT
#include "microslip/io/mat/octave_text_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/mat_text.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

using Kind = MatValue::Kind;

/// The text ends within a variable.
class TextEnded : public FormatError {
 public:
  using FormatError::FormatError;
};

class OctaveText {
 public:
  OctaveText(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  MatTree read(bool allow_truncated) {
    MatTree tree;
    tree.root.kind = Kind::kStruct;
    tree.root.sizes = {1, 1};
    std::set<std::string, std::less<>> taken;
    try {
      while (go_to_entry("name")) {
        std::string name(entry("name"));
        MatValue value = read_value(0);
        if (!is_plain_name(name) || name.empty()) fail("a name", in_quotes(name));
        if (!taken.insert(name).second) fail("each variable once", in_quotes(name) + " twice");
        tree.root.fields.push_back(std::move(name));
        tree.root.children.push_back(std::move(value));
      }
    } catch (const TextEnded&) {
      if (!allow_truncated) throw;
      tree.truncated = true;
    }
    return tree;
  }

 private:
  [[nodiscard]] TextPlace place() const {
    const auto line =
        std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    return {path_, static_cast<std::size_t>(line) + 1, 0};
  }

  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    throw FormatError(place(), expected, found, "The file is damaged; save or copy it again.");
  }

  [[noreturn]] void fail_ended(std::string_view expected) const {
    throw TextEnded(place(), expected, "the end of the file",
                    "It is truncated; copy it again, or read what is left with `allow_truncated`.");
  }

  [[nodiscard]] std::size_t left() const { return text_.size() - at_; }

  std::string_view line() {
    if (left() == 0) fail_ended("more of a variable");
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = std::string_view(text_).substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  /// The value of a line `# key: value`; nothing where the line is another one.
  static std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
    if (!line.starts_with("# ") || !line.substr(2).starts_with(key)) return std::nullopt;
    line.remove_prefix(2 + key.size());
    if (!line.starts_with(':')) return std::nullopt;
    return trimmed(line.substr(1));
  }

  /// The next line, as it is left to be read.
  std::string_view peek() {
    const std::size_t at = at_;
    const std::string_view next = left() == 0 ? std::string_view{} : line();
    at_ = at;
    return next;
  }

  /// Passes over what is no such entry; false where none follows.
  bool go_to_entry(std::string_view key) {
    while (left() > 0) {
      if (value_of(peek(), key)) return true;
      (void)line();
    }
    return false;
  }

  std::string_view entry(std::string_view key) {
    const std::string_view next = line();
    const auto value = value_of(next, key);
    if (!value) fail(fmt::format("a line '# {}: …'", key), in_quotes(next));
    return *value;
  }

  std::size_t count(std::string_view key) {
    const std::string_view text = entry(key);
    return size_of(text);
  }

  [[nodiscard]] std::size_t size_of(std::string_view text) const {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
      fail("a size", in_quotes(text));
    }
    return value;
  }

  MatValue read_value(int depth) {
    if (depth > kDeepestMatValue || ++values_ > kMostMatValues) {
      fail(fmt::format("at most {} arrays, nested {} deep", kMostMatValues, kDeepestMatValue),
           "more");
    }
    std::string_view type = entry("type");
    if (type.starts_with("global ")) type.remove_prefix(7);
    if (type == "string" || type == "sq_string") return read_text();
    if (type == "cell") return read_cell(depth);
    if (type == "scalar struct") return read_struct(depth);
    if (type == "struct") return read_structs(depth);
    if (type.ends_with("diagonal matrix")) return read_diagonal(type.starts_with("complex "));
    if (type == "lazy_index") return read_named(depth, nullptr);  // as find() returns them
    if (type.starts_with("sparse ")) return read_sparse(type.find("complex") != type.npos);
    if (type.ends_with("range")) return read_range();
    const bool complex = type.find("complex ") != type.npos;
    if (type.ends_with("scalar") || type == "bool") return read_scalar(complex);
    if (type.ends_with("matrix") && type != "permutation matrix") return read_matrix(complex);
    MatValue value;
    value.kind = Kind::kOther;
    value.sizes = {1, 1};
    value.other = fmt::format("a value of the type {}", in_quotes(type));
    skip_unknown(depth);
    return value;
  }

  /// What lies within a value of another type: a function handle has the variables that it
  /// captured and an object its properties, as so many entries behind `# length: N`. A blank line
  /// ends it.
  void skip_unknown(int depth) {
    std::size_t inside = 1;
    while (!value_of(peek(), "name")) {
      if (left() == 0) return;
      const std::string_view next = line();
      if (trimmed(next).empty()) return;
      if (const auto length = value_of(next, "length")) inside = size_of(*length);
      if (inside == 0) return;
    }
    for (; inside > 0; --inside) (void)read_named(depth, nullptr);
  }

  static MatValue numbers(std::vector<std::size_t> sizes) {
    MatValue value;
    value.kind = Kind::kNumbers;
    value.sizes = std::move(sizes);
    return value;
  }

  /// The next number, on whatever line.
  double number() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    const char* const begin = text_.data() + at_;
    const char* const end = text_.data() + text_.size();
    double value = 0.0;
    const auto [next, error] = std::from_chars(begin, end, value);
    if (error == std::errc{}) {
      at_ += static_cast<std::size_t>(next - begin);
      return value;
    }
    return special_number();
  }

  double special_number() {
    const std::string_view rest = std::string_view(text_).substr(at_);
    if (rest.empty()) fail_ended("a number");
    if (rest.starts_with("NA")) {
      at_ += 2;
      return std::numeric_limits<double>::quiet_NaN();
    }
    fail("a number", in_quotes(rest.substr(0, rest.find_first_of(" \n"))));
  }

  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  void skip(char c) {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (left() == 0) fail_ended(fmt::format("'{}'", c));
    if (text_[at_] != c) fail(fmt::format("'{}'", c), in_quotes(text_.substr(at_, 1)));
    ++at_;
  }

  std::pair<double, double> complex_number() {
    skip('(');
    const double real = number();
    skip(',');
    const double imaginary = number();
    skip(')');
    return {real, imaginary};
  }

  /// Sets number `to` of a value.
  void take_number(MatValue& value, std::size_t to, bool complex) {
    if (!complex) {
      value.real[to] = number();
      return;
    }
    std::tie(value.real[to], value.imaginary[to]) = complex_number();
  }

  /// Memory for so many numbers, each of which takes a byte of the text and one that ends it.
  void make_room(MatValue& value, std::size_t size, bool complex) {
    if (size > left()) fail_ended(fmt::format("{} numbers", size));
    value.real.resize(size);
    if (complex) value.imaginary.resize(size);
  }

  MatValue read_scalar(bool complex) {
    MatValue value = numbers({1, 1});
    make_room(value, 1, complex);
    take_number(value, 0, complex);
    return value;
  }

  MatValue read_range() {
    (void)line();  // "# base, limit, increment"
    const double base = number();
    const double limit = number();
    const double increment = number();
    // Any other vector of as many values takes two bytes a value.
    constexpr std::size_t kFew = 4096;
    auto value = octave_range(base, limit, increment, std::max(kFew, text_.size()));
    return value ? *std::move(value) : long_range(base, limit, increment);
  }

  /// The product; no more than the text has bytes.
  std::size_t product(const std::vector<std::size_t>& sizes) const {
    std::size_t product = 1;
    for (const std::size_t size : sizes) {
      if (size > 0 && product > text_.size() / size) fail_ended(fmt::format("{} values", size));
      product *= size;
    }
    return product;
  }

  std::vector<std::size_t> read_dimensions() {
    const std::size_t count = this->count("ndims");
    if (count < 2 || count > 32) fail("2 to 32 dimensions", fmt::format("{}", count));
    std::vector<std::size_t> sizes(count);
    std::string_view rest = trimmed(line());
    for (std::size_t& size : sizes) {
      const std::size_t end = rest.find(' ');
      size = size_of(rest.substr(0, end));
      rest = trimmed(end == rest.npos ? std::string_view{} : rest.substr(end));
    }
    return sizes;
  }

  /// With `ndims` one number a line, column by column; else a row a line.
  MatValue read_matrix(bool complex) {
    if (value_of(peek(), "ndims")) {
      MatValue value = numbers(read_dimensions());
      const std::size_t count = product(value.sizes);
      make_room(value, count, complex);
      for (std::size_t i = 0; i < count; ++i) take_number(value, i, complex);
      return value;
    }
    const std::size_t rows = count("rows");
    const std::size_t columns = count("columns");
    MatValue value = numbers({rows, columns});
    make_room(value, product(value.sizes), complex);
    for (std::size_t row = 0; row < (columns == 0 ? 0 : rows); ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        take_number(value, column * rows + row, complex);
      }
    }
    return value;
  }

  /// As a sparse one.
  MatValue read_diagonal(bool complex) {
    const std::size_t rows = count("rows");
    const std::size_t columns = count("columns");
    MatValue value;
    value.kind = Kind::kSparse;
    value.sizes = {rows, columns};
    const std::size_t there = std::min(rows, columns);
    if (columns > text_.size()) fail("values that the file can hold", "more");
    make_room(value, there, complex);
    value.column_start.assign(columns + 1, static_cast<std::int64_t>(there));
    for (std::size_t i = 0; i < there; ++i) {
      take_number(value, i, complex);
      value.row.push_back(static_cast<std::int64_t>(i));
      value.column_start[i] = static_cast<std::int64_t>(i);
    }
    return value;
  }

  std::size_t index(std::size_t most) {
    const double value = number();
    if (value >= 1.0 && value <= static_cast<double>(most) && value == std::floor(value)) {
      return static_cast<std::size_t>(value) - 1;
    }
    fail(fmt::format("an index from 1 to {}", most), fmt::format("{}", value));
  }

  /// Row, column and number a line, column by column.
  MatValue read_sparse(bool complex) {
    const std::size_t numbers = count("nnz");
    const std::size_t rows = count("rows");
    const std::size_t columns = count("columns");
    constexpr std::size_t kFew = 65536;
    if (columns > kFew + 64 * text_.size()) fail("columns with numbers", "more");
    MatValue value;
    value.kind = Kind::kSparse;
    value.sizes = {rows, columns};
    make_room(value, numbers, complex);
    value.column_start.assign(columns + 1, 0);
    std::size_t last = 0;
    for (std::size_t i = 0; i < numbers; ++i) {
      value.row.push_back(static_cast<std::int64_t>(index(rows)));
      const std::size_t column = index(columns);
      if (column < last) fail("numbers column by column", fmt::format("column {}", column + 1));
      last = column;
      ++value.column_start[column + 1];
      take_number(value, i, complex);
    }
    std::partial_sum(value.column_start.begin(), value.column_start.end(),
                     value.column_start.begin());
    const std::string fault = checked_sparse(value);
    if (!fault.empty()) fail("a sparse matrix", fault);
    return value;
  }

  MatValue read_text() {
    const std::size_t rows = count("elements");
    MatValue value;
    value.kind = Kind::kText;
    std::size_t longest = 0;
    if (rows > left()) fail("texts that the file can hold", "more");
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t length = count("length");
      if (length > left()) fail_ended(fmt::format("{} characters", length));
      std::string bytes = text_.substr(at_, length);
      at_ += length;
      if (left() > 0) (void)line();
      longest = std::max(longest, length);
      if (rows > 1) bytes.resize(bytes.find_last_not_of(' ') + 1);
      value.texts.push_back(text_rows_of_bytes(bytes, 1).front());
    }
    value.sizes = {rows, longest};
    return value;
  }

  MatValue read_named(int depth, std::string* name) {
    if (!go_to_entry("name")) fail_ended("the name of a value");
    const std::string_view found = entry("name");
    if (name != nullptr) *name = found;
    return read_value(depth + 1);
  }

  MatValue read_cell(int depth) {
    MatValue value;
    value.kind = Kind::kCell;
    if (value_of(peek(), "ndims")) {
      value.sizes = read_dimensions();
    } else {
      const std::size_t rows = count("rows");
      value.sizes = {rows, count("columns")};
    }
    for (std::size_t left = product(value.sizes); left > 0; --left) {
      value.children.push_back(read_named(depth, nullptr));
    }
    return value;
  }

  /// The names of the fields and their values.
  MatValue read_fields(int depth) {
    MatValue value;
    value.kind = Kind::kStruct;
    value.sizes = {1, 1};
    if (value_of(peek(), "ndims")) value.sizes = read_dimensions();
    std::set<std::string> taken;
    const std::size_t fields = count("length");
    for (std::size_t i = 0; i < fields; ++i) {
      std::string name;
      value.children.push_back(read_named(depth, &name));
      if (!is_plain_name(name)) fail("the name of a field", in_quotes(name));
      if (!taken.insert(name).second) fail("each field once", in_quotes(name) + " twice");
      value.fields.push_back(std::move(name));
    }
    return value;
  }

  MatValue read_struct(int depth) {
    MatValue value = read_fields(depth);
    value.sizes = {1, 1};
    return value;
  }

  /// Each field is a cell of its value in each element.
  MatValue read_structs(int depth) {
    MatValue columns = read_fields(depth);
    if (columns.fields.empty()) return columns;
    const std::vector<std::size_t> sizes = columns.sizes;
    std::optional<MatValue> value = structs_of_columns(std::move(columns));
    if (!value || value->sizes != sizes) fail("fields that are cells of one size", "others");
    return *std::move(value);
  }

  const std::string& text_;
  const std::string& path_;
  std::size_t at_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

MatTree parse_octave_text(const std::string& text, const std::string& path,
                          const MatReadOptions& options) {
  return OctaveText(text, path).read(options.allow_truncated);
}

}  // namespace microslip
