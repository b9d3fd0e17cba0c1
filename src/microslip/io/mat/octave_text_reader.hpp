// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/io/recordings/mat_tree.hpp"

namespace microslip {

/// The variables of a text file of Octave, as `save` writes them by itself and with -text: numbers
/// real and complex of any class, ranges, texts, cells and structs, sparse and diagonal matrices.
/// Permutations, function handles and objects are MatValue::Kind::kOther.
/// @param text     of the whole file.
/// @param path     for messages.
/// @param options  a file that ends within its last variable is read up to that where they allow
///                 it; `only` has no effect.
/// @throws FormatError  naming file and line.
[[nodiscard]] MatTree parse_octave_text(const std::string& text, const std::string& path,
                                        const MatReadOptions& options);

}  // namespace microslip
