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
/// Whether levels are those of one joint of the kind that is sought: the counterpart of
/// RecordVerdict.

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// What no such joint does over its levels.
enum class LevelDeparture {
  kOrder,      ///< D or k_eq of rising levels is another than of falling ones
  kSecant,     ///< k_eq is not that of the joint that D tells of
  kFrequency,  ///< the frequency rises, or falls beyond the softening of that joint
};

#pragma GCC diagnostic pop

inline constexpr std::array kLevelDepartures = {LevelDeparture::kOrder, LevelDeparture::kSecant,
                                                LevelDeparture::kFrequency};  ///< all

/// "order_matters", "secant_against_dissipation", "frequency_against_dissipation".
[[nodiscard]] std::string_view to_string(LevelDeparture departure);

/// What was found of a departure in levels that can show it.
struct LevelDepartureVerdict {
  LevelDeparture departure = LevelDeparture::kOrder;  ///< that was looked for
  double share = 0.0;         ///< relative: of D, of k_eq, of the frequency, 1
  double noise = 0.0;         ///< what of it noise would make, 1
  bool broken = false;        ///< whether it is there
  std::string_view quantity;  ///< in which it is largest: "D", "k_eq", "frequency"
};

/// Rising against falling levels, where at least four of each lie where both were measured. A level
/// rises or falls by the order of LevelEvidence::measured(), changes below 5 % aside. What D/D̂ − 1
/// of rising ones has more than of falling ones, constant and linear in ln A, is a departure where
/// it is more than 3.5 times what scatter makes of it, and above 1 % (rms). The same of k_eq over
/// k.
/// @param levels          with their errors.
/// @param joint           identified from them, D̂.
/// @param linear_damping  β of it, J/m².
[[nodiscard]] std::optional<LevelDepartureVerdict> judge_order(const LevelEvidence& levels,
                                                               const Joint& joint,
                                                               double linear_damping = 0.0);

/// All of them, of those that the levels can show. kSecant and kFrequency are there where the
/// warnings say so that stand for them; their numbers are those of the evidence.
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

/// `order_matters`, where that is broken: the others have warnings of their own.
[[nodiscard]] std::vector<Warning> diagnose(const std::vector<LevelDepartureVerdict>& verdicts);

}  // namespace microslip
