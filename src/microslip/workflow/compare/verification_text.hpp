// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/rig/verification/verification.hpp"
#include "microslip/rig/verification/verification_batch.hpp"

namespace microslip {

/// A verification as text for a person: how it was done, a line a record, the worst of each
/// channel, and what is to be looked at.
[[nodiscard]] std::string describe_verification(const Verifier& verifier,
                                                const VerificationBatch& batch);

/// What of it is to be looked at, for the files: what did not converge, each kind of warning and
/// flag once, what was left out.
[[nodiscard]] std::vector<Warning> verification_warnings(const VerificationBatch& batch);

}  // namespace microslip
