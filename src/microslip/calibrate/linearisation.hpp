// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/calibrate/calibration_options.hpp"
#include "microslip/calibrate/joint_unknowns.hpp"
#include "microslip/calibrate/level_sensitivity.hpp"
#include "microslip/calibrate/level_states.hpp"
#include "microslip/calibrate/linear_evidence.hpp"
#include "microslip/calibrate/mode_unknowns.hpp"
#include "microslip/observe/modal_levels.hpp"

/// @file
/// Levels linearised about the current joints. Internal to calibrate.

namespace microslip {

/// Smallest admissible relative scatter of a frequency: the harmonics and the basis of the density
/// follow a resonance no further.
inline constexpr double kLeastFrequencyScatter = 1e-5;

/// The unknowns of all joints that are sought, one after the other, and last those of the modes.
class AllUnknowns {
 public:
  /// @param which   their indices among the joints of the structure.
  /// @param joints  the unknowns of each.
  /// @param modes   the offsets of the modes; none where these are exact.
  AllUnknowns(std::vector<std::size_t> which, std::vector<JointUnknowns> joints,
              ModeUnknowns modes = {});

  [[nodiscard]] std::size_t count() const { return joints_.size(); }
  [[nodiscard]] const JointUnknowns& of(std::size_t j) const { return joints_[j]; }
  [[nodiscard]] std::size_t index(std::size_t j) const { return which_[j]; }  ///< in the structure
  [[nodiscard]] Eigen::Index begin(std::size_t j) const { return begin_[j]; }
  [[nodiscard]] Eigen::Index size() const { return begin_.back() + mode_count(); }
  [[nodiscard]] const ModeUnknowns& modes() const { return modes_; }
  [[nodiscard]] Eigen::Index modes_begin() const { return begin_.back(); }
  [[nodiscard]] Eigen::Index mode_count() const {
    return static_cast<Eigen::Index>(modes_.count());
  }
  /// How many derivatives a row of a level has: by D_j and k_eq,j of each joint, and by each mode.
  [[nodiscard]] Eigen::Index answers() const {
    return static_cast<Eigen::Index>(2 * count()) + mode_count();
  }
  /// Offsets of the modes.
  [[nodiscard]] std::vector<double> offsets(const Eigen::VectorXd& x) const {
    return modes_.offsets(x.tail(mode_count()));
  }

  /// The unknowns with those of one joint replaced.
  [[nodiscard]] AllUnknowns with(std::size_t j, JointUnknowns joint) const;

  /// The coefficients of one joint among those of all.
  [[nodiscard]] Eigen::VectorXd part(std::size_t j, const Eigen::VectorXd& x) const {
    return x.segment(begin_[j], joints_[j].size());
  }

  /// Coefficients of these unknowns for the joints and modes that other unknowns have.
  /// @param before  the others. @param x  their coefficients.
  [[nodiscard]] Eigen::VectorXd projected(const AllUnknowns& before,
                                          const Eigen::VectorXd& x) const;

