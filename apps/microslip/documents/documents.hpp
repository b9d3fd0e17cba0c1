// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "documents/description.hpp"

/// @file
/// The texts that are made from the help of the program when it is built.

namespace microslip::app {

/// Manual page of the program, or of one of its commands, for section 1: roff with the macros
/// "man", in ASCII.
[[nodiscard]] std::string program_man_page(const ProgramDescription& program);
[[nodiscard]] std::string command_man_page(const ProgramDescription& program,
                                           const CommandDescription& command);

/// All commands on one page, in Markdown.
[[nodiscard]] std::string command_reference(const ProgramDescription& program);

/// Scripts by which a shell completes commands, options, words that are chosen from a few, and
/// files by their ending. The one for bash needs nothing but bash 4.
[[nodiscard]] std::string bash_completion(const ProgramDescription& program);
[[nodiscard]] std::string zsh_completion(const ProgramDescription& program);

}  // namespace microslip::app
