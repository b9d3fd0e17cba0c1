// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/harwell_boeing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

constexpr std::size_t kCountWidth = 14;
constexpr std::size_t kFormatWidth = 16;
constexpr std::size_t kValueFormatWidth = 20;
constexpr std::size_t kLongestField = 64;

/// The columns [begin, begin + width) without blanks around.
std::string_view part(std::string_view line, std::size_t begin, std::size_t width) {
  return begin < line.size() ? trimmed(line.substr(begin, width)) : std::string_view();
}

/// Fields of one width, `count` a line: (10I8), (1P,5E16.8), (3(1PE25.16)).
struct FieldForm {
  std::size_t count = 1;
  std::size_t width = 0;
};

/// The number that ends before `end`; 1 where none does.
std::size_t repetitions(std::string_view text, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && text[begin - 1] >= '0' && text[begin - 1] <= '9') --begin;
  const auto value = whole_integer(text.substr(begin, end - begin));
  return value ? static_cast<std::size_t>(*value) : 1;
}

std::optional<FieldForm> field_form(std::string_view format, std::string_view letters) {
  std::string text;
  for (const char c : in_capitals(format)) {
    if (c != ' ') text += c;
  }
  const std::size_t letter = text.find_first_of(letters);
  if (!text.starts_with('(') || letter == std::string::npos) return std::nullopt;
  FieldForm form{.count = repetitions(text, letter)};
  for (std::size_t at = text.find('(', 1); at < letter; at = text.find('(', at + 1)) {
    form.count *= repetitions(text, at);
  }
  std::size_t begin = letter + 1;
  if (begin < text.size() && (text[begin] == 'S' || text[begin] == 'N')) ++begin;  // ES20.12
  const std::size_t end = std::min(text.find_first_not_of("0123456789", begin), text.size());
  const auto width = whole_integer(text.substr(begin, end - begin));
  const bool fits = width && *width > 0 && *width <= static_cast<std::int64_t>(kLongestField) &&
                    form.count > 0 && form.count <= kLongestField;
  if (!fits) return std::nullopt;
  form.width = static_cast<std::size_t>(*width);
  return form;
}

/// The lines of the file, blank ones too.
class FixedLines {
 public:
  FixedLines(std::string_view text, std::string_view file) : rest_(text), file_(file) {}

  /// @throws FormatError  at the end, with what is missing there.
  std::string_view next(std::string_view what) {
    ++number_;
    if (rest_.empty()) throw FormatError(place(0), what, "the end of the file");
    return take_dos_line(rest_);
  }

