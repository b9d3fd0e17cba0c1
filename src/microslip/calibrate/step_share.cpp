// SPDX-License-Identifier: MIT
#include "microslip/calibrate/step_share.hpp"

#include <algorithm>

namespace microslip {
namespace {

/// Fall of the change from pass to pass, and passes without it before steps are halved.
constexpr double kEnoughFall = 2.0 / 3.0;
constexpr int kMostStalled = 3;
/// A step goes no shorter: one that cycles with it is not of the joints but of rounding.
constexpr double kLeastShare = 1.0 / 16.0;

}  // namespace

void StepShare::take(double change) {
  const double whole = of_whole_step(change);
  if (whole <= kEnoughFall * reference_) {
    reference_ = whole;
    stalled_ = 0;
    return;
  }
  ++stalled_;
  if (stalled_ < kMostStalled || share_ <= kLeastShare) return;
  share_ = std::max(kLeastShare, 0.5 * share_);
  stalled_ = 0;
  reference_ = std::numeric_limits<double>::infinity();
}

}  // namespace microslip
