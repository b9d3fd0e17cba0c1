// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/reduction_batch.hpp"

#include "microslip/rig/reduction/parallel_records.hpp"

namespace microslip {

ReductionBatch reduce_batch(const Reducer& reducer, std::size_t count, const RecordReader& read,
                            const RecordBatchOptions& options) {
  ReductionBatch batch;
  batch.rejected = work_on_records(
      count, read, [&](const Recording& recording) { return reducer.reduce(recording); }, options,
      batch.levels);
  return batch;
}

}  // namespace microslip
