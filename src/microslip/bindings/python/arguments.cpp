// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/arguments.hpp"

#include <memory>
#include <utility>

namespace py = pybind11;

namespace microslip::python {
namespace {

template <class Number>
py::array_t<Number, py::array::c_style> owning_array(std::vector<Number> numbers,
                                                     std::vector<py::ssize_t> shape) {
  auto owned = std::make_unique<std::vector<Number>>(std::move(numbers));
  const Number* const data = owned->data();
  const py::capsule owner(owned.get(),
                          [](void* vector) { delete static_cast<std::vector<Number>*>(vector); });
  owned.release();
  return py::array_t<Number, py::array::c_style>(std::move(shape), data, owner);
}

}  // namespace

std::span<const double> values(const RealArray& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

std::span<const std::complex<double>> values(const ComplexArray& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

std::vector<double> copy_of(const RealArray& array) {
  const auto all = values(array);
  return {all.begin(), all.end()};
}

std::vector<double> copy_of(const py::object& array) {
  return array.is_none() ? std::vector<double>{} : copy_of(array.cast<RealArray>());
}

RealArray array_of(std::vector<double> numbers) {
  const auto size = static_cast<py::ssize_t>(numbers.size());
  return owning_array(std::move(numbers), {size});
}

ComplexArray array_of(std::vector<std::complex<double>> numbers) {
  const auto size = static_cast<py::ssize_t>(numbers.size());
  return owning_array(std::move(numbers), {size});
}

py::object array_or_none(std::vector<double> numbers) {
  return numbers.empty() ? py::object(py::none()) : array_of(std::move(numbers));
}

RealArray array_of(std::vector<double> numbers, std::size_t columns) {
  const auto rows = static_cast<py::ssize_t>(columns == 0 ? 0 : numbers.size() / columns);
  return owning_array(std::move(numbers), {rows, static_cast<py::ssize_t>(columns)});
}

}  // namespace microslip::python
