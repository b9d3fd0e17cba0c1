// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "microslip/workflow/campaign/campaign_effects.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"

/// @file
/// Differences between the sessions of a campaign.

namespace microslip {

/// With y = ln(f/f̂) of each level, f̂ the natural frequency with the secant stiffness that the
/// joint has at its amplitude, and r = ln(D/D̂), D̂ of joint and linear damping there; where ζ was
/// measured r = ln(ζ/ζ̂), structure included, as what is left of ζ for the joints may be noise.
struct SessionEffects {
  std::vector<SessionEffect> sessions = {};  ///< those with levels, in the order of the campaign
  std::vector<double> frequency = {};        ///< f̂ of each level, Hz; empty without frequencies
  std::vector<double> dissipation = {};      ///< D̂ of each level, J
  std::vector<double> exponent = {};  ///< d ln D̂/d ln A there, 1; 0 where D̂ is. None of a model
  /// ζ/ζ̂ of each level, 1; NaN where D was measured. Empty where ζ never was.
  std::vector<double> damping_over_found = {};
  /// rms of y less the offset of its session, 1: error of the model in the frequencies, including
  /// its nominal frequency; 0 without frequencies. Modes whose offset is fitted but not determined
  /// are not in it.
  double frequency_std = 0.0;
  /// rms as above of each mode that is in it, 1.
  std::map<std::size_t, double> frequency_std_of_modes = {};
  /// Of the offsets but those of the first: √(mean δ²), 1; 0 of one session.
  double between_frequencies = 0.0;
  /// Standard deviation of the means of r of the tests of one session and mode, pooled, 1; nothing
  /// where none has two tests.
  std::optional<double> within_sessions = {};
  /// Standard deviation of the means of r of the sessions, pooled over modes, 1; nothing where no
  /// mode has two sessions.
  std::optional<double> between_sessions = {};

  /// The mode, from 1, in the session of that name; null where it has no levels there.
  [[nodiscard]] const SessionEffect* find(const std::string& name, std::size_t mode = 1) const;
  /// Whether a session has levels.
  [[nodiscard]] bool has(const std::string& name) const;
  /// δ and its σ of a mode in a session, both 1, against the first session with levels. Nothing
  /// where either of the two has no frequency of the mode.
  [[nodiscard]] std::optional<std::pair<double, double>> determined_offset(const std::string& name,
                                                                           std::size_t mode) const;
  /// δ and its σ of modes whose offset is not determined in a session, both 1: the mean of the n
  /// that are with s√(1 + 1/n), s their scatter, or of one or two their rms; where none
  /// is, 0 with the offsets of the other sessions, rms. 0 and 0 where none were fitted.
  [[nodiscard]] std::pair<double, double> offset_of_others(const std::string& name) const;
  /// rms of y of a mode, 1; of one without levels that of all.
  [[nodiscard]] double frequency_std_of(std::size_t mode) const;
  /// determined_offset(), or else offset_of_others().
  [[nodiscard]] std::pair<double, double> offset_of(const std::string& name,
                                                    std::size_t mode) const;
};

/// A test whose frequencies of a mode differ from those of the other tests of its session.
struct TestDifference {
  std::size_t test = 0;     ///< its number in the plan, from 0
  std::size_t mode = 1;     ///< from 1
  double difference = 0.0;  ///< of the means of y, 1
  double sigma = 0.0;       ///< its standard deviation, 1
};

/// Tests that differ by more than three standard deviations, s√(1/n + 1/m) of n and m levels that
/// scatter by s about the mean of their test, and by more than the resolution of frequencies.
/// Levels count where the amplitudes of the test and of the others overlap, two of each at least:
/// beyond, the joint may be in error.
/// @param campaign  of the levels. @param levels  of its tests. @param effects  of the levels.
[[nodiscard]] std::vector<TestDifference> differing_tests(const CampaignFile& campaign,
                                                          const CampaignLevels& levels,
                                                          const SessionEffects& effects);

/// Differences are those of least squares, ȳ_s − ȳ_1 with
/// σ² = s²(1/n_s + 1/n_1), s² = Σ(y − ȳ)²/(n − S) over all S sessions, each mode by itself;
/// they are offsets δ_s where the campaign asks for these.
/// @param campaign  of the levels. @param levels  of its tests.
/// @param state     of the structure; k of the joint is in its modes.
/// @param joint     identified from the levels.
/// @param linear_damping  β that was identified with it, J/m².
/// @throws InputError  where offsets are asked for, and a level has no frequency, a frequency
///     differs from that of the first mode by more than a tenth, or no session has two levels.
[[nodiscard]] SessionEffects session_effects(const CampaignFile& campaign,
                                             const CampaignLevels& levels, const StickState& state,
                                             const Joint& joint, double linear_damping);

/// Effects as above for levels whose f̂ and D̂ are known, of any number of modes.
/// @param campaign  of the levels. @param levels  of its tests.
/// @param found  `frequency` and `dissipation` of each level; NaN where the level was not found.
/// @throws InputError  where offsets are asked for, and no frequency tells them: no mode has levels
///     in two sessions, or no mode two levels in one.
[[nodiscard]] SessionEffects session_effects(const CampaignFile& campaign,
                                             const CampaignLevels& levels, SessionEffects found);

/// r of each level, 1: 0 where nothing was lost, which tells nothing; NaN where D is not known.
[[nodiscard]] std::vector<double> loss_residuals(const CampaignLevels& levels,
                                                 const SessionEffects& effects);

/// δ of the session of each level, 1.
[[nodiscard]] std::vector<double> offsets_of_levels(const SessionEffects& effects,
                                                    const CampaignFile& campaign,
                                                    const CampaignLevels& levels);

}  // namespace microslip
