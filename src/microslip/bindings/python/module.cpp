// SPDX-License-Identifier: MIT
#include <string>

#include "microslip/base/version.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"

PYBIND11_MODULE(_core, core) {
  using namespace microslip::python;
  core.doc() = "The compiled half of microslip. Not a public interface: import microslip.";
  core.attr("version") = std::string(microslip::kVersion);
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(stop_long_work));
  add_errors(core);
  add_joint(core);
  add_memory(core);
  add_identification(core);
  add_structure(core);
  add_vibration(core);
  add_march(core);
  add_harmonic_force(core);
  add_recordings(core);
  add_ring_down(core);
  add_rig(core);
  add_records(core);
  add_calibration(core);
  add_report(core);
  add_draws(core);
}
