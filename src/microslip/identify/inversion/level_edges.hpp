// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/identify/inversion/inversion_basis.hpp"
#include "microslip/identify/inversion/inversion_model.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"

/// @file
/// Edges of the density of a joint from its levels. Internal: Eigen stays out of the installed
/// headers.

namespace microslip {

/// Finds edges and the trend of a pass, see EdgeSearch.
/// @param levels  measured levels.
/// @param lambda  of the solution of the pass: where each search of λ begins.
/// @param pass    without edges and trend, and with its weights; gets both.
/// @param inner   counts all solutions.
void find_shape(const ScaledLevels& levels, double lambda, PassOptions& pass,
                InnerSolutions& inner);

/// Other places of all edges together, as EdgeSearch::elsewhere().
/// @param lambda  as find_shape().
/// @param pass    with edges.
/// @param count   of places.
[[nodiscard]] std::vector<std::vector<BasisEdge>> edges_elsewhere(const ScaledLevels& levels,
                                                                  double lambda,
                                                                  const PassOptions& pass,
                                                                  std::size_t count,
                                                                  InnerSolutions& inner);

}  // namespace microslip
