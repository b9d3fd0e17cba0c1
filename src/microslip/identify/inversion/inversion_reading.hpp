// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/identify/inversion/inversion_model.hpp"
#include "microslip/identify/inversion/inversion_result.hpp"

namespace microslip {

/// Writes a solved model to the result, in SI: density, fit, path, scatter and posterior; not the
/// verdicts on it. Internal to identify.
/// @param elsewhere  models with the edges at other places that are as likely.
void read_model(const InversionModel& model, const std::vector<InversionModel>& elsewhere,
                const ScaledLevels& levels, InversionResult& result);

}  // namespace microslip
