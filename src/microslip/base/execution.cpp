// SPDX-License-Identifier: MIT
#include "microslip/base/execution.hpp"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void on_threads(std::size_t count, const Execution::Work& work) {
  // Pieces are long: each is a task of its own.
  tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner());
}

/// Calls the listener once at a time; stopped once it has asked for that.
class ProgressCount {
 public:
  ProgressCount(const Progress& progress, std::size_t total) : progress_(progress), total_(total) {}

  void add_one() {
    const std::scoped_lock lock(mutex_);
    ++done_;
    if (!stopped_ && !progress_(done_, total_)) stopped_ = true;
  }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  const Progress& progress_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace

Execution Execution::serial() {
  return Execution([](std::size_t count, const Work& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
  });
}

Execution Execution::threads(std::size_t most) {
  if (most == 0) return Execution(on_threads);
  // More wait for each other, and TBB reports on standard error that it makes none.
  const int processors = tbb::info::default_concurrency();
  const int threads = static_cast<int>(std::min(most, static_cast<std::size_t>(processors)));
  return Execution([threads](std::size_t count, const Work& work) {
    tbb::task_arena arena(threads);
    arena.execute([&] { on_threads(count, work); });
  });
}

Execution::Execution(ForEach for_each) : for_each_(std::move(for_each)) {
  if (!for_each_) throw InputError("execution", "empty", "must be a function that does the work");
}

void Execution::for_each(std::size_t count, const Work& work) const { for_each_(count, work); }

void Execution::for_each(std::size_t count, const Work& work, const Progress& progress) const {
  if (!progress) return for_each(count, work);
  ProgressCount done(progress, count);
  for_each(count, [&](std::size_t i) {
    if (done.stopped()) return;
    work(i);
    done.add_one();
  });
  if (done.stopped()) throw Cancelled();
}

}  // namespace microslip
