// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/evidence/masing_misfit.hpp"
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
  kSecant,     ///< no Masing joint has this k_eq and this D
  kFrequency,  ///< the frequency rises, falls beyond the softening of any joint, or steps
};

#pragma GCC diagnostic pop

inline constexpr std::array kLevelDepartures = {LevelDeparture::kOrder, LevelDeparture::kSecant,
                                                LevelDeparture::kFrequency};  ///< all

/// "order_matters", "secant_against_dissipation", "frequency_against_dissipation".
[[nodiscard]] std::string_view to_string(LevelDeparture departure);

/// Verdict on one departure in levels that can show it.
struct LevelDepartureVerdict {
  LevelDeparture departure = LevelDeparture::kOrder;  ///< that was tested
  double share = 0.0;                       ///< relative: of D, of k_eq, of the frequency, 1
  double noise = 0.0;                       ///< the most that noise alone gives, 1
  bool broken = false;                      ///< whether it was detected: share > noise
  std::string_view quantity;                ///< where it is largest: "D", "k_eq", "frequency"
  std::optional<MasingMisfit> misfit = {};  ///< behind kSecant, and kFrequency where that steps
};

/// Compares rising with falling levels, where at least four of each lie in the range of both. A
/// level rises or falls by the order of LevelEvidence::measured(), changes below 5 % aside. The
/// excess of D/D̂ − 1 of rising over falling ones, constant and linear in ln A, is a departure
/// where it is more than 3.5 times that expected of scatter, and above 1 % (rms): the larger of
/// these is `noise`. The same holds for k_eq over k.
/// @param levels          with their errors.
/// @param joint           identified from them, D̂.
/// @param linear_damping  β of it, J/m².
[[nodiscard]] std::optional<LevelDepartureVerdict> judge_order(const LevelEvidence& levels,
                                                               const Joint& joint,
                                                               double linear_damping = 0.0);

/// All verdicts that the levels permit: kSecant by secant_misfit(), where noise does not hide every
/// departure; kFrequency by `evidence`, and by frequency_misfit().
/// @param levels          with their errors.
/// @param joint           identified from them.
/// @param linear_damping  β of it, J/m², where D may contain it.
/// @param evidence        of the levels against the joint.
[[nodiscard]] std::vector<LevelDepartureVerdict> judge_levels(const LevelEvidence& levels,
                                                              const Joint& joint,
                                                              std::optional<double> linear_damping,
                                                              const StiffnessEvidence& evidence);

/// Warnings of the verdicts that failed:
///   * `order_matters`        rising and falling levels differ;
///   * `secant_contradicts`   no Masing joint has both D and k_eq;
///   * `frequency_steps`      no Masing joint has both D and the frequencies.
/// A frequency that rises, or falls too far, has warnings of its own.
[[nodiscard]] std::vector<Warning> diagnose(const std::vector<LevelDepartureVerdict>& verdicts);

}  // namespace microslip
