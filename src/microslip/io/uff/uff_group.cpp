// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_group.hpp"

#include <utility>

#include "microslip/io/recordings/doubtful_unit.hpp"

namespace microslip {

void UffGroup::add(UffChannel channel) {
  if (channels.empty()) axis = std::move(channel.axis);
  channels.push_back(std::move(channel));
}

Recording recording_of(UffGroup group, const std::string& source, std::vector<Warning>& warnings) {
  Recording recording{
      .source = source, .axis = std::move(group.axis), .channels = {}, .attributes = {}};
  std::vector<bool> doubtful;
  for (const UffChannel& channel : group.channels) doubtful.push_back(channel.doubtful);
  recording.channels = uff_channels(recording.axis.dimension, std::move(group.channels));
  for (std::size_t i = 0; i < doubtful.size(); ++i) {
    const Channel& channel = recording.channels[i];
    if (!doubtful[i]) continue;
    warnings.push_back(doubtful_gravity(source, channel.name, channel.values));
  }
  return recording;
}

}  // namespace microslip
