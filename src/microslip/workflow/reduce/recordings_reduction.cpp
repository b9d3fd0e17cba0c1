// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/recordings_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/reduction_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/rig/reduction/stepped_sine.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"
#include "microslip/workflow/reduce/recordings_provenance.hpp"
#include "microslip/workflow/reduce/reduction_text.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

/// Stepped-sine tables have no scatter: a column that only some levels could have would be missing
/// in all.
[[noreturn]] void throw_mixed(const std::string& path, std::string_view found,
                              std::string_view wanted) {
  throw InputError(path, found, fmt::format("must be {}, as the first file is", wanted),
                   "Reduce the two kinds one after the other.");
}

/// The recordings, each opened when it is asked for, unless it was before.
class OpenedRecordings {
 public:
  explicit OpenedRecordings(const ReductionInputs& inputs) : inputs_(inputs) {
    check_opened(inputs.opened, inputs.recordings);
  }

  /// Whether the first that can be opened is a table of stepped sines. Others may be left out: at()
  /// tells why.
  bool begin_with_table() {
    if (!inputs_.opened.empty()) return is_table(inputs_.opened.front());
    for (first_at_ = 0; first_at_ < inputs_.recordings.size(); ++first_at_) {
      try {
        first_ = open_test(inputs_.recordings[first_at_]);
        return is_table(*first_);
      } catch (const Error&) {
        if (!inputs_.skip_faulty) return false;
      }
    }
    return false;
  }

  [[nodiscard]] TestFile at(std::size_t i) const {
    if (!inputs_.opened.empty()) return inputs_.opened[i];
    return first_ && i == first_at_ ? *first_ : open_test(inputs_.recordings[i]);
  }

 private:
  static bool is_table(const TestFile& file) { return file.content == TestContent::kSteppedSine; }

  const ReductionInputs& inputs_;
  std::optional<TestFile> first_;
  std::size_t first_at_ = 0;
};

std::vector<ReducedLevel> reduce_table(const Reducer& reducer, const TestFile& file) {
  if (file.content != TestContent::kSteppedSine) {
    throw_mixed(file.path, "a record in time", "a stepped-sine table");
  }
  std::vector<ReducedLevel> levels;
  for (const SteppedSine& sweep : read_stepped_sines(file)) {
    levels.push_back(reduce_stepped_sine(reducer, sweep));
  }
  return levels;
}

ReductionBatch reduce_tables(const Reducer& reducer, const ReductionInputs& inputs,
                             const OpenedRecordings& files, std::vector<std::string>& digests) {
  ReductionBatch batch;
  for (std::size_t i = 0; i < inputs.recordings.size(); ++i) {
    try {
      const TestFile file = files.at(i);
      std::ranges::move(reduce_table(reducer, file), std::back_inserter(batch.levels));
      digests[i] = file.sha256;
    } catch (const Error& error) {
      if (!inputs.skip_faulty) throw;
      batch.rejected.push_back({i, error.what()});
    }
  }
  return batch;
}

ReductionBatch reduce_records(const Reducer& reducer, const ReductionInputs& inputs,
                              const OpenedRecordings& files, std::vector<std::string>& digests,
                              std::vector<std::vector<Warning>>& warnings) {
  const auto read = [&](std::size_t i) {
    const TestFile file = files.at(i);
    if (file.content == TestContent::kSteppedSine) {
      throw_mixed(file.path, "a stepped-sine table", "a record in time");
    }
    std::vector<Recording> recordings =
        named_recordings(read_recordings(file, inputs.reading), file.path, warnings[i]);
    digests[i] = file.sha256;
    return recordings;
  };
  return reduce_batch(reducer, inputs.recordings.size(), read,
                      {.skip_faulty = inputs.skip_faulty, .progress = inputs.progress});
}

/// The flags say more of the cause than a D below 0.
std::string causes(const ReducedLevel& level) {
  std::string text;
  for (const Warning& flag : level.flags) text += (text.empty() ? "" : " ") + flag.text;
  return text;
}

/// A table of levels has D ≥ 0, as every reader of it expects.
std::vector<ReducedLevel> writable_levels(const std::vector<ReducedLevel>& levels) {
  std::vector<ReducedLevel> result;
  std::ranges::copy_if(levels, std::back_inserter(result), [](const ReducedLevel& level) {
    return !level.has_flag(kNegativeDissipation);
  });
  if (!result.empty()) return result;
  const ReducedLevel& first = levels.front();
  throw InputError(first.source + ": dissipation", fmt::format("{:.3g} J", first.dissipation.value),
                   "must be above 0 in one level at least", causes(first));
}

}  // namespace

MeasuredLevels measured_levels(std::span<const ReducedLevel> levels) {
  return levels_of({"levels", reduction_table(levels).str()});
}

ReducedRecordings reduce_recordings(const ReductionInputs& inputs,
                                    const ReductionOptions& options) {
  check_distinct_files(inputs.recordings);
  constexpr std::size_t kLargestRig = std::size_t{1} << 20U;
  NamedInput input = inputs.test_input
                         ? *inputs.test_input
                         : NamedInput{inputs.test, read_text(inputs.test, kLargestRig)};
  const Rig rig = parse_rig(input);
  Reducer reducer = of_rig(input, [&] { return Reducer(rig, options); });
  const std::size_t count = inputs.recordings.size();
  ReducedRecordings reduced{std::move(input), inputs.recordings, std::move(reducer), {}, {}, {}};
  reduced.digests.resize(count);
  reduced.warnings.resize(count);
  OpenedRecordings files(inputs);
  reduced.batch =
      files.begin_with_table()
          ? reduce_tables(reduced.reducer, inputs, files, reduced.digests)
          : reduce_records(reduced.reducer, inputs, files, reduced.digests, reduced.warnings);
  reduced.warnings.push_back(copied_recordings(reduced.recordings, reduced.digests));
  return reduced;
}

std::string levels_text(const ReducedRecordings& reduced, const std::string& command) {
  const ReductionBatch& batch = reduced.batch;
  check_any_left("reduced", reduced.recordings.size(), batch.levels.size(), batch.rejected);
  CsvWriter table = reduction_table(writable_levels(batch.levels));
  table.add_comment(
      recordings_provenance(command, reduced.rig, reduced.recordings, reduced.digests));
  add_warnings(joined_warnings(reduced.warnings), table);
  add_warnings(reduction_warnings(batch), table);
  return table.str();
}

}  // namespace microslip
