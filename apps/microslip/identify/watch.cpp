// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/prediction.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/report_html.hpp"
#include "arguments/stiffness_argument.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/measure/watch_run.hpp"
#include "microslip/workflow/results/experiment_folder.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

using std::chrono::milliseconds;

struct WatchArguments {
  std::string folder;
  std::optional<std::string> stiffness;
  std::string target = "density";
  std::string amplitude;
  std::string interval = "2s";
  bool once = false;
  bool no_report = false;
};

volatile std::sig_atomic_t stop_asked = 0;

extern "C" void ask_to_stop(int) { stop_asked = 1; }

/// While it lives, the first Ctrl-C or SIGTERM asks to stop; another one ends the program as ever.
class StopOnSignal {
 public:
  StopOnSignal() {
    stop_asked = 0;
    for (Former& former : former_) {
      struct sigaction ask {};
      ask.sa_handler = ask_to_stop;
      ask.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
      ::sigaction(former.signal, nullptr, &former.action);
      if (former.action.sa_handler != SIG_IGN) ::sigaction(former.signal, &ask, nullptr);
    }
  }
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  ~StopOnSignal() {
    for (const Former& former : former_) ::sigaction(former.signal, &former.action, nullptr);
  }

  [[nodiscard]] static bool asked() { return stop_asked != 0; }

 private:
  struct Former {
    int signal;
    struct sigaction action;
  };
  Former former_[2] = {{SIGINT, {}}, {SIGTERM, {}}};
};

/// Sleeps in pieces: a signal is heard at once.
void rest(milliseconds time) {
  constexpr milliseconds kPiece{50};
  for (milliseconds left = time; left.count() > 0 && !StopOnSignal::asked(); left -= kPiece) {
    std::this_thread::sleep_for(std::min(left, kPiece));
  }
}

milliseconds interval_of(const std::string& text) {
  const double seconds = parse_quantity("--interval", text, kTime);
  if (!(seconds >= 0.05 && seconds <= 3600.0)) {
    throw InputError("--interval", seconds, "must be from 0.05 to 3600 s");
  }
  return milliseconds(static_cast<milliseconds::rep>(1000.0 * seconds));
}

void say(std::FILE* stream, const std::string& text) {
  print_text(stream, printable(with_option_names(text)) + "\n");
  std::fflush(stream);
}

void tell(WatchedNews news, const std::string& text) {
  switch (news) {
    case WatchedNews::kFault:
      say(stderr, "microslip: warning: " + text);
      return;
    case WatchedNews::kJoint:
      say(stdout, "joint: " + text);
      return;
    case WatchedNews::kNext:
      say(stdout, "next: " + text);
      return;
    case WatchedNews::kRecord:
      say(stdout, text);
  }
}

WatchedTestOptions options_of(const WatchArguments& arguments, const Call& call) {
  WatchedTestOptions options;
  options.folder = arguments.folder;
  if (arguments.stiffness) options.stiffness = parse_stiffness(arguments.stiffness);
  if (arguments.target == "area") options.target = PlanTarget::kArea;
  if (!arguments.amplitude.empty()) {
    options.amplitude = parse_displacements("--amplitude", arguments.amplitude);
  }
  options.command = call.command_line;
  options.tell = [quiet = call.quiet](WatchedNews news, const std::string& text) {
    if (!quiet || news == WatchedNews::kFault) tell(news, text);
  };
  options.progress = [](std::size_t, std::size_t) { return !StopOnSignal::asked(); };
  return options;
}

/// A folder may hold what no report can show: that is no reason to stop.
/// @return whether it was made, but could not be written.
bool lacks_report(const WatchArguments& arguments, const WatchedTest& test, const Call& call) {
  bool is_made = false;
  try {
    ExperimentResults results =
        read_experiment(arguments.folder, kRecordsOverTime,
                        [](std::size_t, std::size_t) { return !StopOnSignal::asked(); });
    const std::string html = report_html(std::move(results), call, false);
    is_made = true;
    write_file(test.report_path(), html);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    say(stderr,
        fmt::format("microslip: warning: {} is not written: {}", test.report_path(), error.what()));
    return is_made;
  }
  return false;
}

/// Until it is asked to stop, or, once, until all that is there is whole and done.
/// @return the exit status: while it goes on, a file that could not be written may be so next time.
ExitStatus watch(const WatchArguments& arguments, const Call& call) {
  const milliseconds interval = interval_of(arguments.interval);
  WatchedTest test(options_of(arguments, call));
  FolderWatch folder(arguments.folder, interval,
                     [&](const std::string& name) { return test.reads(name); });
  bool announced = call.quiet;
  while (!StopOnSignal::asked() && std::ferror(stdout) == 0) {
    const FolderChange change = folder.look();
    if (!announced && !change.any() && !change.waiting) {
      say(stdout, fmt::format("{}: no record yet", arguments.folder));
    }
    announced = true;
    const bool done = change.any() && test.evaluate(change);
    bool lacks_a_file = test.lacks_a_file();
    if (done && !arguments.no_report && lacks_report(arguments, test, call)) lacks_a_file = true;
    if (arguments.once && !change.waiting) return lacks_a_file ? kFailed : kDone;
    rest(interval);
  }
  return std::ferror(stdout) == 0 ? kDone : kFailed;
}

int run(const WatchArguments& arguments, const Call& call) {
  const StopOnSignal stop;
  try {
    return watch(arguments, call);
  } catch (const Cancelled&) {
    if (!StopOnSignal::asked()) throw;
  }
  return kDone;
}

}  // namespace

void add_watch(CLI::App& program, Call& call) {
  auto options = std::make_shared<WatchArguments>();
  CLI::App* command = program.add_subcommand("watch",
                                             "During a test: evaluate the records of a folder as "
                                             "they arrive, and recommend the next level");
  command
      ->add_option("DIR", options->folder,
                   "Folder in which, or in recordings/ of which, records arrive: those of the "
                   "rig.toml in it, or, without one, levels.csv or recordings of force and "
                   "displacement. levels.csv (of a rig), joint.json, density.csv, next_levels.csv "
                   "and the report watch.html are written into it")
      ->required()
      ->type_name(kFolderValue);
  command->add_option("--stiffness", options->stiffness,
                      "k of the stuck joint, in N/m or with a unit; not needed with a rig.toml or "
                      "records of force and displacement");
  command
      ->add_option("--target", options->target,
                   "Quantity whose uncertainty the next level reduces, as in microslip plan")
      ->check(CLI::IsMember({"density", "area"}))
      ->capture_default_str();
  command->add_option("--amplitude", options->amplitude,
                      "FROM:TO, range of the next level, in m or with units; default: from the "
                      "lowest to the highest level");
  command
      ->add_option(
          "--interval", options->interval,
          "Time between two checks of the folder; a file unchanged for this long is complete")
      ->capture_default_str();
  command->add_flag("--once", options->once, "Evaluate the files present, then end");
  command->add_flag("--no-report", options->no_report, "Do not write the report");
  command->add_flag("--quiet", call.quiet, "Print faults only");
  add_examples(*command, {"microslip watch test",
                          "microslip watch test --stiffness 1.7e5 --amplitude 2um:400um",
                          "microslip watch test --once --no-report"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
