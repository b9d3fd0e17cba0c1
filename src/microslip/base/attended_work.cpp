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

/// The state shared by the thread that works and the one that waits.
class SharedState {
 public:
  /// The first call waits for the answer: short work would end before `attend` was called.
  bool report(std::size_t done, std::size_t total) {
    done_.store(done, std::memory_order_relaxed);
    total_.store(total, std::memory_order_relaxed);
    if (!reported_.exchange(true)) wait_for_answer();
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
    changed_.notify_all();
  }
  enum class Event { kEnded, kFirstQuestion, kTimePassed };
  [[nodiscard]] Event wait_a_while() {
    constexpr std::chrono::milliseconds kWhile{50};
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kWhile, [this] { return ended_ || waits_; });
    if (ended_) return Event::kEnded;
    return waits_ ? Event::kFirstQuestion : Event::kTimePassed;
  }
  void answer_first_question() {
    {
      const std::lock_guard lock(mutex_);
      waits_ = false;
    }
    changed_.notify_all();
  }

 private:
  void wait_for_answer() {
    std::unique_lock lock(mutex_);
    waits_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !waits_; });
  }

  std::atomic<std::size_t> done_ = 0;
  std::atomic<std::size_t> total_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  bool waits_ = false;  ///< for the first answer
  std::atomic<bool> reported_ = false;
};

}  // namespace

void do_attended(const std::function<void(const Progress& progress)>& work,
                 const Progress& attend) {
  SharedState state;
  std::exception_ptr of_work;
  std::exception_ptr of_attendance;
  std::thread worker([&] {
    try {
      work([&](std::size_t done, std::size_t total) { return state.report(done, total); });
    } catch (...) {
      of_work = std::current_exception();
    }
    state.end();
  });
  using Event = SharedState::Event;
  for (auto event = state.wait_a_while(); event != Event::kEnded; event = state.wait_a_while()) {
    try {
      if (!of_attendance && !state.ask(attend)) state.stop();
    } catch (...) {
      of_attendance = std::current_exception();
      state.stop();
    }
    if (event == Event::kFirstQuestion) state.answer_first_question();
  }
  worker.join();
  if (of_attendance) std::rethrow_exception(of_attendance);
  if (of_work) std::rethrow_exception(of_work);
}

}  // namespace microslip
