// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/io/bytes/input_name.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/compare/modal_levels_comparison.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"

namespace microslip {
namespace {

/// @param model_path  of what predicts, for messages.
void require_test(const TestFile& file, const std::string& model_path) {
  if (file.content != TestContent::kLevels && file.content != TestContent::kOther) return;
  throw InputError(file.path, known_kind(file.kind)->words,
                   "must be a test: a stepped-sine table, modal levels, or a recording",
                   fmt::format("Name the predicting file first; {} was taken as it.", model_path));
}

bool has_loops(const std::vector<Recording>& recordings) {
  return std::ranges::any_of(recordings, [](const Recording& recording) {
    const auto has = [&](const Dimension& dimension) {
      return std::ranges::any_of(recording.channels, [&](const Channel& channel) {
        return channel.dimension == dimension;
      });
    };
    return has(kForce) && has(kLength);
  });
}

[[noreturn]] void throw_other_kind(const std::string& path, TestKind kind, const char* found) {
  throw InputError("`kind`", in_quotes(to_string(kind)),
                   fmt::format("must be what {} is: {}", path, found),
                   "Leave it out, or name the tests of another kind in another call.");
}

ModalLevels levels_of_table(const TestFile& file, const ModelFile& model,
                            const TestReading& options) {
  std::vector<std::string> joints;
  for (const StructuralJoint& joint : model.structure.joints()) joints.push_back(joint.name);
  const ModalLevels all = parse_modal_levels(text_of(file), input_name(file.path), joints,
                                             model.structure.linear().vibrations());
  return some_levels(all, levels_of_modes(all, options.modes, file.path));
}

void read_decay(const Recordings& file, const ModelFile& model, const std::string& model_path,
                const TestReading& options, ReadTest& test) {
  const ReducedModalDecay reduced = reduce_modal_decay({.recording = test.path,
                                                        .model = model_path,
                                                        .sensors = options.sensors,
                                                        .modes = options.modes,
                                                        .analysis = options.decay,
                                                        .reading = options.reading},
                                                       model, file);
  test.content = levels_of(reduced);
  test.warnings = reduced.warnings;
  test.converged = reduced.converged();
}

void read_loops(std::vector<Recording> recordings, const TestReading& options, ReadTest& test) {
  std::vector<NamedForceRecord> records;
  for (const Recording& recording : recordings) {
    records.push_back(
        {recording.source, force_record(recording, options.channels), recording.axis.start, 1.0});
  }
  test.content = std::move(records);
}

void require_model(const ModelFile* model, const std::string& path, const std::string& test) {
  if (model != nullptr) return;
  throw InputError(path, "a single joint",
                   fmt::format("must be a model.toml for {}, a test of a structure", test),
                   "A single joint predicts only records of its force and displacement.");
}

}  // namespace

std::vector<std::size_t> levels_of_modes(const ModalLevels& levels,
                                         const std::vector<std::size_t>& modes,
                                         const std::string& path) {
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (modes.empty() || std::ranges::count(modes, levels.mode[i] + 1) > 0) some.push_back(i);
  }
  if (!some.empty() || levels.size() == 0) return some;
  throw InputError("`mode`", fmt::format("{}", fmt::join(modes, ", ")),
                   fmt::format("must be one of those of {}", path));
}

ReadTest read_test(const std::string& path, const ModelFile* model, const std::string& model_path,
                   const TestReading& options) {
  return read_test(open_test(path), model, model_path, options);
}

ReadTest read_test(const TestFile& file, const ModelFile* model, const std::string& model_path,
                   const TestReading& options) {
  require_file(file, "tests", "files");
  const std::string& path = file.path;
  ReadTest test{.path = path, .digest = file.sha256, .content = {}, .kind = options.kind};
  require_test(file, model_path);
  if (file.content == TestContent::kSteppedSine) {
    require_model(model, model_path, path);
    if (options.kind && !is_of_sweeps(*options.kind)) {
      throw_other_kind(path, *options.kind, "a stepped-sine table");
    }
    test.content = read_stepped_sines(file);
    return test;
  }
  if (options.kind && is_of_sweeps(*options.kind)) {
    throw_other_kind(path, *options.kind, "no stepped-sine table");
  }
  if (file.content == TestContent::kModalLevels) {
    require_model(model, model_path, path);
    if (options.kind == TestKind::kLoops) throw_other_kind(path, *options.kind, "modal levels");
    test.content = levels_of_table(file, *model, options);
    return test;
  }
  test.is_recording = true;
  Recordings found = read_recordings(file, options.reading);
  const bool loops = options.kind ? options.kind == TestKind::kLoops
                                  : model == nullptr || has_loops(found.recordings);
  if (loops) {
    read_loops(named_recordings(std::move(found), path, test.warnings), options, test);
  } else {
    require_model(model, model_path, path);
    read_decay(found, *model, model_path, options, test);
  }
  return test;
}

}  // namespace microslip
