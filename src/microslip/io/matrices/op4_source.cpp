// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/op4_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <utility>

#include "microslip/io/bytes/byte_order.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

constexpr std::size_t kInteger = 8;       // columns of one in text
constexpr std::size_t kWideInteger = 16;  // of the sizes in a header that ends so:
constexpr std::string_view kWideMark = "|I16";
constexpr std::size_t kName = 8;  // bytes; twice as many beside integers of 64 bits
constexpr std::size_t kMarker = 4;
constexpr std::int64_t kMostPerLine = 100;
static_assert(std::endian::native == std::endian::little);

std::optional<std::int64_t> op4_integer(std::string_view line, std::size_t begin,
                                        std::size_t width) {
  if (begin >= line.size()) return std::nullopt;
  return whole_integer(trimmed(line.substr(begin, width)));
}

bool is_name(std::string_view name) {
  name = trimmed(name);
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::ranges::all_of(name, [](char c) { return c >= ' ' && c <= '~'; });
}

/// A header line, and how its numbers are written: "1P,5E16.9" behind the name.
struct TextHeader {
  Op4Header header;
  std::int64_t per_line = 5;
  std::int64_t width = 16;
};

std::optional<TextHeader> text_header(std::string_view line) {
  const std::string_view whole = trimmed(line);
  const bool wide = whole.ends_with(kWideMark);
  const std::size_t size = wide ? kWideInteger : kInteger;
  const auto columns = op4_integer(line, 0, size);
  const auto rows = op4_integer(line, size, size);
  const auto form = op4_integer(line, 2 * size, kInteger);
  const auto type = op4_integer(line, 2 * size + kInteger, kInteger);
  const std::size_t name = 2 * size + 2 * kInteger;
  if (!columns || !rows || !form || !type || line.size() <= name) return std::nullopt;
  if (*type < 1 || *type > 4 || *form < 1 || *columns < 0) return std::nullopt;
  if (!is_name(line.substr(name, kName))) return std::nullopt;
  TextHeader found{.header = {.columns = *columns,
                              .rows = *rows,
                              .form = *form,
                              .type = *type,
                              .name = in_capitals(trimmed(line.substr(name, kName)))}};
  std::string format = in_capitals(line.substr(std::min(name + kName, line.size())));
  if (const std::size_t scale = format.find("P,"); scale != std::string::npos) {
    format.erase(0, scale + 2);
  }
  const std::size_t letter = format.find_first_of("ED");
  if (letter == std::string::npos) return found;
  const std::size_t first = format.find_first_of("0123456789");
  const std::size_t point = std::min(format.find('.', letter), format.size());
  const auto per_line = op4_integer(format, first, letter - std::min(first, letter));
  const auto width = op4_integer(format, letter + 1, point - letter - 1);
  if (!width || *width < 1 || *width > kMostPerLine) return std::nullopt;
  found.per_line = per_line.value_or(1);
  if (found.per_line < 1 || found.per_line > kMostPerLine) return std::nullopt;
  found.width = *width;
  return found;
}

}  // namespace

bool is_op4_text(std::string_view head) { return text_header(take_dos_line(head)).has_value(); }

bool is_op4_binary(std::string_view head) {
  for (const std::size_t integer : {std::size_t{4}, std::size_t{8}}) {
    const std::size_t size = 4 * integer + kName * (integer / 4);
    if (head.size() < size + 2 * kMarker) continue;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::memcpy(&first, head.data(), kMarker);
    std::memcpy(&last, head.data() + kMarker + size, kMarker);
    if (first != last || !is_name(head.substr(kMarker + 4 * integer, kName))) continue;
    if (first == size || byte_swapped(first) == size) return true;
  }
  return false;
}

bool Op4Text::next_line() {
  if (rest_.empty()) return false;
  line_ = take_dos_line(rest_);
  ++number_;
  return true;
}

std::string_view Op4Text::need_line() {
  if (next_line()) return line_;
  throw FormatError(place(), "the rest of a matrix", "the end of the file",
                    "The file is truncated.");
}

std::int64_t Op4Text::integer(std::size_t begin, std::size_t width) const {
  if (const auto value = op4_integer(line_, begin, width)) return *value;
  throw FormatError({file_, number_, begin + 1}, "an integer of 8 columns", in_quotes(line_));
}

std::optional<Op4Header> Op4Text::header() {
  do {
    if (!next_line()) return std::nullopt;
  } while (trimmed(line_).empty());
  const std::optional<TextHeader> found = text_header(line_);
  if (!found) {
    throw FormatError(place(), "columns, rows, form, type and name of a matrix", in_quotes(line_));
  }
  per_line_ = static_cast<std::size_t>(found->per_line);
  width_ = static_cast<std::size_t>(found->width);
  double_ = found->header.type % 2 == 0;
  return found->header;
}

Op4Column Op4Text::column() {
  need_line();
  return {integer(0, kInteger), integer(kInteger, kInteger), integer(2 * kInteger, kInteger)};
}

