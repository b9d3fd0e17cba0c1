// SPDX-License-Identifier: MIT
#include "microslip/io/open/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/matrices/mesh_input.hpp"
#include "microslip/io/matrices/uff_nodes.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/io/uff/uff_envelope.hpp"

namespace microslip {
namespace {

constexpr std::size_t kHead = 65536;

/// The first line that is neither blank nor a comment of a table.
std::string_view first_line(std::string_view head) {
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  while (!head.empty()) {
    const std::string_view line = take_dos_line(head);
    if (!trimmed(line).empty() && !trimmed(line).starts_with('#')) return line;
  }
  return {};
}

double unit_of_column(const CsvTable& table, std::string_view name) {
  const auto column = std::ranges::find(table.columns(), name, &CsvColumn::name);
  const bool given = column != table.columns().end() && column->unit;
  const std::optional<Unit> unit = given ? find_unit(*column->unit) : std::nullopt;
  return unit ? unit->factor() : 1.0;
}

MeshFile parse_node_table(std::string text, const std::string& file) {
  const CsvTable table(std::move(text), file);
  const std::vector<double> number = table.numbers("node", kDimensionless);
  const std::vector<double> x = table.numbers("x", kLength);
  const std::vector<double> y = table.numbers("y", kLength);
  const std::vector<double> z = table.numbers("z", kLength);
  MeshFile mesh;
  mesh.own_unit = unit_of_column(table, "x");
  for (std::size_t i = 0; i < number.size(); ++i) {
    const bool whole = number[i] >= 1.0 && number[i] <= 1e15 && number[i] == std::floor(number[i]);
    if (!whole) table.reject(i, "node", "the number of a node");
    mesh.nodes.push_back({static_cast<std::int64_t>(number[i]), {x[i], y[i], z[i]}});
  }
  return mesh;
}

constexpr std::string_view kExpectedNodes =
    "nodes: *NODE of CalculiX, datasets 15 or 2411, or a table node, x, y, z";

/// @throws FormatError  where it is a mesh of a program that is not read.
void require_known_mesh(std::string_view head, std::string_view line, const std::string& path) {
  constexpr std::string_view kGroups =
      "In gmsh save it as .inp or .unv, with the option 'Save groups of nodes'.";
  const auto fail = [&](std::string_view found, std::string_view remedy) {
    throw FormatError({path, 0, 0}, kExpectedNodes, found, remedy);
  };
  if (line.starts_with("$MeshFormat")) fail("a mesh of gmsh", kGroups);
  if (head.starts_with("# vtk DataFile")) fail("a mesh of VTK", kGroups);
  if (line.starts_with("$ Created by Gmsh") || line.starts_with("GRID") ||
      line.starts_with("BEGIN BULK") || line.starts_with("CEND")) {
    fail("bulk data of Nastran", kGroups);
  }
}

}  // namespace

MeshFile read_mesh(const std::string& path, double length_unit) {
  const std::string head = read_file_head(path, kHead);
  const std::string_view line = first_line(head);
  MeshFile mesh;
  require_known_mesh(head, line, path);
  if (is_uff_marker(line)) {
    mesh = read_uff_nodes(path, length_unit);
  } else if (trimmed(line).starts_with('*')) {
    mesh = parse_mesh_input(read_text(path), path, length_unit);
  } else {
    mesh = parse_node_table(read_text(path), path);
  }
  if (!mesh.nodes.empty() || !mesh.sets.empty()) return mesh;
  throw FormatError({path, 0, 0}, kExpectedNodes, "none");
}

}  // namespace microslip
