// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// How files of others say over what their values are given, and in which units: what the readers
/// of HDF5 and of MAT files have in common.

namespace microslip {

inline constexpr std::array<const char*, 6> kRateNames{
    "fs", "Fs", "FS", "sampling_rate", "sample_rate", "sampling_frequency"};
inline constexpr std::array<const char*, 4> kStepNames{"dt", "Dt", "sampling_interval", "delta_t"};
inline constexpr std::array<const char*, 3> kStartNames{"t0", "start", "start_time"};
inline constexpr std::array<const char*, 3> kTimeNames{"time", "Time", "t"};
inline constexpr std::array<const char*, 4> kFrequencyNames{"frequency", "Frequency", "freq", "f"};
inline constexpr std::array<const char*, 3> kUnitNames{"unit_str", "unit", "units"};

template <class Names>
[[nodiscard]] bool is_one_of(std::string_view name, const Names& names) {
  return std::ranges::find(names, name) != names.end();
}

/// Whether values of such a name are the points. A single letter may stand for a force or a torque
/// as well: it does unless the values rise.
[[nodiscard]] bool may_be_points(std::string_view name, std::span<const double> values);

/// Axis as known before the values are read.
struct Sampling {
  std::optional<double> step;  ///< s
  double start = 0.0;          ///< s
};

/// Of a sampling whose step is known.
[[nodiscard]] Axis even_axis(const Sampling& sampling);

/// An axis that a file gives point by point.
struct PointsAxis {
  Axis axis;
  std::size_t points = 0;
};

/// 1/rate. @throws InputError  naming `place`, where the rate is not above 0 and finite.
[[nodiscard]] double step_of_rate(double rate, const std::string& place);

/// Points that rise in even steps but for rounding become start and step, others stay as they are.
/// Even means: off by at most 1e-6 steps; where the step is stated elsewhere, by at most 0.01 of
/// it, as points in single precision are.
[[nodiscard]] PointsAxis axis_of_points(std::vector<double> points, const Dimension& dimension,
                                        std::optional<double> stated_step);

/// Brings values to SI by the unit that the file names. An unknown one is kept as the attribute
/// `unit` and gives a warning, as does a doubtful g (doubtful_unit.hpp); an empty one is none.
void apply_unit(Channel& channel, std::string_view unit, const std::string& source,
                std::vector<Warning>& warnings);

/// The same for the points of an axis; `usual` where no unit is named.
[[nodiscard]] Dimension apply_axis_unit(std::vector<double>& points, std::string_view unit,
                                        const Dimension& usual, const std::string& place);

/// Adds the channel to the recording of the same axis and length, or to a new one; a name that is
/// taken there gets `place` behind it.
void add_channel(std::vector<Recording>& recordings, const std::string& source, const Axis& axis,
                 Channel channel, std::string_view place);

/// check_recording() for what was read; its errors start with `place`, which names the file.
void check_read(const Recording& recording, const std::string& place);

/// One warning for each place that was left out because nothing tells over what its values are.
void warn_without_rate(std::span<const std::string> places, std::vector<Warning>& warnings);

/// The path without folders.
[[nodiscard]] std::string file_name(const std::string& path);

}  // namespace microslip