std::vector<std::int64_t> Op4Text::integers(std::size_t count) {
  need_line();
  std::vector<std::int64_t> values;
  // One alone may be wider: the row and the length in one.
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(integer(i * kInteger, count == 1 ? line_.size() : kInteger));
  }
  return values;
}

std::size_t Op4Text::numbers_in(std::int64_t words, bool dense) const {
  return static_cast<std::size_t>(dense || !double_ ? words : words / 2);
}

std::vector<double> Op4Text::numbers(std::size_t count) {
  std::vector<double> values;
  if (count > rest_.size()) {
    throw FormatError(place(), fmt::format("{} numbers", count),
                      fmt::format("{} more bytes", rest_.size()), "The file is truncated.");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (i % per_line_ == 0) need_line();
    const std::size_t begin = i % per_line_ * width_;
    const std::string_view text = begin < line_.size() ? line_.substr(begin, width_) : "";
    const std::optional<double> value = uff_number(text);
    if (!value || !std::isfinite(*value)) {
      throw FormatError({file_, number_, begin + 1}, "a finite number", in_quotes(text));
    }
    values.push_back(*value);
  }
  return values;
}

void Op4Text::end_matrix() {
  next_line();
  if (rest_.empty()) require_whole_lines(text_, place());
}

void Op4Binary::end_column() {
  if (at_ != record_end_) fail("the end of the record of a column", "more");
  end_record();
}

Op4Binary::Op4Binary(std::string_view bytes, std::string file)
    : bytes_(bytes), file_(std::move(file)) {
  std::uint32_t first = 0;
  std::memcpy(&first, bytes.data(), kMarker);
  constexpr std::uint32_t kMostBytes = 48;
  swapped_ = first > kMostBytes;
  long_ = (swapped_ ? byte_swapped(first) : first) == kMostBytes;
}

void Op4Binary::fail(std::string_view expected, const std::string& found) const {
  throw FormatError(place(), expected, fmt::format("{} at byte {}", found, at_ + 1),
                    "The file is damaged or truncated.");
}

template <class Number>
Number Op4Binary::take() {
  if (record_end_ - at_ < sizeof(Number)) fail("more in a record", "its end");
  Number value;
  std::memcpy(&value, bytes_.data() + at_, sizeof(Number));
  at_ += sizeof(Number);
  return swapped_ ? byte_swapped(value) : value;
}

void Op4Binary::begin_record() {
  record_end_ = bytes_.size();
  const auto size = take<std::uint32_t>();
  if (size > bytes_.size() - at_ || bytes_.size() - at_ - size < kMarker) {
    fail(fmt::format("a record of {} bytes", size), "the end of the file");
  }
  record_end_ = at_ + size;
}

void Op4Binary::end_record() {
  const std::size_t before = at_;
  std::uint32_t size = 0;
  std::memcpy(&size, bytes_.data() + record_end_, kMarker);
  if (swapped_) size = byte_swapped(size);
  at_ = record_end_ + kMarker;
  std::uint32_t first = 0;
  const std::size_t begin = record_end_ - std::min<std::size_t>(size, record_end_);
  if (begin >= kMarker) std::memcpy(&first, bytes_.data() + begin - kMarker, kMarker);
  if (swapped_) first = byte_swapped(first);
  if (first != size || begin > before) fail("the size of the record behind it", "another");
}

std::optional<Op4Header> Op4Binary::header() {
  if (at_ == bytes_.size()) return std::nullopt;
  begin_record();
  Op4Header header;
  header.columns = integer();
  header.rows = integer();
  header.form = integer();
  header.type = integer();
  if (record_end_ - at_ < kName || header.type < 1 || header.type > 4)
    fail("a matrix", "no header of one");
  for (const char c : bytes_.substr(at_, long_ ? 2 * kName : kName)) {
    if (c != ' ') header.name += c;  // of 64 bits, each half of it ends in blanks
  }
  header.name = in_capitals(header.name);
  if (!is_name(header.name)) fail("the name of a matrix", in_quotes(header.name));
  double_ = header.type % 2 == 0;
  end_record();
  return header;
}

Op4Column Op4Binary::column() {
  begin_record();
  Op4Column column;
  column.column = integer();
  column.row = integer();
  column.words = integer();
  return column;
}

std::vector<std::int64_t> Op4Binary::integers(std::size_t count) {
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(integer());
  return values;
}

std::size_t Op4Binary::numbers_in(std::int64_t words, bool /*dense*/) const {
  return static_cast<std::size_t>(double_ && !long_ ? words / 2 : words);
}

std::vector<double> Op4Binary::numbers(std::size_t count) {
  const bool wide = double_ || long_;
  if (count > (record_end_ - at_) / (wide ? sizeof(double) : sizeof(float))) {
    fail(fmt::format("{} numbers", count), "the end of their record");
  }
  std::vector<double> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(wide ? take<double>() : static_cast<double>(take<float>()));
    if (!std::isfinite(values.back())) fail("a finite number", "none");
  }
  return values;
}

}  // namespace microslip
