// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/run_program.hpp"
#include "io/support.hpp"

/// @file
/// Models that the program takes.

namespace microslip::cli_test {

/// An example with model.toml and joint.json.
inline Sandbox example_model(const std::string& name) {
  const std::string folder = MICROSLIP_EXAMPLES "/" + name + "/";
  return Sandbox{{"model.toml", test::get(folder + "model.toml")},
                 {"joint.json", test::get(folder + "joint.json")}};
}

inline Sandbox one_mass() { return example_model("one_mass"); }

}  // namespace microslip::cli_test
