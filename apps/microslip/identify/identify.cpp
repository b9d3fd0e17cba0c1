// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/identify_arguments.hpp"
#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/workflow/identify/identification_text.hpp"

namespace microslip::app {
namespace {

/// Writes what was asked for, and tells of it.
/// @param samples  of joint_samples.h5; empty where that was not asked for.
int finish(const IdentifyArguments& arguments, const Call& call, const Identification& found,
           const std::string& joint, const std::string& samples, const std::string& summary) {
  OutputFiles outputs;
  outputs.add(arguments.out, joint);
  if (!samples.empty()) outputs.add(arguments.samples_out, samples);
  if (!arguments.density_csv.empty()) {
    outputs.add(arguments.density_csv, density_csv(found, call.command_line));
  }
  outputs.commit();
  if (!call.quiet) {
    const bool data_on_stdout = arguments.out == "-" || arguments.density_csv == "-";
    print_text(data_on_stdout ? stderr : stdout, with_option_names(summary));
  }
  return found.summary.converged() ? kDone : kNotConverged;
}

int run_assemblies(const IdentifyArguments& arguments, const Call& call) {
  const AssembliesIdentification options =
      assemblies_options(arguments, evidence_files(arguments), call);
  IdentifiedAssemblies done = read_assemblies(options);
  OutputFolders folders;
  folders.make(options.out);
  std::vector<PlannedOutput> planned;
  for (const ResultFile& file : done.files) planned.push_back({file.path, file.kind});
  check_outputs(planned);
  identify_read_assemblies(options, done);
  OutputFiles outputs;
  for (const ResultFile& file : done.files) outputs.add(file.path, file.content);
  outputs.commit();
  if (!call.quiet) print_text(stdout, with_option_names(describe_assemblies(options, done)));
  return done.found.summary.converged() ? kDone : kNotConverged;
}

int run(const IdentifyArguments& arguments, const Call& call) {
  if (arguments.of_assemblies()) return run_assemblies(arguments, call);
  std::vector<PlannedOutput> outputs{{arguments.out, kJointKind}};
  if (!arguments.density_csv.empty()) outputs.push_back({arguments.density_csv, kDensityKind});
  if (!arguments.samples_out.empty()) outputs.push_back({arguments.samples_out, kSamplesKind});
  check_outputs(outputs);
  const bool keep = !arguments.samples_out.empty();
  if (arguments.samples_out == "-") {
    throw InputError("--samples-out", "'-'", "must be a file: HDF5 is not text",
                     "Name it, for instance joint_samples.h5.");
  }
  const EvidenceFiles files = evidence_files(arguments);
  if (!files.one_table()) {
    const RecordsIdentification options = records_options(arguments, files, call.quiet);
    const IdentifiedRecords done = identify_records(options);
    return finish(arguments, call, done.found, joint_text(options, done, call.command_line),
                  keep ? samples_bytes(options, done, call.command_line) : "",
                  describe_identified_records(done));
  }
  const LevelsIdentification options = levels_options(arguments, call.quiet);
  const IdentifiedLevels done = identify_levels(options);
  return finish(
      arguments, call, done.found, joint_text(options, done.found, done.input, call.command_line),
      keep
          ? samples_bytes(options, done.found, done.input, call.command_line, arguments.samples_out)
          : "",
      describe_identified_levels(options, done));
}

}  // namespace

void add_identify(CLI::App& program, Call& call) {
  auto options = std::make_shared<IdentifyArguments>();
  CLI::App* command = program.add_subcommand(
      "identify",
      "Slip-force density of a joint from its measured dissipation, or from forces along a path");
  command
      ->add_option("evidence", options->evidence,
                   "Levels: CSV, one row per level: amplitude [m], dissipation [J]; optional: "
                   "amplitude_std, dissipation_std, secant_stiffness [N/m], secant_stiffness_std; "
                   "resonance_frequency or frequency [Hz], with which the joint is compared. Or "
                   "recordings of force and displacement of the joint over time, detected from the "
                   "content. Several files, of one kind or both, are combined; see --assemblies")
      ->required()
      ->type_name(kRecordingValue);
  add_identify_arguments(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip identify levels.csv --stiffness 1.7e5 --out joint.json",
                "microslip identify levels.csv --stiffness 1.7e5 --bands 1000 \\",
                "          --out joint.json --density-csv density.csv",
                "microslip identify levels.csv --stiffness 170kN/m --method spline \\",
                "          --smoothing p=0.99999 --smoothing-unit mm --out joint.json",
                "microslip identify record.csv --out joint.json",
                "microslip identify record.csv levels.csv --out joint.json",
                "microslip identify record.csv --drift fit --out joint.json",
                "microslip identify campaign.csv --assemblies column --stiffness 1.7e5 \\",
                "          --out assemblies", "microslip identify record.csv --samples 2000 \\",
                "          --samples-out joint_samples.h5 --out joint.json",
                "microslip identify record.csv --force f --displacement u \\",
                "          --start unknown --out joint.json"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
