// SPDX-License-Identifier: MIT
#include "microslip/ensemble/ensemble_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "microslip/base/error.hpp"
#include "microslip/ensemble/bootstrap_jobs.hpp"
#include "microslip/ensemble/design_jobs.hpp"
#include "microslip/ensemble/predict_jobs.hpp"
#include "microslip/ensemble/sweep_jobs.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

std::unique_ptr<const EnsembleJobs> jobs_of_kind(const EnsemblePlan& plan) {
  if (const auto* predict = std::get_if<PredictPlan>(&plan.work)) {
    return std::make_unique<PredictJobs>(*predict, plan);
  }
  if (const auto* bootstrap = std::get_if<BootstrapPlan>(&plan.work)) {
    return std::make_unique<BootstrapJobs>(*bootstrap, plan);
  }
  if (const auto* design = std::get_if<DesignPlan>(&plan.work)) {
    return std::make_unique<DesignJobs>(*design, plan);
  }
  return std::make_unique<SweepJobs>(std::get<SweepPlan>(plan.work), plan);
}

/// Names of all outputs, each once.
std::vector<std::string> names_of_outputs(const EnsembleJobs& jobs) {
  std::vector<std::string> names;
  for (const EnsembleGroup& group : jobs.groups()) {
    for (const EnsembleOutput& output : group.outputs) {
      if (std::ranges::find(names, output.name) == names.end()) names.push_back(output.name);
    }
  }
  return names;
}

void check_raw(const EnsemblePlan& plan, const EnsembleJobs& jobs) {
  const std::vector<std::string> names = names_of_outputs(jobs);
  for (std::size_t i = 0; i < plan.raw.size(); ++i) {
    if (plan.raw[i] == "*" || std::ranges::find(names, plan.raw[i]) != names.end()) continue;
    throw InputError(fmt::format("{}: raw[{}]", plan.file, i), in_quotes(plan.raw[i]),
                     fmt::format("must be '*' or one of {}", fmt::join(names, ", ")));
  }
}

}  // namespace

std::unique_ptr<const EnsembleJobs> make_ensemble_jobs(const EnsemblePlan& plan) {
  std::unique_ptr<const EnsembleJobs> jobs = jobs_of_kind(plan);
  double count = 0.0;
  for (const EnsembleGroup& group : jobs->groups()) count += static_cast<double>(group.jobs);
  if (count > EnsemblePlan::kMostJobs) {
    throw InputError(fmt::format("{}: jobs", plan.file), count,
                     fmt::format("must be {:g} or less", EnsemblePlan::kMostJobs));
  }
  check_raw(plan, *jobs);
  return jobs;
}

}  // namespace microslip
