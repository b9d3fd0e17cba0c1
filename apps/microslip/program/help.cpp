// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "arguments/command.hpp"

namespace microslip::app {

void add_examples(CLI::App& command, const std::vector<std::string>& lines) {
  std::string text = lines.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& line : lines) text += "  " + line + "\n";
  command.footer(text);
}

}  // namespace microslip::app
