// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/test_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/workflow/compare/modal_levels_comparison.hpp"
#include "microslip/workflow/reduce/modal_decay.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"
#include "microslip/workflow/reduce/recordings_provenance.hpp"

namespace microslip {
namespace {

/// Kinds that files hold by their content.
enum class Content : std::uint8_t { kSweeps, kModalLevels, kRecording };

/// @param model_path  of what predicts, for messages.
Content content_of(const std::string& path, const std::string& model_path) {
  if (is_stepped_sine(path)) return Content::kSweeps;
  const PartOfFile part = part_of_file(path);
  const std::string kind = part.variable.empty() ? file_kind(read_kind_head(part.file)) : "";
  if (kind == kModalLevelsKind) return Content::kModalLevels;
  const KnownKind* const known = known_kind(kind);
  if (known != nullptr && !known->is_recording) {
    throw InputError(path, known->words,
                     "must be a test: a stepped-sine table, modal levels, or a recording",
                     fmt::format("What predicts comes first, and that is {} here.", model_path));
  }
  return Content::kRecording;
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

ModalLevels levels_of_table(const std::string& path, const ModelFile& model,
                            const TestReading& options) {
  std::vector<std::string> joints;
  for (const StructuralJoint& joint : model.structure.joints()) joints.push_back(joint.name);
  const ModalLevels all = parse_modal_levels(read_file(path), input_name(path), joints,
                                             model.structure.linear().vibrations());
  return some_levels(all, levels_of_modes(all, options.modes, path));
}

void read_decay(const ModelFile& model, const std::string& model_path, const TestReading& options,
                ReadTest& test) {
  const ReducedModalDecay reduced = reduce_modal_decay({.recording = test.path,
                                                        .model = model_path,
                                                        .sensors = options.sensors,
                                                        .modes = options.modes,
                                                        .analysis = options.decay,
                                                        .reading = options.reading},
                                                       model);
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

/// A test is looked at before it is read, and read again for its hash.
void require_file(const std::string& path) {
  std::error_code unknown;  // what is not there says who reads it
  const bool once = path == "-" || std::filesystem::is_fifo(path, unknown);
  if (!once) return;
  throw InputError("tests", in_quotes(path), "must be files: a pipe can be read only once",
                   "Write it to a file first.");
}

void require_model(const ModelFile* model, const std::string& path, const std::string& test) {
  if (model != nullptr) return;
  throw InputError(path, "a joint by itself",
                   fmt::format("must be a model.toml for {}, a test of a structure", test),
                   "A joint by itself predicts records of its force and displacement.");
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
  require_file(path);
  ReadTest test{.path = path, .digest = digest_of(path), .content = {}, .kind = options.kind};
  const Content content = content_of(path, model_path);
  if (content == Content::kSweeps) {
    require_model(model, model_path, path);
    if (options.kind && !is_of_sweeps(*options.kind)) {
      throw_other_kind(path, *options.kind, "a stepped-sine table");
    }
    test.content = read_stepped_sines(path);
    return test;
  }
  if (options.kind && is_of_sweeps(*options.kind)) {
    throw_other_kind(path, *options.kind, "no stepped-sine table");
  }
  if (content == Content::kModalLevels) {
    require_model(model, model_path, path);
    if (options.kind == TestKind::kLoops) throw_other_kind(path, *options.kind, "modal levels");
    test.content = levels_of_table(path, *model, options);
    return test;
  }
  test.is_recording = true;
  std::vector<Recording> recordings = read_named_recordings(path, options.reading, test.warnings);
  const bool loops =
      options.kind ? options.kind == TestKind::kLoops : model == nullptr || has_loops(recordings);
  if (loops) {
    read_loops(std::move(recordings), options, test);
  } else {
    require_model(model, model_path, path);
    read_decay(*model, model_path, options, test);
  }
  return test;
}

}  // namespace microslip
