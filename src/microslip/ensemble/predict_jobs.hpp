// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/ensemble/case_prediction.hpp"
#include "microslip/ensemble/input_hashes.hpp"
#include "microslip/ensemble/planned_jobs.hpp"

namespace microslip {

/// Draws of a model through its cases: job i of a case is its draw i, the same as that of `frf` and
/// `backbone` of this seed.
class PredictJobs : public EnsembleJobs {
 public:
  /// @throws  as make_ensemble_jobs().
  PredictJobs(const PredictPlan& predict, const EnsemblePlan& plan);

  JobResult run(std::size_t group, std::uint64_t index) const override;

 private:
  std::optional<StructureDraws> draws_;
  std::vector<std::unique_ptr<const CasePrediction>> cases_;
};

}  // namespace microslip
