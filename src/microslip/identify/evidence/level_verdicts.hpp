// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/evidence/stiffness_evidence.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// Verdicts on whether levels are those of one Masing joint: the counterpart of RecordVerdict.

namespace microslip {

// g++ 12 warns that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Departures of levels from a Masing joint under constant normal load.
enum class LevelDeparture {
  kOrder,      ///< D or k_eq of rising levels differs from that of falling ones
  kSecant,     ///< k_eq deviates from that of the joint identified from D
  kFrequency,  ///< the frequency rises, or falls beyond the softening of that joint
};

#pragma GCC diagnostic pop

inline constexpr std::array kLevelDepartures = {LevelDeparture::kOrder, LevelDeparture::kSecant,
                                                LevelDeparture::kFrequency};  ///< all

/// "order_matters", "secant_against_dissipation", "frequency_against_dissipation".
[[nodiscard]] std::string_view to_string(LevelDeparture departure);

/// Verdict on one departure in levels that can show it.
struct LevelDepartureVerdict {
  LevelDeparture departure = LevelDeparture::kOrder;  ///< that was tested
  double share = 0.0;         ///< relative: of D, of k_eq, of the frequency, 1
  double noise = 0.0;         ///< expected of noise alone, 1
  bool broken = false;        ///< whether it was detected
  std::string_view quantity;  ///< where it is largest: "D", "k_eq", "frequency"
};

/// Compares rising with falling levels, where at least four of each lie in the range of both. A
/// level rises or falls by the order of LevelEvidence::measured(), changes below 5 % aside. The
/// excess of D/D̂ − 1 of rising over falling ones, constant and linear in ln A, is a departure
/// where it is more than 3.5 times that expected of scatter, and above 1 % (rms). The same holds
/// for k_eq over k.
/// @param levels          with their errors.
/// @param joint           identified from them, D̂.
/// @param linear_damping  β of it, J/m².
[[nodiscard]] std::optional<LevelDepartureVerdict> judge_order(const LevelEvidence& levels,
                                                               const Joint& joint,
                                                               double linear_damping = 0.0);

/// All verdicts that the levels permit. kSecant and kFrequency are detected where their warnings
/// were given; their numbers are those of the evidence.
/// @param levels          with their errors.
/// @param joint           identified from them.
/// @param linear_damping  β of it, J/m².
/// @param evidence        of the levels against the joint.
/// @param warnings        of the identification.
[[nodiscard]] std::vector<LevelDepartureVerdict> judge_levels(const LevelEvidence& levels,
                                                              const Joint& joint,
                                                              double linear_damping,
                                                              const StiffnessEvidence& evidence,
                                                              const std::vector<Warning>& warnings);

/// The warning `order_matters`, where that departure was detected: the others have warnings of
/// their own.
[[nodiscard]] std::vector<Warning> diagnose(const std::vector<LevelDepartureVerdict>& verdicts);

}  // namespace microslip
