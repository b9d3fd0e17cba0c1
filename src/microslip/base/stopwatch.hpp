// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "microslip/base/summary.hpp"

/// @file
/// Wall time of a numerical method, for its Summary. Internal to the library.

namespace microslip {

/// Runs from its construction.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return since(began_); }

  /// The time of the part `what`, since the last lap or since the beginning.
  [[nodiscard]] Summary::Timing lap(std::string what) {
    const Summary::Timing timing{std::move(what), since(last_)};
    last_ = Clock::now();
    return timing;
  }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] static double since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = began_;
};

}  // namespace microslip
