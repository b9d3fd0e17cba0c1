// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/report_html.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/study/about_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/results/experiment_folder.hpp"

namespace microslip::app {
namespace {

struct ReportOptions {
  std::string folder;
  std::string out;
  std::string title;
  std::string about;
  std::size_t records = kRecordsOverTime;
  bool no_pictures = false;
};

/// Folders in the folder that hold what it lacks, or why its records are not shown.
std::string remedy_for(const std::string& folder, const ExperimentResults& results) {
  if (!results.warnings.empty()) return results.warnings.front().text;
  const std::vector<std::string> folders = folders_holding(folder, {"levels.csv"});
  if (!folders.empty()) return fmt::format("There are levels in {}.", fmt::join(folders, ", "));
  const std::vector<std::string> found =
      folders_holding(folder, {"calibration.json", "calibration.csv"});
  if (found.empty()) {
    return "See microslip reduce, microslip identify and microslip calibrate.";
  }
  return fmt::format("There is a calibration in {}.", fmt::join(found, ", "));
}

constexpr std::size_t kLarge = 4'000'000;  // bytes

int run(const ReportOptions& options, const Call& call) {
  check_output(options.out, kReportKind);
  const ReportAbout about = options.about.empty() ? ReportAbout{} : read_about(options.about);
  ExperimentResults results =
      read_experiment(options.folder, options.records, progress_bar("recordings", call.quiet));
  if (results.is_empty()) {
    throw InputError("DIR", "'" + options.folder + "'",
                     "must contain levels.csv, joint.json, recordings level_*, verification.csv, "
                     "comparison.csv, force_control.csv or what microslip calibrate or campaign "
                     "writes",
                     remedy_for(options.folder, results));
  }
  if (!call.quiet) {
    for (const Warning& warning : results.warnings) {
      print_text(stderr, fmt::format("microslip: warning: {}\n", with_option_names(warning.text)));
    }
  }
  if (!about.title.empty()) results.title = about.title;
  if (!options.title.empty()) results.title = options.title;
  const std::string html = report_html(std::move(results), call, !options.no_pictures, about);
  write_file(options.out, html);
  if (!call.quiet && options.out != "-") {
    print_text(stdout, fmt::format("{}: {:.1f} MB, one file; open it in a browser.\n", options.out,
                                   static_cast<double>(html.size()) * 1e-6));
    if (html.size() > kLarge) {
      print_text(stdout,
                 "That is large for mail and slow to open: fewer --records make it smaller.\n");
    }
  }
  return kDone;
}

}  // namespace

void add_report(CLI::App& program, Call& call) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      program.add_subcommand("report", "Write an interactive HTML report of a test folder");
  command
      ->add_option(
          "DIR", options->folder,
          "Folder with any of rig.toml, levels.csv, joint.json, density.csv; the recordings of "
          "force and displacement that joint.json was identified from; recordings "
          "level_* and before_control_*, also in recordings/; force_control.csv, truth.csv, "
          "truth_joint.json; verification.csv, verification_histories.csv, "
          "verification_harmonics.csv; comparison.csv of verify by a model; the tables of "
          "campaign, campaign.csv, sessions.csv, conditions.csv, leave_one_out.csv; frf.csv, "
          "backbone.csv, "
          "curve.csv, march.csv, ensemble.csv; or calibration.json, calibration.csv, "
          "identifiability.csv")
      ->required()
      ->type_name(kFolderValue);
  command->add_option("--out", options->out, "Report to write, one HTML file; - is standard output")
      ->required()
      ->type_name(kHtmlValue);
  command->add_option("--title", options->title,
                      "Title of the report; default: the name of the folder");
  command
      ->add_option("--about", options->about,
                   "Head of the report (about.toml): title, object, customer, order, operator, "
                   "date, logo")
      ->type_name(kTomlValue);
  command
      ->add_option("--records", options->records,
                   "Number of recordings shown over time; all recordings of a rig are shown by "
                   "their harmonics if they fit on the page")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--no-pictures", options->no_pictures,
                    "Omit the pictures for print that gnuplot draws: a smaller file");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip report test --out report.html",
                          "microslip report test --about about.toml --out report.html"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
