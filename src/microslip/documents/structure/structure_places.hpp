// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/open/mesh_file.hpp"
#include "microslip/structure/meshed_structure.hpp"

/// @file
/// Places and directions of a STRUCTURE.toml. Internal to documents.

namespace microslip {

/// The sets of the file, and those of the mesh beside them; which one is meant by a name.
class NodeSets {
 public:
  /// @param top   may have [[set]].
  /// @param mesh  its nodes are looked at by boxes; its sets are found in any capitals.
  /// @throws FormatError, InputError  for a set that is empty, or of a name that is taken.
  NodeSets(const TomlTable& top, const MeshFile& mesh);
  /// None.
  NodeSets() = default;

  /// The nodes of the set that a key names. @throws InputError  with the closest name.
  [[nodiscard]] const std::vector<std::int64_t>& find(const TomlTable& table,
                                                      std::string_view key) const;

 private:
  std::map<std::string, std::vector<std::int64_t>, std::less<>> own_;
  std::map<std::string, std::vector<std::int64_t>, std::less<>> meshed_;  ///< in capitals
};

/// The keys of a place.
inline constexpr std::string_view kNodeKey = "node";
inline constexpr std::string_view kNodesKey = "nodes";
inline constexpr std::string_view kSetKey = "set";
inline constexpr std::string_view kRowKey = "row";
inline constexpr std::string_view kRowsKey = "rows";
inline constexpr std::string_view kSpiderKey = "spider";
inline constexpr std::string_view kAtKey = "at_m";

/// @throws FormatError, InputError  where it is not one place.
[[nodiscard]] MeshPlace read_place(const TomlTable& table, const NodeSets& sets);

/// The key rows: rows of the matrices from 1, here from 0. @throws InputError  for none, or no row.
[[nodiscard]] std::vector<std::size_t> read_rows(const TomlTable& table);

/// Of the keys node, nodes, set, rows and directions.
[[nodiscard]] MeshSupport read_support(const TomlTable& table, const NodeSets& sets);

/// The key direction of a table.
/// @param needed  where a place has nodes; of rows alone there must be none.
[[nodiscard]] MeshDirection read_direction(const TomlTable& table, bool needed);

}  // namespace microslip
