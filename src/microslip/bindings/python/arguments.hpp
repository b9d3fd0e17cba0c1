// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <complex>
#include <span>
#include <string>
#include <vector>

namespace microslip::python {

/// An array as the package passes it: arguments of users were checked there, so that another type
/// is a mistake of the package, and no copy is made.
using RealArray = pybind11::array_t<double, pybind11::array::c_style>;
using ComplexArray = pybind11::array_t<std::complex<double>, pybind11::array::c_style>;

/// The numbers of an array, valid as long as it is.
[[nodiscard]] std::span<const double> values(const RealArray& array);
[[nodiscard]] std::span<const std::complex<double>> values(const ComplexArray& array);

/// A copy of the numbers.
[[nodiscard]] std::vector<double> copy_of(const RealArray& array);
/// A copy of the numbers; empty for None.
[[nodiscard]] std::vector<double> copy_of(const pybind11::object& array);
/// An array of the numbers, without a copy: it owns the vector.
[[nodiscard]] RealArray array_of(std::vector<double> numbers);
[[nodiscard]] ComplexArray array_of(std::vector<std::complex<double>> numbers);
/// An array, or None without numbers, as of quantities that were not measured.
[[nodiscard]] pybind11::object array_or_none(std::vector<double> numbers);
/// An array by rows, of a length that divides theirs.
[[nodiscard]] RealArray array_of(std::vector<double> numbers, std::size_t columns);

}  // namespace microslip::python
