// SPDX-License-Identifier: MIT
#include "demo_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "demo_data.hpp"
#include "demo_rig_figures.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/io/reduction_file.hpp"
#include "microslip/io/rig_file.hpp"
#include "microslip/io/rig_writer.hpp"
#include "microslip/io/verification_file.hpp"
#include "microslip/io/virtual_measurement_file.hpp"
#include "microslip/rig/virtual_record.hpp"
#include "microslip/workflow/nothing_found.hpp"
#include "progress_bar.hpp"

namespace microslip::app {
namespace {

const std::string kFolder = "reference_rig";

/// Without the joint: what the reduction reads.
Rig without_truth(Rig rig) {
  rig.contact.joint.clear();
  return rig;
}

VirtualMeasurement test_rig(const Rig& rig, const Joint& truth, bool quiet) {
  VirtualMeasurement test =
      measure_virtually(rig, truth, {.progress = progress_bar("virtual test", quiet)});
  if (!test.summary.converged()) {
    throw NothingFound(
        fmt::format("the virtual test: {}; nothing is written", test.summary.reason));
  }
  return test;
}

struct Records {
  std::vector<std::string> names;
  std::vector<Recording> recordings;
  std::vector<std::pair<std::string, Recording>> before_control;  ///< of some levels
};

/// Levels with a record before the force control too.
constexpr std::array<std::size_t, 4> kCompared = {1, 26, 51, 90};

Records record(const Rig& rig, const VirtualMeasurement& test) {
  const StickState state = stick_state(rig, rig.test->modes);
  Records records;
  for (const VirtualLevel& level : test.levels) {
    records.names.push_back(fmt::format("recordings/level_{:02}.csv", level.number));
    Recording& recording = records.recordings.emplace_back(
        virtual_record(rig, state, level.controlled, kDemoSeed, record_number(level)));
    recording.source = records.names.back();
    if (std::ranges::find(kCompared, level.number) == kCompared.end()) continue;
    records.before_control.emplace_back(
        fmt::format("recordings/before_control_{:02}.csv", level.number),
        virtual_record(rig, state, level.uncontrolled, kDemoSeed, record_number(level, true)));
  }
  return records;
}

RecordReader reader_of(const Records& records) {
  return [&records](std::size_t i) { return std::vector<Recording>{records.recordings[i]}; };
}

ReductionBatch reduce(const Reducer& reducer, const Records& records, bool quiet) {
  return reduce_batch(reducer, records.recordings.size(), reader_of(records),
                      {.progress = progress_bar("reduction", quiet)});
}

LevelsFile identified_levels(DemoFolder& folder, const ReductionBatch& reduction,
                             std::string& text) {
  text = reduction_table(reduction.levels).str();
  folder.add(kFolder + "/levels.csv", text);
  return parse_levels(text, "levels.csv");
}

Identification identify_joint(DemoFolder& folder, const ReductionBatch& reduction, double stiffness,
                              LevelsFile& file) {
  std::string text;
  file = identified_levels(folder, reduction, text);
  IdentificationOptions options;
  options.inversion.stiffness = stiffness;
  options.bands =
      BandOptions{.seed = kDemoSeed, .progress = progress_bar("bands", folder.call().quiet)};
  Identification found = identify(file.levels, options);
  folder.add_identification(kFolder, found, options, file.file, text);
  return found;
}

void add_tables(DemoFolder& folder, const RigDemonstration& done, Records records) {
  folder.add(kFolder + "/rig.toml", format_rig(without_truth(done.rig)));
  folder.add(kFolder + "/truth_joint.json", std::string(kReferenceJoint));
  folder.add(kFolder + "/truth.csv",
             truth_table(done.test.levels, done.truth, records.names).str());
  folder.add(kFolder + "/force_control.csv",
             force_control_table(done.test.levels, VirtualMeasurementOptions{}.controlled_harmonics)
                 .str());
  const std::string origin = folder.provenance(kFolder, {"rig.toml", "joint.json"});
  const auto add_predicted = [&](const char* name, CsvWriter table) {
    table.add_comment(origin);
    folder.add(kFolder + name, table.str());
  };
  add_predicted("/verification.csv", verification_table(done.verification.records));
  add_predicted("/verification_histories.csv", histories_table(done.verification.records));
  for (std::size_t i = 0; i < records.names.size(); ++i) {
    folder.add(kFolder + "/" + records.names[i], std::move(records.recordings[i]));
  }
  for (auto& [name, recording] : records.before_control) {
    folder.add(kFolder + "/" + name, std::move(recording));
  }
}

}  // namespace

bool RigDemonstration::converged() const {
  return found.summary.converged() && verification.converged();
}

RigDemonstration demonstrate_rig(DemoFolder& folder) {
  const bool quiet = folder.call().quiet;
  const Rig rig = parse_rig(kReferenceRig, "examples/reference_rig/rig.toml");
  const Joint truth = parse_joint(kReferenceJoint, "examples/reference_rig/joint.json").joint;
  VirtualMeasurement test = test_rig(rig, truth, quiet);
  Records records = record(rig, test);
  Reducer reducer(without_truth(rig));
  ReductionBatch reduction = reduce(reducer, records, quiet);
  LevelsFile levels;
  Identification found = identify_joint(folder, reduction, reducer.state().stiffness, levels);
  Verifier verifier(
      without_truth(rig), found.joint,
      {.covered_to = found.covered_to, .linear_damping = found.linear_damping.value_or(0.0)});
  VerificationBatch verification =
      verify_batch(verifier, records.recordings.size(), reader_of(records),
                   {.progress = progress_bar("verification", quiet)});
  RigDemonstration done{.rig = rig,
                        .truth = truth,
                        .test = std::move(test),
                        .reducer = std::move(reducer),
                        .reduction = std::move(reduction),
                        .found = std::move(found),
                        .verifier = std::move(verifier),
                        .verification = std::move(verification)};
  draw_rig(folder, kFolder, done, levels.levels);
  add_tables(folder, done, std::move(records));
  folder.add_report(kFolder, "Reference rig",
                    "A virtual frictional-support test with shaker, force control and noise; the "
                    "joint is known, and the reduction never reads it");
  return done;
}

}  // namespace microslip::app
