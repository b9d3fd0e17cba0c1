// SPDX-License-Identifier: MIT
#include <memory>

#include "command.hpp"

namespace microslip::app {
namespace {

constexpr const char* kDescription =
    "Identifies the friction model of a jointed structure from the energy it dissipates per\n"
    "cycle, and simulates the joint. All numbers are SI unless a unit is given.";

}  // namespace

std::unique_ptr<CLI::App> make_program(Call& call) {
  std::unique_ptr<CLI::App> program = empty_program(kDescription, "microslip");
  add_measure(*program, call);
  add_reduce(*program, call);
  add_levels(*program, call);
  add_calibrate(*program, call);
  add_identify(*program, call);
  add_campaign(*program, call);
  add_plan(*program, call);
  add_watch(*program, call);
  add_verify(*program, call);
#ifdef MICROSLIP_WITH_MODES
  add_modes(*program, call);
#endif
  add_model(*program, call);
  add_frf(*program, call);
  add_backbone(*program, call);
  add_load(*program, call);
  add_march(*program, call);
  add_spectrum(*program, call);
  add_ensemble(*program, call);
  add_loop(*program, call);
  add_dissipation(*program, call);
  add_report(*program, call);
  add_plot(*program, call);
  add_ringdown(*program, call);
  add_convert(*program, call);
  add_demo(*program, call);
  return program;
}

}  // namespace microslip::app
