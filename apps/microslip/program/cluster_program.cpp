// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "arguments/help_formatter.hpp"
#include "microslip/base/version.hpp"

namespace microslip::app {
namespace {

constexpr const char* kClusterDescription =
    "The part of microslip that shares its work among the ranks of an MPI cluster:\n"
    "`mpirun -n 64 microslip-mpi ensemble plan.toml --out result.h5`.";

std::string exit_status_text() {
  std::string text = "Exit status:\n";
  for (const ExitStatusText& line : kExitStatusTexts) {
    text += fmt::format("  {}  {}\n", static_cast<int>(line.status), line.text);
  }
  return text;
}

}  // namespace

std::unique_ptr<CLI::App> empty_program(const char* description, const std::string& name) {
  auto program = std::make_unique<CLI::App>(description, name);
  program->set_version_flag("--version", name + " " + std::string(kVersion));
  program->require_subcommand(1);
  program->formatter(make_help_formatter(help_width()));
  program->footer(exit_status_text());
  return program;
}

std::unique_ptr<Team> Call::make_local_team(std::size_t threads) {
  return std::make_unique<LocalTeam>(Execution::threads(threads));
}

std::unique_ptr<CLI::App> make_cluster_program(Call& call) {
  std::unique_ptr<CLI::App> program = empty_program(kClusterDescription, "microslip-mpi");
  add_ensemble(*program, call);
  return program;
}

}  // namespace microslip::app
