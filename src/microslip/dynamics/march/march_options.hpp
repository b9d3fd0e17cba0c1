// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// @file
/// Where a march begins, how it integrates and what it records.

namespace microslip {

/// The state at the first time; empty vectors are zeros, or, where there are static loads, the
/// equilibrium under them. The joints are virgin before the path to it.
struct InitialState {
  std::vector<double> displacement = {};  ///< q_i, kg^½ m; one per mode; none with static loads
  std::vector<double> velocity = {};      ///< q̇_i, kg^½ m/s
};

/// How march() integrates, and what it records.
struct MarchOptions {
  /// Longest step, s; ≥ 0, and at least 1e-10 of the time axis. Each interval of the time axis is
  /// cut into the least number of equal steps that are not longer, an even one where the error is
  /// estimated. 0: a twentieth of the shortest period of the stuck structure, an eightieth where a
  /// density has more than 16 atoms, a four-hundredth where a normal load varies.
  double step = 0.0;
  /// Every n-th time of the axis is recorded, from the first on, and the last; ≥ 1.
  std::size_t every = 1;
  /// Points of the modal model whose motion is recorded; no two the same.
  std::vector<std::string> points = {};
  InitialState start = {};  ///< where it begins
  /// Tolerance of the implicit equations of a step, over the largest joint force so far, 1; from
  /// 1e-14 to 1e-4.
  double tolerance = 1e-8;
  /// Evaluations of the joints that one step may take; ≥ 2.
  int max_iterations = 50;
  /// The energy imbalance above which the march does not count as converged, 1; > 0.
  double largest_imbalance = 1e-4;
  /// Whether the error is estimated: each interval of the time axis is then cut into an even number
  /// of steps, and marched again with half as many, for half the time again. Linear structures are
  /// exact, and need none.
  bool estimate_error = true;
  /// The estimated error above which the march does not count as converged, 1; > 0.
  double largest_error = 1e-2;
  /// Jenkins elements of a joint whose normal load varies; ≥ 1, and more than its density has
  /// atoms.
  std::size_t elements = 1000;
};

}  // namespace microslip
