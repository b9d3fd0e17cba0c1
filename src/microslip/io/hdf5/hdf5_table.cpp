// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_table.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"

namespace microslip {
namespace {

/// A row of a list of numbers longer than this is no list of channels.
constexpr hsize_t kWidestField = 4096;

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

std::vector<Member> members_of(hid_t dataset) {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const int count = type.valid() ? H5Tget_nmembers(type.id()) : 0;
  std::vector<Member> members;
  for (int i = 0; i < count; ++i) {
    members.push_back(member_of(type.id(), static_cast<unsigned>(i)));
  }
  return members;
}

/// In memory the member is the only one, its numbers doubles one after the other.
Hdf5Handle memory_type(const Member& member) {
  Hdf5Handle row(H5Tcreate(H5T_COMPOUND, member.width * sizeof(double)), H5Tclose);
  if (!member.is_list) {
    H5Tinsert(row.id(), member.name.c_str(), 0, H5T_NATIVE_DOUBLE);
    return row;
  }
  const Hdf5Handle numbers(H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &member.width), H5Tclose);
  H5Tinsert(row.id(), member.name.c_str(), 0, numbers.id());
  return row;
}

/// One vector for each place of the list.
std::vector<std::vector<double>> read_member(hid_t dataset, const Member& member, std::size_t rows,
                                             const std::string& place) {
  std::vector<double> values(rows * member.width);
  const Hdf5Handle type = memory_type(member);
  if (rows > 0 && H5Dread(dataset, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail_hdf5(place, fmt::format("the values of {}", in_quotes(member.name)));
  }
  std::vector<std::vector<double>> columns(member.width, std::vector<double>(rows));
  for (std::size_t i = 0; i < values.size(); ++i) {
    columns[i % member.width][i / member.width] = values[i];
  }
  return columns;
}

std::string unit_in_attributes(hid_t dataset, const std::vector<Member>& members, std::size_t index,
                               const std::string& place) {
  for (const char* ending : {"_unit", "_units"}) {
    if (auto unit = hdf5_text(dataset, (members[index].name + ending).c_str(), place)) return *unit;
  }
  for (const char* name : {"units", "unit"}) {
    const std::vector<std::string> units = hdf5_texts(dataset, name, place);
    if (units.size() == members.size()) return units[index];
  }
  return {};
}

}  // namespace

Hdf5Table read_hdf5_table(hid_t dataset, const std::string& place) {
  const std::size_t rows = check_hdf5_storage(dataset, place);
  const std::vector<Member> members = members_of(dataset);
  Hdf5Table table;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& member = members[i];
    if (!member.is_number) {
      table.left_out.push_back({member.name, "its values are no real numbers"});
      continue;
    }
    std::string name = member.name;
    std::string unit = unit_in_attributes(dataset, members, i, place);
    const std::optional<CsvColumn> column = parse_column(name, true);
    if (column && column->unit && !column->name.empty()) {
      name = column->name;
      if (unit.empty()) unit = *column->unit;
    }
    std::vector<std::vector<double>> columns = read_member(dataset, member, rows, place);
    for (std::size_t j = 0; j < columns.size(); ++j) {
      table.fields.push_back({.name = member.is_list ? fmt::format("{}_{}", name, j + 1) : name,
                              .unit = unit,
                              .values = std::move(columns[j])});
    }
  }
  return table;
}

}  // namespace microslip
