// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/identify/inversion.hpp"
#include "microslip/identify/inversion_model.hpp"

namespace microslip {

/// What a solved model says, in the units of its user: density, fit, path, scatter and posterior of
/// a result; not what is judged of it. Internal to identify.
void read_model(const InversionModel& model, const ScaledLevels& levels, InversionResult& result);

}  // namespace microslip
