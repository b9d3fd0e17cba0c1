// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/picture_argument.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/report/figures/comparison_figure.hpp"
#include "microslip/workflow/campaign/campaign.hpp"

namespace microslip::app {
namespace {

struct CampaignArguments {
  CampaignRun run;
  std::string picture;
};

void check_campaign_outputs(const CampaignArguments& arguments,
                            const std::vector<ResultFile>& files) {
  std::vector<PlannedOutput> outputs;
  for (const ResultFile& file : files) outputs.push_back({file.path, file.kind});
  if (!arguments.picture.empty()) {
    outputs.push_back({arguments.picture, kind_of(picture_format("--picture", arguments.picture))});
  }
  check_outputs(outputs);
}

/// A picture shows what is predicted.
void check_picture(const CampaignArguments& arguments, const std::vector<ResultFile>& files) {
  const bool predicted =
      std::ranges::find(files, kComparisonKind, &ResultFile::kind) != files.end();
  if (arguments.picture.empty() || predicted) return;
  throw InputError("--picture", in_quotes(arguments.picture),
                   "shows predicted tests, and the campaign has none", "Leave it out.");
}

void write_campaign(const CampaignArguments& arguments, const DoneCampaign& done) {
  OutputFiles outputs;
  for (const ResultFile& file : done.files) outputs.add(file.path, file.content);
  if (!arguments.picture.empty()) {
    const FigureGrid figure = comparison_figure(done.verified.tests);
    outputs.add(arguments.picture, draw(figure, picture_format("--picture", arguments.picture),
                                        comparison_size(figure)));
  }
  outputs.commit();
}

int run(CampaignArguments arguments, const Call& call) {
  arguments.run.command = call.command_line;
  arguments.run.progress = progress_bar("campaign", call.quiet);
  const OpenedCampaign opened = open_campaign(arguments.run);
  const std::vector<ResultFile> planned = planned_files(arguments.run, opened);
  check_picture(arguments, planned);
  OutputFolders folders;
  folders.make(arguments.run.out);
  check_campaign_outputs(arguments, planned);
  const DoneCampaign done = run_campaign(arguments.run, opened);
  write_campaign(arguments, done);
  if (!call.quiet) print_text(stdout, with_option_names(describe_campaign(done)));
  return done.converged() ? kDone : kNotConverged;
}

}  // namespace

void add_campaign(CLI::App& program, Call& call) {
  auto options = std::make_shared<CampaignArguments>();
  CLI::App* command =
      program.add_subcommand("campaign",
                             "Several tests of one structure: identify its joints from some, "
                             "predict the others, and report contradictions");
  command
      ->add_option("campaign", options->run.campaign,
                   "Tests, their sessions and their use, campaign.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option(
          "--out", options->run.out,
          "Folder to write to, created if missing: joint.json, model.toml, "
          "levels.csv and NAME_levels.csv of tests that are reduced, campaign.csv, "
          "sessions.csv; with draws joint_samples.h5; of a model modal_levels.csv and the output "
          "of calibrate in place of levels and joint; of predicted tests comparison.csv; "
          "conditions.csv if tests specify conditions; leave_one_out.csv if the campaign requests "
          "it")
      ->required()
      ->type_name(kFolderValue);
  command
      ->add_option("--picture", options->picture,
                   "Picture of the predicted tests, measured and predicted, as .svg, .png or .pdf")
      ->type_name(kPictureValue);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip campaign campaign.toml --out results",
                "microslip campaign campaign.toml --out results --picture comparison.svg",
                "microslip report results --out results.html",
                "microslip frf results/model.toml --force 1 --frequency 78:82 --out frf.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
