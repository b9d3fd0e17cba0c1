// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/structure_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr std::array<std::string_view, 3> kBoxKeys = {"x_m", "y_m", "z_m"};
constexpr double kLargestNumber = 1e15;  // of a node: doubles hold it exactly
constexpr double kFarthest = 1e9;        // m
/// Of a box, relative to its coordinates: nodes on a face are in it, whatever rounding.
constexpr double kOnFace = 1e-9;

std::int64_t checked_node(const std::string& name, double number) {
  if (number >= 1.0 && number <= kLargestNumber && number == std::floor(number)) {
    return static_cast<std::int64_t>(number);
  }
  throw InputError(name, number, "must be the number of a node, 1 or more");
}

std::vector<std::int64_t> read_nodes(const TomlTable& table) {
  std::vector<std::int64_t> nodes;
  std::set<std::int64_t> seen;
  const std::vector<double> numbers = table.numbers(kNodesKey);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    nodes.push_back(checked_node(table.name(kNodesKey, i), numbers[i]));
    if (!seen.insert(nodes.back()).second) {
      throw InputError(table.name(kNodesKey, i), numbers[i], "must be given only once");
    }
  }
  if (!nodes.empty()) return nodes;
  throw InputError(table.name(kNodesKey), "an empty array", "must have at least one node");
}

std::array<double, 2> read_range(const TomlTable& box, std::string_view key) {
  const std::vector<double> range = box.numbers(key);
  const bool in_order = range.size() == 2 && range[0] <= range[1] &&
                        std::abs(range[0]) <= kFarthest && std::abs(range[1]) <= kFarthest;
  if (in_order) return {range[0], range[1]};
  throw InputError(box.name(key),
                   fmt::format("{} value{}", range.size(), range.size() == 1 ? "" : "s"),
                   fmt::format("must be two, from and to, rising, within ±{:g} m", kFarthest));
}

std::vector<std::int64_t> nodes_in_box(const TomlTable& set, const MeshFile& mesh) {
  const TomlTable box = set.table("box");
  box.allow_only({kBoxKeys.begin(), kBoxKeys.end()});
  std::array<std::optional<std::array<double, 2>>, 3> ranges;
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.has(kBoxKeys[k])) ranges[k] = read_range(box, kBoxKeys[k]);
  }
  std::vector<std::int64_t> nodes;
  for (const MeshNode& node : mesh.nodes) {
    const auto outside = [&](std::size_t k) {
      if (!ranges[k]) return false;
      const auto [from, to] = *ranges[k];
      const double margin = kOnFace * std::max({std::abs(from), std::abs(to), to - from});
      return node.position[k] < from - margin || node.position[k] > to + margin;
    };
    if (!outside(0) && !outside(1) && !outside(2)) nodes.push_back(node.number);
  }
  if (!nodes.empty()) return nodes;
  throw InputError(set.name("box"), fmt::format("none of {} nodes", mesh.nodes.size()),
                   "must have at least one node",
                   mesh.nodes.empty() ? "Give [nodes] with a file." : "Its numbers are in m.");
}

/// Which one of some keys a table has. @throws FormatError  where it is none or two.
std::string_view only_key(const TomlTable& table, const std::vector<std::string_view>& keys) {
  std::string_view found;
  std::string list;
  for (const std::string_view key : keys) {
    list += fmt::format("{}{}", list.empty() ? "" : ", ", key);
    if (!table.has(key)) continue;
    if (!found.empty()) {
      throw FormatError(table.place(key), fmt::format("one of the keys {}", list),
                        fmt::format("{} and {}", found, key));
    }
    found = key;
  }
  if (!found.empty()) return found;
  throw FormatError(table.place(keys.front()), fmt::format("one of the keys {}", list), "none");
}

std::vector<std::int64_t> nodes_of(const TomlTable& table, std::string_view key,
                                   const NodeSets& sets) {
  if (key == kSetKey) return sets.find(table, key);
  if (key == kNodesKey) return read_nodes(table);
  return {checked_node(table.name(key), table.number(key))};
}

std::size_t row_of(const std::string& name, double number) {
  if (number >= 1.0 && number <= static_cast<double>(kMostDegreesOfFreedom) &&
      number == std::floor(number)) {
    return static_cast<std::size_t>(number) - 1;
  }
  throw InputError(name, number, "must be a row of the matrices, counted from 1");
}

std::string place_name(const TomlTable& table, std::string_view key) {
  if (key == kSetKey) return fmt::format("{} {}", table.name(key), in_quotes(table.text(key)));
  return table.name(key);
}

Spider read_spider(const TomlTable& table, std::size_t nodes) {
  const std::string text = table.text(kSpiderKey);
  if (text != "average" && text != "rigid") {
    throw InputError(table.name(kSpiderKey), in_quotes(text), "must be average or rigid");
  }
  if (nodes < 2) {
    throw InputError(table.name(kSpiderKey), in_quotes(text),
                     "needs two nodes or more, and would have no effect", "Leave it out.");
  }
  return text == "rigid" ? Spider::kRigid : Spider::kAverage;
}

Vector3 read_vector(const TomlTable& table, std::string_view key) {
  const std::vector<double> values = table.numbers(key);
  const auto is_far = [](double value) { return !(std::abs(value) <= kFarthest); };
  if (values.size() == 3 && std::ranges::none_of(values, is_far)) {
    return {values[0], values[1], values[2]};
  }
  throw InputError(table.name(key),
                   fmt::format("{} value{}", values.size(), values.size() == 1 ? "" : "s"),
                   fmt::format("must be three, x, y and z, within ±{:g}", kFarthest));
}

