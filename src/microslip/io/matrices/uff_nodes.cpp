// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/uff_nodes.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

#include "microslip/base/error.hpp"
#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_fields.hpp"
#include "microslip/io/uff/uff_input.hpp"

namespace microslip {
namespace {

constexpr std::size_t kIntegerWidth = 10;
constexpr std::size_t kShortRealWidth = 13;
constexpr std::size_t kLongRealWidth = 25;

UffFields fields_of(UffEnvelope& envelope, std::string_view line) {
  return {line, envelope.input().place()};
}

/// The node's label, and what follows it is skipped: its systems and colour.
std::int64_t read_label(UffFields& fields) {
  const std::int64_t label = fields.integer(kIntegerWidth, "the number of a node");
  for (int i = 0; i < 3; ++i) fields.skip(kIntegerWidth);
  return label;
}

Vector3 read_position(UffFields& fields, std::size_t width, double length_unit) {
  Vector3 position = {};
  for (double& value : position) value = fields.number(width, "a coordinate") * length_unit;
  return position;
}

void read_nodes_15(UffEnvelope& envelope, double length_unit, MeshFile& mesh) {
  while (const std::optional<std::string_view> line = envelope.value_line()) {
    UffFields fields = fields_of(envelope, *line);
    const std::int64_t label = read_label(fields);
    mesh.nodes.push_back({label, read_position(fields, kShortRealWidth, length_unit)});
  }
}

void read_nodes_2411(UffEnvelope& envelope, double length_unit, MeshFile& mesh) {
  while (const std::optional<std::string_view> line = envelope.value_line()) {
    UffFields first = fields_of(envelope, *line);
    const std::int64_t label = read_label(first);
    UffFields second = envelope.fields("the coordinates of a node");
    mesh.nodes.push_back({label, read_position(second, kLongRealWidth, length_unit)});
  }
}

}  // namespace

MeshFile read_uff_nodes(const std::string& path, double length_unit) {
  UffInput input(path);
  UffEnvelope envelope(input);
  MeshFile mesh;
  double metres = length_unit;
  while (const std::optional<UffDataset> dataset = envelope.next()) {
    switch (dataset->number) {
      case 164:
        metres = 1.0 / read_uff164(envelope).length;
        mesh.own_unit = metres;
        break;
      case 15:
        read_nodes_15(envelope, metres, mesh);
        break;
      case 2411:
        read_nodes_2411(envelope, metres, mesh);
        break;
      default:
        break;
    }
    envelope.close();
  }
  return mesh;
}

}  // namespace microslip
