// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/ensemble/planned_jobs.hpp"

namespace microslip {

/// A case of a plan: predictions of structures that differ in numbers from that of a model, over
/// the axes of the model's own prediction. Immutable.
class CasePrediction {
 public:
  virtual ~CasePrediction() = default;

  /// Outputs of a prediction.
  [[nodiscard]] virtual const std::vector<EnsembleOutput>& outputs() const = 0;

  /// The prediction of one structure. @throws InputError  where the structure breaks a rule of the
  /// method.
  [[nodiscard]] virtual JobResult of(StructureDraw drawn) const = 0;

  /// Warnings of the prediction of the model itself, and so of all.
  [[nodiscard]] virtual const std::vector<Warning>& warnings() const = 0;

  /// Input files in addition to those of the model.
  [[nodiscard]] virtual std::vector<std::string> files() const { return {}; }
};

/// Predicts the model itself, which gives the axes.
/// @param planned  the case. @param model  as read. @param plan  its file, for messages.
/// @throws InputError  naming the case, where that does not converge, or an option does not fit.
[[nodiscard]] std::unique_ptr<const CasePrediction> make_case(const PlannedCase& planned,
                                                              const ModelFile& model,
                                                              const std::string& plan);

/// Warnings of cases, each with the name of its case.
/// @param cases    that were made. @param planned  of these.
[[nodiscard]] std::vector<Warning> warnings_of(
    const std::vector<std::unique_ptr<const CasePrediction>>& cases,
    const std::vector<PlannedCase>& planned);

}  // namespace microslip
