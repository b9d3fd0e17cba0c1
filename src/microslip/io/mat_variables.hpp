// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/mat_stream.hpp"
#include "microslip/io/mat_tree.hpp"

namespace microslip {

/// All variables of a file of version 4 or 5, from where the stream stands. Internal to io.
/// @param read_variable  reads the next one into the root.
template <class ReadVariable>
[[nodiscard]] MatTree read_variables(MatFileStream& file, const MatReadOptions& options,
                                     const ReadVariable& read_variable) {
  MatTree tree;
  tree.root.kind = MatValue::Kind::kStruct;
  tree.root.sizes = {1, 1};
  try {
    while (!file.at_end()) read_variable(tree.root);
  } catch (const MatStream::Ended&) {
    if (!options.allow_truncated) throw;
    tree.truncated = true;
  }
  return tree;
}

}  // namespace microslip
