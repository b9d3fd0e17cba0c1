// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/results.hpp"

namespace py = pybind11;

namespace microslip::python {

py::dict dict_of(const Summary& summary) {
  using namespace py::literals;
  return py::dict("method"_a = summary.method, "reason"_a = summary.reason,
                  "converged"_a = summary.converged(), "usable"_a = summary.usable(),
                  "residual"_a = summary.residual, "iterations"_a = summary.iterations,
                  "seconds"_a = summary.wall_seconds, "text"_a = summary.full());
}

py::tuple estimate_tuple(const Estimate& estimate) {
  return py::make_tuple(estimate.value, estimate.lower, estimate.upper);
}

py::list list_of(const std::vector<Warning>& warnings) {
  py::list all;
  for (const Warning& warning : warnings) all.append(py::make_tuple(warning.code, warning.text));
  return all;
}

}  // namespace microslip::python
