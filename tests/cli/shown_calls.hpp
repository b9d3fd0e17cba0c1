// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"

/// @file
/// Calls of the program that a text shows.

namespace microslip::cli_test {

/// Of each line that begins with the program's name. A line that ends in \ goes on in the next.
inline std::vector<Arguments> shown_calls(std::string text) {
  for (std::size_t i = text.find("\\\n"); i != std::string::npos; i = text.find("\\\n")) {
    text.erase(i, 2);
  }
  std::vector<Arguments> calls;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != "microslip") continue;
    calls.emplace_back();
    while (words >> word) calls.back().push_back(word);
  }
  return calls;
}

}  // namespace microslip::cli_test
