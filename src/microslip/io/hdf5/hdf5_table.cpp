// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"

namespace microslip {
namespace {

/// A row of a list of numbers longer than this is no list of channels.
constexpr hsize_t kWidestField = 4096;
/// Numbers that are read at once: rows of all fields, so that compressed chunks are read once.
constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 18U;

Hdf5Handle member_type(hid_t type, unsigned index) {
  return {H5Tget_member_type(type, index), H5Tclose};
}

bool is_real(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

/// The length of a list of one dimension; 1 of a single value, 0 of more dimensions.
hsize_t width_of(hid_t type) {
  if (H5Tget_class(type) != H5T_ARRAY) return 1;
  if (H5Tget_array_ndims(type) != 1) return 0;
  hsize_t size = 0;
  H5Tget_array_dims2(type, &size);
  return size;
}

/// A member of the type of a row.
struct Member {
  std::string name;
  bool is_list = false;
  hsize_t width = 1;       ///< of the list
  bool is_number = false;  ///< real numbers
  bool is_date = false;    ///< whole nanoseconds, as pandas writes dates
};

Member member_of(hid_t row, unsigned index) {
  char* name = H5Tget_member_name(row, index);
  Member member{.name = name == nullptr ? "" : name};
  H5free_memory(name);
  const Hdf5Handle type = member_type(row, index);
  member.is_list = H5Tget_class(type.id()) == H5T_ARRAY;
  member.width = width_of(type.id());
  member.is_number = member.is_list ? is_real(Hdf5Handle(H5Tget_super(type.id()), H5Tclose).id())
                                    : is_real(type.id());
  member.is_number = member.is_number && member.width >= 1 && member.width <= kWidestField;
  return member;
}

/// pandas names the type of a column in the attribute NAME_dtype.
bool is_date(hid_t dataset, const std::string& name, const std::string& place) {
  const std::string type = hdf5_text(dataset, (name + "_dtype").c_str(), place).value_or("");
  return type.starts_with("datetime64") || type.starts_with("timedelta64");
}

std::vector<Member> members_of(hid_t dataset, const std::string& place) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const int count = type.valid() ? H5Tget_nmembers(type.id()) : 0;
  std::vector<Member> members;
  for (int i = 0; i < count; ++i) {
    members.push_back(member_of(type.id(), static_cast<unsigned>(i)));
    Member& member = members.back();
    member.is_date = member.is_number && !member.is_list && is_date(dataset, member.name, place);
  }
  return members;
}

/// In memory a row has the numbers alone, doubles one after the other.
Hdf5Handle memory_type(const std::vector<Member>& members, std::size_t numbers) {
  Hdf5Handle row(H5Tcreate(H5T_COMPOUND, numbers * sizeof(double)), H5Tclose);
  std::size_t at = 0;
  for (const Member& member : members) {
    if (!member.is_number) continue;
    const hid_t number = member.is_date ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE;
    if (member.is_list) {
      const Hdf5Handle list(H5Tarray_create2(number, 1, &member.width), H5Tclose);
      H5Tinsert(row.id(), member.name.c_str(), at, list.id());
    } else {
      H5Tinsert(row.id(), member.name.c_str(), at, number);
    }
    at += member.width * sizeof(double);
  }
  return row;
}

/// Rows [first, first + count) of all members.
void read_rows(hid_t dataset, hid_t type, hsize_t first, hsize_t count, double* to,
               const std::string& place) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr) < 0 ||
      H5Dread(dataset, type, memory.id(), space.id(), H5P_DEFAULT, to) < 0) {
    fail_hdf5(place, fmt::format("row {}", first + 1));
  }
}

