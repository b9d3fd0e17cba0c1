// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/decay_signal.hpp"

#include <fmt/format.h>

#include <span>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

bool is_motion(const Recording& recording, const Channel& channel) {
  return recording.axis.dimension == kTime && channel.imaginary.empty() && channel.dimension &&
         (*channel.dimension == kLength || *channel.dimension == kVelocity ||
          *channel.dimension == kAcceleration);
}

/// The channel of that name, or the only motion there is.
DecaySignal choose_signal(const std::vector<Recording>& recordings, const std::string& name,
                          const std::string& file) {
  std::vector<DecaySignal> fits;
  std::string names;
  for (const Recording& recording : recordings) {
    for (const Channel& channel : recording.channels) {
      if (name.empty() ? is_motion(recording, channel) : channel.name == name) {
        fits.push_back({&recording, {channel.name}});
      }
      names += (names.empty() ? "'" : ", '") + channel.name + "'";
    }
  }
  if (fits.size() == 1) return fits.front();
  const std::string what =
      fmt::format("{}: {}", file, name.empty() ? "motion" : "channel " + in_quotes(name));
  const std::string state = fits.empty() ? "missing" : fmt::format("there {} times", fits.size());
  throw InputError(what, InputState{state},
                   name.empty() ? "must have one channel of displacement, velocity or acceleration "
                                  "over time"
                                : "must be given exactly once",
                   fmt::format("The channels are {}; choose by `channel`, and give units that the "
                               "file lacks by `assume_units`.",
                               names.empty() ? "none" : names));
}

}  // namespace

DecaySignal choose_signals(const std::vector<Recording>& recordings,
                           const std::vector<std::string>& names, const std::string& file) {
  if (names.empty()) return choose_signal(recordings, "", file);
  DecaySignal signal = choose_signal(recordings, names.front(), file);
  for (const std::string& name : std::span(names).subspan(1)) {
    const DecaySignal other = choose_signal(recordings, name, file);
    if (other.recording != signal.recording) {
      throw InputError(
          fmt::format("{}: channel {}", file, in_quotes(name)), "of another recording",
          fmt::format("must be recorded with {}: one impact", in_quotes(names.front())));
    }
    signal.channels.push_back(name);
  }
  return signal;
}

}  // namespace microslip
