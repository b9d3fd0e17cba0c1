// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "microslip/io/bytes/character_set.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// The bytes of the first `width` characters of a text in UTF-8.
std::size_t bytes_of(std::string_view text, std::size_t width) {
  std::size_t bytes = 0;
  for (; width > 0 && bytes < text.size(); --width) {
    do {
      ++bytes;
    } while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U);
  }
  return bytes;
}

/// Takes the first `width` columns from the text.
std::string_view take_columns(UffCount count, std::size_t width, std::string_view& text) {
  const std::size_t bytes = count == UffCount::kBytes ? width : bytes_of(text, width);
  const std::string_view field = text.substr(0, bytes);
  text.remove_prefix(field.size());
  return field;
}

std::string without_controls(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

std::string_view without_blanks_behind(std::string_view text) {
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// Numbers that from_chars does not accept: the letter D, no letter, more digits than a double can
/// use.
std::optional<double> read_fortran_number(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool sign = c == '+' || c == '-';
    const bool letter = c == 'D' || c == 'd' || c == 'E' || c == 'e';
    if (sign && i > 0 && std::string_view("DdEe").find(text[i - 1]) == std::string_view::npos) {
      plain += 'E';
    }
    if (c != '+') plain += letter ? 'E' : c;
  }
  double value = 0.0;
  const char* const end = plain.data() + plain.size();
  const auto result = std::from_chars(plain.data(), end, value);
  if (result.ptr != end) return std::nullopt;
  if (result.ec == std::errc()) return value;
  const bool tiny =
      result.ec == std::errc::result_out_of_range && plain.find("E-") != std::string::npos;
  return tiny ? std::optional<double>(0.0) : std::nullopt;
}

/// Whether the fields end where the line does, its blanks counted or not.
bool fits(std::string_view line, std::span<const std::size_t> widths) {
  constexpr std::size_t kRecord = 80;
  const std::size_t used = without_blanks_behind(line).size();
  if (line.size() == kRecord) return true;
  std::size_t end = 0;
  for (std::size_t i = 0; end < line.size(); ++i) {
    end += widths[i % widths.size()];
    if (end == line.size() || end == used) return true;
  }
  return used == 0;
}

/// A number that runs over the end of its field, rather than two that touch.
bool is_cut_by(std::string_view line, std::size_t end, std::string_view next) {
  if (end >= line.size() || line[end - 1] == ' ' || line[end] == ' ') return false;
  return line[end] != '-' && line[end] != '+' && next.find('.') == std::string_view::npos;
}

/// False where the line is not made of such fields; then `numbers` is as before.
bool append_fixed(std::string_view line, std::span<const std::size_t> widths, bool whole,
                  std::vector<double>& numbers) {
  const std::size_t before = numbers.size();
  const std::string_view text = without_blanks_behind(line);
  std::size_t start = 0;
  for (std::size_t i = 0; start < text.size(); ++i) {
    const std::size_t width = widths[i % widths.size()];
    const std::string_view field = line.substr(start, width);
    if (field.size() < width && !whole) break;
    const std::size_t end = start + width;
    const std::optional<double> value = uff_number(field);
    if (!value || is_cut_by(line, end, line.substr(std::min(end, line.size()), width))) {
      numbers.resize(before);
      return false;
    }
    numbers.push_back(*value);
    start = end;
  }
  return true;
}

/// 0 where the field is blank.
std::optional<std::int64_t> read_integer(std::string_view field) {
  field = trimmed(field);
  if (field.empty()) return 0;
  if (field.starts_with('+')) field.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

/// Whether blanks and integers stand where the form has them.
bool has_form(std::string_view line, std::span<const UffField> form, UffCount count) {
  return std::all_of(form.begin(), form.end(), [&](const UffField& expected) {
    const std::string_view field = take_columns(count, expected.width, line);
    switch (expected.kind) {
      case UffField::kBlank:
        return trimmed(field).empty();
      case UffField::kInteger:
        return read_integer(field).has_value();
      case UffField::kText:
        break;
    }
    return true;
  });
}

}  // namespace

std::string uff_text(std::string_view bytes) { return without_controls(to_utf8(bytes)); }

bool uff_is_none(std::string_view text) {
  const std::string_view core = trimmed(text);
  constexpr std::string_view kNone = "NONE";
  constexpr char kLowerCaseBit = 0x20;  // of an ASCII letter
  return core.empty() ||
         std::equal(core.begin(), core.end(), kNone.begin(), kNone.end(),
                    [](char a, char b) { return a == b || a == (b | kLowerCaseBit); });
}

std::optional<double> uff_number(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return std::nullopt;
  text = without_blanks_behind(text.substr(first));
  if (text.front() == '+') {
    text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  }
  const char* const end = text.data() + text.size();
  double value = 0.0;
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ptr == end && result.ec == std::errc()) return value;
  if (text.find_first_not_of("0123456789.+-EeDd") != std::string_view::npos) return std::nullopt;
  return read_fortran_number(text);
}

