// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"

/// @file
/// What the program writes, in every format, as tests need it that hinder it from doing so.

namespace microslip::cli_test {

/// One call and the file that it makes.
struct Writing {
  std::string out;
  Arguments call;
};

void PrintTo(const Writing& writing, std::ostream* to);

/// Calls that make every format of file once, each from what put_inputs() puts into its folder.
[[nodiscard]] std::vector<Writing> all_writings();

void put_inputs(const Sandbox& box);

}  // namespace microslip::cli_test
