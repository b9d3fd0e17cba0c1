// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/modal_levels_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/modal_reduction_file.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/workflow/predict/model_rules.hpp"
#include "microslip/workflow/reduce/modal_reduction_text.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"
#include "microslip/workflow/reduce/point_sensors.hpp"
#include "microslip/workflow/reduce/recordings_provenance.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

StructureTest test_of(const ModalLevelsReduction& options, ModelFile model,
                      const std::string& path) {
  require_driven_by_forces(model, path, "reduce");
  require_no_static_loads(model, path, "reduce");
  std::vector<PointSensor> sensors = point_sensors(options.sensors, model, path);
  std::string force = options.force;
  if (force.empty() && !model.force_channels.empty()) force = model.force_channels.front();
  return {std::move(model.structure), std::move(model.response), std::move(force),
          std::move(sensors)};
}

ModalReducer reducer_of(const ModalLevelsReduction& options, const NamedInput& input) {
  StructureTest test = test_of(
      options, parse_model(input.text, input_name(input.path), JointsToFind::kAllowed), input.path);
  try {
    return ModalReducer(std::move(test), options.reduction);
  } catch (const InputError& error) {
    if (error.name().starts_with("mode")) throw;
    throw error.renamed(fmt::format("{}: {}", input_name(input.path), error.name()));
  }
}

std::vector<std::string> joint_names(const ModalReducer& reducer) {
  std::vector<std::string> names;
  for (const StructuralJoint& joint : reducer.test().structure.joints()) {
    names.push_back(joint.name);
  }
  return names;
}

/// A table of levels has D ≥ 0, as every reader of it expects.
std::vector<ModalLevel> writable_modal_levels(const std::vector<ModalLevel>& levels) {
  std::vector<ModalLevel> result;
  std::ranges::copy_if(levels, std::back_inserter(result), [](const ModalLevel& level) {
    return !level.has_flag(kNegativeDissipation);
  });
  if (!result.empty()) return result;
  const ModalLevel& first = levels.front();
  std::string causes;
  for (const Warning& flag : first.flags) causes += (causes.empty() ? "" : " ") + flag.text;
  throw InputError(first.source + ": dissipation", fmt::format("{:.3g} J", first.dissipation.value),
                   "must be above 0 in one level at least", causes);
}

}  // namespace

ReducedModalLevels reduce_modal_levels(const ReductionInputs& inputs,
                                       const ModalLevelsReduction& options) {
  check_distinct_files(inputs.recordings);
  check_opened(inputs.opened, inputs.recordings);
  constexpr std::size_t kLargestModel = std::size_t{16} << 20U;
  NamedInput input = inputs.test_input
                         ? *inputs.test_input
                         : NamedInput{inputs.test, read_text(inputs.test, kLargestModel)};
  ModalReducer reducer = reducer_of(options, input);
  const std::size_t count = inputs.recordings.size();
  ReducedModalLevels reduced{std::move(input), inputs.recordings, std::move(reducer), {}, {}, {}};
  reduced.digests.resize(count);
  reduced.warnings.resize(count);
  const auto read = [&](std::size_t i) {
    const TestFile file =
        inputs.opened.empty() ? open_test(inputs.recordings[i]) : inputs.opened[i];
    if (file.content == TestContent::kSteppedSine) {
      throw InputError(file.path, "a stepped-sine table", "must be a record in time",
                       "Joints are observed in records of force and accelerations.");
    }
    std::vector<Recording> recordings =
        named_recordings(read_recordings(file, inputs.reading), file.path, reduced.warnings[i]);
    reduced.digests[i] = file.sha256;
    return recordings;
  };
  reduced.batch = reduce_batch(reduced.reducer, count, read,
                               {.skip_faulty = inputs.skip_faulty, .progress = inputs.progress});
  reduced.warnings.push_back(copied_recordings(reduced.recordings, reduced.digests));
  return reduced;
}

std::string modal_levels_text(const ReducedModalLevels& reduced, const std::string& command) {
  const ModalReductionBatch& batch = reduced.batch;
  check_any_left("reduced", reduced.recordings.size(), batch.levels.size(), batch.rejected);
  CsvWriter table =
      modal_reduction_table(writable_modal_levels(batch.levels), joint_names(reduced.reducer));
  table.add_comment(
      recordings_provenance(command, reduced.model, reduced.recordings, reduced.digests));
  add_warnings(joined_warnings(reduced.warnings), table);
  add_warnings(modal_warnings(batch), table);
  return table.str();
}

std::string describe_modal_levels(const ReducedModalLevels& reduced) {
  return describe_modal_reduction(reduced.reducer, reduced.batch);
}

}  // namespace microslip
