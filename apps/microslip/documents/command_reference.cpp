// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "documents/documents.hpp"

namespace microslip::app {
namespace {

/// Escapes what Markdown would take for emphasis, a tag or a link.
std::string markdown(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("*_<`\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// As the sites that show Markdown name the place of a heading.
std::string link_to(const CommandDescription& command) {
  std::string anchor = command.name;
  std::ranges::replace(anchor, ' ', '-');
  return fmt::format("[`{}`](#{})", command.name, anchor);
}

std::string call(const CommandDescription& command) {
  std::string text = command.name;
  for (const ArgumentDescription& argument : command.positionals) {
    const std::string name = argument.names.front() + (argument.repeated ? "..." : "");
    text += argument.required ? " " + name : " [" + name + "]";
  }
  for (const ArgumentDescription& option : command.options) {
    if (option.required) text += fmt::format(" {} {}", option.names.back(), option.value.name);
  }
  return fmt::format("    {} [OPTIONS]\n\n", text);
}

std::string list(std::string_view heading, const std::vector<ArgumentDescription>& arguments) {
  if (arguments.empty()) return "";
  std::string text = fmt::format("{}:\n\n", heading);
  for (const ArgumentDescription& argument : arguments) {
    const std::string value = argument.takes_value ? " " + argument.value.name : "";
    text += fmt::format("* `{}{}`", fmt::join(argument.names, "`, `"), value);
    if (argument.required) text += ", required";
    text += ": " + markdown(sentence(argument.text));
    const std::string more = conditions(argument);
    text += (more.empty() ? "" : " " + markdown(more)) + "\n";
  }
  return text + "\n";
}

std::string page_sections(const CommandDescription& command) {
  std::string text;
  for (const HelpSection& section : command.sections) {
    if (!section.heading.empty()) text += section.heading + ":\n\n";
    for (const std::string& line : section.lines) text += "    " + line + "\n";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string command_reference(const ProgramDescription& program) {
  std::string text = "# Commands\n\n";
  text +=
      "<!-- Made from the help of the program by the target command_reference; do not edit. "
      "-->\n\n";
  text += program.program.text + "\n\n";
  for (const CommandDescription& command : program.commands) {
    text += fmt::format("* {}: {}\n", link_to(command), markdown(sentence(command.text)));
  }
  text += "\n" + list("Options", program.program.options) + page_sections(program.program);
  for (const CommandDescription& command : program.commands) {
    text += fmt::format("## {}\n\n{}\n\n", command.name, markdown(sentence(command.text)));
    text += call(command) + list("Arguments", command.positionals) +
            list("Options", command.options) + page_sections(command);
  }
  text.pop_back();  // one empty line too much
  return text;
}

}  // namespace microslip::app
