// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace microslip {

/// Measured levels: one entry per level of vibration. The vectors `amplitude` and `dissipation` are
/// of one length; each of the others is of that length or empty (not measured).
struct Levels {
  std::vector<double> amplitude = {};             ///< A, amplitude of the joint displacement, m
  std::vector<double> dissipation = {};           ///< D, energy lost per cycle, J
  std::vector<double> amplitude_std = {};         ///< standard deviation of A, m
  std::vector<double> dissipation_std = {};       ///< standard deviation of D, J
  std::vector<double> secant_stiffness = {};      ///< k_eq of the first harmonic, N/m
  std::vector<double> secant_stiffness_std = {};  ///< standard deviation of k_eq, N/m
  /// W_lin, linear loss per cycle that was subtracted from the input energy to get D, J; it is used
  /// by BandOptions::loss_factor_std only.
  std::vector<double> linear_dissipation = {};
  /// Frequency of the resonance at the level, Hz, or of a drive that was kept there. No method fits
  /// it: a joint is compared with it, see stiffness_evidence().
  std::vector<double> frequency = {};
  std::vector<double> frequency_std = {};  ///< its standard deviation, Hz

  /// The number of levels.
  [[nodiscard]] std::size_t size() const { return amplitude.size(); }
};

/// Checks the requirements of every method: lengths agree, A > 0, all finite, D ≥ 0, k_eq > 0,
/// W_lin ≥ 0, f > 0, standard deviations ≥ 0. Order and repetition are free.
/// @throws InputError  naming the level (1-based) and the value.
void check_levels(const Levels& levels);

/// The levels by rising amplitude; levels of equal amplitude become one: the mean of D, k_eq and
/// f weighted by 1/σ² where σ is given (equally otherwise), with its standard deviation; that of
/// W_lin.
struct MergedLevels {
  Levels levels;                   ///< sorted, no two of one amplitude
  std::vector<std::size_t> count;  ///< how many levels became this one
  /// Σ(D_i − D)² of the levels that became this one about their mean D, J²: 0 where it was one.
  std::vector<double> dissipation_spread;

  /// Standard deviation of repeated levels about their mean over it, 1, from all of them together;
  /// nothing where no level was repeated.
  [[nodiscard]] std::optional<double> repeat_scatter() const;
};
/// See MergedLevels. @throws InputError  as check_levels().
[[nodiscard]] MergedLevels sort_and_merge(const Levels& levels);

}  // namespace microslip
