// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/force_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"

namespace microslip {
namespace {

/// Whether there is a channel of that name, or any of that quantity.
bool has_channel(const Recording& recording, const std::string& name, const Dimension& dimension) {
  return std::ranges::any_of(recording.channels, [&](const Channel& channel) {
    return name.empty() ? channel.dimension == dimension : channel.name == name;
  });
}

/// For a file of several recordings: the other ones that have such a channel.
std::string others_with(const Recording& recording, const Dimension& dimension,
                        std::span<const Recording> all) {
  std::string text;
  for (const Recording& other : all) {
    if (&other == &recording || !has_channel(other, {}, dimension)) continue;
    text = fmt::format(
        " One is in another recording of the file, {}: have both recorded at the "
        "same times.",
        other.source);
    break;
  }
  return text;
}

/// The channel of that name, or the only one of that quantity.
std::string channel_of(const Recording& recording, const std::string& name,
                       const Dimension& dimension, std::string_view option,
                       std::span<const Recording> all) {
  if (!name.empty()) return name;
  std::vector<std::string> fits;
  for (const Channel& channel : recording.channels) {
    if (channel.dimension == dimension) fits.push_back(channel.name);
  }
  if (fits.size() == 1) return fits.front();
  throw InputError(
      fmt::format("{}: channel of {}", recording.source, dimension_name(dimension)),
      InputState{fits.empty() ? "missing" : fmt::format("there {} times", fits.size())},
      "must be given exactly once",
      fmt::format("The channels are {}; choose by `{}`, and give units that the file lacks by "
                  "`assume_units`.{}",
                  names_of_channels(recording), option,
                  fits.empty() ? others_with(recording, dimension, all) : ""));
}

std::vector<double> values_of(const Recording& recording, const std::string& name,
                              const Dimension& dimension) {
  const std::span<const double> values = recording.signal(name, dimension);
  return {values.begin(), values.end()};
}

/// @param all  those of its file.
ForceRecord record_among(const Recording& recording, const JointChannels& channels,
                         std::span<const Recording> all) {
  const std::string force = channel_of(recording, channels.force, kForce, "force", all);
  const std::string displacement =
      channel_of(recording, channels.displacement, kLength, "displacement", all);
  ForceRecord record;
  record.force = values_of(recording, force, kForce);
  record.displacement = values_of(recording, displacement, kLength);
  record.time_step = recording.axis.even() ? recording.axis.step : 0.0;
  return record;
}

/// Leaves out those without force or displacement beside one that has both, with a warning each:
/// loggers write markers and slow channels into recordings of their own.
void leave_out_other(std::vector<Recording>& recordings, const JointChannels& channels,
                     std::vector<Warning>& warnings) {
  const auto has_both = [&](const Recording& recording) {
    return has_channel(recording, channels.force, kForce) &&
           has_channel(recording, channels.displacement, kLength);
  };
  if (std::ranges::none_of(recordings, has_both)) return;
  std::erase_if(recordings, [&](const Recording& recording) {
    if (has_both(recording)) return false;
    warnings.push_back({"recording_left_out",
                        fmt::format("{}: left out, of force and displacement it has not both; its "
                                    "channels are {}",
                                    recording.source, names_of_channels(recording))});
    return true;
  });
}

}  // namespace

ForceRecord force_record(const Recording& recording, const JointChannels& channels) {
  return record_among(recording, channels, {});
}

ForceRecords read_force_records(const std::vector<std::string>& paths,
                                const JointChannels& channels,
                                const RecordingReadOptions& reading) {
  std::vector<TestFile> files;
  for (const std::string& path : paths) files.push_back(open_test(path));
  return read_force_records(files, channels, reading);
}

ForceRecords read_force_records(const std::vector<TestFile>& files, const JointChannels& channels,
                                const RecordingReadOptions& reading) {
  ForceRecords all;
  std::vector<std::vector<Warning>> warnings;
  RecordingReadOptions untimed = reading;
  untimed.allow_untimed = true;  // dry friction knows no time
  for (const TestFile& file : files) {
    std::vector<Recording> recordings =
        named_recordings(read_recordings(file, untimed), file.path, warnings.emplace_back());
    leave_out_other(recordings, channels, warnings.back());
    for (const Recording& recording : recordings) {
      all.records.push_back({recording.source, record_among(recording, channels, recordings),
                             recording.axis.start, static_cast<double>(warnings.size()),
                             recording.axis.values});
    }
    all.inputs.push_back({file.path, file.sha256});
  }
  all.warnings = joined_warnings(warnings);
  return all;
}

}  // namespace microslip
