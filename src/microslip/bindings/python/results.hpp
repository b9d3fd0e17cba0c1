// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/records/record_inversion.hpp"

namespace microslip::python {

/// A summary as the package takes it: method, reason, converged, usable, residual, iterations,
/// seconds and the full text.
[[nodiscard]] pybind11::dict dict_of(const Summary& summary);

/// Value and both ends of the band.
[[nodiscard]] pybind11::tuple estimate_tuple(const Estimate& estimate);

/// Pairs of code and text.
[[nodiscard]] pybind11::list list_of(const std::vector<Warning>& warnings);

}  // namespace microslip::python
