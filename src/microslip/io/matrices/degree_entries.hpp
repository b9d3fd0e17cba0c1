// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/structure/structural_matrices.hpp"

/// @file
/// Matrices whose entries name nodes and directions in place of rows and columns. Internal to io.

namespace microslip {

/// An entry as the file has it.
struct DegreeEntry {
  DegreeOfFreedom row;
  DegreeOfFreedom column;
  double value = 0.0;
};

/// A matrix of such entries.
struct DegreeMatrix {
  /// What of a symmetric matrix the file has.
  enum class Triangles {
    kOne,     ///< each pair of degrees of freedom once, in either order
    kBoth,    ///< the whole matrix
    kEither,  ///< both where any entry has one across the diagonal, else one
  };
  std::string name;  ///< of file and matrix, for messages
  Triangles triangles = Triangles::kEither;
  std::vector<DegreeEntry> entries = {};
  std::string_view twice = {};  ///< for messages: what must not be there twice
  std::string_view lacks =
      {};  ///< for messages: remedy where an entry has none across the diagonal
};

/// "z of 12".
[[nodiscard]] std::string degree_text(const DegreeOfFreedom& degree);

/// Both matrices, their rows the degrees of freedom that one of the two names, in rising order.
/// @throws InputError  for an entry that is there twice; one that differs from that across the
///     diagonal; a degree of freedom that has stiffness and no entry on the diagonal.
[[nodiscard]] StructuralMatrices matrices_of(const DegreeMatrix& stiffness,
                                             const DegreeMatrix& mass);

}  // namespace microslip
