// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/version.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/documents/structure/model_writer.hpp"
#include "microslip/documents/study/calibration_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/relative_path.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/identify/calibration_tables.hpp"
#include "microslip/workflow/identify/found_joint.hpp"
#include "microslip/workflow/identify/found_modes.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/predict/model_rules.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

std::string file_of_results(const ModelCalibration& options, const std::string& name) {
  return (fs::path(options.out) / name).string();
}

/// Joints that are sought become files of their name.
void check_file_name(const std::string& model, const std::string& joint) {
  const bool usable =
      joint.find('/') == std::string::npos && !joint.starts_with('.') && printable(joint) == joint;
  if (usable && joint != "calibration") return;
  throw InputError(fmt::format("{}: name of a joint", input_name(model)), in_quotes(joint),
                   usable ? "must not be that of calibration.json, which is written beside it"
                          : "must be usable as the name of a file: without / and not beginning "
                            "with a point",
                   "Rename it in the model.");
}

/// dissipation_lower_x of calibration.csv is of the band of x, or the loss of a joint lower_x:
/// ambiguous.
void check_column_name(const std::string& model, const std::string& joint) {
  if (!joint.starts_with("lower_") && !joint.starts_with("upper_")) return;
  throw InputError(fmt::format("{}: name of a joint", input_name(model)), in_quotes(joint),
                   "must not begin with lower_ or upper_, as columns of calibration.csv do",
                   "Rename it in the model.");
}

std::vector<ResultFile> files_of(const ModelCalibration& options, const ModelFile& model) {
  std::vector<ResultFile> files;
  for (const std::size_t joint : model.to_find) {
    const std::string& name = model.structure.joints()[joint].name;
    files.push_back({file_of_results(options, name + ".json"), kJointKind});
    if (options.keep_draws) {
      files.push_back({file_of_results(options, name + "_samples.h5"), kSamplesKind});
    }
  }
  files.push_back({file_of_results(options, "model.toml"), kModelKind});
  files.push_back({file_of_results(options, "calibration.json"), kCalibrationFileKind});
  files.push_back({file_of_results(options, "calibration.csv"), kCalibrationKind});
  files.push_back({file_of_results(options, "identifiability.csv"), kIdentifiabilityKind});
  return files;
}

ModalLevels read_all_levels(const ModelCalibration& options, CalibratedModel& done) {
  ModalLevels levels;
  const std::vector<std::string> joints = names_of_joints(done.model);
  for (const std::string& path : options.levels) {
    const std::string text = read_text(path);
    done.inputs.push_back({path, sha256(text)});
    append(parse_modal_levels(text, input_name(path), joints,
                              done.model.structure.linear().vibrations()),
           levels);
  }
  return levels;
}

NamedValues options_record(const CalibrationOptions& options, ModelFrequencies frequencies) {
  NamedValues record;
  record.emplace_back("model_frequencies",
                      frequencies == ModelFrequencies::kCorrected ? "corrected" : "given");
  record.emplace_back("frequency", std::string(to_string(options.frequency)));
  record.emplace_back("stiffness", options.fit_stiffness ? "fit" : "given");
  record.emplace_back("shapes", options.stuck_shapes ? "stuck" : "found");
  record.emplace_back("edges", options.edges ? "sought" : "none");
  record.emplace_back("forcing",
                      options.balance.forcing == Forcing::kModal ? "modal" : "excitation");
  record.emplace_back("harmonics", static_cast<double>(options.balance.harmonics));
  record.emplace_back("samples", static_cast<double>(options.draws));
  return record;
}

Provenance calibration_provenance(const ModelCalibration& options, const CalibratedModel& done) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = options.command;
  provenance.inputs = done.inputs;
  provenance.options = options_record(options.options, options.model_frequencies);
  provenance.seed = options.options.seed;
  return provenance;
}

std::string comment_of(const ModelCalibration& options, const CalibratedModel& done) {
  std::string comment = heading_of(options.command);
  for (const InputHash& input : done.inputs) {
    comment += '\n' + hash_comment(input.file, input.sha256);
  }
  return with_warnings(std::move(comment), done.found.warnings);
}

CsvWriter commented(CsvWriter table, const std::string& comment) {
  table.add_comment(comment);
  return table;
}

// ---- The summary. ----

std::string describe_edges(const CalibratedJoint& joint) {
  if (joint.edges.empty()) return {};
  std::vector<std::string> places;
  for (const DensityEdge& edge : joint.edges) {
    places.push_back(fmt::format("{:.4g} ± {:.2g} N", edge.slip_force, edge.deviation));
  }
  return line("", fmt::format("its density jumps at {}", fmt::join(places, ", ")));
}

