// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace microslip::python {

/// A table as its file has it: "amplitude [m]" → array, a column without unit → list of texts.
[[nodiscard]] pybind11::dict columns_of(const std::string& table);

}  // namespace microslip::python
