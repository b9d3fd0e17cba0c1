// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff58.hpp"

#include <fmt/format.h>

#include <array>

#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr std::array<std::string_view, 11> kRecords{
    "ID line 1",           "ID line 2",
    "ID line 3",           "ID line 4",
    "ID line 5",           "record 6",
    "record 7 (the form)", "record 8 (abscissa)",
    "record 9 (ordinate)", "record 10 (denominator)",
    "record 11 (z axis)"};

constexpr UffField kBlank{UffField::kBlank, 1};
constexpr UffField integer_field(std::size_t width) { return {UffField::kInteger, width}; }
constexpr UffField text_field(std::size_t width) { return {UffField::kText, width}; }

/// Record 6.
constexpr std::array kFunctionForm{
    integer_field(5), integer_field(10), integer_field(5),  integer_field(10),
    kBlank,           text_field(10),    integer_field(10), integer_field(4),
    kBlank,           text_field(10),    integer_field(10), integer_field(4)};

/// Records 8 to 11.
constexpr std::array kQuantityForm{
    integer_field(10), integer_field(5), integer_field(5), integer_field(5), kBlank,
    text_field(20),    kBlank,           text_field(20)};

UffPoint read_point(UffFields& fields, std::string_view what) {
  UffPoint point;
  fields.skip(1);
  point.entity = fields.text(10);
  point.node = fields.integer(10, what);
  point.direction = fields.integer(4, what);
  return point;
}

void read_function(UffFields fields, Uff58Header& header) {
  header.function_type = fields.integer(5, "the function type");
  header.function_id = fields.integer(10, "the function number");
  header.version = fields.integer(5, "the version");
  header.load_case = fields.integer(10, "the load case");
  header.response = read_point(fields, "the response node or direction");
  header.reference = read_point(fields, "the reference node or direction");
}

void read_form(UffFields fields, const TextPlace& place, Uff58Header& header) {
  const std::int64_t type = fields.integer(10, "the ordinate data type");
  const std::int64_t points = fields.integer(10, "the number of points");
  const std::int64_t spacing = fields.integer(10, "the spacing");
  header.start = fields.number(13, "the first abscissa");
  header.step = fields.number(13, "the step of the abscissa");
  header.z = fields.number(13, "the z value");
  if (type != 2 && type != 4 && type != 5 && type != 6) {
    throw FormatError(place, "the ordinate data type 2, 4, 5 or 6", fmt::format("{}", type));
  }
  if (points < 0) {
    throw FormatError(place, "a number of points of 0 or more", fmt::format("{}", points));
  }
  if (spacing != 0 && spacing != 1) {
    throw FormatError(place, "the spacing 0 (uneven) or 1 (even)", fmt::format("{}", spacing));
  }
  header.is_double = type == 4 || type == 6;
  header.is_complex = type >= 5;
  header.points = static_cast<std::size_t>(points);
  header.even = spacing == 1;
}

UffQuantity read_quantity(UffFields fields) {
  UffQuantity quantity;
  quantity.type = fields.integer(10, "the specific data type");
  for (std::int64_t& exponent : quantity.exponents) {
    exponent = fields.integer(5, "an exponent of units");
  }
  fields.skip(1);
  quantity.label = fields.text(20);
  fields.skip(1);
  quantity.unit = fields.text(20);
  return quantity;
}

/// Record 8, 9, 10 or 11. What may be one unit or another is none.
UffQuantity read_quantity(UffEnvelope& envelope, std::string_view record,
                          std::vector<Warning>& warnings) {
  const std::string_view line = envelope.line(record);
  const TextPlace place = envelope.input().place();
  const UffColumns columns = uff_columns(line, kQuantityForm);
  UffQuantity quantity = read_quantity({line, place, columns.count});
  if (columns.certain) return quantity;
  const UffQuantity other = read_quantity({line, place, UffCount::kBytes});
  if (other.unit == quantity.unit) return quantity;
  warnings.push_back(
      {"uff_columns",
       fmt::format("{}: the unit in {} is {} where its columns are characters and {} "
                   "where they are bytes; none is taken",
                   envelope.dataset_name(), record, in_quotes(quantity.unit),
                   in_quotes(other.unit))});
  quantity.unit = kUnknownUffUnit;
  return quantity;
}

void warn_of_rest(const UffEnvelope& envelope, const UffEnvelope::Rest& rest,
                  std::vector<Warning>& warnings) {
  if (rest.lines > 0) {
    warnings.push_back(
        {"uff_extra_lines",
         fmt::format("{}: {} line{} after the announced values are not read",
                     envelope.dataset_name(), rest.lines, rest.lines == 1 ? "" : "s")});
  }
  if (!rest.closed) {
    warnings.push_back(
        {"uff_not_closed", fmt::format("{}: the file ends without the line '    -1' that closes it",
                                       envelope.dataset_name())});
  }
}

/// Cuts what is there to whole points, or refuses it.
void take_truncated(UffEnvelope& envelope, Uff58& data, bool allow_truncated,
                    std::vector<Warning>& warnings) {
  const std::size_t per_point = data.header.values_per_point();
  const std::size_t announced = data.header.points;
  const std::size_t found = data.x.size() + data.values.size() + data.imaginary.size();
  const std::size_t points = found / per_point;
  if (!allow_truncated) {
    throw UffTruncated(envelope.input().place(),
                       fmt::format("{} values ({} points) in {}", announced * per_point, announced,
                                   envelope.dataset_name()),
                       fmt::format("{} before its end", found),
                       "Record or export it again, or read what is left with `allow_truncated`.");
  }
  data.header.points = points;
  data.values.resize(points);
  if (!data.header.even) data.x.resize(points);
  if (data.header.is_complex) data.imaginary.resize(points);
  warnings.push_back({"uff_truncated", fmt::format("{}: {} of {} announced points are present",
                                                   envelope.dataset_name(), points, announced)});
}

}  // namespace

Uff58Header read_uff58_header(UffEnvelope& envelope, std::vector<Warning>& warnings) {
  Uff58Header header;
  for (std::size_t i = 0; i < header.id_lines.size(); ++i) {
    header.id_lines[i] = envelope.fields(kRecords[i]).text(80);
  }
  const std::string_view function = envelope.line(kRecords[5]);
  const UffCount count = uff_columns(function, kFunctionForm).count;
  read_function({function, envelope.input().place(), count}, header);
  UffFields form = envelope.fields(kRecords[6]);
  read_form(std::move(form), envelope.input().place(), header);
  header.abscissa = read_quantity(envelope, kRecords[7], warnings);
  header.ordinate = read_quantity(envelope, kRecords[8], warnings);
  header.denominator = read_quantity(envelope, kRecords[9], warnings);
  header.z_axis = read_quantity(envelope, kRecords[10], warnings);
  return header;
}

Uff58 read_uff58(UffEnvelope& envelope, const UffDataset& dataset, bool allow_truncated,
                 std::vector<Warning>& warnings) {
  Uff58 data;
  data.header = read_uff58_header(envelope, warnings);
  if (dataset.binary) {
    read_uff58_binary_values(envelope, dataset, data, allow_truncated, warnings);
  } else {
    read_uff58_text_values(envelope, data, warnings);
  }
  const bool whole = data.values.size() == data.header.points &&
                     (!data.header.is_complex || data.imaginary.size() == data.header.points);
  if (!whole) take_truncated(envelope, data, allow_truncated, warnings);
  const UffEnvelope::Rest rest = envelope.close();
  if (whole) warn_of_rest(envelope, rest, warnings);
  return data;
}

}  // namespace microslip
