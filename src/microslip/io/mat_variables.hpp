// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <set>
#include <string>

#include "microslip/io/mat_stream.hpp"
#include "microslip/io/mat_tree.hpp"
#include "microslip/io/text.hpp"

namespace microslip {

/// All variables of a file of version 4 or 5, from where the stream stands. Internal to io.
/// @param read_variable  reads the next one into the root.
/// @throws FormatError  where two have one name, too: no program writes that, and values are taken
///                      out of the tree by name.
template <class ReadVariable>
[[nodiscard]] MatTree read_variables(MatFileStream& file, const MatReadOptions& options,
                                     const ReadVariable& read_variable) {
  MatTree tree;
  tree.root.kind = MatValue::Kind::kStruct;
  tree.root.sizes = {1, 1};
  std::set<std::string> names;
  try {
    while (!file.at_end()) {
      const std::size_t before = tree.root.fields.size();
      read_variable(tree.root);
      if (tree.root.fields.size() == before) continue;
      const std::string& name = tree.root.fields.back();
      if (!names.insert(name).second) {
        file.fail("each variable once", fmt::format("{} twice", in_quotes(name)));
      }
    }
  } catch (const MatStream::Ended&) {
    if (!options.allow_truncated) throw;
    tree.truncated = true;
  }
  return tree;
}

}  // namespace microslip
