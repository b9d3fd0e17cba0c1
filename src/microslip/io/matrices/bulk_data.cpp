// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/bulk_data.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"

namespace microslip {
namespace {

constexpr std::size_t kNarrow = 8;
constexpr std::size_t kWide = 16;

bool goes_on(std::string_view line) {
  return line.front() == ' ' || line.front() == '+' || line.front() == '*' || line.front() == ',';
}

/// With an e where the format leaves it out or writes a D.
std::string with_exponent(std::string_view text) {
  std::string number;
  for (const char c : in_capitals(text)) {
    const bool sign = c == '+' || c == '-';
    if (c == 'D' || c == 'E') {
      number += 'e';
    } else if (sign && !number.empty() && number.back() != 'e') {
      (number += 'e') += c;
    } else if (c != '+' || !number.empty()) {
      number += c;
    }
  }
  const std::size_t plus = number.find("e+");
  return plus == std::string::npos ? number : number.erase(plus + 1, 1);
}

}  // namespace

bool BulkData::next_line() {
  while (!rest_.empty()) {
    line_ = take_line(rest_);
    ++number_;
    line_ = line_.substr(0, line_.find('$'));
    if (line_.find_first_not_of(" \t\r") != std::string_view::npos) return true;
  }
  line_ = {};
  return false;
}

bool BulkData::next() {
  if (line_.empty() && !next_line()) return false;
  fields_.clear();
  first_line_ = number_;
  const std::string_view name = trimmed(line_.substr(0, line_.find_first_of(", *\t\r")));
  name_ = in_capitals(name.substr(0, kNarrow));
  do {
    take(line_);
  } while (next_line() && goes_on(line_));
  return true;
}

void BulkData::take(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.find('\t') != std::string_view::npos) {
    throw FormatError({std::string(file_), number_, line.find('\t') + 1}, "fields of 8 columns",
                      "a tab");
  }
  if (line.substr(0, kNarrow + 2).find(',') != std::string_view::npos) {
    take_between_commas(line);
  } else if (line.substr(0, kNarrow).find('*') != std::string_view::npos) {
    take_columns(line, kWide, 4);
  } else {
    take_columns(line, kNarrow, 8);
  }
}

void BulkData::take_columns(std::string_view line, std::size_t width, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = kNarrow + i * width;
    const std::string_view text = begin < line.size() ? line.substr(begin, width) : "";
    fields_.push_back({trimmed(text), number_, begin + 1});
  }
}

void BulkData::take_between_commas(std::string_view line) {
  const std::size_t count = line.substr(0, kNarrow + 2).find('*') == std::string_view::npos ? 8 : 4;
  std::size_t at = std::min(line.find(','), line.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = std::min(at + 1, line.size());
    at = std::min(line.find(',', begin), line.size());
    fields_.push_back({trimmed(line.substr(begin, at - begin)), number_, begin + 1});
  }
}

BulkData::Field BulkData::field(std::size_t i) const {
  return i < fields_.size() ? fields_[i] : Field{};
}

TextPlace BulkData::place(const Field& field) const {
  if (field.line == 0) return {std::string(file_), first_line_, 1};
  return {std::string(file_), field.line, field.column};
}

std::int64_t BulkData::integer(std::size_t i, std::string_view what) const {
  const Field found = field(i);
  if (const auto value = whole_integer(found.text)) return *value;
  throw FormatError(place(found), what, found.text.empty() ? "nothing" : in_quotes(found.text));
}

double BulkData::number(std::size_t i, std::string_view what) const {
  const Field found = field(i);
  const auto value = whole_number<double>(with_exponent(found.text));
  if (value && std::isfinite(*value)) return *value;
  throw FormatError(place(found), what, found.text.empty() ? "nothing" : in_quotes(found.text));
}

}  // namespace microslip
