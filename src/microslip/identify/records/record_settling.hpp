// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "microslip/identify/records/record_model.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"

/// @file
/// The noise of records and the prior exponent, estimated from them. Internal: Eigen stays out of
/// the installed headers.

namespace microslip {

/// A model of records with its best solution by restricted likelihood.
struct SettledRecords {
  std::shared_ptr<const ScaledRecords> records;  ///< with the knots of the model
  RecordModel model;
  SmoothingPoint best;
  RecordPass settings;  ///< of the model
};

/// A prior that the data leave possible, with its model and solution.
struct PossiblePrior {
  SettledRecords settled;
  double weight = 0.0;  ///< posterior probability, 1
};

/// The model to draw from: scatter and correlation are those of its own residuals, and χ₀ is 0
/// unless the likelihood strongly favours a power law.
/// @param records  must outlive the result.
/// @param viscous  whether c u̇ is sought too.
[[nodiscard]] SettledRecords settle_records(const ScaledRecords& records, bool viscous);

/// The joint that is nearest in force, for records that no joint explains: rows are weighed alike,
/// as residuals of another joint are no noise. Whitened by their correlation increments of the
/// force would be fitted, and the force itself missed.
/// @param settled  of such records.
[[nodiscard]] SettledRecords nearest_in_force(const SettledRecords& settled);

/// The priors that the data leave possible: those of other exponents χ₀ beside the likeliest, which
/// is the first, all with its knots. They differ in what continues below the resolution of the
/// records, and in how smooth the density is; k depends on both.
/// @param settled  the likeliest.
[[nodiscard]] std::vector<PossiblePrior> possible_priors(const SettledRecords& settled);

/// χ₀ that are tried: 0 and powers that rise towards zero.
[[nodiscard]] std::span<const double> tried_exponents();

}  // namespace microslip
