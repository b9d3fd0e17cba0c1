// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "microslip/base/percent.hpp"
#include "microslip/identify/diagnostics.hpp"

namespace microslip {
namespace {

/// What a departure is called, is, and calls for.
struct DepartureText {
  std::string_view code;
  std::string_view what;
  std::string_view remedy;
};

DepartureText text_of(RecordDeparture departure) {
  switch (departure) {
    case RecordDeparture::kRate:
      return {"rate_dependent", "follows the velocity",
              "`viscous fit` finds a viscous part beside the friction; a slower test shows less "
              "of it."};
    case RecordDeparture::kAsymmetry:
      return {"asymmetric", "is other to one side than to the other",
              "Look for a contact that opens, or a load that is not central; no symmetric joint "
              "has such loops."};
    case RecordDeparture::kDeadZone:
      return {"dead_zone", "is missing about zero: backlash or pinching",
              "Take up the play, or measure the displacement behind it."};
    case RecordDeparture::kDrift:
      return {"drifts", "grows or falls over the record: wear, temperature or a load that moves",
              "Identify its parts by themselves, or run the joint in first."};
    case RecordDeparture::kOffset:
      return {"offset_drifts", "has a zero that moves",
              "Balance the force sensor, or take a shorter part of the record."};
    case RecordDeparture::kOther:
      return {"records_contradict", "is not that of the joint of the other records",
              "Compare units, gains and channels of the files, or identify from each by itself."};
    case RecordDeparture::kRange:
      break;
  }
  return {"not_masing", "has branches of different ranges that do not lie on one curve",
          "Identify from motions of one size by themselves."};
}

Warning contradiction(const std::string& name, std::string_view what, const LevelVerdict& verdict) {
  return {what == "D" ? "levels_contradict" : "secant_differs",
          fmt::format("{}: its {} is off that of the joint of the other files by {}, where noise "
                      "would make {}: another joint, load or gain. Identify from each by itself.",
                      name, what, percent_text(verdict.share), percent_text(verdict.noise))};
}

}  // namespace

std::string_view to_string(RecordDeparture departure) { return text_of(departure).code; }

std::vector<Warning> diagnose(const RecordInversionResult& result, const JointEvidence& evidence) {
  std::vector<Warning> warnings;
  for (std::size_t r = 0; r < result.records.size(); ++r) {
    for (const RecordVerdict& verdict : result.records[r].verdicts) {
      if (!verdict.broken) continue;
      const DepartureText text = text_of(verdict.departure);
      const std::string which =
          result.records.size() > 1 ? evidence.name_of_record(r) + ": " : std::string();
      warnings.push_back(
          {std::string(text.code),
           fmt::format("{}not a joint of this kind: {} of the force {}, where noise would make "
                       "{}. {}",
                       which, percent_text(verdict.share), text.what, percent_text(verdict.noise),
                       text.remedy)});
    }
  }
  for (std::size_t t = 0; t < result.levels.size(); ++t) {
    const LevelFit& fit = result.levels[t];
    const std::string name = evidence.name_of_levels(t);
    if (fit.dissipation_verdict && fit.dissipation_verdict->broken) {
      warnings.push_back(contradiction(name, "D", *fit.dissipation_verdict));
    }
    if (fit.secant_verdict && fit.secant_verdict->broken) {
      warnings.push_back(contradiction(name, "k_eq", *fit.secant_verdict));
    }
  }
  return warnings;
}

}  // namespace microslip
