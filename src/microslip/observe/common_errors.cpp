// SPDX-License-Identifier: MIT
#include "microslip/observe/common_errors.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_gain(std::string_view name, double value) {
  if (std::isfinite(value) && value >= 0.0 && value < 0.3) return;
  throw InputError(name, value, "must be a relative standard deviation from 0 to 0.3");
}

}  // namespace

void CommonErrors::check() const {
  check_gain("dissipation_gain_std", dissipation_gain_std);
  check_gain("amplitude_gain_std", amplitude_gain_std);
  check_gain("loss_factor_std", loss_factor_std);
}

CommonErrorDraw CommonErrors::draw(RandomStream& random) const {
  CommonErrorDraw draw;
  draw.dissipation_gain = std::max(0.0, 1.0 + dissipation_gain_std * random.normal());
  draw.amplitude_gain = std::max(0.1, 1.0 + amplitude_gain_std * random.normal());
  draw.loss_factor = loss_factor_std * random.normal();
  return draw;
}

}  // namespace microslip
