// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/prediction.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "arguments/stiffness_argument.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/identify/level_plan.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct PlanOptions {
  std::string levels;
  std::optional<std::string> stiffness;
  std::string target = "density";
  std::string count = "5";
  std::string amplitude;
  std::string range;
  std::string force;
  std::string frequency;
  std::string joint;
  std::string draws = "1000";
  std::string seed = "1";
  std::string out;
};

constexpr std::string_view kPeak = "peak:";

/// Options of the target peak are required with it and refused with others.
PlannedPeak peak_of(const PlanOptions& options) {
  const bool asked = options.target.starts_with(kPeak);
  const auto check = [&](std::string_view option, const std::string& value) {
    if (asked && value.empty()) {
      throw InputError(option, InputState{"missing"},
                       "must be given with --target peak:MODEL.toml");
    }
    if (!asked && !value.empty()) {
      throw InputError(option, in_quotes(value), "applies to --target peak:MODEL.toml",
                       "Leave it out.");
    }
  };
  check("--force", options.force);
  check("--frequency", options.frequency);
  if (!asked) {
    check("--joint", options.joint);
    return {};
  }
  if (!options.range.empty()) {
    throw InputError("--range", in_quotes(options.range), "applies to the targets density and area",
                     "Leave it out.");
  }
  PlannedPeak peak{.model = options.target.substr(kPeak.size()), .joint = options.joint};
  peak.force = parse_force("--force", options.force);
  std::tie(peak.from, peak.to) = parse_frequencies("--frequency", options.frequency);
  return peak;
}

PlanTarget target_of(const std::string& text) {
  if (text == "density") return PlanTarget::kDensity;
  if (text == "area") return PlanTarget::kArea;
  if (text.starts_with(kPeak) && text.size() > kPeak.size()) return PlanTarget::kPeak;
  throw InputError("--target", in_quotes(text), "must be density, area or peak:MODEL.toml");
}

LevelPlanning planning_of(const PlanOptions& options, bool quiet) {
  LevelPlanning all;
  all.levels = options.levels;
  all.target = target_of(options.target);
  all.peak = peak_of(options);
  all.stiffness = parse_stiffness(options.stiffness);
  all.count = parse_whole_number("--count", options.count, 1, kMostDesigned);
  if (!options.amplitude.empty()) {
    all.amplitude = parse_displacements("--amplitude", options.amplitude);
  }
  if (!options.range.empty()) all.range = parse_interval("--range", options.range, kForce);
  all.draws = parse_whole_number("--draws", options.draws, 100, LevelPlanning::kMostDraws,
                                 "1000 give expected widths to about 3 %.");
  all.seed =
      parse_whole_number("--seed", options.seed, 0, std::numeric_limits<std::uint64_t>::max());
  all.progress = progress_bar("draws", quiet);
  return all;
}

int run(const PlanOptions& options, const Call& call) {
  check_output(options.out, kPlanKind);
  const LevelPlanning planning = planning_of(options, call.quiet);
  const LevelPlan plan = plan_levels(planning);
  write_file(options.out, plan_text(plan, planning, call.command_line));
  if (call.quiet) return kDone;
  show_warnings(plan.warnings);
  print_text(options.out == "-" ? stderr : stdout,
             with_option_names(describe_plan(plan, planning)));
  return kDone;
}

void add_plan_options(CLI::App& command, PlanOptions& options) {
  command.add_option("--stiffness", options.stiffness,
                     "k of the stuck joint, in N/m or with a unit: slip forces are k times A");
  command
      .add_option("--target", options.target,
                  "Quantity whose uncertainty the levels reduce. density: its mean band width over "
                  "--range; area: the slipping fraction of k there; peak:MODEL.toml: the height of "
                  "the highest peak of that structure")
      ->capture_default_str();
  command
      .add_option("--count", options.count, "Number of levels, including repeats of one amplitude")
      ->capture_default_str();
  command.add_option("--amplitude", options.amplitude,
                     "FROM:TO, range of the amplitudes that can be measured, in m or with units; "
                     "default: from the lowest to the highest level. Beyond these the density is "
                     "only known to be as smooth as below");
  command.add_option("--range", options.range,
                     "FROM:TO of slip forces, in N or with units; default: k times --amplitude");
  command.add_option("--force", options.force,
                     "Peak: amplitude of the force on the structure, in N or with a unit");
  command.add_option("--frequency", options.frequency,
                     "Peak: FROM:TO of the frequencies searched, in Hz or with units");
  command.add_option("--joint", options.joint,
                     "Peak: name of the model joint that the levels are of, if it has several. The "
                     "levels determine this joint, not its file");
  command
      .add_option("--draws", options.draws,
                  "Posterior draws of the density on which the plan is based")
      ->type_name("UINT")
      ->capture_default_str();
  command
      .add_option("--seed", options.seed, "Seed of the draws; the same seed gives the same draws")
      ->type_name("UINT")
      ->capture_default_str();
}

}  // namespace

void add_plan(CLI::App& program, Call& call) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = program.add_subcommand(
      "plan", "Levels to measure next, and by how much they narrow the band of a result");
  command->add_option("levels", options->levels, "Levels measured so far, as identify reads them")
      ->required()
      ->type_name(kCsvValue);
  add_plan_options(*command, *options);
  command
      ->add_option(
          "--out", options->out,
          "CSV to write: rank [1], amplitude [m], repeats [1], width_before, width_after, "
          "width_endless (limit if that amplitude were repeated without end); - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip plan levels.csv --stiffness 1.7e5 --count 10 --out next.csv",
                          "microslip plan levels.csv --stiffness 1.7e5 --target area \\",
                          "          --amplitude 1um:400um --out next.csv",
                          "microslip plan levels.csv --stiffness 1.7e5 \\",
                          "          --target peak:model.toml --force 2 --frequency 50:60 \\",
                          "          --out next.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
