// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

/// @file
/// The matrices of a discretised structure, K and M of M ẍ + K x = f, before modes are made of
/// them.

namespace microslip {

/// A symmetric matrix by its entries on and below the diagonal; entries of one place add up.
struct SymmetricEntries {
  std::size_t size = 0;              ///< rows, and columns
  std::vector<std::int32_t> row;     ///< from 0
  std::vector<std::int32_t> column;  ///< from 0, ≤ row; one per entry
  std::vector<double> value;         ///< finite; one per entry
  /// Entries of a file that stood at a place that another one before had.
  std::size_t repeated = 0;
  /// Whether the file does not say how many entries it has: lines may be missing at its end.
  bool is_open_ended = false;
};

/// The largest matrix that is taken, rows: indices are of 32 bits, and a factor needs more.
inline constexpr std::size_t kMostDegreesOfFreedom = 20'000'000;

/// The direction in which a degree of freedom displaces its node, or the axis it turns it about.
enum class NodalDirection : std::uint8_t { kX, kY, kZ, kTurnX, kTurnY, kTurnZ };

inline constexpr std::size_t kNodalDirections = 6;  ///< how many there are

/// "x", "y", "z", "rx", "ry", "rz".
inline constexpr std::array<std::string_view, kNodalDirections> kNodalDirectionNames = {
    "x", "y", "z", "rx", "ry", "rz"};

/// Degree of freedom of a row of the matrices.
struct DegreeOfFreedom {
  std::int64_t node = 0;                          ///< its number in the mesh
  NodalDirection direction = NodalDirection::kX;  ///< translation, m, or rotation, rad

  /// Orders by node, then by direction.
  friend auto operator<=>(const DegreeOfFreedom&, const DegreeOfFreedom&) = default;
};

/// K and M of a structure without its joints, in SI.
struct StructuralMatrices {
  SymmetricEntries stiffness;  ///< K, N/m (N m/rad of rotations); n × n
  SymmetricEntries mass;       ///< M, kg (kg m² of rotations); n × n
  /// One per row; empty where the degrees of freedom are not known.
  std::vector<DegreeOfFreedom> degrees = {};
  /// Whether several rows may be of one degree of freedom, as of the faces of shells that were
  /// expanded to solids: the node moves by their mean, and a force on it is shared by them.
  bool expanded = false;
  double stiffness_rounding = 0.0;  ///< entry_rounding() of K as it was written; from 0
  double possible_rounding = 0.0;   ///< possible_entry_rounding() of K as it was written; from 0
};

}  // namespace microslip
