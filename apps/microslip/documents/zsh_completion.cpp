// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "documents/documents.hpp"

namespace microslip::app {
namespace {

/// Within a specification of _arguments, between single quotes.
std::string spec_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("[]:\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return escaped;
}

/// Endings in capitals or not. Parentheses around a single one would be qualifiers of the glob.
std::string files_action(const std::vector<std::string>& endings) {
  if (endings.empty()) return "_files";
  const std::string any_of = fmt::format("{}", fmt::join(endings, "|"));
  return fmt::format("_files -g \"*.(#i){}\"", endings.size() > 1 ? "(" + any_of + ")" : any_of);
}

std::string action_of(const ValueDescription& value) {
  switch (value.offer) {
    case Offer::kNothing:
      return " ";
    case Offer::kChoices:
      return fmt::format("({})", fmt::join(value.choices, " "));
    case Offer::kFiles:
      return files_action(value.endings);
    case Offer::kFolders:
      break;
  }
  return "_files -/";
}

/// One specification for each of its names; the other ones are excluded once it is there.
std::string option_specs(const ArgumentDescription& option) {
  std::string specs;
  for (const std::string& name : option.names) {
    const std::string once =
        option.repeated ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    const std::string value =
        option.takes_value
            ? fmt::format(":{}:{}", spec_text(option.value.name), action_of(option.value))
            : "";
    const bool assigned = option.takes_value && name.starts_with("--");
    specs += fmt::format(" \\\n    '{}{}{}[{}]{}'", once, name, assigned ? "=" : "",
                         spec_text(option.text), value);
  }
  return specs;
}

std::string positional_specs(const CommandDescription& command) {
  std::string specs;
  for (const ArgumentDescription& argument : command.positionals) {
    specs += fmt::format(" \\\n    '{}:{}:{}'",
                         argument.repeated   ? "*"
                         : argument.required ? ""
                                             : ":",
                         spec_text(argument.names.front()), action_of(argument.value));
  }
  return specs;
}

std::string subcommand_list(const ProgramDescription& program) {
  std::string list;
  for (const CommandDescription& command : program.commands) {
    list += fmt::format("    '{}:{}'\n", subcommand_name(command), spec_text(command.text));
  }
  return list;
}

std::string subcommand_cases(const ProgramDescription& program) {
  std::string cases;
  for (const CommandDescription& command : program.commands) {
    cases += fmt::format("    {})\n    _arguments", subcommand_name(command));
    for (const ArgumentDescription& option : command.options) cases += option_specs(option);
    cases += positional_specs(command) + "\n    ;;\n";
  }
  return cases;
}

}  // namespace

std::string zsh_completion(const ProgramDescription& program) {
  std::string options;
  for (const ArgumentDescription& option : program.program.options) options += option_specs(option);
  return fmt::format(
      "#compdef microslip\n"
      "# Completion of microslip {} for zsh; made from the help of the program.\n\n"
      "_microslip() {{\n"
      "  local context state state_descr line curcontext=\"$curcontext\"\n"
      "  typeset -A opt_args\n"
      "  local -a commands\n"
      "  commands=(\n{}  )\n"
      "  _arguments -C{} \\\n"
      "    '1:command:->command' \\\n"
      "    '*::argument:->argument' && return\n"
      "  case $state in\n"
      "  command) _describe -t commands 'command of microslip' commands ;;\n"
      "  argument)\n"
      "    case $words[1] in\n{}    esac\n"
      "    ;;\n"
      "  esac\n"
      "}}\n\n"
      "if [[ $funcstack[1] == _microslip ]]; then\n"
      "  _microslip \"$@\"\n"
      "else\n"
      "  compdef _microslip microslip\n"
      "fi\n",
      program.version, subcommand_list(program), options, subcommand_cases(program));
}

}  // namespace microslip::app
