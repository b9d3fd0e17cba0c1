// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Recordings as the package passes them: a dict of `source`, `axis` (unit, start, step, values
/// or None), `channels` (name, unit or None, values, attributes) and `attributes`; units of SI.
namespace microslip::python {

/// find_unit() of a text that must name one. @throws InputError
[[nodiscard]] Unit known_unit(const std::string& text);

[[nodiscard]] Recording recording_of(const pybind11::dict& recording);
[[nodiscard]] std::vector<Recording> recordings_of(const pybind11::list& recordings);

[[nodiscard]] pybind11::dict dict_of(Recording recording);
[[nodiscard]] pybind11::list list_of(std::vector<Recording> recordings);

/// Numbers that may be complex, of an array and as one.
void set_values(const pybind11::object& values, std::vector<double>& real,
                std::vector<double>& imaginary);
[[nodiscard]] pybind11::object values_of(std::vector<double> real,
                                         const std::vector<double>& imaginary);

}  // namespace microslip::python