 private:
  std::vector<std::size_t> which_;
  std::vector<JointUnknowns> joints_;
  ModeUnknowns modes_;
  std::vector<Eigen::Index> begin_;
};

/// Levels, and how they are used.
struct CalibrationEvidence {
  const ModalLevels& levels;
  FrequencyUse frequency;
  bool fit_stiffness;
  bool stuck_shapes;  ///< amplitudes of the joints do not depend on the joints found
  Forcing forcing;
  /// Index in levels.joints of each joint of the structure; kNone without.
  std::vector<std::size_t> column;
  /// Whether standard deviations are known: positive at every level. Otherwise none of them is
  /// used, as the ratio of some to the others is not known.
  bool loss_std_given;
  bool frequency_std_given;

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Amplitude of a joint at a level by its sensor, m; NaN without.
  [[nodiscard]] double measured_amplitude(std::size_t level, std::size_t joint) const;
  /// Whether that is an observation beside others, with a standard deviation: the structure then
  /// has the amplitude of the level.
  [[nodiscard]] bool sensor_observes(std::size_t level, std::size_t joint) const;
  /// Whether it is the amplitude of the level: measured, and no such observation.
  [[nodiscard]] bool sensor_replaces(std::size_t level, std::size_t joint) const;
};

/// Whether the loss of a level has a positive standard deviation, in each column that counts.
[[nodiscard]] bool loss_deviation_known(const CalibrationEvidence& evidence, std::size_t level);

/// Half range of a joint's displacement at a level that its energies are computed from: as
/// measured where a sensor replaces it, else that of the states.
[[nodiscard]] double used_amplitude(const CalibrationEvidence& evidence, const LevelStates& states,
                                    std::size_t level, std::size_t joint);

/// Measured D of all joints at a level: as given, or from ζ minus the loss of the structure in its
/// present vibration. NaN where neither was measured.
struct MeasuredLoss {
  double value;      ///< J
  double deviation;  ///< its standard deviation, J; 0 where it is not known
  /// The loss to which an unknown deviation is relative, J: D, or all of ζ.
  double scattered;
  double by_displacement;  ///< dD/dX where ζ is measured: energies grow with X², N; else 0
};
[[nodiscard]] MeasuredLoss measured_loss(const ModalLevels& levels, std::size_t level,
                                         const SteadyVibration& vibration);

/// ω of a level as measured over that of its vibration, minus 1; NaN where it was not measured.
[[nodiscard]] double frequency_error(const ModalLevels& levels, std::size_t level,
                                     const SteadyVibration& vibration);

/// D of a joint at a level, J, and its derivative by the coefficients, with the dependence of the
/// amplitude on them.
struct LinearLoss {
  double value = 0.0;
  Eigen::RowVectorXd slope;
};
/// The losses of each joint sought, about the joints of the states.
/// @param level  a solved level.
[[nodiscard]] std::vector<LinearLoss> losses_about(const CalibrationEvidence& evidence,
                                                   const AllUnknowns& unknowns,
                                                   const LevelStates& states, std::size_t level);

/// Standard deviations of a level, including the error of its displacement; relative ones,
/// of a scatter of 1, where they are not known. NaN where not measured.
struct LevelDeviations {
  double loss;                 ///< of all joints together, J
  std::vector<double> joints;  ///< of the loss of each joint of the structure, J
  double frequency;            ///< relative, 1
  /// Change of the loss of each joint of the structure by one standard deviation of the
  /// displacement of the response point, J; 0 where that is not known.
  std::vector<double> by_displacement;
};
/// @param level  a solved level.
[[nodiscard]] LevelDeviations deviations_about(const CalibrationEvidence& evidence,
                                               const AllUnknowns& unknowns,
                                               const LevelStates& states, std::size_t level);

/// A row of a level before weighting, linear in the loss D_j and the stiffness k_eq,j of the joints
/// sought at their amplitudes there, and in the offsets of the modes.
struct LevelRow {
  Eigen::RowVectorXd by;   ///< derivatives by D_1, k_eq,1, D_2, k_eq,2 …, ε_1, ε_2 …
  double data = 0.0;       ///< measured value
  double size = 0.0;       ///< measured loss, J
  double deviation = 1.0;  ///< standard deviation
  /// Change of measured minus fitted value by one standard deviation of the displacement
  double by_displacement = 0.0;
  std::size_t level = 0;
  std::size_t joint = kAllJoints;  ///< whose loss it is
  std::size_t place = 0;           ///< of the level among LinearisedLevels::amplitude

  static constexpr std::size_t kAllJoints = static_cast<std::size_t>(-1);
};

/// Solved levels, linearised about the joints of the states, for any coefficients of the densities.
struct LinearisedLevels {
  std::vector<LevelRow> losses;
  std::vector<LevelRow> frequencies;
  std::vector<LevelRow> sensors;               ///< displacements of joints that sensors observe
  std::vector<std::vector<double>> amplitude;  ///< [solved level][joint that is sought], m
};

/// Rows of solved levels. A loss or a frequency of unknown deviation is weighted by itself: the
/// scatter found is then relative. All rows of a level share the error of its displacement, which
/// counts once: each is what the rows before it leave of it. Repeated levels, of one mode at one
/// displacement, count as their mean would: they share that error, too.
/// @param x  the coefficients of the joints of the states.
[[nodiscard]] LinearisedLevels linearise(const CalibrationEvidence& evidence,
                                         const AllUnknowns& unknowns, const LevelStates& states,
                                         const std::vector<std::size_t>& which,
                                         const Eigen::VectorXd& x);

/// The linearised levels in the coefficients of any unknowns of these joints, with their priors.
[[nodiscard]] LinearEvidence in_terms_of(const CalibrationEvidence& evidence,
                                         const AllUnknowns& unknowns,
                                         const LinearisedLevels& levels);

}  // namespace microslip
