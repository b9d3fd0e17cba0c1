// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/io/loggers/tdms_contents.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Over what the channels of a group of a TDMS file are. Internal to io/loggers.

namespace microslip {

/// What a channel states of its axis.
struct WaveformAxis {
  std::optional<Axis> axis = {};  ///< nothing where it states no increment
  std::string fault = {};         ///< in words, why it cannot be had; empty where it can
};

/// The axis by `wf_increment` and `wf_start_offset` in the unit `wf_xunit_string`, s where there is
/// none, and `wf_start_time`. A fault: a unit that is not known, or of neither time nor frequency.
/// @param earliest  time at which an axis of time is 0; nothing: no channel states one.
[[nodiscard]] WaveformAxis waveform_axis(const TdmsProperties& properties,
                                         const std::optional<TdmsTime>& earliest);

/// A channel with its values in its unit.
struct LoggedChannel {
  const TdmsObject* object;
  Channel channel;
  std::optional<Axis> axis = {};
};

/// Channels that are not sampled together with the longest one.
struct ApartChannels {
  std::vector<std::string> names;
  std::string reason;  ///< in words
};

struct Alignment {
  bool is_cut = false;
  std::vector<ApartChannels> apart;
};

/// Gives channels that are sampled together the same axis, and cuts them to the time that all of
/// them have. Together are those whose steps differ by at most 1e-9, or by so little that the
/// longest channel ends less than 0.01 steps apart; that begin whole steps apart, to 0.01 of a step
/// or 2 µs, but at most 0.25 of a step; and that have 0.9 of the points of the longest in common.
/// Of the others those that are together are aligned likewise.
[[nodiscard]] Alignment align_channels(std::vector<LoggedChannel>& channels);

/// Values that follow each other by one increment.
struct TdmsSteps {
  std::size_t count;
  double increment;  ///< as stated
};

/// The values of a channel that states wf_increment, by increments. Those that differ by rounding
/// are one, and one that no values follow is none.
[[nodiscard]] std::vector<TdmsSteps> steps_of(const TdmsObject& object, std::size_t count);

/// The points of values by steps_of(), even where these are one.
/// @param last  even, by the increment that was stated last.
[[nodiscard]] Axis axis_of_steps(const Axis& last, const TdmsObject& object,
                                 const std::vector<TdmsSteps>& steps);

}  // namespace microslip