  /// The place of a byte of the line taken last.
  [[nodiscard]] TextPlace place(std::size_t byte) const {
    return {std::string(file_), number_, byte + 1};
  }
  [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  std::string_view file_;
  std::size_t number_ = 0;
};

/// A piece of a line, and where it begins.
struct PlacedField {
  std::string_view text;
  std::size_t begin = 0;
};

/// Where the piece of a line ends that begins at `begin`: at a blank or, if so asked, at a sign
/// behind a digit.
std::size_t end_of_piece(std::string_view line, std::size_t begin, bool at_signs) {
  std::size_t end = begin + 1;
  while (end < line.size() && line[end] != ' ') {
    const bool is_sign = line[end] == '-' || line[end] == '+';
    if (at_signs && is_sign && line[end - 1] >= '0' && line[end - 1] <= '9') break;
    ++end;
  }
  return std::min(end, line.size());
}

std::vector<PlacedField> pieces_of(std::string_view line, bool at_signs) {
  std::vector<PlacedField> pieces;
  for (std::size_t at = line.find_first_not_of(' '); at < line.size();) {
    const std::size_t end = end_of_piece(line, at, at_signs);
    pieces.push_back({line.substr(at, end - at), at});
    at = line.find_first_not_of(' ', end);
  }
  return pieces;
}

/// The fields of a line by their width; where blanks, or blanks and signs, part as many pieces,
/// these, for some programs write narrower fields than their header says (SciPy 1.10: 24 columns
/// for E25.16, 14 for E15.7, without a blank before a sign).
std::vector<PlacedField> fields_of(std::string_view line, std::size_t count,
                                   const FieldForm& form) {
  for (const bool at_signs : {false, true}) {
    std::vector<PlacedField> pieces = pieces_of(line, at_signs);
    if (pieces.size() == count) return pieces;
  }
  std::vector<PlacedField> fields;
  for (std::size_t i = 0; i < count; ++i) {
    fields.push_back({part(line, i * form.width, form.width), i * form.width});
  }
  return fields;
}

/// The fields of a list that goes over several lines.
template <class Take>
void for_each_field(FixedLines& lines, std::size_t count, const FieldForm& form,
                    std::string_view what, const Take& take) {
  if (count > lines.bytes_left()) {
    throw FormatError(lines.place(0), fmt::format("{} of {}", count, what),
                      fmt::format("a file of {} more bytes", lines.bytes_left()),
                      "The file is truncated, or its header is wrong.");
  }
  for (std::size_t done = 0; done < count;) {
    const std::string_view line = lines.next(what);
    for (const PlacedField& field : fields_of(line, std::min(form.count, count - done), form)) {
      if (!take(field.text)) {
        throw FormatError(lines.place(field.begin), what,
                          field.text.empty() ? "nothing" : in_quotes(field.text));
      }
      ++done;
    }
  }
}

struct HarwellBoeingHeader {
  std::string type;  ///< in capitals
  [[nodiscard]] bool has_integers() const { return type[0] == 'I'; }
  std::size_t rows = 0;
  std::size_t entries = 0;
  FieldForm pointers;
  FieldForm indices;
  FieldForm values;
  bool has_right_sides = false;
};

void check_type(const std::string& type, const TextPlace& place) {
  const std::string_view expected = "a matrix RSA or RUA: real, symmetric or not, assembled";
  if (type[0] == 'P') {
    throw FormatError(place, expected, in_quotes(type), "It has a pattern and no values.");
  }
  if (type[0] == 'C') {
    throw FormatError(place, expected, in_quotes(type), "Mass and stiffness are real.");
  }
  if (type[2] != 'A') throw FormatError(place, expected, in_quotes(type), "Assemble it first.");
  if (type[1] != 'S' && type[1] != 'U') throw FormatError(place, expected, in_quotes(type));
}

std::size_t count_of(const FixedLines& lines, std::string_view line, std::size_t field,
                     std::string_view what) {
  const std::string_view text = part(line, field * kCountWidth, kCountWidth);
  const auto value = whole_integer(text);
  if (value && *value >= 0) return static_cast<std::size_t>(*value);
  throw FormatError(lines.place(field * kCountWidth), what, in_quotes(text));
}

FieldForm form_of(const FixedLines& lines, std::string_view line, std::size_t begin,
                  std::size_t width, std::string_view letters) {
  const std::string_view text = part(line, begin, width);
  if (const auto form = field_form(text, letters)) return *form;
  throw FormatError(lines.place(begin), "a format of Fortran, (16I5) or (5E16.8)", in_quotes(text));
}

HarwellBoeingHeader read_header_of(FixedLines& lines) {
  HarwellBoeingHeader header;
  (void)lines.next("a title");
  const std::string_view cards = lines.next("the numbers of lines");
  const auto right_sides = whole_integer(part(cards, 4 * kCountWidth, kCountWidth));
  header.has_right_sides = right_sides.value_or(0) > 0;
  const std::string_view sizes = lines.next("the type of the matrix and its size");
  header.type = in_capitals(sizes.substr(0, 3));
  check_type(header.type, lines.place(0));
  header.rows = count_of(lines, sizes, 1, "the number of rows");
  const std::size_t columns = count_of(lines, sizes, 2, "the number of columns");
  header.entries = count_of(lines, sizes, 3, "the number of entries");
  if (header.rows == 0 || header.rows > kMostDegreesOfFreedom || columns != header.rows) {
    throw FormatError(lines.place(kCountWidth),
                      fmt::format("a square matrix of 1 to {} rows", kMostDegreesOfFreedom),
                      fmt::format("{} rows and {} columns", header.rows, columns));
  }
  const std::string_view formats = lines.next("formats");
  header.pointers = form_of(lines, formats, 0, kFormatWidth, "I");
  header.indices = form_of(lines, formats, kFormatWidth, kFormatWidth, "I");
  header.values = form_of(lines, formats, 2 * kFormatWidth, kValueFormatWidth,
                          header.has_integers() ? "I" : "EDFG");
  if (header.has_right_sides) (void)lines.next("the form of the right-hand sides");
  return header;
}

std::vector<std::size_t> read_pointers(FixedLines& lines, const HarwellBoeingHeader& header) {
  std::vector<std::size_t> pointers;
  const auto take = [&](std::string_view field) {
    const auto value = whole_integer(field);
    const std::size_t least = pointers.empty() ? 1 : pointers.back() + 1;
    const std::size_t most = pointers.empty() ? 1 : header.entries + 1;
    if (!value || *value < static_cast<std::int64_t>(least)) return false;
    if (*value > static_cast<std::int64_t>(most)) return false;
    pointers.push_back(static_cast<std::size_t>(*value) - 1);
    return true;
  };
  for_each_field(lines, header.rows + 1, header.pointers,
                 fmt::format("pointers from 1 that rise to {}", header.entries + 1), take);
  if (pointers.back() == header.entries) return pointers;
  throw FormatError(lines.place(0), fmt::format("a last pointer of {}", header.entries + 1),
                    std::to_string(pointers.back() + 1));
}

MatrixEntries read_columns(FixedLines& lines, const HarwellBoeingHeader& header) {
  const std::vector<std::size_t> pointers = read_pointers(lines, header);
  MatrixEntries entries{.size = header.rows, .row = {}, .column = {}, .value = {}};
  const auto rows = static_cast<std::int64_t>(header.rows);
  for_each_field(lines, header.entries, header.indices, fmt::format("rows from 1 to {}", rows),
                 [&](std::string_view field) {
                   const auto value = whole_integer(field);
                   if (!value || *value < 1 || *value > rows) return false;
                   entries.row.push_back(static_cast<std::int32_t>(*value - 1));
                   return true;
                 });
  for_each_field(lines, header.entries, header.values, "finite numbers with a point",
                 [&](std::string_view field) {
                   const auto value = uff_number(field);
                   if (!value || !std::isfinite(*value)) return false;
                   // Without a point the format would place it.
                   const bool placed = header.has_integers() || field.find('.') < field.size();
                   if (*value != 0.0 && !placed) return false;
                   entries.value.push_back(*value);
                   return true;
                 });
  for (std::size_t column = 0; column < header.rows; ++column) {
    entries.column.insert(entries.column.end(), pointers[column + 1] - pointers[column],
                          static_cast<std::int32_t>(column));
  }
  return entries;
}

}  // namespace

bool is_harwell_boeing(std::string_view head) {
  (void)take_line(head);
  const std::string_view cards = take_line(head);
  const std::string type = in_capitals(take_line(head));
  const std::string_view formats = take_line(head);
  constexpr std::string_view kOf[] = {"RCPI", "SUHZR", "AE"};
  if (type.size() < 4 * kCountWidth) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (kOf[i].find(type[i]) == std::string_view::npos) return false;
  }
  return whole_integer(part(cards, 0, kCountWidth)) &&
         whole_integer(part(type, kCountWidth, kCountWidth)) && trimmed(formats).starts_with('(');
}

SymmetricEntries parse_harwell_boeing(std::string_view text, std::string_view file) {
  FixedLines lines(text, file);
  const HarwellBoeingHeader header = read_header_of(lines);
  MatrixEntries entries = read_columns(lines, header);
  require_whole_lines(text, lines.place(0));
  if (header.type[1] == 'S') return symmetric_of_triangle(std::move(entries), file);
  return symmetric_of_both(entries, file, "A matrix of one triangle has the type RSA.");
}

SymmetricEntries read_harwell_boeing(const std::string& path) {
  return parse_harwell_boeing(read_text(path), input_name(path));
}

}  // namespace microslip
