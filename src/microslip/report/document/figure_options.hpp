// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/joint/joint.hpp"
#include "microslip/report/drawing/figure.hpp"

namespace microslip {

/// Scale of the axis of an amplitude, and of energies over it.
enum class AmplitudeScale { kAsSuits, kLinear, kLog };

/// A joint under a name.
struct NamedJoint {
  std::string name;  ///< in the legend
  Joint joint;       ///< drawn beside that of the results
};

/// Options of the figures of a test.
struct FigureOptions {
  AmplitudeScale scale = AmplitudeScale::kAsSuits;  ///< of the axis of an amplitude
  std::vector<NamedJoint> others = {};              ///< drawn beside the joint of the results
  std::string response_unit = "m/s²";               ///< of a response: "m/s²", "g"
  std::vector<Layer> beside = {};                   ///< in SI units, drawn behind the results
};

}  // namespace microslip
