// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/hdf5/hdf5_dates.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

/// A row of a list of numbers longer than this is no list of channels.
constexpr hsize_t kWidestField = 4096;
/// Numbers that are read at once: rows of all fields, so that compressed chunks are read once.
constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 18U;

Hdf5Handle member_type(hid_t type, unsigned index) {
  return {H5Tget_member_type(type, index), H5Tclose};
}

/// The length of a list of one dimension; 1 of a single value, 0 of more dimensions.
hsize_t width_of(hid_t type) {
  if (H5Tget_class(type) != H5T_ARRAY) return 1;
  if (H5Tget_array_ndims(type) != 1) return 0;
  hsize_t size = 0;
  H5Tget_array_dims2(type, &size);
  return size;
}

/// How the numbers of a member are stored.
enum class Stored {
  kOther,        ///< none, or none that are read
  kNumbers,      ///< real numbers
  kWholeTimes,   ///< whole numbers of eight bytes, called time or in a unit of time
  kNanoseconds,  ///< whole ones, as pandas writes dates
  kTimes,        ///< as PyTables writes Time32Col and Time64Col
};

/// A member of the type of a row.
struct Member {
  std::string name;
  bool is_list = false;
  hsize_t width = 1;  ///< of the list
  Stored stored = Stored::kOther;
  hid_t integer = H5I_INVALID_HID;      ///< in memory, of a single one of eight bytes
  hid_t in_memory = H5T_NATIVE_DOUBLE;  ///< of eight bytes or, of seconds, four
  std::optional<Hdf5Time> time = {};    ///< of kTimes
  std::string reason = {};              ///< why it is left out

  [[nodiscard]] bool is_read() const { return stored != Stored::kOther; }
  [[nodiscard]] bool is_date() const { return stored > Stored::kWholeTimes; }
};

/// pandas names the type of a column in the attribute NAME_dtype, that of an index in NAME_kind.
bool is_date(hid_t dataset, const std::string& name, const std::string& place) {
  return std::ranges::any_of(std::array{"_dtype", "_kind"}, [&](const char* ending) {
    const std::string type = hdf5_text(dataset, (name + ending).c_str(), place).value_or("");
    return type.starts_with("datetime64") || type.starts_with("timedelta64");
  });
}

Stored stored_number(hid_t dataset, const std::string& name, hid_t type, const std::string& place) {
  if (hdf5_time(type)) return Stored::kTimes;
  if (!is_hdf5_number(type)) return Stored::kOther;
  return is_date(dataset, name, place) ? Stored::kNanoseconds : Stored::kNumbers;
}

/// Why a member is not read; empty where it is.
std::string reason_of(const Member& member, bool has_numbers) {
  if (!has_numbers) return "its values are no real numbers";
  if (member.width == 0) return "it has lists of several dimensions";
  if (member.width <= kWidestField) return {};
  return fmt::format("it has lists of {} numbers, more than {}", member.width, kWidestField);
}

Member member_of(hid_t dataset, hid_t row, unsigned index, const std::string& place) {
  char* name = H5Tget_member_name(row, index);
  Member member{.name = name == nullptr ? "" : name};
  H5free_memory(name);
  const Hdf5Handle type = member_type(row, index);
  member.is_list = H5Tget_class(type.id()) == H5T_ARRAY;
  member.width = width_of(type.id());
  if (member.is_list) {
    const Hdf5Handle item(H5Tget_super(type.id()), H5Tclose);
    if (is_hdf5_number(item.id())) member.stored = Stored::kNumbers;
  } else {
    member.stored = stored_number(dataset, member.name, type.id(), place);
    if (is_large_integer(type.id())) member.integer = large_integer_in_memory(type.id());
    member.time = hdf5_time(type.id());
    if (member.time) member.in_memory = member.time->type;
    if (member.stored == Stored::kNanoseconds) member.in_memory = H5T_NATIVE_INT64;
  }
  member.reason = reason_of(member, member.is_read());
  if (!member.reason.empty()) member.stored = Stored::kOther;
  return member;
}

std::vector<Member> members_of(hid_t dataset, const std::string& place) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const int count = type.valid() ? H5Tget_nmembers(type.id()) : 0;
  std::vector<Member> members;
  for (int i = 0; i < count; ++i) {
    members.push_back(member_of(dataset, type.id(), static_cast<unsigned>(i), place));
  }
  return members;
}

