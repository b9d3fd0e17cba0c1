// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/temporaries.hpp"
#include "nothing_found.hpp"

namespace {

using namespace microslip::app;

constexpr const char* kDescription =
    "Identifies the friction model of a jointed structure from the energy it dissipates per\n"
    "cycle, and simulates the joint. All numbers are SI unless a unit is given.";

// Nothing half-written stays behind: files in the making go, then the signal does what it would have
// done.
extern "C" void remove_temporaries_and_die(int signal) {
  microslip::remove_temporaries();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// What the caller wants ignored, as nohup does, stays ignored.
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

std::string command_line(int argc, char** argv) {
  std::string text = "microslip";
  for (int i = 1; i < argc; ++i) text += " " + quoted(argv[i]);
  return text;
}

/// One line, whatever a name or a cell holds. Nobody may listen: that is no error.
int complain(int status, std::string_view message) {
  std::string line = fmt::format("microslip: {}", message);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
  return status;
}

/// What CLI11 found, but for a subcommand that does not exist: it says that there is none.
std::string fault_of(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<std::string> rest = program.remaining();
  if (!program.get_subcommands().empty() || rest.empty()) return error.what();
  std::string names;
  for (const CLI::App* command : program.get_subcommands({})) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  if (rest.front().starts_with('-')) return fmt::format("There is no option {}", rest.front());
  return fmt::format("subcommand = '{}'; must be one of {}", rest.front(), names);
}

int parse_and_run(CLI::App& program, Call& call, int argc, char** argv) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const std::string help =
        chosen.empty() ? "microslip --help" : "microslip " + chosen.front()->get_name() + " --help";
    return complain(kInputAtFault, fmt::format("{}. Run `{}` for the options and examples.",
                                               fault_of(program, error), help));
  }
  const int status = call.run();
  if (std::fflush(stdout) != 0) {
    return complain(kFailed, fmt::format("standard output: cannot be written: {}",
                                         std::generic_category().message(errno)));
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) remove_temporaries_on(signal);
  try {
    CLI::App program(kDescription, "microslip");
    program.set_version_flag("--version", "microslip " + std::string(microslip::kVersion));
    program.require_subcommand(1);
    program.get_formatter()->column_width(36);
    Call call;
    call.command_line = command_line(argc, argv);
    add_measure(program, call);
    add_reduce(program, call);
    add_identify(program, call);
    add_loop(program, call);
    add_dissipation(program, call);
    add_verify(program, call);
    add_frf(program, call);
    add_backbone(program, call);
    add_march(program, call);
    add_convert(program, call);
    add_ringdown(program, call);
    add_demo(program, call);
    return parse_and_run(program, call, argc, argv);
  } catch (const microslip::InputError& error) {
    return complain(kInputAtFault, error.what());
  } catch (const microslip::FormatError& error) {
    return complain(kInputAtFault, error.what());
  } catch (const microslip::FileError& error) {
    return complain(kInputAtFault, error.what());
  } catch (const microslip::app::NothingFound& error) {
    return complain(kNotConverged, error.what());
  } catch (const std::bad_alloc&) {
    return complain(kFailed, "out of memory");
  } catch (const std::exception& error) {
    return complain(kFailed, error.what());
  }
}
