// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "documents/documents.hpp"

namespace microslip::app {
namespace {

/// The part that is the same for each program. COMP_WORDS has ":" and "=" as words of their own.
constexpr const char* kEngine = R"~~~(
# _microslip_offer KIND TYPED: sets COMPREPLY.
_microslip_offer() {
  local typed=$2 entry path name all
  case $1 in
    words\ *)
      mapfile -t COMPREPLY < <(compgen -W "${1#words }" -- "$typed")
      ;;
    folders | files*)
      compopt -o filenames 2>/dev/null
      typed=${typed#[\"\']}
      typed=${typed//\\/}
      mapfile -t all < <(compgen -f -- "$typed")
      for entry in "${all[@]}"; do
        path=${entry/#\~\//$HOME/}
        name=${entry,,}
        if [[ -d $path || "$1 " == *" ${name##*.} "* ]]; then COMPREPLY+=("$entry"); fi
      done
      # None of the ending: whatever is there may be what is meant.
      if [[ ${#COMPREPLY[@]} -eq 0 && $1 == files* || $1 == files ]]; then COMPREPLY=("${all[@]}"); fi
      ;;
  esac
}

_microslip() {
  local command='' awaited='' glued='' position=0 word i
  local plain valued positionals endless kind
  COMPREPLY=()
  _microslip_command ''
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ $word == = ]]; then
      continue
    elif [[ $word == : ]]; then
      glued=yes
    elif [[ -n $glued ]]; then
      glued=''
    elif [[ -n $awaited ]]; then
      awaited=''
    elif [[ " $valued " == *" $word "* ]]; then
      awaited=$word
    elif [[ $word == -?* ]]; then
      continue
    elif [[ -z $command ]]; then
      command=$word
      _microslip_command "$command"
    else
      ((++position))
    fi
  done
  word=${COMP_WORDS[COMP_CWORD]}
  if [[ $word == = ]]; then word=''; fi
  if [[ -n $glued || $word == : ]]; then
    return 0
  elif [[ -n $awaited ]]; then
    _microslip_value "$command $awaited"
  elif [[ $word == -* ]]; then
    kind="words $plain $valued"
  else
    if [[ -n $endless && $position -ge ${#positionals[@]} ]]; then position=$((${#positionals[@]} - 1)); fi
    kind=${positionals[position]:-}
  fi
  _microslip_offer "$kind" "$word"
}

complete -F _microslip microslip
)~~~";

/// "words a b", "files csv", "files" for any, "folders", or nothing.
std::string kind_of(const ValueDescription& value) {
  switch (value.offer) {
    case Offer::kNothing:
      return "";
    case Offer::kChoices:
      return fmt::format("words {}", fmt::join(value.choices, " "));
    case Offer::kFiles:
      return value.endings.empty() ? "files"
                                   : fmt::format("files {}", fmt::join(value.endings, " "));
    case Offer::kFolders:
      break;
  }
  return "folders";
}

std::string names_of(const CommandDescription& command, bool with_value) {
  std::string names;
  for (const ArgumentDescription& option : command.options) {
    if (option.takes_value != with_value) continue;
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

std::string command_case(const CommandDescription& command, const std::string& positionals) {
  const bool endless = !command.positionals.empty() && command.positionals.back().repeated;
  return fmt::format(
      "    '{}')\n"
      "      plain='{}'\n"
      "      valued='{}'\n"
      "      positionals=({})\n"
      "      endless='{}'\n"
      "      ;;\n",
      subcommand_name(command), names_of(command, false), names_of(command, true), positionals,
      endless ? "yes" : "");
}

std::string command_cases(const ProgramDescription& program) {
  std::string subcommands;
  for (const CommandDescription& command : program.commands) {
    subcommands += " " + subcommand_name(command);
  }
  std::string cases = command_case(program.program, fmt::format("'words{}'", subcommands));
  for (const CommandDescription& command : program.commands) {
    std::string positionals;
    for (const ArgumentDescription& argument : command.positionals) {
      positionals += fmt::format("{}'{}'", positionals.empty() ? "" : " ", kind_of(argument.value));
    }
    cases += command_case(command, positionals);
  }
  return cases + "    *) plain='' valued='' positionals=() endless='' ;;\n";
}

std::string value_cases(const ProgramDescription& program) {
  std::string cases;
  for (const CommandDescription& command : program.commands) {
    for (const ArgumentDescription& option : command.options) {
      if (!option.takes_value) continue;
      std::string patterns;
      for (const std::string& name : option.names) {
        patterns +=
            fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", subcommand_name(command), name);
      }
      cases += fmt::format("    {}) kind='{}' ;;\n", patterns, kind_of(option.value));
    }
  }
  return cases + "    *) kind='' ;;\n";
}

}  // namespace

std::string bash_completion(const ProgramDescription& program) {
  return fmt::format(
      "# Completion of microslip {} for bash; made from the help of the program.\n\n"
      "# _microslip_command COMMAND: its options without and with a value, and what its arguments "
      "are.\n"
      "_microslip_command() {{\n"
      "  case $1 in\n{}  esac\n}}\n\n"
      "# _microslip_value 'COMMAND OPTION': what its value is.\n"
      "_microslip_value() {{\n"
      "  case $1 in\n{}  esac\n}}\n{}",
      program.version, command_cases(program), value_cases(program), kEngine);
}

}  // namespace microslip::app