/// In memory a row has the numbers alone, doubles one after the other.
Hdf5Handle memory_type(const std::vector<Member>& members, std::size_t numbers) {
  Hdf5Handle row(H5Tcreate(H5T_COMPOUND, numbers * sizeof(double)), H5Tclose);
  std::size_t at = 0;
  for (const Member& member : members) {
    if (!member.is_read()) continue;
    const hid_t number = member.in_memory;
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
  for (const Member& member : members) numbers += member.is_read() ? member.width : 0;
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

std::int64_t bits_of(double number) { return std::bit_cast<std::int64_t>(number); }

/// From dates to seconds from the first on.
void make_seconds(const std::optional<Hdf5Time>& time, std::vector<double>& dates) {
  std::vector<std::int64_t> nanoseconds(dates.size());
  std::ranges::transform(dates, nanoseconds.begin(), [&](double date) {
    const std::int64_t bits = bits_of(date);
    return time ? time_in_nanoseconds(bits, *time) : bits;
  });
  dates = seconds_from_first(nanoseconds);
}

/// The field of whole numbers by the bits that were read.
Hdf5Field field_of_whole_times(const std::string& name, const std::string& unit, bool is_signed,
                               const std::vector<double>& bits, const std::string& place,
                               std::vector<Warning>& warnings) {
  WholeNumbers numbers{.bits = std::vector<std::int64_t>(bits.size()), .is_signed = is_signed};
  std::ranges::transform(bits, numbers.bits.begin(), bits_of);
  WholeTimes times = whole_times(numbers, unit, fmt::format("{}: {}", place, in_quotes(name)));
  if (times.warning) warnings.push_back(*std::move(times.warning));
  return {.name = name, .unit = std::move(times.unit), .values = std::move(times.values)};
}

/// Those of the attributes, one for each member; empty ones where there are none.
std::vector<std::string> units_of(hid_t dataset, const std::vector<Member>& members,
                                  const std::string& place, std::vector<Warning>& warnings) {
  std::vector<std::string> units(members.size());
  for (const char* name : {"units", "unit"}) {
    std::vector<std::string> given = hdf5_texts(dataset, name, place);
    if (given.size() == 1) {
      const std::string list = std::move(given.front());
      const std::vector<std::string_view> cells = comma_cells(list);
      given.assign(cells.begin(), cells.end());
    }
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

bool is_of_time(const std::string& name, const std::string& unit) {
  return is_one_of(name, kTimeNames) || stated_unit_of_time(unit);
}

/// The names of the members without their units, which are cut from them.
std::vector<std::string> take_names(std::vector<Member>& members, std::vector<std::string>& units,
                                    const std::string& place, std::vector<Warning>& warnings) {
  std::vector<std::string> names(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    Member& member = members[i];
    if (!member.is_read()) continue;
    names[i] = name_of(member, units[i], place, warnings);
    const bool is_whole = member.stored == Stored::kNumbers && member.integer >= 0;
    if (!is_whole || !is_of_time(names[i], units[i])) continue;
    member.stored = Stored::kWholeTimes;
    member.in_memory = member.integer;
  }
  return names;
}

}  // namespace

Hdf5Table read_hdf5_table(hid_t dataset, const std::string& place) {
  const std::size_t rows = check_hdf5_storage(dataset, place);
  std::vector<Member> members = members_of(dataset, place);
  Hdf5Table table;
  std::vector<std::string> units = units_of(dataset, members, place, table.warnings);
  const std::vector<std::string> names = take_names(members, units, place, table.warnings);
  std::vector<std::vector<double>> columns = read_numbers(dataset, members, rows, place);
  std::size_t at = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& member = members[i];
    if (!member.is_read()) {
      table.left_out.push_back({member.name, member.reason});
      table.warnings.push_back(
          {"channel_left_out",
           fmt::format("{}: {}: left out, {}", place, in_quotes(member.name), member.reason)});
      continue;
    }
    const std::string& name = names[i];
    if (member.stored == Stored::kWholeTimes) {
      table.fields.push_back(field_of_whole_times(name, units[i],
                                                  member.in_memory == H5T_NATIVE_INT64,
                                                  columns[at++], place, table.warnings));
      continue;
    }
    for (std::size_t j = 0; j < member.width; ++j, ++at) {
      if (member.is_date()) make_seconds(member.time, columns[at]);
      table.fields.push_back({.name = member.is_list ? fmt::format("{}_{}", name, j + 1) : name,
                              .unit = member.is_date() ? "s" : units[i],
                              .values = std::move(columns[at])});
    }
  }
  return table;
}

}  // namespace microslip
