// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/rig/reduction/record_batch.hpp"
#include "microslip/rig/verification/verification.hpp"

namespace microslip {

/// The verifications of many files.
struct VerificationBatch {
  std::vector<Verification> records;     ///< in the order of the files and of the records in each
  std::vector<RejectedRecord> rejected;  ///< with `skip_faulty`: the records left out

  [[nodiscard]] bool converged() const;  ///< all of them
};

/// Reads and verifies `count` files, several at once; of each only its comparison is kept. The
/// result does not depend on the number of threads. A record whose prediction does not converge is
/// kept with that status.
/// @throws Error  as `read` and Verifier::verify(). @throws Cancelled  as requested by progress or
/// `read`
[[nodiscard]] VerificationBatch verify_batch(const Verifier& verifier, std::size_t count,
                                             const RecordReader& read,
                                             const RecordBatchOptions& options = {});

}  // namespace microslip
