// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/recordings.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/bindings/python/tables.hpp"
#include "microslip/documents/levels/reduction_file.hpp"
#include "microslip/documents/response/verification_file.hpp"
#include "microslip/documents/response/virtual_measurement_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/documents/structure/rig_writer.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"
#include "microslip/rig/setup/rig_structure.hpp"
#include "microslip/rig/verification/verification_batch.hpp"
#include "microslip/rig/virtual_test/virtual_measurement.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"
#include "microslip/workflow/compare/verification_draws.hpp"
#include "microslip/workflow/compare/verification_text.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/reduce/reduction_text.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

// ---- The virtual test. ----

VirtualMeasurementOptions measurement_options(const py::dict& given) {
  return {.shaker = given["shaker"].cast<bool>(),
          .force_distortion = given["force_distortion"].cast<double>(),
          .linear_damping = given["linear_damping"].cast<double>()};
}

/// Result of a virtual test: records of the levels that were found.
struct Measured {
  VirtualMeasurement test;
  std::vector<Recording> recordings;
  std::vector<Recording> before_control;
};

/// As the program names its files.
std::string name_of(const VirtualMeasurement& test, const VirtualLevel& level, const char* stem) {
  const std::size_t width = std::max<std::size_t>(2, std::to_string(test.levels.size()).size());
  return fmt::format("{}_{:0{}}", stem, level.number, width);
}

Recording record_of(const Rig& rig, const StickState& state, const VirtualLevel& level,
                    std::uint64_t seed, bool before_control) {
  return virtual_record(rig, state, before_control ? level.uncontrolled : level.controlled, seed,
                        record_number(level, before_control));
}

Measured measured(const Rig& rig, const Joint& joint, const VirtualMeasurementOptions& options,
                  std::uint64_t seed, bool before_control) {
  Measured all{measure_virtually(rig, joint, options), {}, {}};
  const StickState state = stick_state(rig);
  for (const VirtualLevel& level : all.test.levels) {
    if (!level.summary.converged()) continue;
    all.recordings.push_back(record_of(rig, state, level, seed, false));
    all.recordings.back().source = name_of(all.test, level, "level");
    if (!before_control) continue;
    all.before_control.push_back(record_of(rig, state, level, seed, true));
    all.before_control.back().source = name_of(all.test, level, "before_control");
  }
  return all;
}

/// The warnings of the levels, each kind once.
py::list warnings_of(const Rig& rig, const Joint& joint, const VirtualMeasurement& test) {
  std::vector<Warning> all;
  if (const auto other = stiffness_warning(stick_state(rig), joint)) all.push_back(*other);
  for (const VirtualLevel& level : test.levels) {
    for (const Warning& warning : level.warnings) {
      if (std::ranges::find(all, warning.code, &Warning::code) == all.end()) {
        all.push_back(warning);
      }
    }
  }
  return list_of(all);
}

py::dict measure(const Rig& rig, const Joint& joint, const py::dict& given,
                 const py::object& listener) {
  VirtualMeasurementOptions options = measurement_options(given);
  const auto seed = given["seed"].cast<std::uint64_t>();
  const auto before_control = given["before_control"].cast<bool>();
  Measured all = long_result(
      [&](const Progress& progress) {
        options.progress = progress;
        return measured(rig, joint, options, seed, before_control);
      },
      listener);
  std::string truth;
  if (!all.recordings.empty()) {
    std::vector<std::string> sources;
    for (const VirtualLevel& level : all.test.levels) {
      sources.push_back(name_of(all.test, level, "level"));
    }
    truth = truth_table(all.test.levels, joint, sources).str();
  }
  py::dict control;
  if (options.shaker && !all.recordings.empty()) {
    control = columns_of(force_control_table(all.test.levels, options.controlled_harmonics).str());
  }
  return py::dict("recordings"_a = list_of(std::move(all.recordings)),
                  "before_control"_a = list_of(std::move(all.before_control)),
                  "truth"_a = truth.empty() ? py::dict() : columns_of(truth), "truth_csv"_a = truth,
                  "force_control"_a = control, "warnings"_a = warnings_of(rig, joint, all.test),
                  "summary"_a = python::dict_of(all.test.summary));
}

// ---- Records to levels. ----

