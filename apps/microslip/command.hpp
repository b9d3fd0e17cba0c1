// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

/// @file
/// What the subcommands share. Each lives in a file of its own, adds itself to the program by one
/// function, and does its work by calls to the library.

namespace microslip::app {

/// Exit statuses of the program.
enum ExitStatus : int {
  kDone = 0,
  kFailed = 1,        ///< anything that is neither of the others
  kInputAtFault = 2,  ///< the input or the call
  kNotConverged = 3,  ///< a solver; what was found is written and marked
};

/// The call of the program as a whole.
struct Call {
  std::string command_line;  ///< as typed, quoted where a shell would need it
  bool quiet = false;
  std::function<int()> run;  ///< set by the subcommand that was chosen; gives the exit status
};

void add_measure(CLI::App& program, Call& call);
void add_reduce(CLI::App& program, Call& call);
void add_identify(CLI::App& program, Call& call);
void add_loop(CLI::App& program, Call& call);
void add_dissipation(CLI::App& program, Call& call);
void add_frf(CLI::App& program, Call& call);
void add_backbone(CLI::App& program, Call& call);
void add_march(CLI::App& program, Call& call);
void add_convert(CLI::App& program, Call& call);
void add_ringdown(CLI::App& program, Call& call);
void add_verify(CLI::App& program, Call& call);
void add_demo(CLI::App& program, Call& call);

/// An example at the end of a subcommand's help.
void add_examples(CLI::App& command, const std::vector<std::string>& lines);

}  // namespace microslip::app
