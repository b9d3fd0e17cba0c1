// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/uff_nodes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

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

/// Groups with nodes among their entities, as sets: number and seven others, the last of which is
/// the number of entities; the name; two entities a line, each of a type, a number and two others.
void read_groups(UffEnvelope& envelope, MeshFile& mesh) {
  constexpr int kOthers = 6;
  constexpr std::int64_t kNode = 7;
  while (const std::optional<std::string_view> line = envelope.value_line()) {
    UffFields first = fields_of(envelope, *line);
    (void)first.integer(kIntegerWidth, "the number of a group");
    for (int i = 0; i < kOthers; ++i) first.skip(kIntegerWidth);
    const std::int64_t count = first.integer(kIntegerWidth, "the number of entities of a group");
    constexpr std::size_t kNameWidth = 80;
    NodeSet set{.name = envelope.fields("the name of a group").text(kNameWidth), .nodes = {}};
    for (std::int64_t done = 0; done < count; done += 2) {
      UffFields pair = envelope.fields("entities of a group");
      for (std::int64_t i = done; i < std::min(done + 2, count); ++i) {
        const std::int64_t type = pair.integer(kIntegerWidth, "the type of an entity");
        const std::int64_t number = pair.integer(kIntegerWidth, "the number of an entity");
        for (int skipped = 0; skipped < 2; ++skipped) pair.skip(kIntegerWidth);
        if (type == kNode) set.nodes.push_back(number);
      }
    }
    std::ranges::sort(set.nodes);
    const auto rest = std::ranges::unique(set.nodes);
    set.nodes.erase(rest.begin(), rest.end());
    if (!set.nodes.empty()) mesh.sets.push_back(std::move(set));
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
      case 2467:
      case 2477:
        read_groups(envelope, mesh);
        break;
      default:
        break;
    }
    envelope.close();
  }
  return mesh;
}

}  // namespace microslip
