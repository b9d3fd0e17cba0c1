// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/record_batch.hpp"

/// @file
/// Processing of the records of many files, several files at once. Internal to rig.

namespace microslip {

[[nodiscard]] inline std::string reason_of(const std::exception_ptr& fault) {
  try {
    std::rethrow_exception(fault);
  } catch (const Error& error) {
    return error.what();
  }
}

/// Outcome of one file.
template <typename Result>
struct FileOutcome {
  std::vector<Result> results;
  std::vector<std::exception_ptr> faults;
};

template <typename Result, typename Work>
FileOutcome<Result> work_on_file(std::size_t index, const RecordReader& read, const Work& work) {
  FileOutcome<Result> outcome;
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
    keep_fault([&] { outcome.results.push_back(work(recording)); });
  }
  return outcome;
}

/// Reads `count` files and puts the results of `work` on their records into `results`, in the order
/// of the files and of the records in each, whatever the number of threads. Each record is released
/// when it is done.
/// @return the records left out.
/// @throws Error  as `read` and `work`. @throws Cancelled  as requested by progress or `read`
template <typename Result, typename Work>
std::vector<RejectedRecord> work_on_records(std::size_t count, const RecordReader& read,
                                            const Work& work, const RecordBatchOptions& options,
                                            std::vector<Result>& results) {
  std::vector<FileOutcome<Result>> outcomes(count);
  // A fault is kept with its file, so that of several the first in order is reported, whatever
  // thread met it first.
  options.execution.for_each(
      count, [&](std::size_t i) { outcomes[i] = work_on_file<Result>(i, read, work); },
      options.progress);

  std::vector<RejectedRecord> rejected;
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::exception_ptr& fault : outcomes[i].faults) {
      if (!options.skip_faulty) std::rethrow_exception(fault);
      rejected.push_back({i, reason_of(fault)});
    }
    std::ranges::move(outcomes[i].results, std::back_inserter(results));
  }
  return rejected;
}

}  // namespace microslip
