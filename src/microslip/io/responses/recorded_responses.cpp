// SPDX-License-Identifier: MIT
#include "microslip/io/responses/recorded_responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/responses/nodal_function.hpp"
#include "microslip/io/uff/uff_channel.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kOfResponse = 4;  // function type

std::string channel_name(const Recording& recording, const Channel& channel) {
  return fmt::format("{}: channel {}", recording.source, in_quotes(channel.name));
}

FrequencyResponse response_of(const Recording& recording, const Channel& channel,
                              const UffPoint& response, const UffPoint& reference) {
  return frequency_response(
      {.name = channel_name(recording, channel),
       .response = response,
       .reference = reference,
       .axis = recording.axis,
       .dimension = channel.dimension,
       .values = channel.values,
       .imaginary = channel.imaginary,
       .unit_rule = "must have the unit of a motion over a force, for instance m/s^2/N",
       .unit_remedy = "Give it in the file, or by the key unit of a [[test.response]].",
       .point_remedy = "Give channel, node and direction in a [[test.response]]."});
}

/// The recording of a channel; names are unique in each, but not in all.
Recording& recording_with(std::vector<Recording>& recordings, const ResponseChannel& wanted) {
  Recording* found = nullptr;
  for (Recording& recording : recordings) {
    if (std::ranges::find(recording.channels, wanted.name, &Channel::name) ==
        recording.channels.end()) {
      continue;
    }
    if (found != nullptr) {
      throw InputError("channel " + in_quotes(wanted.name),
                       fmt::format("in {} and {}", found->source, recording.source),
                       "must be given exactly once");
    }
    found = &recording;
  }
  if (found != nullptr) return *found;
  (void)recordings.front().channel(wanted.name);  // whose message has the names there are
  return recordings.front();
}

FrequencyResponse listed_response(std::vector<Recording>& recordings,
                                  const ResponseChannel& wanted) {
  Recording& recording = recording_with(recordings, wanted);
  if (wanted.unit) recording.assume_unit(wanted.name, *wanted.unit);
  return response_of(recording, recording.channel(wanted.name), wanted.response, wanted.reference);
}

void add_described_responses(const Recording& recording,
                             std::vector<FrequencyResponse>& responses) {
  const std::vector<Uff58Header> headers = uff58_headers(recording);
  for (std::size_t i = 0; i < headers.size(); ++i) {
    if (headers[i].function_type != kOfResponse) continue;
    responses.push_back(
        response_of(recording, recording.channels[i], headers[i].response, headers[i].reference));
  }
}

}  // namespace

FrequencyResponses read_recorded_responses(const std::string& path,
                                           std::span<const ResponseChannel> channels) {
  Recordings read = read_recordings(path, {});
  FrequencyResponses result;
  result.warnings = std::move(read.warnings);
  for (const ResponseChannel& wanted : channels) {
    if (std::ranges::count(channels, wanted.name, &ResponseChannel::name) > 1) {
      throw InputError("channel " + in_quotes(wanted.name), "in two [[test.response]]",
                       "must be measured at one point");
    }
    result.responses.push_back(listed_response(read.recordings, wanted));
  }
  if (!channels.empty()) return result;
  for (const Recording& recording : read.recordings) {
    add_described_responses(recording, result.responses);
  }
  if (!result.responses.empty()) return result;
  throw FormatError(
      {.file = path},
      "channels with their measurement point, as convert keeps it from a universal file", "none",
      "Give channel, node and direction of each in a [[test.response]].");
}

}  // namespace microslip
