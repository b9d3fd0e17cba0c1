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
  std::vector<double> dissipation = {};       ///< one per level
  std::vector<double> secant_stiffness = {};  ///< one per level; empty where k_eq was not measured
};

/// A prediction of the levels.
struct LevelPrediction {
  LevelRows value = {};  ///< D, J, and k_eq, N/m
  /// Their change by one standard deviation of the amplitude, J and N/m. An empty column: none.
  LevelRows change = {};
};

/// Scatter of the levels: a multiple of the standard deviations where they were given.
struct LevelScatter {
  double dissipation = 1.0;  ///< else as a share of D, 1
  /// Else absolute, N/m: the level of k_eq does not determine its noise.
  double secant_stiffness = 1.0;
};

/// Levels with their errors: the one place that defines how far a level may deviate. Weights of
/// levels, tests of residuals and draws of a repeated test all use it.
///
/// Standard deviations of a level i where a joint, or a fit, predicts D_i and k_i:
///
///     σ_D,i = s_D √(dissipation_std_i² + change_D,i²)   where given and positive at all levels,
///     σ_D,i = s_D D_i/√n_i                              otherwise,
///
/// n_i levels merged into one, change_D,i the effect of amplitude_std on D (effective variance;
/// Orear, Am. J. Phys. 50 (1982) 912), s_D the scatter, which a fit may estimate. The same holds
/// for k_eq, but with σ_k,i = s_k/√n_i where it is not known. The share is one of the
/// prediction, not of the measured D: a level that is far too low by scatter, or zero, would get
/// the largest weight of all. For the same reason a level whose D is below dissipation_floor()
/// counts with no smaller σ than one at the floor.
class LevelEvidence {
 public:
  /// The least scatter of k_eq where its deviation is not given, over k, 1: a smooth column is not
  /// proof of an exact one, and would outweigh all of D.
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
  /// Whether amplitude_std is used: an estimated scatter already includes it.
  [[nodiscard]] bool amplitude_std_counts() const;

  /// D below this share of D ∝ A³ through the largest level counts as zero, J.
  [[nodiscard]] const std::vector<double>& dissipation_floor() const { return floor_; }

  /// D smoothed without a model: the median of D/A³ over five neighbouring levels, times A³; k_eq
  /// as measured. Changes as of D ∝ A³. A first fit is weighted by it.
  [[nodiscard]] LevelPrediction typical() const;

  /// The levels as a joint predicts them.
  /// @param joint           whose D and k_eq are predicted.
  /// @param linear_damping  β of βA² that adds to D, J/m².
  [[nodiscard]] LevelRows predict(const Joint& joint, double linear_damping = 0.0) const;

  /// The change of that by ± σ_A, ½|D(A + σ_A) − D(A − σ_A)|: unlike the slope it is
  /// continuous where an atom slips. Empty where amplitude_std does not count.
  /// @param joint           as for predict().
  /// @param linear_damping  β of βA², J/m².
  [[nodiscard]] LevelRows amplitude_change(const Joint& joint, double linear_damping = 0.0) const;

  /// The scatter before anything is fitted: 1 where standard deviations were given; otherwise that
  /// of ln D and of k_eq about their neighbours, see scatter_about_neighbours().
  /// @param stiffness  k, N/m, of which k_eq scatters by kLeastSecantScatter at least.
  [[nodiscard]] LevelScatter expected_scatter(double stiffness) const;

  /// σ_D,i and σ_k,i as above, J and N/m.
  /// @param prediction  from which σ is computed.
  /// @param scatter     s_D and s_k.
  [[nodiscard]] LevelRows deviations(const LevelPrediction& prediction,
                                     const LevelScatter& scatter = {}) const;

  /// The deviations of each level of measured(), in their order: √n times that of their mean.
  [[nodiscard]] LevelRows measured_deviations(const LevelPrediction& prediction,
                                              const LevelScatter& scatter = {}) const;

  /// (measured − predicted)/σ.
  /// @param prediction  D, J, and k_eq, N/m.
  /// @param deviations  σ of deviations().
  [[nodiscard]] LevelRows residuals(const LevelRows& prediction, const LevelRows& deviations) const;

  /// The number of levels that carry information on D: less than size() where some lie below the
  /// floor, or far below the prediction.
  /// @param prediction  by which a level is judged.
  [[nodiscard]] double informative_levels(const LevelPrediction& prediction) const;

  /// Scatter of repeated levels: Σ(D − D̄)²/σ² over the levels that became one, and its
  /// degrees of freedom. Residuals contain their means alone.
  /// @param deviations  σ of deviations().
  [[nodiscard]] double repeat_sum(const LevelRows& deviations) const;
  [[nodiscard]] double repeat_freedom() const;  ///< measured levels less size()

  /// ln of the normal likelihood of the measured levels, common errors aside.
  /// @param prediction  mean of the levels, from which σ is computed.
  /// @param scatter     s_D and s_k.
  [[nodiscard]] double log_likelihood(const LevelPrediction& prediction,
                                      const LevelScatter& scatter = {}) const;

  /// The levels as another test of the same joint would give them: those predicted with the
  /// scatter of each and one draw of the common errors.
  /// @param prediction  mean of the levels, from which σ is computed.
  /// @param scatter     s_D and s_k.
  /// @param random      gives two or three normal numbers per level, and three more.
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
