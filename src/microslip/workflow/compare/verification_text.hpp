// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/verification/verification.hpp"
#include "microslip/rig/verification/verification_batch.hpp"

namespace microslip {

/// Summary of a verification: how it was done, one line per record, the worst of each
/// channel, and what is to be looked at.
[[nodiscard]] std::string describe_verification(const Verifier& verifier,
                                                const VerificationBatch& batch);

/// Points to be checked, for the files: what did not converge, each kind of warning and
/// flag once, what was left out.
[[nodiscard]] std::vector<Warning> verification_warnings(const VerificationBatch& batch);

}  // namespace microslip
