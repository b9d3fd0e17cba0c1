// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace microslip::validation {

/// Of a figure, in its own unit.
struct Bounds {
  std::optional<double> at_least = {};
  std::optional<double> at_most = {};
};

/// Bounds in figures.toml of a figure of a test, `folder.Suite.Test` and `name [unit]`.
[[nodiscard]] Bounds bounds_of(const std::string& test, const std::string& figure);

}  // namespace microslip::validation
