// SPDX-License-Identifier: MIT
#include "documents/description.hpp"
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "arguments/command.hpp"
#include "microslip/documents/exports/export_targets.hpp"

namespace microslip::app {
namespace {

constexpr std::array kRecordingEndings = {"csv", "uff", "unv", "uf", "mat", "h5", "hdf5"};
constexpr std::array kPictureEndings = {"svg", "png", "pdf"};

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
  return fmt::format("{}", fmt::join(parts, separator));
}

/// CLI::IsMember says "{a,b}", CLI::Range "INT in [1 - 100]"; other validators something else.
void take_validator(std::string_view text, ValueDescription& value) {
  if (text.starts_with('{') && text.ends_with('}')) {
    value.choices = split(text.substr(1, text.size() - 2), ',');
    return;
  }
  const std::size_t open = text.find(" in [");
  const std::size_t dash = text.find(" - ", open);
  if (open == std::string_view::npos || dash == std::string_view::npos || !text.ends_with(']')) {
    value.rule = text;
    return;
  }
  const std::string_view from = text.substr(open + 5, dash - open - 5);
  const std::string_view to = text.substr(dash + 3, text.size() - dash - 4);
  value.rule = fmt::format("from {} to {}", from, to);
}

void find_offer(ValueDescription& value) {
  if (!value.choices.empty()) {
    value.offer = Offer::kChoices;
  } else if (value.name == kFolderValue) {
    value.offer = Offer::kFolders;
  } else if (value.name == kResultValue || value.name == kTestValue) {
    value.offer = Offer::kFiles;
  } else if (value.name == kDescriptionValue) {
    value.offer = Offer::kFiles;
    value.endings = {"toml", "json"};
  } else if (value.name == kRecordingValue) {
    value.offer = Offer::kFiles;
    value.endings.assign(kRecordingEndings.begin(), kRecordingEndings.end());
  } else if (value.name == kInputValue) {
    value.offer = Offer::kFiles;
    for (const ExportTarget& target : all_export_targets()) {
      const std::string ending(
          target.ending.substr(std::min<std::size_t>(1, target.ending.size())));
      if (!ending.empty() && std::ranges::count(value.endings, ending) == 0) {
        value.endings.push_back(ending);
      }
    }
  } else if (value.name == kPictureValue) {
    value.offer = Offer::kFiles;
    value.endings.assign(kPictureEndings.begin(), kPictureEndings.end());
  } else if (value.name.starts_with("FILE.")) {
    value.offer = Offer::kFiles;
    value.endings = {value.name.substr(value.name.find('.') + 1)};
  }
}

/// CLI11 names the type and then the validators: "UINT:INT in [1 - 100]".
ValueDescription describe_value(const CLI::Option& option) {
  ValueDescription value;
  const std::string type = option.get_type_name();
  const std::size_t end = std::min(type.find(':'), type.size());
  value.name = type.substr(0, end);
  if (end < type.size()) take_validator(std::string_view(type).substr(end + 1), value);
  find_offer(value);
  // Whatever it is: arguments that are no options are files as a rule.
  if (value.name == "TEXT" && value.choices.empty() && option.get_positional()) {
    value.offer = Offer::kFiles;
  }
  return value;
}

/// In the order of the letters: CLI11 has them in the order of their addresses.
std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::ranges::sort(names);
  return names;
}

ArgumentDescription describe_argument(const CLI::Option& option) {
  ArgumentDescription argument;
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  if (option.get_positional()) argument.names = {option.get_name(true)};
  argument.text = option.get_description();
  argument.takes_value = option.get_items_expected_max() > 0;
  argument.required = option.get_required();
  argument.repeated = option.get_items_expected_max() > 1;
  if (argument.takes_value) {
    argument.value = describe_value(option);
    argument.default_text = option.get_default_str();
  }
  argument.needs = names_of(option.get_needs());
  argument.excludes = names_of(option.get_excludes());
  return argument;
}

std::vector<HelpSection> sections_of(const std::string& footer) {
  std::vector<HelpSection> sections;
  for (const std::string& line : split(footer, '\n')) {
    if (line.empty()) continue;
    const bool heading = !line.starts_with(' ') && line.ends_with(':');
    if (heading || sections.empty()) sections.emplace_back();
    if (heading) {
      sections.back().heading = line.substr(0, line.size() - 1);
    } else {
      sections.back().lines.push_back(line.starts_with("  ") ? line.substr(2) : line);
    }
  }
  return sections;
}

CommandDescription describe_command(const CLI::App& app, std::string name) {
  CommandDescription command;
  command.name = std::move(name);
  command.text = app.get_description();
  std::ranges::replace(command.text, '\n', ' ');
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    auto& list = option->get_positional() ? command.positionals : command.options;
    list.push_back(describe_argument(*option));
  }
  command.sections = sections_of(app.get_footer());
  return command;
}

}  // namespace

ProgramDescription describe(const CLI::App& program, std::string version) {
  ProgramDescription description;
  description.program = describe_command(program, program.get_name());
  description.version = std::move(version);
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_group().empty()) continue;  // hidden
    description.commands.push_back(
        describe_command(*command, program.get_name() + " " + command->get_name()));
  }
  return description;
}

std::string subcommand_name(const CommandDescription& command) {
  const std::size_t space = command.name.find(' ');
  return space == std::string::npos ? "" : command.name.substr(space + 1);
}

std::string sentence(std::string text) {
  if (!text.ends_with('.')) text += '.';
  return text;
}

std::string conditions(const ArgumentDescription& argument) {
  std::vector<std::string> sentences;
  if (!argument.value.choices.empty()) {
    sentences.push_back("One of " + joined(argument.value.choices, ", ") + ".");
  }
  if (!argument.value.rule.empty()) sentences.push_back("Allowed: " + argument.value.rule + ".");
  if (!argument.default_text.empty()) {
    sentences.push_back("Default: " + argument.default_text + ".");
  }
  if (!argument.needs.empty()) {
    sentences.push_back("Only with " + joined(argument.needs, " and ") + ".");
  }
  if (!argument.excludes.empty()) {
    sentences.push_back("Not with " + joined(argument.excludes, " or ") + ".");
  }
  return joined(sentences, " ");
}

}  // namespace microslip::app
