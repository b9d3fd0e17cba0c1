// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/recordings/even_axis.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// How files of others say over what their values are given, and in which units: what the readers
/// of HDF5 and of MAT files have in common.

namespace microslip {

inline constexpr std::array<const char*, 17> kRateNames{"fs",
                                                        "Fs",
                                                        "FS",
                                                        "sampling_rate",
                                                        "sample_rate",
                                                        "Sample_rate",
                                                        "samplingrate",
                                                        "samplerate",
                                                        "samplingRate",
                                                        "sampleRate",
                                                        "SamplingRate",
                                                        "SampleRate",
                                                        "sampling_frequency",
                                                        "sample_frequency",
                                                        "sampling_rate_hz",
                                                        "ActualRate",
                                                        "Time_Sample_Rate"};
inline constexpr std::array<const char*, 5> kStepNames{"dt", "Dt", "sampling_interval", "delta_t",
                                                       "wf_increment"};
inline constexpr std::array<const char*, 4> kStartNames{"t0", "start", "start_time",
                                                        "wf_start_offset"};
inline constexpr std::array<const char*, 3> kTimeNames{"time", "Time", "t"};
inline constexpr std::array<const char*, 5> kFrequencyNames{"frequency", "Frequency", "freq",
                                                            "Freq", "f"};
inline constexpr std::array<const char*, 5> kUnitNames{"unit_str", "unit", "units", "unit_string",
                                                       "NI_UnitDescription"};

template <class Names>
[[nodiscard]] bool is_one_of(std::string_view name, const Names& names) {
  return std::ranges::find(names, name) != names.end();
}

/// Whether values of such a name are the points. A single letter may stand for a force or a torque
/// as well: it does unless the values rise.
[[nodiscard]] bool may_be_points(std::string_view name, std::span<const double> values);

/// Whether values by a name of frequency are the points: beside a rate only where they rise, for
/// the frequencies of a drive over time may fall.
[[nodiscard]] bool may_be_frequencies(std::string_view name, std::span<const double> values,
                                      bool has_rate);

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
  bool rate_used = false;  ///< whether the axis is in PointsInFile::rate
};

/// 1/rate. @throws InputError  naming `place`, where the rate is not above 0 and finite.
[[nodiscard]] double step_of_rate(double rate, const std::string& place);

/// The unit of the points of an axis: as find_unit(), and days; what counts from a date, "seconds
/// since DATE" (CF Conventions 1.10, section 4.4), counts as well. Nothing where it is not known.
[[nodiscard]] std::optional<Unit> find_unit_of_points(std::string_view text);

/// The unit, where it is stated and one of time.
[[nodiscard]] std::optional<Unit> stated_unit_of_time(std::string_view text);

/// Whether points of the usual dimension may have this unit: not where it is of another one.
[[nodiscard]] bool may_be_unit_of_points(std::string_view text, const Dimension& usual);

/// How a file gives the points of an axis.
struct PointsInFile {
  std::vector<double> points;                 ///< as in the file
  std::string unit;                           ///< as in the file; empty: none
  Dimension usual;                            ///< of the points where no unit is named
  std::string place;                          ///< for messages
  std::optional<PrintedDigits> printed = {};  ///< of points that were printed
  std::optional<double> rate = {};            ///< that the user states for a clock that rounds, Hz
};

/// Points that rise in even steps but for rounding become start and step, others stay as they are.
/// Even means: off by at most 1e-6 steps; where all are whole numbers or of single precision, or
/// were printed, by as much as their rounding explains (even_axis.hpp); where the step of times is
/// stated elsewhere, by at most 0.01 of it. Whole numbers that are exactly even keep their step.
/// Of a clock that rounds to whole numbers, the step is that of axis_of_clock().
/// Times without a unit that count from 1970 (counted_unit()) are given from the first on, with a
/// warning; whole ones in long steps cause one as well (doubtful_seconds()).
/// @throws InputError  where find_unit_of_points() does not know the unit, and as axis_of_clock().
[[nodiscard]] PointsAxis axis_of_points(PointsInFile file, std::optional<double> stated_step,
                                        std::vector<Warning>& warnings);

/// A warning where times are even in another step than what the file states by its rate or
/// interval, by more than 0.01 of it: the times are used.
/// @param name  of the times in the file.
[[nodiscard]] std::optional<Warning> contradicting_rate(const PointsAxis& points,
                                                        std::optional<double> stated_step,
                                                        std::string_view name,
                                                        std::string_view place);

/// A warning where points are frequencies and the file states a rate or an interval as well: the
/// frequencies are used.
/// @param name  of the frequencies in the file.
[[nodiscard]] std::optional<Warning> unused_rate(const Axis& axis,
                                                 std::optional<double> stated_step,
                                                 std::string_view name, std::string_view place);

/// Brings values to SI by the unit that the file names. An unknown one is kept as the attribute
/// `unit` and gives a warning unless it is one of another quantity, such as °C or V; so does a
/// doubtful g (doubtful_unit.hpp). An empty one is none.
void apply_unit(Channel& channel, std::string_view unit, const std::string& source,
                std::vector<Warning>& warnings);

/// Adds the channel to the recording of the same axis and length, or to a new one; a name that is
/// taken there gets `place` behind it.
void add_channel(std::vector<Recording>& recordings, const std::string& source, const Axis& axis,
                 Channel channel, std::string_view place);

/// check_recording() for what was read; its errors start with `place`, which names the file.
void check_read(const Recording& recording, const std::string& place);

/// check_read() of all recordings, after channels without a value at some point have been left out,
/// with a warning each, and beside others recordings that have no other channels or that fail.
void check_foreign(Recordings& read, const std::string& place);

/// For WithoutAxis::found: points in a unit that is not known.
[[nodiscard]] std::string points_of_unknown_unit(std::string_view name, std::string_view unit);

/// A place that was left out because nothing tells over what its values are.
struct WithoutAxis {
  std::string place;
  std::string found = {};  ///< "'time' of 499 values for its 500"; empty: nothing
};

/// One warning for each of them.
void warn_without_rate(std::span<const WithoutAxis> places, std::vector<Warning>& warnings);

/// Whether points may be taken to be 1 s apart, as RecordingReadOptions::allow_untimed has it:
/// there are places without axis, and none contradicts a time.
[[nodiscard]] bool may_be_untimed(std::span<const WithoutAxis> places);

/// @throws InputError  where a rate, Hz, is not above 0 and finite.
void check_rate(double rate);

/// The step of points that nothing places, s: by the rate that is stated, else 1.
[[nodiscard]] double untimed_step(const RecordingReadOptions& options);

/// To be called where points took untimed_step(): notes that the rate was used, or warns once that
/// they are 1 s apart.
void note_untimed(const RecordingReadOptions& options, std::string_view place,
                  Recordings& recordings);

/// @param rate  that was stated, Hz.
/// @throws InputError  naming `file`, where no points took it: it has times or a rate of its own.
void require_rate_used(double rate, std::string_view file, const Recordings& recordings);

/// The error where there is nothing else. @param remedy  what to add.
[[nodiscard]] FormatError no_sampling_rate(const WithoutAxis& place, std::string_view remedy);

/// The path without folders.
[[nodiscard]] std::string file_name(const std::string& path);

}  // namespace microslip
