// SPDX-License-Identifier: MIT
#include <atomic>
#include <mutex>
#include <utility>

#include "microslip/ensemble/team.hpp"

namespace microslip {

LocalTeam::LocalTeam(Execution execution) : execution_(std::move(execution)) {}

/// Alone it always does, and what failed is thrown where it was.
void LocalTeam::agree(const std::string& /*text*/, const std::string& /*failure*/) {}

void LocalTeam::deal(const std::vector<std::uint64_t>& blocks, const Work& work,
                     const Receive& receive) {
  std::mutex one_at_a_time;
  std::atomic<bool> stopped = false;
  execution_.for_each(blocks.size(), [&](std::size_t i) {
    if (stopped) return;
    const std::string done = work(blocks[i], [] {});
    const std::scoped_lock lock(one_at_a_time);
    if (!stopped && !receive(blocks[i], done)) stopped = true;
  });
}

}  // namespace microslip