UffColumns uff_columns(std::string_view line, std::span<const UffField> form) {
  constexpr std::size_t kRecord = 80;
  if (!is_utf8(line)) return {UffCount::kBytes, true};
  const std::string text = without_controls(std::string(line));
  const bool by_bytes = has_form(text, form, UffCount::kBytes);
  const bool by_characters = has_form(text, form, UffCount::kCharacters);
  if (by_bytes != by_characters) {
    return {by_bytes ? UffCount::kBytes : UffCount::kCharacters, true};
  }
  if (line.size() == kRecord) return {UffCount::kBytes, true};
  return {UffCount::kCharacters, uff_width(line) == kRecord};
}

UffFields::UffFields(std::string_view line, TextPlace place, UffCount count)
    : line_(without_controls(std::string(line))),
      rest_(line_),
      place_(std::move(place)),
      count_(is_utf8(line_) ? count : UffCount::kBytes) {}

std::string_view UffFields::take(std::size_t width) {
  const std::string_view field = take_columns(count_, width, rest_);
  column_ = next_column_;
  next_column_ += width;
  return field;
}

std::string UffFields::text(std::size_t width) {
  const std::string_view field = take(width);
  return uff_is_none(field) ? std::string() : to_utf8(trimmed(field));
}

std::int64_t UffFields::integer(std::size_t width, std::string_view what) {
  const std::string_view field = trimmed(take(width));
  const std::optional<std::int64_t> value = read_integer(field);
  if (!value) fail(fmt::format("an integer as {}", what), field);
  return *value;
}

double UffFields::number(std::size_t width, std::string_view what) {
  const std::string_view field = take(width);
  if (trimmed(field).empty()) return 0.0;
  const std::optional<double> value = uff_number(field);
  if (!value || !std::isfinite(*value)) fail(fmt::format("a number as {}", what), field);
  return *value;
}

void UffFields::fail(std::string_view expected, std::string_view found) const {
  TextPlace place = place_;
  if (place.line > 0) place.column = column_;
  throw FormatError(place, expected, in_quotes(found));
}

void append_uff_numbers(std::string_view line, std::span<const std::size_t> widths, bool whole,
                        const TextPlace& place, std::vector<double>& numbers) {
  if (fits(line, widths) || !whole) {
    if (append_fixed(line, widths, whole, numbers)) return;
  }
  std::size_t start = line.find_first_not_of(" \t");
  while (start != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t", start), line.size());
    if (end == line.size() && !whole) return;
    const std::string_view word = line.substr(start, end - start);
    const std::optional<double> value = uff_number(word);
    if (!value) {
      TextPlace there = place;
      if (there.line > 0) there.column = start + 1;
      throw FormatError(there, "a number", in_quotes(word));
    }
    numbers.push_back(*value);
    start = line.find_first_not_of(" \t", end);
  }
}

std::string uff_padded(std::string_view text, std::size_t width) {
  std::string result = uff_text(text);
  result.resize(bytes_of(result, width));
  result.append(width - uff_width(result), ' ');
  return result;
}

std::size_t uff_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

}  // namespace microslip
