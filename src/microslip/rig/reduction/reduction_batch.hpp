// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/rig/reduction/record_batch.hpp"
#include "microslip/rig/reduction/reduction.hpp"

namespace microslip {

/// The levels of many files.
struct ReductionBatch {
  std::vector<ReducedLevel> levels;      ///< in the order of the files and of the records in each
  std::vector<RejectedRecord> rejected;  ///< with `skip_faulty`: the records left out
};

/// Reads and reduces `count` files, several at once; each is released when it is reduced. The
/// result does not depend on the number of threads.
/// @throws Error  as `read` and Reducer::reduce(). @throws Cancelled  as requested by progress or
/// `read`
[[nodiscard]] ReductionBatch reduce_batch(const Reducer& reducer, std::size_t count,
                                          const RecordReader& read,
                                          const RecordBatchOptions& options = {});

}  // namespace microslip
