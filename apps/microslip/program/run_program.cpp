// SPDX-License-Identifier: MIT

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/output/postponed_signals.hpp"
#include "microslip/io/output/temporaries.hpp"
#include "microslip/io/output/write_error.hpp"
#include "microslip/workflow/text/nothing_found.hpp"

namespace microslip::app {
namespace {

constexpr std::string_view kStandardOutput = "standard output";

// Nothing half-written stays behind: files in the making go, then the signal does what it would
// have done.
extern "C" void remove_temporaries_and_die(int signal) {
  if (postpone_signal(signal)) return;
  remove_temporaries();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Signals that the caller ignores, as nohup does, stay ignored.
void remove_temporaries_on(int signal) {
  if (std::signal(signal, remove_temporaries_and_die) == SIG_IGN) std::signal(signal, SIG_IGN);
}

std::string quoted(std::string_view argument) {
  const bool plain = !argument.empty() && argument.find_first_not_of(
                                              "abcdefghijklmnopqrstuvwxyz"
                                              "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                              "0123456789-_=+.,:/@%") == std::string_view::npos;
  if (plain) return std::string(argument);
  std::string text = "'";
  for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string command_line(const std::vector<char*>& arguments) {
  std::string text = "microslip";
  for (std::size_t i = 1; i < arguments.size(); ++i) text += " " + quoted(arguments[i]);
  return text;
}

/// One line, whatever a name or a cell holds. Nobody may listen: that is no error.
int complain(int status, std::string_view message) {
  print_text(stderr, fmt::format("microslip: {}\n", printable(with_option_names(message))));
  return status;
}

/// What readers of recordings advise, whoever calls them.
constexpr std::array<std::string_view, 3> kReadingOptions{"rate", "assume_units",
                                                          "allow_truncated"};

/// A message on a file may name an option that the command does not have: then the file is
/// converted first, or the file of a campaign has a key of the name.
std::string with_options_of(const CLI::App& program, std::string_view message) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  if (chosen.empty()) return with_option_names(message);
  const CLI::App& command = *chosen.front();
  return with_option_names(message, [&](std::string_view name, const std::string& option) {
    const bool reads = std::ranges::find(kReadingOptions, name) != kReadingOptions.end();
    if (!reads || command.get_option_no_throw(option) != nullptr) return option;
    if (command.get_name() != "campaign") return option + " of convert";
    return name == "rate" ? std::string("rate_Hz of the test") : std::string(name) + " of the test";
  });
}

/// "; did you mean --stiffness?": the name that was probably meant, where there is one.
std::string near_text(std::string_view name, const std::vector<std::string>& known) {
  const std::string_view nearest = closest_name(name, {known.begin(), known.end()});
  return nearest.empty() ? std::string() : fmt::format("; did you mean {}?", nearest);
}

/// CLI11's "OPTION: VALUE not in {A,B}" in the form of all messages; others as they are.
std::string value_fault(const std::string& text) {
  constexpr std::string_view kNotIn = " not in {";
  const std::size_t colon = text.find(": ");
  const std::size_t list = text.find(kNotIn);
  if (colon == std::string::npos || list == std::string::npos || list < colon ||
      !text.ends_with('}')) {
    return text;
  }
  std::vector<std::string> known;
  std::istringstream names(
      text.substr(list + kNotIn.size(), text.size() - list - kNotIn.size() - 1));
  for (std::string name; std::getline(names, name, ',');) known.push_back(name);
  const std::string value = text.substr(colon + 2, list - colon - 2);
  return fmt::format("{} = '{}'; must be one of {}{}", text.substr(0, colon), value,
                     fmt::join(known, ", "), near_text(value, known));
}

/// An option that the subcommand does not have, and the one that was probably meant.
std::string unknown_option(const CLI::App& command, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& one : option->get_lnames()) known.push_back("--" + one);
  }
  return fmt::format("There is no option {}{}", name, near_text(name, known));
}

/// An option that CLI11 took for the value of the one before it: "--stiffness --out x.json".
std::string swallowed_option(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (!value.starts_with("--") || command.get_option_no_throw(value) == nullptr) continue;
      return fmt::format("{} has no value: it is followed by the option {}", option->get_name(),
                         value);
    }
  }
  return "";
}

/// "--amplitude 9 um": the shell hands it on as two.
std::string split_unit(const std::vector<std::string>& rest) {
  if (rest.size() != 1 || !find_unit(rest.front())) return "";
  return fmt::format("'{}' stands alone; write a number and its unit together, without a space",
                     rest.front());
}

/// Fault found by CLI11, but for unknown options and subcommands, which it does not name.
std::string fault_of(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  if (!chosen.empty()) {
    if (std::string text = swallowed_option(*chosen.front()); !text.empty()) return text;
    if (std::string text = split_unit(chosen.front()->remaining()); !text.empty()) return text;
    for (const std::string& argument : chosen.front()->remaining()) {
      if (argument == "--") return "After -- all arguments are file names: give options before it";
      if (argument.starts_with("--")) return unknown_option(*chosen.front(), argument);
    }
    return value_fault(error.what());
  }
  const std::vector<std::string> rest = program.remaining();
  if (rest.empty()) return error.what();
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  if (rest.front().starts_with('-')) return unknown_option(program, rest.front());
  return fmt::format("subcommand = '{}'; must be one of {}{}", rest.front(), fmt::join(names, ", "),
                     near_text(rest.front(), names));
}

