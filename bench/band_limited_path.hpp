// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/joint/joint.hpp"

namespace microslip::bench {

/// A displacement path like that of a joint under random excitation of a mode near 60 Hz, sampled
/// at 8192 Hz: Gaussian noise in the band from 20 to 100 Hz, scaled to the given largest
/// displacement, m. It turns some 15 times in 1000 samples. The same in each run.
[[nodiscard]] std::vector<double> band_limited_path(std::size_t samples, double largest);

/// A joint of 1.7e5 N/m with a piecewise-linear density of 100 segments up to 50 N and random
/// ordinates; an elastic remainder of 5 %. The same in each run.
[[nodiscard]] Joint joint_of_100_segments();

}  // namespace microslip::bench
