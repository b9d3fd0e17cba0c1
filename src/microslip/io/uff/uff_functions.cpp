// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_functions.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "microslip/io/uff/uff_axis.hpp"
#include "microslip/io/uff/uff_channel.hpp"
#include "microslip/io/uff/uff_group.hpp"

namespace microslip {

Recordings recordings_of_functions(std::vector<Uff58> functions, const std::string& source) {
  Recordings result;
  UffGroup group;
  const auto finish = [&] {
    if (group.channels.empty()) return;
    result.recordings.push_back(recording_of(std::exchange(group, {}), source, result.warnings));
  };
  for (Uff58& function : functions) {
    UffChannel channel = uff_channel(std::move(function), std::nullopt);
    if (!group.takes(channel)) finish();
    group.add(std::move(channel));
  }
  finish();
  for (std::size_t i = 0; i < result.recordings.size(); ++i) {
    if (result.recordings.size() > 1) result.recordings[i].source += fmt::format(" #{}", i + 1);
    check_recording(result.recordings[i]);
  }
  return result;
}

std::vector<Uff58> functions_of_recording(const Recording& recording) {
  check_recording(recording);
  const std::vector<double> x = uff_abscissae(recording);
  std::vector<Uff58Header> headers = uff58_headers(recording);
  std::vector<Uff58> functions;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    const Channel& channel = recording.channels[i];
    set_abscissae(x, headers[i]);
    functions.push_back({std::move(headers[i]), x, channel.values, channel.imaginary});
  }
  return functions;
}

}  // namespace microslip