std::string describe_joint(const CalibratedJoint& joint) {
  const double k = joint.joint.stiffness();
  std::string text =
      line("joint", joint.name) +
      line("", fmt::format("k {:.5g} N/m, slipping fraction {} up to {:.3g} N", k,
                           percent_text(1.0 - joint.joint.density().elastic_remainder()),
                           k * joint.largest_amplitude)) +
      line("", fmt::format("variance reduction of its density up to {}",
                           percent_text(std::ranges::max(joint.variance_reduction)))) +
      describe_edges(joint);
  return text;
}

std::string describe_scatter(const CalibrationResult& found) {
  std::string text =
      line("losses",
           found.loss_std_given
               ? fmt::format("scatter {:.2f} times their standard deviations", found.loss_scatter)
               : fmt::format("scatter by {}", percent_text(found.loss_scatter)));
  if (found.frequency_scatter > 0.0) {
    text += line("frequencies", found.frequency_std_given
                                    ? fmt::format("scatter {:.2f} times their standard deviations",
                                                  found.frequency_scatter)
                                    : fmt::format("scatter by {:.1e}", found.frequency_scatter));
  }
  return text;
}

std::string describe_pairs(const CalibrationResult& found) {
  std::string text;
  for (const JointPair& pair : found.pairs) {
    text += line(text.empty() ? "together" : "",
                 fmt::format("{} and {}: loss of both known to {}, of the better known one to {}",
                             found.joints[pair.first].name, found.joints[pair.second].name,
                             percent_text(pair.spread_together), percent_text(pair.spread_alone)));
  }
  return text;
}

void check_model_frequencies(const ModelCalibration& options) {
  if (options.model_frequencies == ModelFrequencies::kGiven) return;
  if (options.options.frequency == FrequencyUse::kChange) return;
  throw InputError("frequencies of the model", "\"corrected\"",
                   "must not be asked for unless frequencies of the levels count by their change: "
                   "absolute ones take the model's to be right",
                   "Leave --model-frequencies out, or --frequency.");
}

void check_to_calibrate(const ModelFile& model, const std::string& path) {
  if (model.to_find.empty()) {
    throw InputError(fmt::format("{}: joints to find", input_name(path)), InputState{"none"},
                     "must be one or more", "Give a [[joint]] stiffness_N_per_m in place of file.");
  }
  require_no_static_loads(model, path, "calibrate");
  for (const std::size_t joint : model.to_find) {
    check_file_name(path, model.structure.joints()[joint].name);
  }
  for (const StructuralJoint& joint : model.structure.joints()) check_column_name(path, joint.name);
}

}  // namespace

std::vector<std::string> names_of_joints(const ModelFile& model) {
  std::vector<std::string> names;
  for (const StructuralJoint& joint : model.structure.joints()) names.push_back(joint.name);
  return names;
}

ModelFile read_model_to_calibrate(const std::string& path) {
  ModelFile model = read_model(path, JointsToFind::kAllowed);
  check_to_calibrate(model, path);
  return model;
}

ModelFile model_to_calibrate(const NamedInput& input) {
  ModelFile model = parse_model(input.text, input_name(input.path), JointsToFind::kAllowed);
  check_to_calibrate(model, input.path);
  return model;
}

JointSamples joint_samples(const CalibratedJoint& joint, const Provenance& provenance,
                           std::uint64_t seed) {
  JointSamples samples;
  samples.method = "posterior of modal levels";
  samples.seed = seed;
  samples.provenance = provenance;
  samples.slip_displacement = joint.slip_displacement;
  for (const StiffnessDraw& draw : joint.draws) {
    samples.stiffness.push_back(draw.stiffness);
    samples.stiffness_density.insert(samples.stiffness_density.end(), draw.density.begin(),
                                     draw.density.end());
  }
  return samples;
}

std::vector<ResultFile> planned_files(const ModelCalibration& options) {
  require_result_folder(options.out);
  return planned_files(options, read_model_to_calibrate(options.model));
}

std::vector<ResultFile> planned_files(const ModelCalibration& options, const ModelFile& model) {
  require_result_folder(options.out);
  std::vector<ResultFile> files = files_of(options, model);
  std::vector<std::string> inputs = options.levels;
  inputs.push_back(options.model);
  check_inputs_kept(options.out, files, inputs);
  return files;
}