/// Buffers standard output until the end: for an earlier write the cause of a failure would be
/// lost.
void write_at_the_end() {
  static std::array<char, std::size_t{1} << 16U> text;  // a length without it is not heeded
  if (::isatty(STDOUT_FILENO) == 0) (void)std::setvbuf(stdout, text.data(), _IOFBF, text.size());
}

/// @throws WriteError  where what was printed got lost.
void finish_printed() {
  const bool whole = std::ferror(stdout) == 0;
  if (std::fflush(stdout) != 0) fail_to_write(kStandardOutput, errno);
  if (!whole) fail_to_write(kStandardOutput, EIO);
  close_copy(STDOUT_FILENO, kStandardOutput);
}

/// The status, which a summary that got lost does not change: the files that it tells of are whole.
int finished_with_summary(int status) {
  try {
    finish_printed();
  } catch (const WriteError& error) {
    complain(status, fmt::format("warning: the summary is lost: {}", error.what()));
  }
  return status;
}

/// A stream that the caller has closed must not become a file that is written: messages would get
/// into it. Reading from it or writing to it fails.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    const int access = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", access) < 0) return;  // takes the lowest number that is free
  }
}

/// `microslip help [COMMAND]` is `microslip [COMMAND] --help`.
bool takes_help(std::vector<char*>& arguments) {
  const bool takes = arguments.size() > 1 && std::string_view(arguments[1]) == "help";
  if (takes) arguments.erase(arguments.begin() + 1);
  return takes;
}

/// A name that is no subcommand stands alone, so that it is named.
void add_help(const CLI::App& program, std::vector<char*>& arguments) {
  static std::string option = "--help";
  const auto known = program.get_subcommands({});
  const bool unknown =
      arguments.size() > 1 && std::ranges::none_of(known, [&](const CLI::App* command) {
        return command->get_name() == arguments[1];
      });
  arguments.resize(std::min<std::size_t>(arguments.size(), 2));
  if (!unknown) arguments.push_back(option.data());
}

int parse_and_run(CLI::App& program, Call& call, std::vector<char*>& arguments) {
  try {
    program.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::Success& success) {
    const int status = program.exit(success);  // --help, --version
    finish_printed();
    return status;
  } catch (const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const std::string help =
        chosen.empty() ? "microslip --help" : "microslip " + chosen.front()->get_name() + " --help";
    const std::string fault = fault_of(program, error);
    return complain(kInputAtFault, fmt::format("{}{} Run `{}` for the options and examples.", fault,
                                               fault.ends_with('?') ? "" : ".", help));
  }
  const int status = call.run();
  if (!call.prints_result) return finished_with_summary(status);
  finish_printed();
  return status;
}

}  // namespace

int run_program(int argc, char** argv, Call& call, std::unique_ptr<CLI::App> (*make)(Call& call)) {
  occupy_closed_streams();
  write_at_the_end();
  // Those of a terminal, and those by which batch systems tell that the time is over.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2, SIGALRM}) {
    remove_temporaries_on(signal);
  }
  // A closed pipe and a limit of the file size are errors of writing, as a full
  // disk.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  try {
    std::vector<char*> arguments(argv, argv + argc);
    const bool is_help = takes_help(arguments);
    call.command_line = command_line(arguments);
    const std::unique_ptr<CLI::App> program = make(call);
    if (is_help) add_help(*program, arguments);
    try {
      return parse_and_run(*program, call, arguments);
    } catch (const InputError& error) {
      return complain(kInputAtFault, with_options_of(*program, error.what()));
    } catch (const FormatError& error) {
      return complain(kInputAtFault, with_options_of(*program, error.what()));
    }
  } catch (const WriteError& error) {
    return complain(kFailed, error.what());
  } catch (const FileError& error) {
    return complain(kInputAtFault, error.what());
  } catch (const NothingFound& error) {
    return complain(kNotConverged, error.what());
  } catch (const StoppedElsewhere&) {
    return kDone;  // another process tells why
  } catch (const std::bad_alloc&) {
    return complain(kFailed,
                    "out of memory: the call needs more than this machine, or the limit of ulimit "
                    "-v, allows. Give a part of the file, fewer points, draws or --threads.");
  } catch (const std::system_error& error) {  // of a table on standard output, as a rule
    const bool lost = std::ferror(stdout) != 0;
    return complain(kFailed, lost ? fmt::format("{}: cannot be written: {}", kStandardOutput,
                                                error.code().message())
                                  : error.what());
  } catch (const std::exception& error) {
    return complain(kFailed, error.what());
  }
}

}  // namespace microslip::app
