// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "documents/description.hpp"

namespace microslip::app::examples_test {
namespace {

using Words = std::vector<std::string>;

/// The calls among the examples, without "microslip". A line that ends in \ goes on.
std::vector<Words> calls(const CommandDescription& command) {
  std::string text;
  for (const HelpSection& section : command.sections) {
    if (!section.heading.starts_with("Example")) continue;
    for (const std::string& line : section.lines) {
      text += line.ends_with('\\') ? line.substr(0, line.size() - 1) : line + "\n";
    }
  }
  std::vector<Words> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != "microslip") continue;
    result.emplace_back();
    while (words >> word) result.back().push_back(word);
  }
  return result;
}

/// "csv" of "level_*.csv"; nothing of "1.7e5" or "p=0.99".
std::string ending(const std::string& word) {
  const std::size_t dot = word.rfind('.');
  if (dot == std::string::npos || word.find_first_of("=:") != std::string::npos) return "";
  const std::string end = word.substr(dot + 1);
  return !end.empty() && std::isalpha(static_cast<unsigned char>(end.front())) != 0 ? end : "";
}

void expect_declared(const CommandDescription& command, const ArgumentDescription& argument,
                     const std::string& word) {
  const std::string end = ending(word);
  if (end.empty()) return;
  if (argument.value.offer == Offer::kFiles && argument.value.endings.empty()) return;  // any file
  EXPECT_NE(std::ranges::count(argument.value.endings, end), 0)
      << command.name << ": an example gives " << word << " to " << argument.names.back()
      << ", which is a " << argument.value.name << "; call it ->type_name(\"FILE." << end
      << "\"), or as command.hpp names such files, so that the shells complete it";
}

void check_call(const CommandDescription& command, const Words& words) {
  std::size_t position = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].starts_with("--")) {
      const auto option =
          std::ranges::find_if(command.options, [&](const ArgumentDescription& candidate) {
            return std::ranges::count(candidate.names, words[i]) > 0;
          });
      ASSERT_NE(option, command.options.end()) << command.name << " " << words[i];
      if (option->takes_value && i + 1 < words.size()) {
        expect_declared(command, *option, words[++i]);
      }
      continue;
    }
    ASSERT_FALSE(command.positionals.empty()) << command.name << " " << words[i];
    const std::size_t last = command.positionals.size() - 1;
    expect_declared(command, command.positionals[std::min(position++, last)], words[i]);
  }
}

TEST(Examples, NameFilesOnlyWhereShellsCompleteThem) {
  Call call;
  const std::unique_ptr<CLI::App> program = make_program(call);
  const std::vector<CommandDescription> commands = describe(*program, "").commands;
  std::size_t count = 0;
  for (const CommandDescription& shown : commands) {
    for (const Words& words : calls(shown)) {
      // An example may go on with another command.
      const auto called =
          std::ranges::find(commands, words.empty() ? "" : words.front(), subcommand_name);
      ASSERT_NE(called, commands.end()) << shown.name;
      check_call(*called, words);
      ++count;
    }
  }
  EXPECT_GE(count, 10u);
}

}  // namespace
}  // namespace microslip::app::examples_test
