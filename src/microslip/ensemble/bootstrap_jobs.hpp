// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/ensemble/found_density.hpp"
#include "microslip/ensemble/planned_jobs.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/observe/level_evidence.hpp"

namespace microslip {

/// Identifications of levels resampled from those measured [Efron & Tibshirani, An Introduction to
/// the Bootstrap, Chapman & Hall 1993, ch. 6 and 9]: all of them, D and k_eq of the fit plus the
/// residuals of randomly chosen levels, of which the fit has used edf of n; or as many levels drawn
/// from them with repetition, which may leave out the ends.
class BootstrapJobs : public EnsembleJobs {
 public:
  /// @throws  as make_ensemble_jobs().
  BootstrapJobs(const BootstrapPlan& bootstrap, const EnsemblePlan& plan);

  JobResult run(std::size_t group, std::uint64_t index) const override;

 private:
  [[nodiscard]] Levels levels_of(std::uint64_t index) const;
  void prepare_residuals();

  BootstrapPlan bootstrap_;
  std::uint64_t seed_;
  Levels measured_;
  InversionOptions options_;
  std::optional<LevelEvidence> evidence_;
  LevelRows fit_;         ///< of the levels, where residuals are drawn
  LevelRows deviations_;  ///< σ
  LevelRows residuals_;   ///< over σ, as large as the errors are
  std::optional<FoundDensity> found_;
};

}  // namespace microslip
