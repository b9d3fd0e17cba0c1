// SPDX-License-Identifier: MIT
#include "long_work.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace py = pybind11;

namespace microslip::python {
namespace {

/// What the thread that works and the one that waits tell each other.
class SharedState {
 public:
  bool tell(std::size_t done, std::size_t total) {
    done_.store(done, std::memory_order_relaxed);
    total_.store(total, std::memory_order_relaxed);
    return !cancelled_.load(std::memory_order_relaxed);
  }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] std::pair<std::size_t, std::size_t> told() const {
    return {done_.load(std::memory_order_relaxed), total_.load(std::memory_order_relaxed)};
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
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
};

/// Signals, and the listener where there is news.
class Attention {
 public:
  explicit Attention(const py::object& listener) : listener_(listener) {}

  /// @return whether to go on. @throws py::error_already_set
  bool pay(const SharedState& state) {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const auto news = state.told();
    if (listener_.is_none() || news == last_) return true;
    last_ = news;
    const py::object answer = listener_(news.first, news.second);
    return answer.is_none() || py::bool_(answer);
  }

 private:
  const py::object& listener_;
  std::pair<std::size_t, std::size_t> last_{0, 0};
};

}  // namespace

void do_long_work(const std::function<void(const Progress& progress)>& work,
                  const py::object& listener) {
  SharedState state;
  std::exception_ptr of_work;
  std::exception_ptr of_python;
  {
    const py::gil_scoped_release unlocked;
    std::thread worker([&] {
      try {
        work([&](std::size_t done, std::size_t total) { return state.tell(done, total); });
      } catch (...) {
        of_work = std::current_exception();
      }
      state.end();
    });
    Attention attention(listener);
    while (!state.wait_a_while()) {
      if (of_python) continue;
      try {
        if (!attention.pay(state)) state.cancel();
      } catch (...) {
        of_python = std::current_exception();
        state.cancel();
      }
    }
    worker.join();
  }
  if (of_python) std::rethrow_exception(of_python);
  if (of_work) std::rethrow_exception(of_work);
}

}  // namespace microslip::python
