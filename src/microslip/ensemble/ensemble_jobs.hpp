// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/ensemble/planned_jobs.hpp"

/// @file
/// From the plan of an ensemble to its jobs.

namespace microslip {

/// The jobs of a plan; its inputs are read here.
/// @throws FileError, FormatError, InputError  as the readers of the inputs; naming a case whose
///     curve without draws does not converge; for an output in `raw` that no group has.
[[nodiscard]] std::unique_ptr<const EnsembleJobs> make_ensemble_jobs(const EnsemblePlan& plan);

}  // namespace microslip
