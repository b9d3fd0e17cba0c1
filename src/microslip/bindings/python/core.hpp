// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "microslip/joint/joint.hpp"

/// @file
/// The compiled half of the package: one function here for each file that adds a topic to it.
namespace microslip::python {

/// A joint is shared with the objects made of it, which may outlive the Python object.
using SharedJoint = std::shared_ptr<const Joint>;

void add_errors(pybind11::module_& core);
void add_joint(pybind11::module_& core);
void add_memory(pybind11::module_& core);
void add_identification(pybind11::module_& core);
void add_structure(pybind11::module_& core);
void add_vibration(pybind11::module_& core);
void add_march(pybind11::module_& core);
void add_harmonic_force(pybind11::module_& core);
void add_recordings(pybind11::module_& core);
void add_ring_down(pybind11::module_& core);
void add_rig(pybind11::module_& core);
void add_records(pybind11::module_& core);
void add_calibration(pybind11::module_& core);
void add_report(pybind11::module_& core);
void add_draws(pybind11::module_& core);

}  // namespace microslip::python
