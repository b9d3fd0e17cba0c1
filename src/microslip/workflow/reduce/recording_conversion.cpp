// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/recording_conversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/recordings/assumed_units.hpp"

namespace microslip {
namespace {

/// Without the file or the line, before the first colon, that it is about.
std::string_view matter_of(std::string_view text) {
  const std::size_t place = text.find(": ");
  return place == std::string_view::npos ? text : text.substr(place);
}

/// Whether an earlier conversion has said it, then of another file.
bool says(const Recording& recording, const Warning& warning) {
  return std::ranges::any_of(recording.attributes, [&](const auto& attribute) {
    const std::string_view said = attribute.second;
    return attribute.first == "warning" && said.starts_with(warning.code + ": ") &&
           said.ends_with(matter_of(warning.text));
  });
}

/// Of a universal file.
bool may_have_mode_shapes(const std::string& path) {
  if (path == "-") return false;
  const PartOfFile part = part_of_file(path);
  if (!part.variable.empty()) return false;
  const RecordingFormat format = recording_format(part.file);
  return format == RecordingFormat::kUff || format == RecordingFormat::kUffBinary;
}

}  // namespace

void choose_channels(const std::vector<std::string>& names, std::vector<Recording>& recordings) {
  if (names.empty()) return;
  for (Recording& recording : recordings) {
    std::vector<Channel> chosen;
    for (const std::string& name : names) chosen.push_back(recording.channel(name));
    recording.channels = std::move(chosen);
  }
}

void add_warning_attributes(const std::vector<Warning>& warnings,
                            std::vector<Recording>& recordings) {
  for (Recording& recording : recordings) {
    for (const Warning& warning : warnings) {
      if (says(recording, warning)) continue;
      recording.attributes.emplace_back("warning",
                                        fmt::format("{}: {}", warning.code, warning.text));
    }
  }
}

UffContents read_with_mode_shapes(const std::string& path, const RecordingReadOptions& options) {
  if (!may_have_mode_shapes(path)) {
    return {.recordings = read_recordings(path, options), .mode_shapes = {}};
  }
  UffContents contents = read_contents_uff(path, options);
  finish_units(options.assumed_units, contents.recordings);
  return contents;
}

}  // namespace microslip
