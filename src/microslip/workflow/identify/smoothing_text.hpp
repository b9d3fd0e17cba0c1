// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "microslip/identify/methods/identification.hpp"

namespace microslip {

/// Sets the smoothing of the chosen method from `--smoothing gcv|lambda=X|p=X` and
/// `--smoothing-unit UNIT`.
///
///   * inversion: gcv, or lambda=X in the scaled variables that joint.json reports; it has no p.
///   * spline: gcv, lambda=X in UNIT³, or the csaps factor p=X with the amplitude in UNIT. Both
///     mean nothing without their unit.
///   * differences: takes neither.
/// @param unit  nothing where the option was not given.
/// @throws InputError  where the two do not fit the method or break a rule.
void set_smoothing(const std::string& smoothing, const std::optional<std::string>& unit,
                   IdentificationOptions& options);

}  // namespace microslip
