// SPDX-License-Identifier: MIT
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/version.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/bindings/python/structure.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/workflow/identify/calibration.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

const std::map<std::string, FrequencyUse> kUses{{"change", FrequencyUse::kChange},
                                                {"absolute", FrequencyUse::kAbsolute},
                                                {"ignore", FrequencyUse::kIgnore}};

CalibrationOptions calibration_options_of(const py::dict& given) {
  CalibrationOptions all;
  all.frequency = kUses.at(given["frequency"].cast<std::string>());
  all.fit_stiffness = given["fit_stiffness"].cast<bool>();
  all.stuck_shapes = given["stuck_shapes"].cast<bool>();
  all.edges = given["edges"].cast<bool>();
  all.balance.forcing =
      given["modal_forcing"].cast<bool>() ? Forcing::kModal : Forcing::kExcitation;
  all.balance.harmonics = given["harmonics"].cast<std::size_t>();
  all.draws = given["samples"].cast<std::size_t>();
  all.seed = given["seed"].cast<std::uint64_t>();
  all.check();
  return all;
}

// ---- Levels, as columns: NaN where something was not measured. ----

ModalLevels modal_levels_of(const py::dict& given) {
  const auto column = [&](const char* name) { return copy_of(given[name].cast<py::object>()); };
  ModalLevels levels{.displacement = column("displacement"),
                     .displacement_std = column("displacement_std"),
                     .frequency = column("frequency"),
                     .frequency_std = column("frequency_std"),
                     .dissipation = column("dissipation"),
                     .dissipation_std = column("dissipation_std"),
                     .damping_ratio = column("damping_ratio"),
                     .damping_ratio_std = column("damping_ratio_std")};
  levels.mode = given["mode"].cast<std::vector<std::size_t>>();
  for (const py::handle one : given["joints"]) {
    const auto [name, amplitude, amplitude_std, dissipation, dissipation_std] =
        one.cast<std::tuple<std::string, py::object, py::object, py::object, py::object>>();
    levels.joints.push_back({name, copy_of(amplitude), copy_of(amplitude_std), copy_of(dissipation),
                             copy_of(dissipation_std)});
  }
  return levels;
}

py::dict dict_of(const ModalLevels& levels) {
  py::list joints;
  for (const JointLevels& joint : levels.joints) {
    joints.append(py::make_tuple(
        joint.name, array_or_none(joint.amplitude), array_or_none(joint.amplitude_std),
        array_or_none(joint.dissipation), array_or_none(joint.dissipation_std)));
  }
  return py::dict("mode"_a = levels.mode, "displacement"_a = array_or_none(levels.displacement),
                  "displacement_std"_a = array_or_none(levels.displacement_std),
                  "frequency"_a = array_or_none(levels.frequency),
                  "frequency_std"_a = array_or_none(levels.frequency_std),
                  "dissipation"_a = array_or_none(levels.dissipation),
                  "dissipation_std"_a = array_or_none(levels.dissipation_std),
                  "damping_ratio"_a = array_or_none(levels.damping_ratio),
                  "damping_ratio_std"_a = array_or_none(levels.damping_ratio_std),
                  "joints"_a = joints);
}

py::dict read_modal_levels(const std::vector<std::string>& paths,
                           const std::shared_ptr<ModelFile>& model) {
  std::vector<std::string> joints;
  for (const StructuralJoint& joint : model->structure.joints()) joints.push_back(joint.name);
  ModalLevels levels;
  for (const std::string& path : paths) {
    append(parse_modal_levels(read_text(path), input_name(path), joints,
                              model->structure.linear().vibrations()),
           levels);
  }
  return dict_of(levels);
}

// ---- What was found. ----

py::dict dict_of(const CalibratedJoint& joint, const Provenance& provenance) {
  const double k = joint.joint.stiffness();
  std::vector<double> slip_force;
  std::vector<double> density;
  for (std::size_t i = 0; i < joint.slip_displacement.size(); ++i) {
    slip_force.push_back(k * joint.slip_displacement[i]);
    density.push_back(joint.density[i] / (k * k));
  }
  py::list edges;
  for (const DensityEdge& edge : joint.edges) {
    edges.append(py::make_tuple(edge.slip_force, edge.deviation));
  }
  return py::dict(
      "name"_a = joint.name, "joint"_a = std::make_shared<Joint>(joint.joint),
      "slip_force"_a = array_of(std::move(slip_force)), "density"_a = array_of(std::move(density)),
      "lower"_a = array_of(joint.band.lower), "upper"_a = array_of(joint.band.upper),
      "variance_reduction"_a = array_of(joint.variance_reduction),
      "loss_significance"_a = joint.loss_significance,
      "stiffness"_a = estimate_tuple(joint.stiffness),
      "elastic_stiffness"_a = estimate_tuple(joint.elastic_stiffness), "edges"_a = edges,
      "covered_from"_a = k * joint.least_amplitude, "covered_to"_a = k * joint.largest_amplitude,
      "draws"_a = py::cast(joint_samples(joint, provenance, provenance.seed.value_or(0))));
}

