// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

/// @file
/// Verdicts on whether a record, or a table of levels, is of the joint that all evidence together
/// determines.

namespace microslip {

/// Departures of a record from a Masing joint under constant normal load.
enum class RecordDeparture {
  kRate,               ///< the force depends on the velocity
  kAsymmetry,          ///< it differs between the two directions
  kDeadZone,           ///< it is missing about zero, or a contact closes: backlash, bearing
  kDrift,              ///< it changes over the cycles: wear, temperature, a changing load
  kOffset,             ///< its zero drifts
  kDisplacementDrift,  ///< the zero of the displacement drifts
  kRange,              ///< branches do not follow one curve: other loops than Masing has
  kOther,  ///< it deviates from the joint of the other records: units, gain, another joint
};
inline constexpr std::array
    kRecordDepartures =
        {
            RecordDeparture::kRate,
            RecordDeparture::kAsymmetry,
            RecordDeparture::kDeadZone,
            RecordDeparture::kDrift,
            RecordDeparture::kOffset,
            RecordDeparture::kDisplacementDrift,
            RecordDeparture::kRange,
            RecordDeparture::kOther};  ///< all; the last is tested with several records only

/// The code of a departure, as of its warning: "rate_dependent".
[[nodiscard]] std::string_view to_string(RecordDeparture departure);

/// Verdict on one departure in a record.
struct RecordVerdict {
  RecordDeparture departure = RecordDeparture::kRate;  ///< that was tested
  double share = 0.0;   ///< of the force, rms, that it explains in addition to the joint, 1
  double noise = 0.0;   ///< that it would explain of noise alone, 1
  bool broken = false;  ///< whether it was detected
  /// It explains the record nearly as well as the first one does, in place of it, not beside it.
  bool alternative = false;
};

/// Verdict on levels against the joint of the records, or of all other tables where there are no
/// records.
struct LevelVerdict {
  double share = 0.0;   ///< rms relative difference of D or k_eq, weighted by 1/variance, 1
  double noise = 0.0;   ///< expected from the errors of both, 1
  bool broken = false;  ///< whether they are of another joint
};

}  // namespace microslip
