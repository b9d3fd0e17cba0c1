// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/dynamics/jointed_structure.hpp"
#include "microslip/rig/point_sensor.hpp"
#include "microslip/rig/record_batch.hpp"
#include "microslip/rig/reduction.hpp"
#include "microslip/signal/fourier_fit.hpp"
#include "microslip/signal/recording.hpp"

/// @file
/// From steady records of a structure with several joints to levels of its modes.

namespace microslip {

/// The flag of a level in which not all joints are seen.
inline constexpr std::string_view kJointNotSeen = "joint_not_seen";

/// A structure whose joints are to be observed, and what was measured on it.
struct StructureTest {
  /// With one excitation, whose harmonics do not matter: the force is measured. Of the joints only
  /// stiffness and place are used.
  JointedStructure structure;
  std::string response;  ///< the point whose displacement is told
  /// The channel of the force; empty: the only one of a force in each record.
  std::string force_channel;
  std::vector<PointSensor> accelerometers;  ///< one at least
};

/// What one record tells of one joint.
struct JointLevel {
  Measured amplitude;         ///< A, half of its displacement peak to peak, m
  Measured dissipation;       ///< D = ∮ F du, J
  Measured secant_stiffness;  ///< k_eq of its loop, N/m: see Reducer
  std::size_t reversals = 2;  ///< of its displacement in a cycle
  /// Share of its force that the accelerometers do not show, 0 to 1: 1 where the joint is taken to
  /// stick for want of a sensor.
  double unseen = 0.0;
};

/// What one record tells: one row of modal_levels.csv.
struct ModalLevel {
  std::string source = {};          ///< of the record
  std::size_t mode = 1;             ///< by the frequency of the structure with stuck joints, from 1
  Measured displacement = {};       ///< first harmonic at the response point, m
  Measured frequency = {};          ///< of phase resonance at this amplitude, Hz
  double drive_frequency = 0.0;     ///< of the cycle, as fitted, Hz
  double force_amplitude = 0.0;     ///< |F_1|, N
  Measured dissipation = {};        ///< W_ext − W_lin, of all joints together, J
  double input_energy = 0.0;        ///< W_ext, J
  double linear_dissipation = 0.0;  ///< W_lin, J
  Measured energy_difference = {};  ///< Σ D_j − (W_ext − W_lin), J: 0 within noise
  double force_distortion = 0.0;    ///< as in ReducedLevel
  double misfit = 0.0;  ///< the worst of the accelerometers against the model's motion, 1
  double cycles = 0.0;  ///< in the record
  std::vector<JointLevel> joints = {};  ///< in the order of the structure
  std::vector<Warning> flags = {};      ///< what is to be looked at, each once

  /// Whether one of the flags has this code.
  [[nodiscard]] bool has_flag(std::string_view code) const;
};

/// How ModalReducer reduces, and what it flags.
struct ModalReductionOptions {
  /// As in ReductionOptions.
  FourierFitOptions fit = {.seek_longer_period = false};
  /// From 1; nothing: the mode with the stuck frequency nearest to that of the record.
  std::optional<std::size_t> mode = {};
  double most_distortion = 0.01;  ///< of the force without the flag force_distortion, 1; above 0
  double most_misfit = 0.05;      ///< without the flag model_misfit, 1; above 0
  double most_phase = 0.05;       ///< as in ReductionOptions
};

/// Reduces the records of one structure. Shared by threads.
///
/// A record is fitted by Fourier series with a common fundamental; what the joints do follows from
/// force and accelerations (JointsObserver). D_j = π Σ_n n Im(F_jn conj u_jn). The dissipation of
/// all joints together is W_ext − W_lin: the work of the force on the accelerometer at the exciter,
/// or on the observed motion where there is none, less Σ_i Σ_n nπ Im Z_i(nω)|q_in|²; it needs no
/// more than one accelerometer. The frequency is that of phase resonance: with h_j1 = δ_j u_j1
/// kept, the response lags the force by π/2, so that the drive may be off it. Standard deviations
/// come from the scatter over the cycles, or from the noise where these are too few; what is not
/// seen adds its own.
///
/// Flags: `joint_not_seen` (too few accelerometers, or none where it moves them: the model's stuck
/// joint stands for it), `inner_reversals`, `dissipation_negative`, `dissipation_in_noise`,
/// `joint_in_noise` (D_j below three standard deviations), `dissipation_above_bound` (D_j > k A²),
/// `secant_above_stuck`, `energies_differ` (Σ D_j is not W_ext − W_lin, by more than three standard
/// deviations), `off_resonance` (the drive, by more than three standard deviations),
/// `resonance_not_found` (the frequency is then that of the drive), `far_from_mode`,
/// `model_misfit`, and those of the record, as Reducer has them.
class ModalReducer {
 public:
  /// @throws InputError  as JointsObserver, for a point that the structure lacks, a channel that is
  ///                     there twice, and naming an option out of range.
  explicit ModalReducer(StructureTest test, ModalReductionOptions options = {});

  /// The level that a record holds.
  /// @throws InputError  naming the source: a channel is missing, of another unit or length, there
  ///                     is no steady vibration in it (and why not).
  [[nodiscard]] ModalLevel reduce(const Recording& recording) const;

  /// The structure and the channels of the records.
  [[nodiscard]] const StructureTest& test() const { return test_; }
  /// The options, as given.
  [[nodiscard]] const ModalReductionOptions& options() const { return options_; }
  /// Of the structure with stuck joints, Hz, rising.
  [[nodiscard]] const std::vector<double>& stuck_frequencies() const { return stuck_frequencies_; }

 private:
  StructureTest test_;
  ModalReductionOptions options_;
  std::vector<double> stuck_frequencies_;
};

/// The levels of many files.
struct ModalReductionBatch {
  std::vector<ModalLevel> levels;        ///< in the order of the files and of the records in each
  std::vector<RejectedRecord> rejected;  ///< with `skip_faulty`: what was left out
};

/// reduce_batch() of such records. @throws Error  as `read` and ModalReducer::reduce().
/// @throws Cancelled  as progress or `read` says
[[nodiscard]] ModalReductionBatch reduce_batch(const ModalReducer& reducer, std::size_t count,
                                               const RecordReader& read,
                                               const RecordBatchOptions& options = {});

}  // namespace microslip
