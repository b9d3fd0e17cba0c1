// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/rig/verification.hpp"
#include "microslip/rig/verification_batch.hpp"

namespace microslip::app {

/// A verification as text for a person: how it was done, a line a record, the worst of each channel, and
/// what is to be looked at.
[[nodiscard]] std::string describe_verification(const Verifier& verifier,
                                                const VerificationBatch& batch);

}  // namespace microslip::app
