// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/draw_arguments.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/exports/export_targets.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/predict/joint_export.hpp"
#include "microslip/workflow/predict/joint_export_draws.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct ExportOptions {
  std::string joint;
  std::string out;
  std::string errors;
  ExportRequest request;
  std::string reach;
  std::size_t elements = 0;
  std::string error = "0.001";
  JointDrawArguments draws;
};

/// The name of the file without its ending, where none was given.
std::string name_of(const ExportOptions& options, const ExportTarget& target) {
  if (!options.request.name.empty()) return options.request.name;
  return name_for_target(target, std::filesystem::path(options.joint).stem().string());
}

ExportRequest request_of(const ExportOptions& options) {
  ExportRequest request = options.request;
  if (options.elements > 0) request.sliders = options.elements;
  if (!options.reach.empty()) {
    request.reach = parse_quantity("--up-to", options.reach, kLength);
    check_displacement("--up-to", request.reach);
  }
  request.error = parse_quantity("--error", options.error, kDimensionless);
  request.name = name_of(options, export_target(request.target));
  return request;
}

/// What a file tells of the call: an archive neither paths nor the call, so that the same joint is
/// the same file wherever it is made.
std::string remarks_of(const ExportOptions& options, const Call& call, NamedInput input) {
  if (!export_target(options.request.target).archive) {
    return provenance_of(call.command_line, {input});
  }
  input.path = std::filesystem::path(input.path).filename().string();
  return provenance_of("microslip export", {input});
}

/// A file for each draw, and the table of them, in a folder.
int run_draws(const ExportOptions& options, const ExportRequest& request, const Call& call) {
  if (options.out == "-") {
    throw InputError("--out", options.out, "must be a folder with --draws: each draw is a file");
  }
  const DrawOptions draw{
      .count = parse_whole_number("--draws", options.draws.count, 1, kMostExportedDraws),
      .seed = parse_whole_number("--seed", options.draws.seed, 0,
                                 std::numeric_limits<std::uint64_t>::max())};
  OutputFolders folders;
  folders.make(options.out);
  const std::filesystem::path folder(options.out);
  const std::string kind = export_kind(request.target);  // PlannedOutput refers to it
  const std::string table = (folder / "draws.csv").string();
  const std::vector<std::string> names = draw_file_names(request, draw.count);
  std::vector<PlannedOutput> planned{{table, kExportedDrawsKind}};
  for (const std::string& name : names) planned.push_back({(folder / name).string(), kind});
  check_outputs(planned);
  check_other_draws(options.out, names);
  const NamedInput input{options.joint, read_text(options.joint)};
  const JointFile file = parse_joint(input.text, input.path);
  LoneJointDraws draws = draws_without_band(file, uncertainty_of(options.draws), draw);
  draws.progress = progress_bar("draws", call.quiet);
  const std::vector<ExportedDraw> exported =
      export_draws(file, draws, request, remarks_of(options, call, input));
  OutputFiles files;
  files.add(table, exported_draws_table(exported, names, draws, call.command_line));
  for (std::size_t i = 0; i < exported.size(); ++i) {
    files.add((folder / names[i]).string(), exported[i].result.text);
  }
  files.commit();
  if (call.quiet) return kDone;
  show_warnings(exported.front().result.warnings);
  print_text(stdout, exported_draws_summary(exported, request, options.out));
  return kDone;
}

int run(const ExportOptions& options, const Call& call) {
  const ExportRequest request = request_of(options);
  if (options.draws.any()) return run_draws(options, request, call);
  if (options.out == "-" && export_target(request.target).archive && ::isatty(STDOUT_FILENO) != 0) {
    throw InputError("--out", options.out, "would write an archive to the terminal",
                     "Name a file.");
  }
  const std::string kind = export_kind(request.target);  // PlannedOutput refers to it
  std::vector<PlannedOutput> planned{{options.out, kind}};
  if (!options.errors.empty()) planned.push_back({options.errors, kSliderErrorsKind});
  check_outputs(planned);
  const NamedInput input{options.joint, read_text(options.joint)};
  const JointFile file = parse_joint(input.text, input.path);
  const JointExport result = export_joint(file, request, remarks_of(options, call, input));
  OutputFiles files;
  files.add(options.out, result.text);
  if (!options.errors.empty()) {
    files.add(options.errors, slider_errors_table(result.errors, command_of(call, options.errors)));
  }
  files.commit();
  if (call.quiet) return kDone;
  show_warnings(result.warnings);
  if (options.out != "-") print_text(stdout, export_summary(result, request, options.out));
  return kDone;
}