std::optional<std::size_t> named_direction(std::string_view text) {
  const auto found = std::ranges::find(kNodalDirectionNames, text);
  if (found == kNodalDirectionNames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kNodalDirectionNames.begin());
}

MeshDirection read_named_direction(const TomlTable& table, const std::string& text) {
  const bool backwards = text.starts_with('-');
  const std::optional<std::size_t> found =
      named_direction(std::string_view(text).substr(backwards ? 1 : 0));
  if (!found) {
    throw InputError(table.name("direction"), in_quotes(text),
                     "must be x, y, z, rx, ry or rz, one of them with - before it, or a vector "
                     "[x, y, z]");
  }
  MeshDirection direction{.axis = {0.0, 0.0, 0.0}, .turns = *found >= 3};
  direction.axis[*found % 3] = backwards ? -1.0 : 1.0;
  return direction;
}

}  // namespace

NodeSets::NodeSets(const TomlTable& top, const MeshFile& mesh) {
  for (const NodeSet& set : mesh.sets) meshed_[in_capitals(set.name)] = set.nodes;
  if (!top.has(kSetKey)) return;
  for (const TomlTable& table : top.tables(kSetKey)) {
    table.allow_only({"name", kNodesKey, "box"});
    const std::string name = table.text("name");
    if (name.empty() || own_.contains(name) || meshed_.contains(in_capitals(name))) {
      throw InputError(table.name("name"), in_quotes(name),
                       "must be a text that no earlier set of the file or mesh has");
    }
    own_[name] = only_key(table, {kNodesKey, "box"}) == "box" ? nodes_in_box(table, mesh)
                                                              : read_nodes(table);
  }
}

const std::vector<std::int64_t>& NodeSets::find(const TomlTable& table,
                                                std::string_view key) const {
  const std::string name = table.text(key);
  if (const auto found = own_.find(name); found != own_.end()) return found->second;
  if (const auto found = meshed_.find(in_capitals(name)); found != meshed_.end()) {
    if (!found->second.empty()) return found->second;
    throw InputError(table.name(key), in_quotes(name), "must have at least one node");
  }
  std::vector<std::string_view> names;
  for (const auto& [its, nodes] : own_) names.emplace_back(its);
  for (const auto& [its, nodes] : meshed_) names.emplace_back(its);
  std::string_view closest = closest_name(name, names);
  if (closest.empty()) closest = closest_name(in_capitals(name), names);
  throw InputError(table.name(key), in_quotes(name),
                   "must be a [[set]] of the file, or a set of the mesh of [nodes]",
                   closest.empty() ? fmt::format("There are {} sets.", names.size())
                                   : fmt::format("Did you mean {}?", in_quotes(closest)));
}

MeshPlace read_place(const TomlTable& table, const NodeSets& sets) {
  const std::string_view key = only_key(table, {kNodeKey, kNodesKey, kSetKey, kRowKey});
  MeshPlace place{.name = place_name(table, key), .nodes = {}};
  if (key == kRowKey) {
    for (const std::string_view idle : {kSpiderKey, kAtKey}) {
      if (!table.has(idle)) continue;
      throw FormatError(table.place(idle), "a place with nodes", "a row", "Leave it out.");
    }
    place.row = row_of(table.name(key), table.number(key));
    return place;
  }
  place.nodes = nodes_of(table, key, sets);
  if (table.has(kSpiderKey)) place.spider = read_spider(table, place.nodes.size());
  if (table.has(kAtKey)) place.at = read_vector(table, kAtKey);
  return place;
}

std::vector<std::size_t> read_rows(const TomlTable& table) {
  const std::vector<double> numbers = table.numbers(kRowsKey);
  if (numbers.empty()) {
    throw InputError(table.name(kRowsKey), "an empty array", "must have at least one row");
  }
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    rows.push_back(row_of(table.name(kRowsKey, i), numbers[i]));
  }
  return rows;
}

MeshSupport read_support(const TomlTable& table, const NodeSets& sets) {
  table.allow_only({kNodeKey, kNodesKey, kSetKey, kRowsKey, "directions"});
  const std::string_view key = only_key(table, {kNodeKey, kNodesKey, kSetKey, kRowsKey});
  MeshSupport support{.name = place_name(table, key), .nodes = {}};
  if (key == kRowsKey) {
    if (table.has("directions")) {
      throw FormatError(table.place("directions"), "a support with nodes", "one of rows",
                        "Leave it out.");
    }
    support.rows = read_rows(table);
    return support;
  }
  support.nodes = nodes_of(table, key, sets);
  if (!table.has("directions")) return support;
  support.held.fill(false);
  for (const std::string& text : table.texts("directions")) {
    const std::optional<std::size_t> found = named_direction(text);
    if (!found) {
      throw InputError(table.name("directions"), in_quotes(text), "must be x, y, z, rx, ry or rz");
    }
    support.held[*found] = true;
  }
  return support;
}

MeshDirection read_direction(const TomlTable& table, bool needed) {
  if (!needed) {
    if (!table.has("direction")) return {};
    throw FormatError(table.place("direction"), "a place with nodes",
                      "rows, which define their own", "Leave it out.");
  }
  if (table.is_text("direction")) return read_named_direction(table, table.text("direction"));
  MeshDirection direction{.axis = read_vector(table, "direction")};
  const double length = std::hypot(direction.axis[0], direction.axis[1], direction.axis[2]);
  if (!(length > 0.0)) {
    throw InputError(table.name("direction"), "0 in x, y and z", "must be a direction");
  }
  for (double& value : direction.axis) value /= length;
  return direction;
}

}  // namespace microslip
