// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/ensemble/case_prediction.hpp"
#include "microslip/ensemble/planned_jobs.hpp"

namespace microslip {

/// A model over a grid of its numbers: job i of a case is point i of the grid, whose last axis runs
/// fastest.
class SweepJobs : public EnsembleJobs {
 public:
  /// @throws  as make_ensemble_jobs(); naming an axis whose number does not exist.
  SweepJobs(SweepPlan sweep, const EnsemblePlan& plan);

  JobResult run(std::size_t group, std::uint64_t index) const override;

 private:
  /// A file of a joint whose numbers are varied.
  struct JointText {
    std::size_t joint = 0;  ///< of the structure
    std::string name;       ///< of the joint
    std::string file;       ///< its name
    std::string text;       ///< all of it
  };

  void find_joints(const ModelFile& model, const std::string& plan);
  void try_axes(const std::string& plan) const;
  [[nodiscard]] JointedStructure structure_at(const std::vector<double>& values) const;

  SweepPlan sweep_;
  std::string text_;  ///< of the model
  std::vector<JointText> joints_;
  std::vector<std::unique_ptr<const CasePrediction>> cases_;
};

/// The numbers at a point of a grid, whose last axis runs fastest.
/// @param axes   of the grid.
/// @param point  from 0 to before the product of their sizes.
[[nodiscard]] std::vector<double> values_at(const std::vector<SweepAxis>& axes,
                                            std::uint64_t point);

}  // namespace microslip
