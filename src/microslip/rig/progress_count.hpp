// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>

#include "microslip/base/progress.hpp"

/// @file
/// Progress of work that several threads do. Internal to rig.

namespace microslip {

/// Tells the listener one at a time; true once it has asked to stop.
class ProgressCount {
 public:
  ProgressCount(const Progress& progress, std::size_t total) : progress_(progress), total_(total) {}

  void add_one() {
    const std::scoped_lock lock(mutex_);
    ++done_;
    if (progress_ && !progress_(done_, total_)) stopped_ = true;
  }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  const Progress& progress_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace microslip