ModelFile model_with_found(const ModelCalibration& options, const CalibratedModel& done) {
  const std::string out = file_of_results(options, "model.toml");
  std::vector<StructuralJoint> joints(done.model.structure.joints().begin(),
                                      done.model.structure.joints().end());
  ModelFile model = done.model;
  model.joint_samples.resize(joints.size());
  model.covered_to.resize(joints.size());
  for (const CalibratedJoint& joint : done.found.joints) {
    joints[joint.index].joint = joint.joint;
    model.joint_files[joint.index] = joint.name + ".json";
    model.covered_to[joint.index] = joint.joint.stiffness() * joint.largest_amplitude;
    if (options.keep_draws) model.joint_samples[joint.index] = joint.name + "_samples.h5";
    model.identified_damping[joint.index] = joints[joint.index].linear_damping;
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (std::ranges::find(model.to_find, j) != model.to_find.end()) continue;
    model.joint_files[j] = path_from(model.joint_files[j], out);
    std::string& samples = model.joint_samples[j];
    if (!samples.empty()) samples = path_from(samples, out);
  }
  model.to_find.clear();
  model.structure = done.model.structure.with_joints(std::move(joints));
  return model;
}

std::vector<std::optional<JointSamples>> samples_of_joints(const ModelCalibration& options,
                                                           const CalibratedModel& done) {
  std::vector<std::optional<JointSamples>> samples(done.model.structure.joints().size());
  const Provenance provenance = calibration_provenance(options, done);
  for (const CalibratedJoint& joint : done.found.joints) {
    samples[joint.index] = joint_samples(joint, provenance, options.options.seed);
  }
  for (std::size_t j = 0; j < done.model.joint_samples.size(); ++j) {
    if (samples[j] || done.model.joint_samples[j].empty()) continue;
    const StructuralJoint& joint = done.model.structure.joints()[j];
    samples[j] = samples_for(done.model.joint_samples[j], joint.joint.stiffness(),
                             fmt::format("'{}'", joint.name));
  }
  return samples;
}

void compose_calibration(const ModelCalibration& options, const ModalLevels& levels,
                         CalibratedModel& done) {
  done.files = files_of(options, done.model);
  const Provenance provenance = calibration_provenance(options, done);
  std::size_t at = 0;
  for (const CalibratedJoint& joint : done.found.joints) {
    done.files[at++].content =
        format_joint(joint_file_of(found_joint(done.found, joint), provenance));
    if (!options.keep_draws) continue;
    const JointSamples samples = joint_samples(joint, provenance, options.options.seed);
    done.files[at].content = joint_samples_bytes(samples, done.files[at].path);
    ++at;
  }
  const std::string comment = comment_of(options, done);
  ModelFile model = model_with_found(options, done);
  set_found_modes(done.found.modes, options.model_frequencies, model);
  done.files[at++].content = format_model(model, comment);
  done.files[at++].content =
      format_calibration(calibration_file_of(found_calibration(done.found), provenance));
  done.files[at++].content =
      commented(calibration_table(done.found, levels, names_of_joints(done.model)), comment).str();
  done.files[at++].content = commented(identifiability_table(done.found), comment).str();
}

void calibrate_levels(const ModelCalibration& options, const ModalLevels& levels,
                      const std::string& levels_name, CalibratedModel& done) {
  try {
    done.found = calibrate(done.model.structure, done.model.to_find, done.model.response, levels,
                           options.options);
  } catch (const InputError& error) {
    if (error.name().find("level") == std::string::npos) throw;
    throw error.renamed(fmt::format("{}: {}", levels_name, error.name()));
  }
  std::ranges::move(mode_warnings(done.model), std::back_inserter(done.found.warnings));
  std::ranges::move(same_content_warnings(done.inputs, "each level"),
                    std::back_inserter(done.found.warnings));
}

CalibratedModel calibrate_model(const ModelCalibration& options) {
  check_distinct_files(options.levels);
  check_model_frequencies(options);
  CalibratedModel done{.model = read_model_to_calibrate(options.model)};
  done.inputs.push_back({options.model, sha256(read_text(options.model))});
  const ModalLevels levels = read_all_levels(options, done);
  calibrate_levels(options, levels, input_name(options.levels.front()), done);
  compose_calibration(options, levels, done);
  return done;
}

std::string describe_calibration(const ModelCalibration& options, const CalibratedModel& done) {
  std::string text = describe_model(options.model, done.model.structure) +
                     line("levels", fmt::format("{} of {}", done.found.levels.size(),
                                                counted(options.levels.size(), "file"))) +
                     describe_ending(done.found.summary);
  for (const CalibratedJoint& joint : done.found.joints) text += describe_joint(joint);
  return text + describe_scatter(done.found) +
         describe_found_modes(done.found, options.model_frequencies) + describe_pairs(done.found) +
         describe_warnings(done.found.warnings);
}

}  // namespace microslip
