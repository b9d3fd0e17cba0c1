// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/dynamics/march/load_history.hpp"
#include "microslip/dynamics/march/march_options.hpp"
#include "microslip/dynamics/march/march_state.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Loads on the modes and joints over the intervals of the time axis. Internal to dynamics.
class MarchLoads {
 public:
  /// @param loads  kept by reference.
  MarchLoads(const JointedStructure& structure, const LoadHistory& loads);

  /// Initial state of the march: the requested one, or, with static loads, at rest under them.
  [[nodiscard]] InitialState start(InitialState asked) const;

  /// Whether the march begins at rest under static loads.
  [[nodiscard]] bool at_rest() const { return !equilibrium_.empty(); }

  /// Sets all that is not constant from one interval to the next, and the static loads.
  void set(std::size_t interval, MarchState::Loads& loads) const;

 private:
  const LoadHistory& history_;
  std::vector<std::vector<double>> shapes_;  // of the points with a force, padded
  std::vector<std::size_t> joints_;          // whose normal load varies
  std::vector<double> static_load_;          // of the modes, padded; empty without
  std::vector<double> equilibrium_;          // q under them
};

/// The joints with their hysteresis under these loads.
/// @param elements  of a joint whose normal load varies.
[[nodiscard]] std::vector<MarchedJoint> marched_joints(const JointedStructure& structure,
                                                       const LoadHistory& loads,
                                                       std::size_t elements);

}  // namespace microslip
