// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/identify/inversion_basis.hpp"
#include "microslip/identify/inversion_model.hpp"
#include "microslip/identify/smoothing_path.hpp"

/// @file
/// Where populations of sliders end at once. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// How the smoothness of a density changes along it: edges and the trend of a pass.
///
/// Edges are each as likely as "very strong" evidence asks for: −2 log of the likelihood
/// falls by 10 [Kass & Raftery, J. Am. Stat. Assoc. 90 (1995) 773] and by the price of having
/// looked at n places for it, 2 ln n, or more, on average over edges that tell only together, as
/// the two ends of a narrow population may. They are sought one by one among the knots, each then
/// moved between them to where it is likeliest, and those that the others make needless are left
/// out again. The trend is the likeliest, with a prior deviation of 3.
/// @param levels  what was measured.
/// @param lambda  of the solution of the pass: where each search of λ begins.
/// @param pass    without edges and trend, and with its weights; gets both.
/// @param inner   told of all solutions.
void find_shape(const ScaledLevels& levels, double lambda, PassOptions& pass,
                InnerSolutions& inner);

/// Other places of all edges together, each as likely as another to the extent that the likelihood
/// of each place falls as that of a normal distribution: −2 log rises by 1 at a standard deviation.
/// @param lambda  as find_shape().
/// @param pass    with edges.
/// @param count   of places.
[[nodiscard]] std::vector<std::vector<BasisEdge>> edges_elsewhere(const ScaledLevels& levels,
                                                                  double lambda,
                                                                  const PassOptions& pass,
                                                                  std::size_t count,
                                                                  InnerSolutions& inner);

}  // namespace microslip
