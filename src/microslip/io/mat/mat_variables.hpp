// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <set>
#include <string>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_stream.hpp"
#include "microslip/io/recordings/mat_tree.hpp"

/// @file
/// What the versions of MAT files have in common.

namespace microslip {

/// The names of the variables so far. No program writes one twice, and values are taken out of the
/// tree by name.
class MatNames {
 public:
  /// @throws FormatError  where there is one of this name, at the place where the file is.
  void add(const std::string& name, const MatFileStream& file) {
    if (names_.insert(name).second) return;
    file.fail("each variable once", fmt::format("{} twice", in_quotes(name)));
  }
  [[nodiscard]] std::size_t size() const { return names_.size(); }

 private:
  std::set<std::string> names_;
};

/// The variables that follow in a file, as fields of the root; of one that ends within the last of
/// them those before that, where the options allow it.
/// @param read_variable  adds the next one to the root.
template <class ReadVariable>
[[nodiscard]] MatTree read_mat_variables(const MatFileStream& file, const MatReadOptions& options,
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
