// SPDX-License-Identifier: MIT
#include "microslip/rig/verification/verification_batch.hpp"

#include <algorithm>

#include "microslip/rig/reduction/parallel_records.hpp"

namespace microslip {

bool VerificationBatch::converged() const {
  return std::ranges::all_of(records,
                             [](const Verification& record) { return record.summary.converged(); });
}

VerificationBatch verify_batch(const Verifier& verifier, std::size_t count,
                               const RecordReader& read, const RecordBatchOptions& options) {
  VerificationBatch batch;
  batch.rejected = work_on_records(
      count, read, [&](const Recording& recording) { return verifier.verify(recording); }, options,
      batch.records);
  return batch;
}

}  // namespace microslip