/// The numbers of each place of a row, in its order.
std::vector<std::vector<double>> read_numbers(hid_t dataset, const std::vector<Member>& members,
                                              std::size_t rows, const std::string& place) {
  std::size_t numbers = 0;
  for (const Member& member : members) numbers += member.is_number ? member.width : 0;
  std::vector<std::vector<double>> columns(numbers, std::vector<double>(rows));
  if (numbers == 0) return columns;
  const Hdf5Handle type = memory_type(members, numbers);
  const std::size_t step = std::max<std::size_t>(kNumbersAtOnce / numbers, 1);
  std::vector<double> buffer(std::min(step, rows) * numbers);
  for (std::size_t row = 0; row < rows; row += step) {
    const std::size_t count = std::min(step, rows - row);
    read_rows(dataset, type.id(), row, count, buffer.data(), place);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < numbers; ++j) columns[j][row + i] = buffer[i * numbers + j];
    }
  }
  return columns;
}

/// From the bits of whole nanoseconds to seconds from the first on: doubles do not hold dates.
void make_seconds(std::vector<double>& dates) {
  constexpr double kNanosecond = 1e-9;
  if (dates.empty()) return;
  const auto first = std::bit_cast<std::int64_t>(dates.front());
  for (double& date : dates) {
    date = kNanosecond * static_cast<double>(std::bit_cast<std::int64_t>(date) - first);
  }
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    parts.emplace_back(trimmed(std::string_view(text).substr(at, comma - at)));
    at = comma + 1;
  }
  return parts;
}

/// Those of the attributes, one for each member; empty ones where there are none.
std::vector<std::string> units_of(hid_t dataset, const std::vector<Member>& members,
                                  const std::string& place, std::vector<Warning>& warnings) {
  std::vector<std::string> units(members.size());
  for (const char* name : {"units", "unit"}) {
    std::vector<std::string> given = hdf5_texts(dataset, name, place);
    if (given.size() == 1) given = split_at_commas(given.front());
    if (given.empty() || (given.size() == 1 && given.front().empty())) continue;
    if (given.size() == members.size()) {
      units = std::move(given);
    } else {
      warnings.push_back({"units_not_assigned",
                          fmt::format("{}: the attribute {} has {} units for {} fields: they are "
                                      "not used",
                                      place, name, given.size(), members.size())});
    }
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (const char* ending : {"_unit", "_units"}) {
      if (auto unit = hdf5_text(dataset, (members[i].name + ending).c_str(), place)) {
        units[i] = *std::move(unit);
      }
    }
  }
  return units;
}

/// The name without a unit in brackets, which is taken where no attribute gives one.
std::string name_of(const Member& member, std::string& unit, const std::string& place,
                    std::vector<Warning>& warnings) {
  const std::optional<CsvColumn> column = parse_column(member.name, true);
  if (!column || !column->unit || column->name.empty()) return member.name;
  if (unit.empty()) {
    unit = *column->unit;
  } else if (unit != *column->unit) {
    warnings.push_back(
        {"units_differ", fmt::format("{}: {} has the unit {} by an attribute, which is taken",
                                     place, in_quotes(member.name), in_quotes(unit))});
  }
  return column->name;
}

}  // namespace

Hdf5Table read_hdf5_table(hid_t dataset, const std::string& place) {
  const std::size_t rows = check_hdf5_storage(dataset, place);
  const std::vector<Member> members = members_of(dataset, place);
  Hdf5Table table;
  std::vector<std::string> units = units_of(dataset, members, place, table.warnings);
  std::vector<std::vector<double>> columns = read_numbers(dataset, members, rows, place);
  std::size_t at = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& member = members[i];
    if (!member.is_number) {
      constexpr const char* kReason = "its values are no real numbers";
      table.left_out.push_back({member.name, kReason});
      table.warnings.push_back({"channel_left_out", fmt::format("{}: {}: left out, {}", place,
                                                                in_quotes(member.name), kReason)});
      continue;
    }
    const std::string name = name_of(member, units[i], place, table.warnings);
    for (std::size_t j = 0; j < member.width; ++j, ++at) {
      if (member.is_date) make_seconds(columns[at]);
      table.fields.push_back({.name = member.is_list ? fmt::format("{}_{}", name, j + 1) : name,
                              .unit = member.is_date ? "s" : units[i],
                              .values = std::move(columns[at])});
    }
  }
  return table;
}

}  // namespace microslip
