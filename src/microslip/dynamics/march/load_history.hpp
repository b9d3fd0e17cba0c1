// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/joint/jenkins_network.hpp"

/// @file
/// Load histories of a structure for a march in time.

namespace microslip {

/// The force at a point, or the acceleration of a base, over time.
struct PointForce {
  std::string point;          ///< of the modal model, or a base of it; no two the same
  std::vector<double> force;  ///< N, m/s² of a base; one per time
};

/// The normal load of a joint over time, p(t) = P_N(t)/P_0 [AR14 App. B].
struct JointNormalLoad {
  std::string joint;                                ///< of the structure; no two the same
  std::vector<double> load;                         ///< p, 1; ≥ 0; one per time
  NormalLoadLaw law = NormalLoadLaw::kIncremental;  ///< how its elements answer the load
};

/// Load history of a structure; linear in time between the given times. The excitations of the
/// structure itself, which are periodic, do not act; its static loads do.
struct LoadHistory {
  std::vector<double> time;                        ///< s; at least 2, rising, even or not
  std::vector<PointForce> forces;                  ///< may be none: free vibration
  std::vector<JointNormalLoad> normal_loads = {};  ///< joints that are not named keep p = 1
};

}  // namespace microslip