std::string targets_text() {
  std::string text;
  for (const ExportTarget& target : all_export_targets()) {
    if (target.text == nullptr) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", target.name, target.words);
  }
  return text;
}

/// How exact the sliders are.
void add_accuracy(CLI::App& command, ExportOptions& options) {
  CLI::Option* elements = command.add_option(
      "--elements", options.elements,
      "Number of sliders, chosen so that the largest error of the force is as small as it can be; "
      "if not given as many as --error needs");
  elements->check(CLI::Range(1, 5000));
  command
      .add_option("--error", options.error,
                  "Largest error of the force along a nested path, over its largest force; from "
                  "1e-7 to 0.5, or in %")
      ->capture_default_str()
      ->excludes(elements);
  command.add_option("--up-to", options.reach,
                     "Largest displacement of the joint in the analysis, in m or with a unit: "
                     "what slips beyond it becomes a spring, and the sliders are as exact as they "
                     "can be below it");
}

/// Units, names and numbers in the target.
void add_language(CLI::App& command, ExportOptions& options) {
  command
      .add_option("--units", options.request.units,
                  "Units of the target: SI (N, m), mm-N-t (N, mm) or in-lbf (lbf, in)")
      ->check(CLI::IsMember({"SI", "mm-N-t", "in-lbf"}, CLI::ignore_case))
      ->capture_default_str();
  command.add_option("--name", options.request.name,
                     "Name of the joint in the target; that of the file if not given, with _joint "
                     "behind it if that is a word of the language");
  command
      .add_option("--first-number", options.request.first_number,
                  "First number of the nodes, elements, real constants or tags that are made")
      ->check(CLI::Range(1, 90'000'000))
      ->capture_default_str();
}

}  // namespace

void add_export(CLI::App& program, Call& call) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand(
      "export", "A joint as the input of a finite-element code or another program");
  command->add_option("joint", options->joint, "Joint model, joint.json")
      ->required()
      ->type_name(kJsonValue);
  command->add_option("--to", options->request.target, targets_text())
      ->required()
      ->type_name("TARGET");
  command
      ->add_option("--out", options->out,
                   "File to write; - is standard output. With --draws a folder: a file of each "
                   "draw, draws.csv. The joint becomes Jenkins elements in parallel, each a "
                   "spring in series with a slider")
      ->required()
      ->type_name(kInputValue);
  add_accuracy(*command, *options);
  add_language(*command, *options);
  add_single_draw_arguments(
      *command, options->draws,
      "Write so many posterior draws of the joint, those of the predictions with draws, as a file "
      "each, and draws.csv: draw [1], file, stiffness [N/m], macroslip_force [N], "
      "elastic_stiffness [N/m], sliders [1], path_error [1]");
  command
      ->add_option("--errors-csv", options->errors,
                   "CSV to write: amplitude [m], dissipation_error [1] and secant_stiffness_error "
                   "[1] of the sliders, relative to the joint")
      ->excludes(command->get_option("--draws"))
      ->type_name(kCsvValue);
  command->add_flag("--quiet", call.quiet, "No summary and no warnings on the screen");
  add_examples(*command, {"microslip export joint.json --to calculix \\",
                          "          --units mm-N-t --out joint.inp",
                          "microslip export joint.json --to opensees \\",
                          "          --first-number 100 --out joint.tcl",
                          "microslip export joint.json --to fmu --name bolt \\",
                          "          --error 1e-4 --out bolt.fmu",
                          "microslip export joint.json --to opensees --draws 100 \\",
                          "          --samples joint_samples.h5 --out draws"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
