// SPDX-License-Identifier: MIT
#include "microslip/io/cells/number_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"

namespace microslip {
namespace {

constexpr std::string_view kBlanks = " \t\r";

}  // namespace

bool NumberLines::next() {
  while (!rest_.empty()) {
    line_ = take_line(rest_);
    ++number_;
    at_ = 0;
    field_ = 0;
    if (line_.find_first_not_of(kBlanks) != std::string_view::npos) return true;
  }
  line_ = {};
  return false;
}

TextPlace NumberLines::place() const { return {std::string(file_), number_, field_ + 1}; }

std::string_view NumberLines::field() {
  field_ = std::min(line_.find_first_not_of(kBlanks, at_), line_.size());
  at_ = std::min(line_.find_first_of(kBlanks, field_), line_.size());
  return line_.substr(field_, at_ - field_);
}

void NumberLines::fail(std::string_view expected, std::string_view found) const {
  throw FormatError(place(), expected, found.empty() ? "the end of the line" : in_quotes(found));
}

std::int64_t NumberLines::integer(std::string_view what) {
  const std::string_view text = field();
  const std::optional<std::int64_t> value = whole_integer(text);
  if (!value) fail(what, text);
  return *value;
}

std::int32_t NumberLines::index(std::string_view what, std::size_t size) {
  const std::int64_t found = integer(what);
  if (found >= 1 && static_cast<std::uint64_t>(found) <= size) {
    return static_cast<std::int32_t>(found - 1);
  }
  throw FormatError(place(), fmt::format("{} from 1 to {}", what, size), std::to_string(found),
                    found == 0 ? "Rows and columns count from 1; add 1 to those of a program that "
                                 "counts from 0."
                               : "");
}

double NumberLines::number(std::string_view what) {
  const std::string_view text = field();
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = !digits.empty() && end == digits.data() + digits.size();
  // A number too small for a double is 0; from_chars does not distinguish it from one too large.
  const bool tiny = whole && error == std::errc::result_out_of_range &&
                    digits.find("e-") != std::string_view::npos;
  if (tiny) return 0.0;
  if (!whole || error != std::errc() || !std::isfinite(value)) fail(what, text);
  return value;
}

void NumberLines::end() {
  if (const std::string_view text = field(); !text.empty()) fail("the end of the line", text);
}

}  // namespace microslip
