// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/io/recordings/whole_times.hpp"

/// @file
/// Contents of TDMS files of LabVIEW [NI, "The NI TDMS File Format", version 2.0]. Internal to
/// io/loggers.
///
/// A file is a row of segments: a lead-in of 28 bytes, the metadata of some objects, and raw
/// values. Objects are the file "/", groups "/'g'" and channels "/'g'/'c'"; what a segment does not
/// state again of an object stays as it was.

namespace microslip {

/// A time stamp: seconds since 1904-01-01 00:00 UTC, and 2^-64 s.
struct TdmsTime {
  std::int64_t seconds = 0;
  std::uint64_t fraction = 0;

  friend bool operator==(const TdmsTime&, const TdmsTime&) = default;
};

/// s from one to the other.
[[nodiscard]] double seconds_between(const TdmsTime& from, const TdmsTime& to);

using TdmsValue = std::variant<double, std::string, TdmsTime>;

struct TdmsProperties {
  std::map<std::string, TdmsValue, std::less<>> all = {};

  /// Null where there is none of this name, or it is of another kind.
  [[nodiscard]] const double* number(std::string_view name) const;
  [[nodiscard]] const std::string* text(std::string_view name) const;
  [[nodiscard]] const TdmsTime* time(std::string_view name) const;
};

/// Whether a wf_increment is there and states a step: 0, which LabVIEW writes where it knows none,
/// does not.
[[nodiscard]] bool states_step(const double* increment);

/// Values of a channel as stored. Those of DAQmx come from several sources, by their number.
struct TdmsSource {
  std::uint32_t scale_id = 0;
  std::vector<double> values;
};

struct TdmsObject {
  enum class Kind { kFile, kGroup, kChannel };

  Kind kind = Kind::kFile;
  std::string group;    ///< also that of a channel; may be empty
  std::string channel;  ///< may be empty
  TdmsProperties properties = {};
  std::vector<TdmsSource> sources = {};
  bool is_daqmx = false;
  std::vector<TdmsTime> times = {};  ///< of a channel of time stamps
  WholeNumbers whole = {};           ///< of a channel called time of integers of eight bytes
  std::string other = {};            ///< in words, of values that are neither numbers nor times
  /// The first property on which the values depend, in words, that a later segment states
  /// otherwise. The last statement counts, but of wf_start_time the first one.
  std::string change = {};
  /// Where a later segment states another wf_increment: the number of values before it, and the
  /// increment of those since the change before.
  std::vector<std::pair<std::size_t, double>> former_steps = {};

  /// How many values there are, stored.
  [[nodiscard]] std::size_t size() const {
    return sources.empty() ? times.size() : sources.front().values.size();
  }
};

struct TdmsContents {
  std::vector<TdmsObject> objects;  ///< in the order of the file
  bool truncated = false;           ///< it ends within a segment, whose last values are left out
  std::uint64_t part_chunks = 0;    ///< bytes left out behind the last whole chunks of segments
};

/// @throws FileError    where it cannot be read.
/// @throws FormatError  where it is damaged, or ends early, or a segment ends within a chunk, and
///                      that is not allowed.
/// @throws Cancelled    where the progress callback says so.
[[nodiscard]] TdmsContents read_tdms(const std::string& path, bool allow_truncated,
                                     const Progress& progress);

}  // namespace microslip
