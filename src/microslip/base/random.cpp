// SPDX-License-Identifier: MIT
#include "microslip/base/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace microslip {

std::uint64_t RandomStream::next() {
  if (left_ == 0) {
    using Generator = r123::Philox4x64;
    const Generator::ctr_type counter = {{counter_++, 0, 0, 0}};
    const Generator::key_type key = {{seed_, stream_}};
    const Generator::ctr_type block = Generator{}(counter, key);
    for (int i = 0; i < 4; ++i) block_[i] = block[static_cast<std::size_t>(i)];
    left_ = 4;
  }
  return block_[--left_];
}

double RandomStream::uniform() {
  // The upper 52 bits, moved by half a step off both ends; with 53 the largest would round to 1.
  return (static_cast<double>(next() >> 12U) + 0.5) * 0x1p-52;
}

double RandomStream::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_normal_;
  }
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace microslip
