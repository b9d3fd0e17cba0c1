// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/identify/inversion.hpp"

namespace microslip {

/// What invert() returns is whole; what a caller made may not be. Internal to identify.
/// @throws InputError  where a result has no model, no levels, or lengths that do not fit.
void check_result(const InversionResult& result);

}  // namespace microslip
