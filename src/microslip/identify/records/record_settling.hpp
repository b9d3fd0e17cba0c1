// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/identify/records/record_model.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"

/// @file
/// The noise of records and the prior exponent, estimated from them. Internal: Eigen stays out of
/// the installed headers.

namespace microslip {

/// A model of records with its best solution by restricted likelihood.
struct SettledRecords {
  RecordModel model;
  SmoothingPoint best;
  RecordPass settings;  ///< of the model
};

/// The model to draw from: scatter and correlation are those of its own residuals, and χ₀ is 0
/// unless the likelihood strongly favours a power law.
/// @param records  must outlive the result.
/// @param viscous  whether c u̇ is sought too.
[[nodiscard]] SettledRecords settle_records(const ScaledRecords& records, bool viscous);

}  // namespace microslip