py::list levels_found(const CalibrationResult& found) {
  py::list all;
  for (const CalibratedLevel& level : found.levels) {
    py::list joints;
    for (const JointAtLevel& joint : level.joints) {
      joints.append(py::make_tuple(joint.amplitude, joint.measured_amplitude,
                                   estimate_tuple(joint.dissipation)));
    }
    all.append(py::dict("found"_a = level.found, "frequency"_a = level.frequency,
                        "measured_frequency"_a = level.measured_frequency,
                        "dissipation"_a = level.dissipation,
                        "measured_dissipation"_a = level.measured_dissipation,
                        "damping_ratio"_a = level.damping_ratio, "residual"_a = level.residual,
                        "frequency_residual"_a = level.frequency_residual, "joints"_a = joints));
  }
  return all;
}

py::dict dict_of(const CalibrationResult& found, const Provenance& provenance) {
  py::list joints;
  for (const CalibratedJoint& joint : found.joints) joints.append(dict_of(joint, provenance));
  py::list pairs;
  for (const JointPair& pair : found.pairs) {
    pairs.append(py::make_tuple(found.joints[pair.first].name, found.joints[pair.second].name,
                                pair.correlation, pair.spread_alone, pair.spread_together,
                                pair.known_only_together));
  }
  return py::dict(
      "joints"_a = joints, "levels"_a = levels_found(found), "pairs"_a = pairs,
      "frequency_offset"_a = array_of(found.frequency_offset),
      "loss_scatter"_a = found.loss_scatter, "frequency_scatter"_a = found.frequency_scatter,
      "warnings"_a = list_of(found.warnings), "summary"_a = python::dict_of(found.summary));
}

Provenance provenance_of(const CalibrationOptions& options, const std::string& command) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = command;
  provenance.seed = options.seed;
  return provenance;
}

/// Of levels that came as arrays: so that draws of other data are not taken for those of one
/// calibration.
InputHash hash_of(const ModalLevels& levels) {
  Sha256 digest;
  const auto add = [&](const std::vector<double>& numbers) {
    const std::string size = std::to_string(numbers.size()) + ":";
    digest.update(size);
    digest.update({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)});
  };
  for (const std::size_t mode : levels.mode) digest.update(std::to_string(mode) + ",");
  for (const auto* numbers : {&levels.displacement, &levels.displacement_std, &levels.frequency,
                              &levels.frequency_std, &levels.dissipation, &levels.dissipation_std,
                              &levels.damping_ratio, &levels.damping_ratio_std}) {
    add(*numbers);
  }
  for (const JointLevels& joint : levels.joints) {
    digest.update(joint.name);
    for (const auto* numbers :
         {&joint.amplitude, &joint.amplitude_std, &joint.dissipation, &joint.dissipation_std}) {
      add(*numbers);
    }
  }
  return {"arrays", digest.finish()};
}

py::dict calibrate_structure(const std::shared_ptr<ModelFile>& model,
                             const std::vector<std::size_t>& sought, const std::string& response,
                             const py::dict& columns, const py::dict& given,
                             const std::string& command, const py::object& listener) {
  const ModalLevels levels = modal_levels_of(columns);
  CalibrationOptions options = calibration_options_of(given);
  const CalibrationResult found = long_result(
      [&](const Progress& progress) {
        options.progress = progress;
        return calibrate(model->structure, sought, response, levels, options);
      },
      listener);
  Provenance provenance = provenance_of(options, command);
  provenance.inputs = {hash_of(levels)};
  return dict_of(found, provenance);
}

/// By the files of the program, which are written.
py::dict calibrate_files(const std::string& model, const std::vector<std::string>& levels,
                         const std::string& out, bool keep_samples, const py::dict& given,
                         const std::string& command, const py::object& listener) {
  ModelCalibration calibration{.model = model,
                               .levels = levels,
                               .out = out,
                               .keep_draws = keep_samples,
                               .options = calibration_options_of(given),
                               .command = command};
  std::vector<PlannedOutput> planned;
  const std::vector<ResultFile> files = planned_files(calibration);
  OutputFolders folders;
  folders.make(out);
  for (const ResultFile& file : files) planned.push_back({file.path, file.kind});
  check_outputs(planned);
  const CalibratedModel done = long_result(
      [&](const Progress& progress) {
        calibration.options.progress = progress;
        return calibrate_model(calibration);
      },
      listener);
  OutputFiles outputs;
  for (const ResultFile& file : done.files) outputs.add(file.path, file.content);
  outputs.commit();
  Provenance provenance = provenance_of(calibration.options, command);
  provenance.inputs = done.inputs;
  return dict_of(done.found, provenance);
}

py::tuple read_model_to_find(const std::string& path) {
  const auto file = std::make_shared<ModelFile>(read_model(path, JointsToFind::kAllowed));
  return py::make_tuple(file, file->response, file->to_find);
}

}  // namespace

void add_calibration(py::module_& core) {
  core.def("read_model_to_find", read_model_to_find);
  core.def("read_modal_levels", read_modal_levels);
  core.def("calibrate", calibrate_structure);
  core.def("calibrate_files", calibrate_files);
}

}  // namespace microslip::python
