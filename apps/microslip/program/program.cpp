// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>

#include "arguments/command.hpp"

namespace microslip::app {
namespace {

constexpr const char* kDescription =
    "Identifies the friction model of a jointed structure from the energy it dissipates per\n"
    "cycle, and simulates the joint. All numbers are SI unless a unit is given.";

struct Subcommand {
  std::string_view name;
  void (*add)(CLI::App& program, Call& call);
};

/// In the order of the help.
constexpr std::array kSubcommands{
    Subcommand{"measure", add_measure},
    Subcommand{"reduce", add_reduce},
    Subcommand{"levels", add_levels},
    Subcommand{"calibrate", add_calibrate},
    Subcommand{"identify", add_identify},
    Subcommand{"campaign", add_campaign},
    Subcommand{"plan", add_plan},
    Subcommand{"watch", add_watch},
    Subcommand{"verify", add_verify},
#ifdef MICROSLIP_WITH_MODES
    Subcommand{"modes", add_modes},
#endif
    Subcommand{"model", add_model},
    Subcommand{"frf", add_frf},
    Subcommand{"backbone", add_backbone},
    Subcommand{"load", add_load},
    Subcommand{"march", add_march},
    Subcommand{"spectrum", add_spectrum},
    Subcommand{"ensemble", add_ensemble},
    Subcommand{"loop", add_loop},
    Subcommand{"dissipation", add_dissipation},
    Subcommand{"export", add_export},
    Subcommand{"report", add_report},
    Subcommand{"plot", add_plot},
    Subcommand{"ringdown", add_ringdown},
    Subcommand{"convert", add_convert},
    Subcommand{"demo", add_demo},
};

/// Text after the name of the program.
std::string_view first_argument(std::string_view command_line) {
  const std::size_t space = command_line.find(' ');
  if (space == std::string_view::npos) return {};
  const std::string_view arguments = command_line.substr(space + 1);
  return arguments.substr(0, arguments.find(' '));
}

}  // namespace

/// The options of all subcommands take more time than some of them need for their work: where one
/// is called, it is made alone.
std::unique_ptr<CLI::App> make_program(Call& call) {
  std::unique_ptr<CLI::App> program = empty_program(kDescription, "microslip");
  const auto called =
      std::ranges::find(kSubcommands, first_argument(call.command_line), &Subcommand::name);
  if (called != kSubcommands.end()) {
    called->add(*program, call);
  } else {
    for (const Subcommand& subcommand : kSubcommands) subcommand.add(*program, call);
  }
  return program;
}

}  // namespace microslip::app
