// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "microslip/observe/level_evidence.hpp"

/// @file
/// Whether there is any Masing joint at all that levels can be of. Of its density nothing is
/// assumed but φ ≥ 0, and nothing of k: the joint is
///
///     D(A) = 4 Σ_j ψ_j x_j (A − x_j)₊,   k_eq(A) = K_e + Σ_j ψ_j g(x_j/A),   ψ_j ≥ 0, K_e ≥ 0,
///
/// with sliders at every level and between and below them. Frequencies are those of a mode of which
/// the joint provides any share: f² = a + b k_eq with any a, b ≥ 0, which steps with k_eq alone.

namespace microslip {

// g++ 12 warns that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// What makes levels deviate from every Masing joint.
enum class LevelCause {
  kUnknown,        ///< none of the others explains most of it
  kStep,           ///< the normal load differs from a level on
  kTrend,          ///< the normal load changes with the level
  kOrder,          ///< the normal load changes with the order of measurement
  kLinearDamping,  ///< D contains a loss βA²
  kLossFactor,     ///< D is a multiple of what k_eq requires
};

#pragma GCC diagnostic pop

/// The misfit of the best Masing joint.
struct MasingMisfit {
  double share = 0.0;                       ///< misfit as a share of k_eq or f, rms, 1
  double noise = 0.0;                       ///< the most that noise gives, 1
  LevelCause cause = LevelCause::kUnknown;  ///< that explains it best
  /// Of the cause: the change of the load from the first to the last level, relative; the part
  /// of D at the largest level; D over that of k_eq.
  double size = 0.0;
  double at = 0.0;  ///< A of the first level after a step, m; otherwise where the misfit is largest

  /// Whether the levels are of no Masing joint.
  [[nodiscard]] bool failed() const { return share > noise; }
};

/// Of D with k_eq. With weights 1/σ², and χ² of the best joint with and without a cause,
///
///     F = (χ²₀ − χ²₁)/s²,   s² = (χ²₁ + ν₀)/(ν₁ + ν₀),
///
/// fails above 10 for a cause that has a size of its own. The same with D and k_eq each fitted by
/// a joint of its own, of m more sliders, fails above 15 + 3m where deviations are given, and 30 +
/// 8m otherwise. Where the deviations are given s² is 1 at least; otherwise σ of D and of k_eq are
/// those of the residual of the best cause, ν₀ as of few levels, within limits by the scatter of
/// ln D and k_eq about smooth curves. An error common to all levels that is given is fitted with
/// its deviation.
/// @param levels          four or more.
/// @param stiffness       k, N/m, for units alone.
/// @param linear_damping  whether D may contain βA².
/// @return  nothing without k_eq, or with fewer levels.
[[nodiscard]] std::optional<MasingMisfit> secant_misfit(const LevelEvidence& levels,
                                                        double stiffness, bool linear_damping);

/// The same of D with frequencies, for a load that differs from a level on, or changes with the
/// order of measurement; the deviation of f counts as 2e-5 of it at least. Other causes cannot be
/// seen: the share of the joint in the mode is free and may change with k_eq, and D may be any
/// multiple.
[[nodiscard]] std::optional<MasingMisfit> frequency_misfit(const LevelEvidence& levels,
                                                           double stiffness, bool linear_damping);

/// Cause and size as the end of a sentence: "as if the normal load were 18 % lower from 21 µm on".
[[nodiscard]] std::string cause_text(const MasingMisfit& misfit, std::string_view quantity);

}  // namespace microslip
