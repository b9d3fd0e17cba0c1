// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/dynamics/march/march.hpp"

namespace microslip::python {

/// The loads on a structure, from the arguments of march() of the package.
[[nodiscard]] LoadHistory load_history_of(const RealArray& time, const pybind11::list& forces,
                                          const pybind11::list& normal_loads);
[[nodiscard]] MarchOptions march_options_of(const pybind11::dict& given);

/// Converts a march to Python.
[[nodiscard]] pybind11::dict march_dict(MarchResult result);

}  // namespace microslip::python
