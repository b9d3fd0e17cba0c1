// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "microslip/base/summary.hpp"

namespace microslip::python {

/// A summary as the package takes it: method, reason, converged, usable, residual, iterations,
/// seconds and the full text.
[[nodiscard]] pybind11::dict dict_of(const Summary& summary);

/// Pairs of code and text.
[[nodiscard]] pybind11::list list_of(const std::vector<Warning>& warnings);

}  // namespace microslip::python
