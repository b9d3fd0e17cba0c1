// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "documents/documents.hpp"

namespace microslip::app {
namespace {

/// The code point that starts at text[at], which is moved behind it. The help is valid UTF-8.
std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto byte = [&] { return static_cast<unsigned char>(text[at++]); };
  const std::uint32_t first = byte();
  if (first < 0x80) return first;
  const int following = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  std::uint32_t point = first & (0x3FU >> following);
  for (int i = 0; i < following && at < text.size(); ++i) point = point << 6 | (byte() & 0x3FU);
  return point;
}

/// A text within a line: the signs that roff takes for something else, or shows as another sign, by
/// their names.
std::string roff(std::string_view text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t point = next_code_point(text, at);
    switch (point) {
      case '\\':
        escaped += "\\(rs";
        break;
      case '-':
        escaped += "\\-";
        break;
      case '\'':
        escaped += "\\(aq";
        break;
      case '"':
        escaped += "\\(dq";
        break;
      case '^':
        escaped += "\\(ha";
        break;
      case '~':
        escaped += "\\(ti";
        break;
      case '`':
        escaped += "\\(ga";
        break;
      default:
        escaped += point < 0x80 ? std::string(1, static_cast<char>(point))
                                : fmt::format("\\[u{:04X}]", point);
    }
  }
  return escaped;
}

/// A line of its own, which may begin with a dot.
std::string roff_line(std::string_view text) {
  return (text.starts_with('.') ? "\\&" : "") + roff(text) + "\n";
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return capitals;
}

std::string page_name(const CommandDescription& command) {
  std::string name = command.name;
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string reference_to(const CommandDescription& command) {
  return fmt::format("{}(1)", bold(page_name(command)));
}

std::string head(const ProgramDescription& program, const CommandDescription& command) {
  return fmt::format(
      ".\\\" Made from the help of the program.\n"
      ".TH {} 1 \"\" \"microslip {}\" \"microslip\"\n"
      ".SH NAME\n"
      "{} \\- {}\n"
      ".SH SYNOPSIS\n"
      ".ad l\n",
      roff(in_capitals(page_name(command))), program.version, roff(page_name(command)),
      roff(command.text));
}

std::string names(const ArgumentDescription& argument) {
  std::string text;
  for (const std::string& name : argument.names) text += (text.empty() ? "" : ", ") + bold(name);
  return text;
}

std::string with_value(const ArgumentDescription& argument) {
  return names(argument) + (argument.takes_value ? " " + italic(argument.value.name) : "");
}

std::string synopsis(const CommandDescription& command) {
  std::string text = bold(command.name);
  for (const ArgumentDescription& argument : command.positionals) {
    const std::string name = italic(argument.names.front()) + (argument.repeated ? " \\&..." : "");
    text += argument.required ? " " + name : " [" + name + "]";
  }
  for (const ArgumentDescription& option : command.options) {
    if (option.required) text += " " + with_value(option);
  }
  return text + " [" + italic("OPTIONS") + "]\n.ad b\n";
}

std::string argument_list(std::string_view heading,
                          const std::vector<ArgumentDescription>& arguments, bool positional) {
  if (arguments.empty()) return "";
  std::string text = fmt::format(".SH {}\n", heading);
  for (const ArgumentDescription& argument : arguments) {
    const std::string term = positional ? italic(argument.names.front()) : with_value(argument);
    text += ".TP\n" + term + "\n" + roff_line(sentence(argument.text));
    const std::string more = conditions(argument);
    if (!more.empty()) text += roff_line(more);
  }
  return text;
}

std::string man_sections(const CommandDescription& command) {
  std::string text;
  for (const HelpSection& section : command.sections) {
    const std::string heading = section.heading.empty() ? "NOTES" : in_capitals(section.heading);
    text += fmt::format(".SH {}\n.nf\n", roff(heading));
    for (const std::string& line : section.lines) text += roff_line(line);
    text += ".fi\n";
  }
  return text;
}

}  // namespace

std::string program_man_page(const ProgramDescription& program) {
  std::string text = head(program, program.program);
  text += fmt::format("{} {} [{}] ...\n.br\n{} {}\n.ad b\n", bold("microslip"), italic("COMMAND"),
                      italic("ARGUMENTS"), bold("microslip"), bold("--version"));
  text += ".SH DESCRIPTION\n" + roff_line(program.program.text) + ".SH COMMANDS\n";
  for (const CommandDescription& command : program.commands) {
    text += ".TP\n" + reference_to(command) + "\n" + roff_line(sentence(command.text));
  }
  text += argument_list("OPTIONS", program.program.options, false) + man_sections(program.program);
  return text;
}

std::string command_man_page(const ProgramDescription& program, const CommandDescription& command) {
  return head(program, command) + synopsis(command) +
         argument_list("ARGUMENTS", command.positionals, true) +
         argument_list("OPTIONS", command.options, false) + man_sections(command) +
         man_sections(program.program) + ".SH SEE ALSO\n" + reference_to(program.program) + "\n";
}

}  // namespace microslip::app
