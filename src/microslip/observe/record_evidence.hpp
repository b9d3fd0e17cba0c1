// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/observe/force_record.hpp"
#include "microslip/observe/path_rows.hpp"
#include "microslip/observe/smoothed_path.hpp"

namespace microslip {

/// A force–displacement record with its errors: its path without noise, and rows that are linear
/// in the stiffness density (path_rows.hpp). The force of a row of n samples scatters by
///
///     σ_i = s/√n_i,
///
/// s that of one sample, which a fit estimates.
class RecordEvidence {
 public:
  /// About so many rows, beside a few of each branch: a density has a few dozen degrees of freedom,
  /// and a path hardly more than a few thousand places that differ.
  static constexpr std::size_t kMostRows = 6000;

  /// @param measured  as recorded.
  /// @param start     the state at its first sample.
  /// @throws InputError  as check_force_record().
  RecordEvidence(ForceRecord measured, PathStart start);

  [[nodiscard]] const ForceRecord& measured() const { return measured_; }  ///< as given
  [[nodiscard]] const SmoothedPath& path() const { return path_; }         ///< of the joint
  [[nodiscard]] const PathRows& rows() const { return rows_; }             ///< of that path
  [[nodiscard]] PathStart start() const { return start_; }                 ///< as given

  /// This record with another state at its first sample.
  [[nodiscard]] RecordEvidence from(PathStart start) const;

 private:
  ForceRecord measured_;
  SmoothedPath path_;
  PathStart start_;
  PathRows rows_;
};

}  // namespace microslip
