// SPDX-License-Identifier: MIT
#include "microslip/workflow/measure/rig_demonstration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "microslip/documents/levels/reduction_file.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"
#include "microslip/workflow/text/nothing_found.hpp"

namespace microslip {
namespace {

VirtualMeasurement test_rig(const Rig& rig, const Joint& truth, const Progress& progress) {
  VirtualMeasurement test = measure_virtually(rig, truth, {.progress = progress});
  if (!test.summary.converged()) {
    throw NothingFound(
        fmt::format("the virtual test: {}; nothing is written", test.summary.reason));
  }
  return test;
}

/// Levels with a record before the force control too.
constexpr std::array<std::size_t, 4> kCompared = {1, 26, 51, 90};

VirtualRecords record(const Rig& rig, const VirtualMeasurement& test, std::uint64_t seed) {
  const StickState state = stick_state(rig, rig.test->modes);
  VirtualRecords records;
  for (const VirtualLevel& level : test.levels) {
    records.names.push_back(fmt::format("recordings/level_{:02}.csv", level.number));
    Recording& recording = records.recordings.emplace_back(
        virtual_record(rig, state, level.controlled, seed, record_number(level)));
    recording.source = records.names.back();
    if (std::ranges::find(kCompared, level.number) == kCompared.end()) continue;
    records.before_control.emplace_back(
        fmt::format("recordings/before_control_{:02}.csv", level.number),
        virtual_record(rig, state, level.uncontrolled, seed, record_number(level, true)));
  }
  return records;
}

RecordReader reader_of(const VirtualRecords& records) {
  return [&records](std::size_t i) { return std::vector<Recording>{records.recordings[i]}; };
}

}  // namespace

Rig without_truth(Rig rig) {
  rig.contact.joint.clear();
  return rig;
}

bool RigDemonstration::converged() const {
  return found.summary.converged() && verification.converged();
}

RigDemonstration demonstrate(const Rig& rig, const Joint& truth, std::uint64_t seed,
                             const std::function<Progress(const char*)>& progress) {
  VirtualMeasurement test = test_rig(rig, truth, progress("virtual test"));
  VirtualRecords records = record(rig, test, seed);
  const std::size_t count = records.recordings.size();
  Reducer reducer(without_truth(rig));
  ReductionBatch reduction =
      reduce_batch(reducer, count, reader_of(records), {.progress = progress("reduction")});
  const std::string text = reduction_table(reduction.levels).str();
  LevelsFile levels = parse_levels(text, "levels.csv");
  IdentificationOptions options;
  options.bands = BandOptions{.seed = seed, .progress = progress("bands")};
  Identification found = identify(levels.levels, reducer.state().stiffness, options);
  Verifier verifier(
      without_truth(rig), found.joint,
      {.covered_to = found.covered_to, .linear_damping = found.linear_damping.value_or(0.0)});
  VerificationBatch verification =
      verify_batch(verifier, count, reader_of(records), {.progress = progress("verification")});
  return {.rig = rig,
          .truth = truth,
          .test = std::move(test),
          .recordings = std::move(records),
          .reducer = std::move(reducer),
          .reduction = std::move(reduction),
          .levels_text = text,
          .levels = std::move(levels),
          .options = std::move(options),
          .found = std::move(found),
          .verifier = std::move(verifier),
          .verification = std::move(verification)};
}

}  // namespace microslip
