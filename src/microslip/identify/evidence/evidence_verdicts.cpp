// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/evidence_verdicts.hpp"

namespace microslip {

std::string_view to_string(RecordDeparture departure) {
  switch (departure) {
    case RecordDeparture::kRate:
      return "rate_dependent";
    case RecordDeparture::kAsymmetry:
      return "asymmetric";
    case RecordDeparture::kDeadZone:
      return "dead_zone";
    case RecordDeparture::kDrift:
      return "drifts";
    case RecordDeparture::kOffset:
      return "offset_drifts";
    case RecordDeparture::kDisplacementDrift:
      return "displacement_drifts";
    case RecordDeparture::kOther:
      return "records_contradict";
    case RecordDeparture::kRange:
      break;
  }
  return "not_masing";
}

}  // namespace microslip
