// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/force_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/signal/recording/resampling.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"

namespace microslip {
namespace {

/// The channel of that name, or the only one of that quantity.
std::string channel_of(const Recording& recording, const std::string& name,
                       const Dimension& dimension, std::string_view option) {
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
                  "`assume_units`.",
                  names_of_channels(recording), option));
}

std::vector<double> values_of(const Recording& recording, const std::string& name,
                              const Dimension& dimension) {
  const std::span<const double> values = recording.signal(name, dimension);
  return {values.begin(), values.end()};
}

}  // namespace

ForceRecord force_record(const Recording& recording, const JointChannels& channels) {
  const std::string force = channel_of(recording, channels.force, kForce, "force");
  const std::string displacement =
      channel_of(recording, channels.displacement, kLength, "displacement");
  ForceRecord record;
  record.force = values_of(recording, force, kForce);
  record.displacement = values_of(recording, displacement, kLength);
  if (!recording.axis.even()) throw uneven_times(recording);
  record.time_step = recording.axis.step;
  return record;
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
    for (const Recording& recording :
         named_recordings(read_recordings(file, untimed), file.path, warnings.emplace_back())) {
      all.records.push_back({recording.source, force_record(recording, channels),
                             recording.axis.start, static_cast<double>(warnings.size())});
    }
    all.inputs.push_back({file.path, file.sha256});
  }
  all.warnings = joined_warnings(warnings);
  return all;
}

}  // namespace microslip
