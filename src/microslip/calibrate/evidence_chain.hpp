// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "microslip/algebra/core.hpp"
#include "microslip/calibrate/linear_evidence.hpp"

/// @file
/// Draws from the posterior of levels and prior. Internal to calibrate.

namespace microslip {

/// Number and random stream of the draws of a chain.
struct ChainLength {
  std::size_t draws = 0;
  std::uint64_t seed = 0;
  std::uint64_t chain = 0;  ///< its number: chains of one seed are independent
};

/// Draws of PosteriorChain: x, τ of losses and of frequencies, and the smoothing. The λ of the
/// joints are drawn together, in the ratio in which they settled, with a local factor for each
/// place of each. Coefficients that may be 0 are 0 in some of the draws
/// (PosteriorChain::projected()): a joint that does not slip at small amplitudes has no loss there
/// in them.
/// @param settled  where it starts.
/// @param least    smallest τ of each kind.
/// @param keep     called with each draw.
void draw_evidence(const NormalEquations& equations, const SettledEvidence& settled,
                   const std::array<double, kRowKinds.size()>& least, const ChainLength& length,
                   const std::function<void(const Eigen::VectorXd&)>& keep);

/// Draws of the prior alone, at the settled λ.
void draw_prior(const NormalEquations& equations, const SettledEvidence& settled,
                const ChainLength& length, const std::function<void(const Eigen::VectorXd&)>& keep);

}  // namespace microslip
