// SPDX-License-Identifier: MIT
#include "microslip/base/attended_work.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>

namespace microslip {
namespace {

/// What the thread that works and the one that waits tell each other.
class SharedState {
 public:
  bool tell(std::size_t done, std::size_t total) {
    done_.store(done, std::memory_order_relaxed);
    total_.store(total, std::memory_order_relaxed);
    return !stopped_.load(std::memory_order_relaxed);
  }
  void stop() { stopped_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool ask(const Progress& attend) const {
    return attend(done_.load(std::memory_order_relaxed), total_.load(std::memory_order_relaxed));
  }
  void end() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_one();
  }
  /// @return whether it has ended.
  bool wait_a_while() {
    constexpr std::chrono::milliseconds kWhile{50};
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kWhile, [this] { return ended_; });
  }

 private:
  std::atomic<std::size_t> done_ = 0;
  std::atomic<std::size_t> total_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
};

}  // namespace

void do_attended(const std::function<void(const Progress& progress)>& work,
                 const Progress& attend) {
  SharedState state;
  std::exception_ptr of_work;
  std::exception_ptr of_attendance;
  std::thread worker([&] {
    try {
      work([&](std::size_t done, std::size_t total) { return state.tell(done, total); });
    } catch (...) {
      of_work = std::current_exception();
    }
    state.end();
  });
  while (!state.wait_a_while()) {
    if (of_attendance) continue;
    try {
      if (!state.ask(attend)) state.stop();
    } catch (...) {
      of_attendance = std::current_exception();
      state.stop();
    }
  }
  worker.join();
  if (of_attendance) std::rethrow_exception(of_attendance);
  if (of_work) std::rethrow_exception(of_work);
}

}  // namespace microslip
