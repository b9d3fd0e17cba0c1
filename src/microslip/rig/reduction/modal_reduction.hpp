// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/rig/reduction/modal_level.hpp"
#include "microslip/rig/reduction/modal_reduction_options.hpp"
#include "microslip/rig/reduction/record_batch.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "microslip/rig/setup/structure_test.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// From steady records of a structure with several joints to levels of its modes.

namespace microslip {

/// Reduces the records of one structure. Shared by threads.
///
/// A record is fitted by Fourier series with a common fundamental; the motion of the joints follows
/// from force and accelerations (JointsObserver). D_j = π Σ_n n Im(F_jn conj u_jn). The dissipation
/// of all joints together is W_ext − W_lin: the work of the force on the accelerometer at the
/// exciter, or on the observed motion where there is none, less Σ_i Σ_n nπ Im Z_i(nω)|q_in|²; it
/// needs only one accelerometer. The frequency is that of phase resonance: with h_j1 = δ_j u_j1
/// kept, the response lags the force by π/2, so that the drive may be off it. Standard deviations
/// come from the scatter over the cycles, or from the noise where these are too few; unobserved
/// directions add their own.
///
/// Flags: `joint_not_seen` (too few accelerometers, or none where it moves them: the model's stuck
/// joint is used), `inner_reversals`, `dissipation_negative`, `dissipation_in_noise`,
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

  /// The level of a record.
  /// @throws InputError  naming the source: a channel is missing, of another unit or length, there
  ///                     is no steady vibration in it (and why not).
  [[nodiscard]] ModalLevel reduce(const Recording& recording) const;

  /// The structure and the channels of the records.
  [[nodiscard]] const StructureTest& test() const { return test_; }
  /// The options, as given.
  [[nodiscard]] const ModalReductionOptions& options() const { return options_; }
  /// Natural frequencies of the structure with stuck joints, Hz, rising.
  [[nodiscard]] const std::vector<double>& stuck_frequencies() const { return stuck_frequencies_; }

 private:
  StructureTest test_;
  ModalReductionOptions options_;
  std::vector<double> stuck_frequencies_;
};

/// The levels of many files.
struct ModalReductionBatch {
  std::vector<ModalLevel> levels;        ///< in the order of the files and of the records in each
  std::vector<RejectedRecord> rejected;  ///< with `skip_faulty`: the records left out
};

/// reduce_batch() of such records. @throws Error  as `read` and ModalReducer::reduce().
/// @throws Cancelled  as requested by progress or `read`
[[nodiscard]] ModalReductionBatch reduce_batch(const ModalReducer& reducer, std::size_t count,
                                               const RecordReader& read,
                                               const RecordBatchOptions& options = {});

}  // namespace microslip
