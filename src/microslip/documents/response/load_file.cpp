// SPDX-License-Identifier: MIT
#include "microslip/documents/response/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/tables/column_rules.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {
namespace {

constexpr std::string_view kForceAt = "force at ";
constexpr std::string_view kAccelerationOf = "acceleration of ";
constexpr std::string_view kLoadOf = "normal_load of ";

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) {
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", name);
  }
  return text.empty() ? "none" : text;
}

/// @param what  "a point", "a joint".
std::string known(const CsvTable& table, std::string_view column, std::string_view name,
                  std::string_view what, const std::vector<std::string_view>& names) {
  if (std::ranges::find(names, name) != names.end()) return std::string(name);
  const std::string_view closest = closest_name(name, names);
  throw FormatError({table.file()}, fmt::format("{} of the model, {}", what, listed(names)),
                    fmt::format("column '{}'", column),
                    closest.empty() ? "" : fmt::format("Did you mean '{}'?", closest));
}

/// The only one, for a column that names none.
std::string only(const CsvTable& table, std::string_view column, std::string_view prefix,
                 std::string_view what, const std::vector<std::string_view>& names) {
  if (names.size() == 1) return std::string(names.front());
  throw FormatError({table.file()}, fmt::format("a column '{}NAME'", prefix),
                    fmt::format("'{}'", column),
                    fmt::format("The model has {} {}s: {}.", names.size(), what, listed(names)));
}

std::vector<double> rising_time(const CsvTable& table) {
  std::vector<double> time = table.numbers("time", kTime);
  for (std::size_t row = 1; row < time.size(); ++row) {
    if (!(time[row] > time[row - 1])) {
      table.reject(row, "time", "a time later than that of the row before it");
    }
  }
  if (time.size() >= 2) return time;
  throw FormatError({table.file()}, "two rows or more", "one");
}

class Loads {
 public:
  Loads(const CsvTable& table, const JointedStructure& structure, NormalLoadLaw law)
      : table_(table), law_(law) {
    for (const ModalPoint& point : structure.linear().points()) points_.push_back(point.name);
    for (const Excitation& excitation : structure.excitations()) {
      if (std::ranges::find(excited_, excitation.point) != excited_.end()) continue;
      excited_.push_back(excitation.point);
    }
    for (const ModalBase& base : structure.linear().bases()) bases_.push_back(base.name);
    if (structure.base_driven()) excited_.clear();  // a column `force` is at no base
    for (const StructuralJoint& joint : structure.joints()) joints_.push_back(joint.name);
    loads_.time = rising_time(table);
  }

  LoadHistory read() {
    for (const CsvColumn& column : table_.columns()) {
      const std::string_view name = column.name;
      if (name == "force" && excited_.empty()) {
        throw FormatError({table_.file()},
                          "a column 'acceleration of BASE [m/s^2]' or 'force at POINT [N]'",
                          "'force'", "The model is driven by its base.");
      }
      if (name == "force") {
        add_force(name, only(table_, name, kForceAt, "excitation", excited_));
      } else if (name.starts_with(kForceAt)) {
        add_force(name, known(table_, name, name.substr(kForceAt.size()), "a point", points_));
      } else if (name.starts_with(kAccelerationOf)) {
        const std::string_view base = name.substr(kAccelerationOf.size());
        add_force(name, known(table_, name, base, "a base", bases_), kAcceleration);
      } else if (name == "normal_load") {
        add_load(name, only(table_, name, kLoadOf, "joint", joints_));
      } else if (name.starts_with(kLoadOf)) {
        add_load(name, known(table_, name, name.substr(kLoadOf.size()), "a joint", joints_));
      }
    }
    if (!loads_.forces.empty()) return std::move(loads_);
    throw FormatError({table_.file()},
                      bases_.empty() ? "a column 'force [N]' or 'force at POINT [N]'"
                                     : "a column 'force [N]', 'force at POINT [N]' or "
                                       "'acceleration of BASE [m/s^2]'",
                      fmt::format("the columns {}", names_of_columns()));
  }

 private:
  [[nodiscard]] std::string names_of_columns() const {
    std::vector<std::string_view> names;
    for (const CsvColumn& column : table_.columns()) names.push_back(column.name);
    return listed(names);
  }

  void add_force(std::string_view column, std::string point, const Dimension& unit = kForce) {
    refuse_twice(column, point, loads_.forces, &PointForce::point);
    loads_.forces.push_back({std::move(point), table_.numbers(column, unit)});
  }

  void add_load(std::string_view column, std::string joint) {
    refuse_twice(column, joint, loads_.normal_loads, &JointNormalLoad::joint);
    std::vector<double> load = table_.numbers(column, kDimensionless);
    require_non_negative(table_, column, load,
                         "It is the normal load over its nominal value; 0 means no contact.");
    loads_.normal_loads.push_back({std::move(joint), std::move(load), law_});
  }

  template <typename Given, typename Name>
  void refuse_twice(std::string_view column, const std::string& name,
                    const std::vector<Given>& given, Name of) const {
    if (std::ranges::find(given, name, of) == given.end()) return;
    throw FormatError({table_.file()}, fmt::format("one column for '{}'", name),
                      fmt::format("also column '{}'", column));
  }

  const CsvTable& table_;
  NormalLoadLaw law_;
  std::vector<std::string_view> points_;
  std::vector<std::string_view> bases_;
  std::vector<std::string_view> excited_;  // each place once
  std::vector<std::string_view> joints_;
  LoadHistory loads_;
};

}  // namespace

LoadHistory parse_loads(std::string text, std::string_view file, const JointedStructure& structure,
                        NormalLoadLaw law) {
  const CsvTable table(std::move(text), file);
  return Loads(table, structure, law).read();
}

LoadHistory read_loads(const std::string& path, const JointedStructure& structure,
                       NormalLoadLaw law) {
  return parse_loads(read_text(path), input_name(path), structure, law);
}

TableColumn load_column(const JointedStructure& structure, const LoadHistory& loads,
                        const PointForce& at) {
  if (structure.linear().is_base(at.point)) {
    return {fmt::format("{}{}", kAccelerationOf, at.point), kAcceleration};
  }
  const bool only_one = loads.forces.size() == 1;
  return {only_one ? "force" : fmt::format("{}{}", kForceAt, at.point), kForce};
}

std::string format_loads(const LoadHistory& loads, const JointedStructure& structure,
                         std::string_view comment) {
  CsvWriter table;
  if (!comment.empty()) table.add_comment(comment);
  table.add_numbers("time", kTime, loads.time);
  for (const PointForce& at : loads.forces) {
    const TableColumn column = load_column(structure, loads, at);
    table.add_numbers(column.name, column.dimension, at.force);
  }
  return table.str();
}

}  // namespace microslip