ReductionOptions reduction_options(const py::dict& given) {
  ReductionOptions all;
  all.fit.order = given["order"].cast<int>();
  all.fit.frequency_guess = given["frequency"].cast<std::optional<double>>();
  all.modes = given["modes"].cast<std::size_t>();
  all.use_vibrometer = given["use_vibrometer"].cast<bool>();
  return all;
}

/// The records are in memory: the batch takes each as a file.
RecordReader reader_of(const std::vector<Recording>& recordings) {
  return [&recordings](std::size_t i) { return std::vector<Recording>{recordings[i]}; };
}

py::list rejected_of(const std::vector<RejectedRecord>& rejected) {
  py::list all;
  for (const RejectedRecord& record : rejected) {
    all.append(py::make_tuple(record.index, record.reason));
  }
  return all;
}

/// Levels with D ≥ 0, as tables contain them.
std::vector<ReducedLevel> levels_in_table(const ReductionBatch& batch) {
  std::vector<ReducedLevel> levels = batch.levels;
  std::erase_if(levels, [](const ReducedLevel& one) { return one.has_flag(kNegativeDissipation); });
  if (levels.empty()) {
    throw InputError("recordings", std::to_string(batch.levels.size()) + " levels",
                     "must contain one with a dissipation of 0 or more",
                     batch.rejected.empty() ? "" : batch.rejected.front().reason);
  }
  return levels;
}

py::dict reduce(const Rig& rig, const py::list& recordings, const py::dict& options,
                bool skip_faulty, const std::string& command, const py::object& listener) {
  const Reducer reducer(rig, reduction_options(options));
  const std::vector<Recording> all = recordings_of(recordings);
  const ReductionBatch batch = long_result(
      [&](const Progress& progress) {
        return reduce_batch(reducer, all.size(), reader_of(all),
                            {.skip_faulty = skip_faulty, .progress = progress});
      },
      listener);
  CsvWriter table = reduction_table(levels_in_table(batch));
  const std::vector<Warning> warnings = reduction_warnings(batch);
  const py::dict columns = columns_of(table.str());
  table.add_comment(heading_of(command));
  add_warnings(warnings, table);
  return py::dict("table"_a = columns, "csv"_a = table.str(),
                  "rejected"_a = rejected_of(batch.rejected), "warnings"_a = list_of(warnings));
}

// ---- Records against a joint. ----

VerificationOptions verification_options(const py::dict& given) {
  VerificationOptions all;
  all.reduction = reduction_options(given);
  all.sine = given["sine"].cast<bool>();
  all.history_cycles = given["cycles"].cast<double>();
  all.covered_to = given["covered_to"].cast<std::optional<double>>();
  all.linear_damping = given["linear_damping"].cast<double>();
  return all;
}

RigUncertainty uncertainty_of(const py::dict& given) {
  const auto std_of = [&](const char* name) { return given[name].cast<double>(); };
  return {.frequency = std_of("frequency_std"),
          .loss_factor = std_of("loss_factor_std"),
          .normal_load = std_of("normal_load_std"),
          .force_gain = std_of("force_gain_std"),
          .acceleration_gain = std_of("acceleration_gain_std")};
}

/// The requested draws.
struct AskedDraws {
  DrawOptions options;
  std::optional<JointSamples> joint;
  RigUncertainty rig;
};

std::optional<AskedDraws> draws_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  const auto draws = given.cast<py::dict>();
  return AskedDraws{.options = {.count = draws["count"].cast<std::size_t>(),
                                .confidence = draws["confidence"].cast<double>(),
                                .seed = draws["seed"].cast<std::uint64_t>()},
                    .joint = draws["joint"].cast<std::optional<JointSamples>>(),
                    .rig = uncertainty_of(draws)};
}

/// A verification with its bands over draws.
struct Verified {
  VerificationBatch batch;
  std::optional<VerificationSpread> spread;
};

Verified verified(const Verifier& verifier, const std::vector<Recording>& recordings,
                  bool skip_faulty, const std::optional<AskedDraws>& draws,
                  const Progress& progress) {
  Verified all{verify_batch(verifier, recordings.size(), reader_of(recordings),
                            {.skip_faulty = skip_faulty, .progress = progress}),
               {}};
  if (!draws || !all.batch.converged() || all.batch.records.empty()) return all;
  JointDraws joint;
  if (draws->joint) joint = joint_draws_of(*draws->joint, false);
  all.spread = verification_spread(verifier, all.batch.records, std::move(joint), draws->rig,
                                   draws->options, Execution::threads(), progress);
  return all;
}

