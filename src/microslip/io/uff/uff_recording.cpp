// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/uff/uff151.hpp"
#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff58.hpp"
#include "microslip/io/uff/uff_channel.hpp"
#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_group.hpp"
#include "microslip/io/uff/uff_mode_shapes.hpp"

namespace microslip {
namespace {

enum class Wanted { kRecordings, kAll };

/// "2 datasets 15, 1 dataset 55 (mode shapes)".
std::string describe(const std::map<int, std::size_t>& datasets) {
  std::string text;
  for (const auto& [number, count] : datasets) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} dataset{} {}", count, count == 1 ? "" : "s", number);
    if (number == 55) text += " (mode shapes)";
    if (number == 2414) text += " (results at nodes or on elements)";
  }
  return text;
}

class UffRecordingReader {
 public:
  UffRecordingReader(const std::string& path, const RecordingReadOptions& options, Wanted wanted)
      : options_(options), wanted_(wanted), input_(path, options.progress), envelope_(input_) {
    source_ = path == "-" ? input_.name() : std::filesystem::path(path).filename().string();
  }

  UffContents read() {
    try {
      while (const auto dataset = envelope_.next()) read(*dataset);
    } catch (const UffTruncated& error) {
      if (!options_.allow_truncated || (group_.channels.empty() && result_.recordings.empty())) {
        throw;
      }
      result_.warnings.push_back({"uff_truncated", error.what()});
    }
    finish_group();
    if (result_.recordings.empty() && mode_shapes_.empty()) fail_empty();
    for (std::size_t i = 0; i < result_.recordings.size(); ++i) {
      Recording& recording = result_.recordings[i];
      recording.source = source_;
      if (result_.recordings.size() > 1) recording.source += fmt::format(" #{}", i + 1);
      check_recording(recording);
    }
    return {std::move(result_), std::move(mode_shapes_)};
  }

 private:
  void read(const UffDataset& dataset) {
    ++datasets_[dataset.number];
    if (dataset.number == 58) {
      add(read_uff58(envelope_, dataset, options_.allow_truncated, result_.warnings));
      return;
    }
    if (dataset.number == 151) begin_file();
    if (has_uff_mode_shape(dataset) && wanted_ == Wanted::kAll) read_mode_shape(dataset);
    if (dataset.number == 164) units_ = read_uff164(envelope_);
    if (!envelope_.close().closed) {
      result_.warnings.push_back(
          {"uff_not_closed", fmt::format("{} ends with the file, without the "
                                         "line '    -1' that closes it",
                                         envelope_.dataset_name())});
    }
  }

  void read_mode_shape(const UffDataset& dataset) {
    try {
      auto shape = read_uff_mode_shape(envelope_, dataset, units_, result_.warnings);
      if (shape) mode_shapes_.push_back(std::move(*shape));
    } catch (const FormatError& error) {
      if (!damaged_shape_) damaged_shape_ = std::current_exception();
      result_.warnings.push_back({"uff_mode_shape", error.what()});
    }
  }

  /// Files are joined by putting one behind the other: units do not reach beyond a header.
  void begin_file() {
    finish_group();
    attributes_ = read_uff151(envelope_);
    if (seen_function_) units_.reset();
    seen_function_ = false;
  }

  void add(Uff58 data) {
    seen_function_ = true;
    if (data.header.points < 2) {
      result_.warnings.push_back(
          {"uff_too_short",
           fmt::format("{} has {} point{} and is left out", envelope_.dataset_name(),
                       data.header.points, data.header.points == 1 ? "" : "s")});
      return;
    }
    if (!uff_abscissa_unit(data.header, units_)) {
      result_.warnings.push_back(
          {"uff_axis_unit", fmt::format("{}: the unit of the abscissa, '{}', is not known; it is "
                                        "treated as neither time nor frequency",
                                        envelope_.dataset_name(), data.header.abscissa.unit)});
    }
    UffChannel channel = uff_channel(std::move(data), units_);
    if (!group_.takes(channel)) finish_group();
    group_.add(std::move(channel));
  }

  void finish_group() {
    if (group_.channels.empty()) return;
    Recording recording = recording_of(std::move(group_), source_, result_.warnings);
    recording.attributes = attributes_;
    result_.recordings.push_back(std::move(recording));
    group_ = {};
  }

  [[noreturn]] void fail_empty() const {
    if (damaged_shape_) std::rethrow_exception(damaged_shape_);
    const std::string found = input_.size() == 0 ? "an empty file" : describe(datasets_);
    throw FormatError({.file = input_.name()},
                      "a function of at least two points (dataset 58 or 58b)", found);
  }

  RecordingReadOptions options_;
  Wanted wanted_;
  UffInput input_;
  UffEnvelope envelope_;
  std::string source_;
  std::optional<Uff164> units_;
  Attributes attributes_;
  bool seen_function_ = false;
  UffGroup group_;
  Recordings result_;
  std::vector<UffModeShape> mode_shapes_;
  std::exception_ptr damaged_shape_;
  std::map<int, std::size_t> datasets_;  ///< how many of each number
};

}  // namespace

Recordings read_recordings_uff(const std::string& path, const RecordingReadOptions& options) {
  return UffRecordingReader(path, options, Wanted::kRecordings).read().recordings;
}

UffContents read_contents_uff(const std::string& path, const RecordingReadOptions& options) {
  return UffRecordingReader(path, options, Wanted::kAll).read();
}

}  // namespace microslip
