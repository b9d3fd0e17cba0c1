// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/identify/inversion/inversion_model.hpp"
#include "microslip/identify/inversion/inversion_result.hpp"

namespace microslip {

/// What a solved model says, in the units of its user: density, fit, path, scatter and posterior of
/// a result; not what is judged of it. Internal to identify.
/// @param elsewhere  models with the edges at other places that are as likely.
void read_model(const InversionModel& model, const std::vector<InversionModel>& elsewhere,
                const ScaledLevels& levels, InversionResult& result);

}  // namespace microslip
