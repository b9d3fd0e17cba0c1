// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/rig/reduction.hpp"
#include "microslip/signal/recording.hpp"

namespace microslip {

/// A file of the batch that could not be read, or a record of it that could not be reduced.
struct RejectedRecord {
  std::size_t index = 0;  ///< of the file
  std::string reason;     ///< what the error says
};

struct ReductionBatch {
  std::vector<ReducedLevel> levels;  ///< in the order of the files and of the records in each
  std::vector<RejectedRecord> rejected;
};

struct ReductionBatchOptions {
  /// Leave out files that cannot be read and records that cannot be reduced, and say so. Otherwise
  /// the first of them, in the order of the files, ends the batch.
  bool skip_faulty = false;
  Progress progress = {};  ///< files done of all files
};

/// Reads and reduces `count` files, several at once; each is forgotten when it is reduced. The result
/// does not depend on the number of threads.
/// @param read  the records of a file; called from several threads at once.
/// @throws Error  as `read` and Reducer::reduce(). @throws Cancelled  as progress or `read` says
[[nodiscard]] ReductionBatch reduce_batch(
    const Reducer& reducer, std::size_t count,
    const std::function<std::vector<Recording>(std::size_t)>& read,
    const ReductionBatchOptions& options = {});

}  // namespace microslip
