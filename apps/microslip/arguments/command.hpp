// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/ensemble/team.hpp"

/// @file
/// Declarations common to the subcommands. Each is in a file of its own, adds itself to the program
/// by one function, and does its work by calls to the library.

// Only code that makes or parses an App needs CLI11, which is slow to compile.
namespace CLI {
class App;
}

namespace microslip::app {

/// Exit statuses of the program.
enum ExitStatus : int {
  kDone = 0,
  kFailed = 1,        ///< any other failure
  kInputAtFault = 2,  ///< the input or the call
  kNotConverged = 3,  ///< a solver; what it found, if anything, is written and marked
};

struct ExitStatusText {
  ExitStatus status;
  const char* text;
};

/// Exit statuses in the order and words of the help and the manual.
inline constexpr std::array<ExitStatusText, 4> kExitStatusTexts = {{
    {kDone, "done"},
    {kInputAtFault, "invalid input or call; one line names the place, the fault and the remedy"},
    {kNotConverged, "a solver did not converge; what it found, if anything, is written and marked"},
    {kFailed, "anything else, for instance a file that cannot be written"},
}};

/// Names of arguments in the help (CLI::Option::type_name) that are files or folders. The
/// completion of the shells offers names with this ending.
inline constexpr const char* kCsvValue = "FILE.csv";
inline constexpr const char* kHdf5Value = "FILE.h5";
inline constexpr const char* kJsonValue = "FILE.json";
inline constexpr const char* kTomlValue = "FILE.toml";
inline constexpr const char* kHtmlValue = "FILE.html";
inline constexpr const char* kInputValue = "INPUT";  ///< of another program, as export writes it
inline constexpr const char* kPictureValue = "PICTURE";      ///< in any format that is drawn
inline constexpr const char* kRecordingValue = "RECORDING";  ///< in any format that can be read
inline constexpr const char* kTestValue = "TEST";  ///< a recording, or another file of a test
inline constexpr const char* kDescriptionValue = "DESCRIPTION";  ///< .toml, or the .json of a joint
inline constexpr const char* kFolderValue = "FOLDER";
inline constexpr const char* kResultValue = "RESULT";  ///< a folder, or a file of any kind

/// The call of the program as a whole.
struct Call {
  std::string command_line;  ///< as typed, quoted where a shell would need it
  bool quiet = false;
  bool prints_result = false;  ///< what is printed is no summary of files that stay
  std::function<int()> run;    ///< set by the subcommand that was chosen; gives the exit status
  /// Makes the team that does the blocks of an ensemble. @param threads  maximum number; 0:
  /// default.
  std::function<std::unique_ptr<Team>(std::size_t threads)> make_team = make_local_team;

  /// This process alone.
  [[nodiscard]] static std::unique_ptr<Team> make_local_team(std::size_t threads);
};

/// The call as a small table names it: none in one that is printed, which scripts read on.
[[nodiscard]] inline std::string command_of(const Call& call, std::string_view out) {
  return out == "-" ? std::string() : call.command_line;
}

/// A program without subcommands.
[[nodiscard]] std::unique_ptr<CLI::App> empty_program(const char* description,
                                                      const std::string& name);

/// The program with all of its subcommands. Both must live until the call has run.
[[nodiscard]] std::unique_ptr<CLI::App> make_program(Call& call);

/// The program for a cluster, with only the subcommands that distribute their work.
[[nodiscard]] std::unique_ptr<CLI::App> make_cluster_program(Call& call);

/// Body of main(): parses the command line, runs the subcommand and reports errors.
/// @param make  make_program() or make_cluster_program(). @return the exit status.
[[nodiscard]] int run_program(int argc, char** argv, Call& call,
                              std::unique_ptr<CLI::App> (*make)(Call& call));

void add_measure(CLI::App& program, Call& call);
void add_reduce(CLI::App& program, Call& call);
void add_identify(CLI::App& program, Call& call);
void add_levels(CLI::App& program, Call& call);
void add_calibrate(CLI::App& program, Call& call);
void add_campaign(CLI::App& program, Call& call);
void add_loop(CLI::App& program, Call& call);
void add_dissipation(CLI::App& program, Call& call);
void add_export(CLI::App& program, Call& call);
void add_model(CLI::App& program, Call& call);
void add_modes(CLI::App& program, Call& call);
void add_frf(CLI::App& program, Call& call);
void add_backbone(CLI::App& program, Call& call);
void add_load(CLI::App& program, Call& call);
void add_spectrum(CLI::App& program, Call& call);
void add_march(CLI::App& program, Call& call);
void add_convert(CLI::App& program, Call& call);
void add_ringdown(CLI::App& program, Call& call);
void add_plan(CLI::App& program, Call& call);
void add_verify(CLI::App& program, Call& call);
void add_watch(CLI::App& program, Call& call);
void add_report(CLI::App& program, Call& call);
void add_plot(CLI::App& program, Call& call);
void add_demo(CLI::App& program, Call& call);
void add_ensemble(CLI::App& program, Call& call);

/// An example at the end of a subcommand's help.
void add_examples(CLI::App& command, const std::vector<std::string>& lines);

}  // namespace microslip::app
