// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/core.hpp"

/// @file
/// Views of plain numbers for Eigen. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// The values themselves, not a copy: they must outlive the view.
[[nodiscard]] inline Eigen::Map<const Eigen::VectorXd> view_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace microslip
