// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/damping_twice.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/model_writer.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/rig_file.hpp"
#include "microslip/io/text.hpp"
#include "microslip/rig/rig_structure.hpp"
#include "microslip/workflow/provenance.hpp"
#include "prediction.hpp"
#include "recording_arguments.hpp"

namespace microslip::app {
namespace {

namespace fs = std::filesystem;

struct ModelOptions {
  std::string rig;
  std::string joint;
  std::string out;
  std::size_t modes = 7;
};

/// What only solving the rig can find names its file.
template <typename Make>
auto of_rig(const ModelOptions& options, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", input_name(options.rig), error.name()));
  }
}

/// A model is text: names in it are UTF-8 without control characters.
void check_name(std::string_view what, std::string_view name) {
  if (printable(name) == name) return;
  throw InputError(what, in_quotes(name), "must be printable UTF-8 to be named in a model",
                   "Rename it.");
}

/// Points of a model are columns of tables, which not every channel's name can be.
void check_readable(const std::string& text, const ModelOptions& options) {
  try {
    (void)parse_model(text, options.out);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: channel", input_name(options.rig)));
  }
}

/// As the model names it: relative to the model's folder, unless it was given from the root.
std::string joint_name(const ModelOptions& options) {
  const fs::path joint(options.joint);
  if (joint.is_absolute() || options.out == "-") return joint.string();
  const fs::path folder = fs::path(options.out).parent_path();
  const fs::path relative = fs::relative(joint, folder.empty() ? "." : folder);
  return relative.empty() ? fs::absolute(joint).string() : relative.string();
}

int run(const ModelOptions& options, const Call& call) {
  check_output(options.out, kModelKind);
  if (options.joint == "-") {
    throw InputError("joint", "standard input", "must be a file, which the model names");
  }
  const std::vector<NamedInput> inputs{{options.rig, read_file(options.rig)},
                                       {options.joint, read_file(options.joint)}};
  const Rig rig = parse_rig(inputs[0].text, input_name(options.rig));
  const JointFile file = parse_joint(inputs[1].text, options.joint);
  const Joint& joint = file.joint;
  const double damping = identified_damping(file).value_or(0.0);
  check_name("joint", options.joint);
  const StickState state = of_rig(options, [&] { return stick_state(rig, options.modes); });
  const ModelFile model{
      of_rig(options, [&] { return rig_structure(rig, state, joint, {1.0}, damping); }),
      rig.excitation.channel,
      {joint_name(options)},
      {covered_to(file)},
      {identified_damping(file)}};
  std::vector<Warning> warnings = damping_twice(model.structure);
  if (const auto warning = stiffness_warning(state, joint)) warnings.push_back(*warning);
  const std::string text =
      format_model(model, with_warnings(provenance_of(call.command_line, inputs), warnings));
  check_readable(text, options);
  write_file(options.out, text);
  if (call.quiet) return kDone;
  show_warnings(warnings);
  const bool on_stdout = options.out == "-";
  fmt::print(on_stdout ? stderr : stdout, "{}",
             describe_model(on_stdout ? "standard output" : options.out, model.structure) +
                 describe_damping(model));
  return kDone;
}

}  // namespace

void add_model(CLI::App& program, Call& call) {
  auto options = std::make_shared<ModelOptions>();
  CLI::App* command = program.add_subcommand(
      "model",
      "The structure of a test rig with a joint, as a model.toml for frf, backbone, march");
  command->add_option("rig", options->rig, "Description of the test, rig.toml")
      ->required()
      ->type_name(kTomlValue);
  command->add_option("joint", options->joint, "The joint in its contact, joint.json")
      ->required()
      ->type_name(kJsonValue);
  command
      ->add_option("--out", options->out,
                   "Model to write, model.toml: modes, points named after the channels, the joint; "
                   "- is standard output")
      ->required()
      ->type_name(kTomlValue);
  command->add_option("--modes", options->modes, "Modes of the beam in the model")
      ->check(CLI::Range(1, 40))
      ->capture_default_str();
  command->add_flag("--quiet", call.quiet, "No summary, no warnings");
  add_examples(*command,
               {"microslip model rig.toml joint.json --out model.toml",
                "microslip frf model.toml --response 0.1mm --frequency 53:58 --out frf.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
