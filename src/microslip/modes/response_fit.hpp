// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// Modes that several frequency responses to one force have in common. Internal to modes.

namespace microslip {

/// A motion over the force at the drive point, (iω)^p times a receptance.
struct BandResponse {
  std::vector<double> omega;                 ///< rad/s, > 0, rising; three or more
  std::vector<std::complex<double>> values;  ///< SI; one an ω
  int derivatives = 0;                       ///< p
};

/// Options of the search for modes.
struct ResponseFitOptions {
  std::vector<double> start = {};         ///< ω near those of the modes, rad/s; empty: a search
  std::optional<std::size_t> count = {};  ///< so many are searched; as many as show without it
  DampingLaw law = DampingLaw::kViscous;  ///< of the modes
  std::size_t drive = 0;                  ///< which of the responses is that at the drive point
};

/// Result of fit_responses().
struct ResponseFit {
  std::vector<Mode> modes = {};  ///< rising in ω, all within the band
  Eigen::MatrixXd residues;      ///< R_jr, 1/kg: responses × modes
  Eigen::MatrixXd errors;        ///< their standard deviations by the residual, 1/kg
  Eigen::MatrixXcd numerators;   ///< N_jr, R where modes need not be real
  Eigen::VectorXd upper;         ///< U_j, m/N: compliance of modes above the band
  std::vector<double> misfits;   ///< rms of the residual of each response over its own rms, 1
  std::vector<double> undriven;  ///< ω of peaks that only a negative residue of the drive explains
  Summary summary = {};          ///< of the last search for ω and η
};

/// Fits
///
///     H_j(ω) = (iω)^p (Σ_r N_jr/(ω_r² − ω² + iη_r ω_r ω) − L_j/ω² + U_j)      (kViscous)
///
/// or iη_r ω_r² (kHysteretic), with N_jr = a + b iω/ω_r or a + ib, by least squares over all
/// responses: a, b, L and U are linear, ω_r and η_r common to all and found by variable projection
/// [Golub & Pereyra], each response weighted by its residual. Beginning with the highest peak of
/// Σ|H_j|², a mode is added where the residual has its highest peak, as long as it is significant:
/// it explains more than noise would, and a tenth of the motion there. The residues R of real modes
/// are those with b = 0 and the same ω_r and η_r.
/// @param responses  one or more, over the same band.
/// @throws InputError  where no mode, or fewer than requested, are found.
[[nodiscard]] ResponseFit fit_responses(std::span<const BandResponse> responses,
                                        const ResponseFitOptions& options);

}  // namespace microslip
