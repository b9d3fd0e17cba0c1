// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// @file
/// The help of a program as plain values: the manual pages, the command reference and
/// the completions of the shells are written from it and from nothing else.

namespace microslip::app {

/// Completions that a shell can offer for a value.
enum class Offer {
  kNothing,  ///< a number
  kChoices,  ///< one of a few words
  kFiles,    ///< files with one of a few endings, or any where none is given
  kFolders,
};

struct ValueDescription {
  std::string name;  ///< as the help shows it: "FILE.csv", "UINT"
  std::string rule;  ///< which values it may have, where the help says it: "from 1 to 100"
  Offer offer = Offer::kNothing;
  std::vector<std::string> choices;
  std::vector<std::string> endings;  ///< without the dot, in small letters
};

/// A positional argument, an option or a flag.
struct ArgumentDescription {
  std::vector<std::string> names;  ///< "-h" and "--help"; of a positional its one name
  std::string text;
  bool takes_value = false;
  ValueDescription value;
  std::string default_text;  ///< empty where there is none
  bool required = false;
  bool repeated = false;  ///< may be given more than once
  std::vector<std::string> needs;
  std::vector<std::string> excludes;
};

/// A part at the end of a help text: a line "Examples:" and the indented ones below it.
struct HelpSection {
  std::string heading;             ///< without the colon; empty for lines without one
  std::vector<std::string> lines;  ///< without the indentation that all of them have
};

struct CommandDescription {
  std::string name;  ///< "microslip" or "microslip identify"
  std::string text;
  std::vector<ArgumentDescription> positionals;
  std::vector<ArgumentDescription> options;
  std::vector<HelpSection> sections;
};

struct ProgramDescription {
  CommandDescription program;
  std::string version;
  std::vector<CommandDescription> commands;
};

[[nodiscard]] ProgramDescription describe(const CLI::App& program, std::string version);

/// The part of a command's name after "microslip "; empty for the program itself.
[[nodiscard]] std::string subcommand_name(const CommandDescription& command);

/// With a full stop at its end.
[[nodiscard]] std::string sentence(std::string text);

/// Text after that of an argument, in sentences: choices, rule, default, other options that
/// it needs or excludes. Empty where there is nothing.
[[nodiscard]] std::string conditions(const ArgumentDescription& argument);

}  // namespace microslip::app
