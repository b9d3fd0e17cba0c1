// SPDX-License-Identifier: MIT
#include "microslip/ensemble/predict_jobs.hpp"

#include <fmt/format.h>

#include "microslip/base/error.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

namespace microslip {
namespace {

Correlation correlation_of(const std::string& text) {
  if (text == "together") return Correlation::kTogether;
  return text == "independent" ? Correlation::kIndependent : Correlation::kAuto;
}

}  // namespace

PredictJobs::PredictJobs(const PredictPlan& predict, const EnsemblePlan& plan) {
  const ModelFile model = read_model(predict.model);
  // Their number and statistics are those of the plan, not of a band.
  draws_.emplace(draws_of(model, predict.model,
                          {.count = DrawOptions::kMostDraws,
                           .confidence = 0.5,
                           .seed = plan.seed,
                           .correlation = correlation_of(predict.correlation)}));
  for (const PlannedCase& planned : plan.cases) {
    cases_.push_back(make_case(planned, model, plan.file));
    groups_.push_back({planned.name, predict.draws, cases_.back()->outputs()});
  }
  inputs_ = hashes_of(predict.model, model, cases_);
  warnings_ = warnings_of(cases_, plan.cases);
  notes_.push_back(fmt::format("uncertain: {}", uncertain_text(model)));
}

JobResult PredictJobs::run(std::size_t group, std::uint64_t index) const {
  try {
    return cases_[group]->of(draws_->draw(index));
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

}  // namespace microslip
