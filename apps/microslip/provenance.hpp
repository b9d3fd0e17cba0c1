// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "command.hpp"

/// @file
/// What files that are written say of their origin.

namespace microslip::app {

/// An input of a command, as it was named and read.
struct NamedInput {
  std::string path;
  std::string text;
};

/// The lines of a comment: version and call, then "FILE: sha256 …" of each input.
[[nodiscard]] std::string provenance_of(const Call& call, const std::vector<NamedInput>& inputs);

}  // namespace microslip::app