/// The summary of the first record whose prediction was not found, or of the first.
const Summary& worst_summary(const VerificationBatch& batch) {
  for (const Verification& record : batch.records) {
    if (!record.summary.converged()) return record.summary;
  }
  return batch.records.front().summary;
}

py::dict dict_of(const Verified& all, const std::string& command) {
  const std::vector<Verification>& records = all.batch.records;
  if (records.empty()) {
    throw InputError("recordings", "none that can be verified", "must contain one",
                     all.batch.rejected.empty() ? "" : all.batch.rejected.front().reason);
  }
  std::vector<Warning> warnings = verification_warnings(all.batch);
  CsvWriter table = verification_table(records);
  if (all.spread) {
    warnings.insert(warnings.end(), all.spread->warnings.begin(), all.spread->warnings.end());
    add_checked(*all.spread, records, table);
  }
  const py::dict columns = columns_of(table.str());
  table.add_comment(with_warnings(heading_of(command), warnings));
  if (all.spread) table.add_comment(checked_comment(*all.spread));
  return py::dict("table"_a = columns, "harmonics"_a = columns_of(harmonics_table(records).str()),
                  "histories"_a = columns_of(histories_table(records).str()), "csv"_a = table.str(),
                  "rejected"_a = rejected_of(all.batch.rejected),
                  "failed_draws"_a = all.spread ? py::object(py::int_(all.spread->taken.failed()))
                                                : py::object(py::none()),
                  "warnings"_a = list_of(warnings),
                  "summary"_a = python::dict_of(worst_summary(all.batch)));
}

py::dict verify(const Rig& rig, const Joint& joint, const py::list& recordings,
                const py::dict& options, bool skip_faulty, const py::object& draws,
                const std::string& command, const py::object& listener) {
  const Verifier verifier(rig, joint, verification_options(options));
  const std::vector<Recording> all = recordings_of(recordings);
  const std::optional<AskedDraws> asked = draws_of(draws);
  if (asked) asked->options.check();
  return dict_of(long_result(
                     [&](const Progress& progress) {
                       return verified(verifier, all, skip_faulty, asked, progress);
                     },
                     listener),
                 command);
}

}  // namespace

void add_rig(py::module_& core) {
  py::class_<Rig, std::shared_ptr<Rig>>(core, "Rig")
      .def("text", [](const Rig& rig) { return format_rig(rig); })
      .def_property_readonly("joint", [](const Rig& rig) { return rig.contact.joint; })
      .def_property_readonly("has_test", [](const Rig& rig) { return rig.test.has_value(); })
      .def("stuck_frequencies", [](const Rig& rig) { return array_of(stick_state(rig).omega); })
      .def_property_readonly("stiffness", [](const Rig& rig) { return stick_state(rig).stiffness; })
      .def_property_readonly("channels", [](const Rig& rig) {
        std::vector<std::string> names{rig.excitation.channel};
        for (const RigSensor& sensor : rig.accelerometers) names.push_back(sensor.channel);
        if (rig.vibrometer) names.push_back(rig.vibrometer->channel);
        return names;
      });
  core.def("read_rig",
           [](const std::string& path) { return std::make_shared<Rig>(read_rig(path)); });
  core.def("parse_rig", [](const std::string& text, const std::string& name) {
    return std::make_shared<Rig>(parse_rig(text, name));
  });
  core.def("rig_structure", [](const Rig& rig, const Joint& joint, double linear_damping) {
    JointedStructure structure = rig_structure(rig, stick_state(rig), joint, {1.0}, linear_damping);
    std::string driven = structure.excitations().front().point;
    return std::make_shared<ModelFile>(ModelFile{.structure = std::move(structure),
                                                 .response = std::move(driven),
                                                 .joint_files = {std::string()}});
  });
  core.def("measure", measure);
  core.def("reduce", reduce);
  core.def("verify", verify);
}

}  // namespace microslip::python
