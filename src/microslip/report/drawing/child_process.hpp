// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Another program as a function from text to text. Internal to report.

namespace microslip {

struct ChildResult {
  std::string output;  ///< all that it wrote to its standard output
  std::string errors;  ///< all that it wrote to its standard error
  int status = 0;      ///< its exit status; 128 + the signal that ended it
};

/// Starts command[0], looked up in PATH, with the arguments that follow; no shell is involved.
/// Gives it `input` as its standard input and waits for its end. It need not read its input.
/// Several threads may do this at once.
/// @return nothing where there is no such program.
/// @throws Error  where the system cannot start it.
[[nodiscard]] std::optional<ChildResult> run_child(std::vector<std::string> command,
                                                   std::string_view input);

}  // namespace microslip
