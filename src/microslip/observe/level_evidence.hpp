// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/common_errors.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip {

/// Values at the levels of an evidence, by rising amplitude.
struct LevelRows {
  std::vector<double> dissipation = {};       ///< one a level
  std::vector<double> secant_stiffness = {};  ///< one a level; empty where k_eq was not measured
};

/// What something says of the levels.
struct LevelPrediction {
  LevelRows value = {};  ///< D, J, and k_eq, N/m
  /// What one standard deviation of the amplitude makes of them, J and N/m. An empty column: none.
  LevelRows change = {};
};

/// How much the levels scatter: times the standard deviations where they were given.
struct LevelScatter {
  double dissipation = 1.0;       ///< else as a share of D, 1
  double secant_stiffness = 1.0;  ///< else itself, N/m: the level of k_eq says nothing of its noise
};

/// Levels with the errors that they have: the one place that says how much a level may be off.
/// Whoever weights levels, judges a residual, or draws the levels of a repeated test asks here.
///
/// Standard deviations of a level i where a joint, or a fit, predicts D_i and k_i:
///
///     σ_D,i = s_D √(dissipation_std_i² + change_D,i²)   where given and positive at all levels,
///     σ_D,i = s_D D_i/√n_i                              otherwise,
///
/// n_i levels merged into one, change_D,i what amplitude_std makes of D (effective variance; Orear,
/// Am. J. Phys. 50 (1982) 912), s_D the scatter, which whoever fits may estimate. k_eq likewise,
/// but with σ_k,i = s_k/√n_i where it is not known.
/// The share is one of the prediction, not of the measured D: a level that is far too low by
/// scatter, or zero, would get the largest weight of all. For the same reason a level whose D is
/// below dissipation_floor() counts with no smaller σ than one at the floor.
class LevelEvidence {
 public:
  /// What k_eq scatters by at least where nobody says it, over k, 1: a smooth column is no proof of
  /// an exact one, and would outweigh all of D.
  static constexpr double kLeastSecantScatter = 1e-3;

  /// @param measured  in any order; equal amplitudes are merged, see sort_and_merge().
  /// @param common    errors that all of them share.
  /// @throws InputError  as check_levels() and CommonErrors::check(), and where loss_factor_std
  ///                     lacks linear_dissipation.
  LevelEvidence(Levels measured, CommonErrors common = {});

  [[nodiscard]] const Levels& measured() const { return measured_; }     ///< as given
  [[nodiscard]] const Levels& levels() const { return merged_.levels; }  ///< sorted, merged
  [[nodiscard]] const MergedLevels& merged() const { return merged_; }   ///< with their numbers
  [[nodiscard]] const CommonErrors& common_errors() const { return common_; }  ///< of all levels
  [[nodiscard]] std::size_t size() const { return levels().size(); }           ///< after merging

  /// Whether standard deviations are known: given, and positive at every level.
  [[nodiscard]] bool dissipation_std_given() const;
  [[nodiscard]] bool secant_std_given() const;  ///< those of k_eq
  /// Whether amplitude_std says something: an estimated scatter holds it already.
  [[nodiscard]] bool amplitude_std_counts() const;

  /// D below this share of D ∝ A³ through the largest level counts as zero, J.
  [[nodiscard]] const std::vector<double>& dissipation_floor() const { return floor_; }

  /// D smoothed without a model: the median of D/A³ over five neighbouring levels, times A³; k_eq
  /// as measured. Changes as of D ∝ A³. What a first fit is weighted by.
  [[nodiscard]] LevelPrediction typical() const;

  /// What a joint says of the levels.
  /// @param joint           whose D and k_eq it is.
  /// @param linear_damping  β of βA² that adds to D, J/m².
  [[nodiscard]] LevelRows predict(const Joint& joint, double linear_damping = 0.0) const;

  /// What ± σ_A makes of that, ½|D(A + σ_A) − D(A − σ_A)|: unlike the slope it is continuous where
  /// an atom slips. Empty where amplitude_std does not count.
  /// @param joint           as for predict().
  /// @param linear_damping  β of βA², J/m².
  [[nodiscard]] LevelRows amplitude_change(const Joint& joint, double linear_damping = 0.0) const;

  /// The scatter before anything is fitted: 1 where standard deviations were given; otherwise that
  /// of ln D and of k_eq about their neighbours, see scatter_about_neighbours().
  /// @param stiffness  k, N/m, of which k_eq scatters by kLeastSecantScatter at least.
  [[nodiscard]] LevelScatter expected_scatter(double stiffness) const;

  /// σ_D,i and σ_k,i as above, J and N/m.
  /// @param prediction  what they are by.
  /// @param scatter     s_D and s_k.
  [[nodiscard]] LevelRows deviations(const LevelPrediction& prediction,
                                     const LevelScatter& scatter = {}) const;

  /// The same of each level of measured(), in their order: √n times that of their mean.
  [[nodiscard]] LevelRows measured_deviations(const LevelPrediction& prediction,
                                              const LevelScatter& scatter = {}) const;

  /// (measured − predicted)/σ.
  /// @param prediction  D, J, and k_eq, N/m.
  /// @param deviations  σ of deviations().
  [[nodiscard]] LevelRows residuals(const LevelRows& prediction, const LevelRows& deviations) const;

  /// Levels that say something of D: less than size() where some lie below the floor, or far below
  /// the prediction.
  /// @param prediction  by which a level is judged.
  [[nodiscard]] double informative_levels(const LevelPrediction& prediction) const;

  /// What repeated levels differ by: Σ(D − D̄)²/σ² over the levels that became one, and how many
  /// degrees of freedom that is. Residuals see their means alone.
  /// @param deviations  σ of deviations().
  [[nodiscard]] double repeat_sum(const LevelRows& deviations) const;
  [[nodiscard]] double repeat_freedom() const;  ///< measured levels less size()

  /// ln of the normal likelihood of the measured levels, common errors aside.
  /// @param prediction  mean of the levels, and what σ are by.
  /// @param scatter     s_D and s_k.
  [[nodiscard]] double log_likelihood(const LevelPrediction& prediction,
                                      const LevelScatter& scatter = {}) const;

  /// The levels as another test of the same joint would give them: those predicted with the
  /// scatter of each and one draw of the common errors.
  /// @param prediction  mean of the levels, and what σ are by.
  /// @param scatter     s_D and s_k.
  /// @param random      two or three normal numbers a level, and three.
  [[nodiscard]] Levels simulate(const LevelPrediction& prediction, const LevelScatter& scatter,
                                RandomStream& random) const;

 private:
  Levels measured_;
  CommonErrors common_;
  MergedLevels merged_;
  std::vector<double> floor_;
  std::vector<double> dissipation_std_;  // raised at the floor; empty where not given
};

}  // namespace microslip
