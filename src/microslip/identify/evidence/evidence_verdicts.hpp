// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

/// @file
/// Whether a record, or a table of levels, is of the joint that all evidence together tells of.

namespace microslip {

/// What no joint of the kind does that is sought: sliders that follow Masing's rule under constant
/// load.
enum class RecordDeparture {
  kRate,       ///< the force depends on the velocity
  kAsymmetry,  ///< to one side it is another than to the other
  kDeadZone,   ///< it is missing about zero: backlash, pinching
  kDrift,      ///< it changes over the cycles: wear, temperature, a load that moves
  kOffset,     ///< its zero moves
  kRange,      ///< branches of different ranges do not lie on one curve
  kOther,      ///< it is not that of the joint of the other records: units, gain, another joint
};
inline constexpr std::array kRecordDepartures = {
    RecordDeparture::kRate,  RecordDeparture::kAsymmetry, RecordDeparture::kDeadZone,
    RecordDeparture::kDrift, RecordDeparture::kOffset,    RecordDeparture::kRange,
    RecordDeparture::kOther};  ///< all; the last is looked for in several records

/// The code of a departure, as of its warning: "rate_dependent".
[[nodiscard]] std::string_view to_string(RecordDeparture departure);

/// What was found of a departure in a record.
struct RecordVerdict {
  RecordDeparture departure = RecordDeparture::kRate;  ///< that was looked for
  double share = 0.0;   ///< of the force, rms, that it explains beside the joint, 1
  double noise = 0.0;   ///< that it would of noise alone, 1
  bool broken = false;  ///< whether it is there
};

/// What was found of levels against the joint of the records, or without any of all other tables.
struct LevelVerdict {
  double share = 0.0;   ///< rms relative difference of D or k_eq, weighted by 1/variance, 1
  double noise = 0.0;   ///< that errors of both would make, 1
  bool broken = false;  ///< whether they are of another joint
};

}  // namespace microslip
