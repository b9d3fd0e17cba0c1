// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction_batch.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <mutex>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// What became of one file.
struct Outcome {
  std::vector<ReducedLevel> levels;
  std::vector<std::exception_ptr> faults;
};

Outcome reduce_file(const Reducer& reducer, std::size_t index,
                    const std::function<std::vector<Recording>(std::size_t)>& read) {
  Outcome outcome;
  const auto keep_fault = [&](const auto& step) {
    try {
      step();
    } catch (const Cancelled&) {
      throw;
    } catch (const Error&) {
      outcome.faults.push_back(std::current_exception());
    }
  };
  std::vector<Recording> recordings;
  keep_fault([&] { recordings = read(index); });
  for (const Recording& recording : recordings) {
    keep_fault([&] { outcome.levels.push_back(reducer.reduce(recording)); });
  }
  return outcome;
}

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

std::string reason_of(const std::exception_ptr& fault) {
  try {
    std::rethrow_exception(fault);
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

ReductionBatch reduce_batch(const Reducer& reducer, std::size_t count,
                            const std::function<std::vector<Recording>(std::size_t)>& read,
                            const ReductionBatchOptions& options) {
  std::vector<Outcome> outcomes(count);
  ProgressCount progress(options.progress, count);
  // A fault is kept with its file, so that of several the first in order is told, whatever thread
  // met it first.
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    if (progress.stopped()) return;
    outcomes[i] = reduce_file(reducer, i, read);
    progress.add_one();
  });
  if (progress.stopped()) throw Cancelled();

  ReductionBatch batch;
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::exception_ptr& fault : outcomes[i].faults) {
      if (!options.skip_faulty) std::rethrow_exception(fault);
      batch.rejected.push_back({i, reason_of(fault)});
    }
    std::ranges::move(outcomes[i].levels, std::back_inserter(batch.levels));
  }
  return batch;
}

}  // namespace microslip
