// SPDX-License-Identifier: MIT
#include "microslip/ensemble/bootstrap_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/workflow/reduce/level_table.hpp"

namespace microslip {
namespace {

/// A whole number below `count`.
std::size_t drawn_index(RandomStream& random, std::size_t count) {
  const auto index = static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  return std::min(index, count - 1);
}

/// Level `from` of one set behind those of another.
void append_level(const Levels& from, std::size_t i, Levels& to) {
  const auto copy = [i](const std::vector<double>& source, std::vector<double>& target) {
    if (!source.empty()) target.push_back(source[i]);
  };
  copy(from.amplitude, to.amplitude);
  copy(from.dissipation, to.dissipation);
  copy(from.amplitude_std, to.amplitude_std);
  copy(from.dissipation_std, to.dissipation_std);
  copy(from.secant_stiffness, to.secant_stiffness);
  copy(from.secant_stiffness_std, to.secant_stiffness_std);
}

/// Errors are larger than what a fit leaves of them.
void scale(std::vector<double>& residuals, double edf) {
  const auto n = static_cast<double>(residuals.size());
  const double factor = std::sqrt(n / std::max(1.0, n - edf));
  for (double& value : residuals) value *= factor;
}

}  // namespace

BootstrapJobs::BootstrapJobs(const BootstrapPlan& bootstrap, const EnsemblePlan& plan)
    : bootstrap_(bootstrap),
      seed_(plan.seed),
      options_(inversion_options(bootstrap.identification)) {
  const LevelTable table =
      read_level_table(bootstrap.levels, {.assemblies = AssemblyColumn::kRefused});
  measured_ = table.used.levels;
  try {
    evidence_.emplace(measured_);
    prepare_residuals();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", table.used.file, error.name()));
  }
  const auto [lowest, highest] = std::ranges::minmax(measured_.amplitude);
  found_.emplace(bootstrap.stiffness, lowest, highest, bootstrap.points, options_.linear_damping);
  groups_.push_back({"bootstrap", bootstrap.count, found_->outputs()});
  inputs_.push_back({bootstrap.levels, sha256(table.input.text)});
  notes_.push_back(bootstrap.residuals ? "resampled: residuals of the levels about their fit"
                                       : "resampled: levels");
  warnings_ = table.warnings;
}

void BootstrapJobs::prepare_residuals() {
  const InversionResult fit = invert(*evidence_, bootstrap_.stiffness, options_);
  if (!bootstrap_.residuals) return;
  fit_ = {fit.fitted_dissipation, fit.fitted_secant_stiffness};
  deviations_ = evidence_->deviations({fit_, {}});
  residuals_ = evidence_->residuals(fit_, deviations_);
  scale(residuals_.dissipation, fit.edf);
  scale(residuals_.secant_stiffness, 1.0);  // of their common offset
}

Levels BootstrapJobs::levels_of(std::uint64_t index) const {
  RandomStream random(seed_, index);
  if (!bootstrap_.residuals) {
    Levels levels;
    for (std::size_t i = 0; i < measured_.size(); ++i) {
      append_level(measured_, drawn_index(random, measured_.size()), levels);
    }
    return levels;
  }
  Levels levels = evidence_->levels();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::size_t j = drawn_index(random, levels.size());
    levels.dissipation[i] =
        std::max(0.0, fit_.dissipation[i] + deviations_.dissipation[i] * residuals_.dissipation[j]);
    if (levels.secant_stiffness.empty()) continue;
    levels.secant_stiffness[i] =
        fit_.secant_stiffness[i] + deviations_.secant_stiffness[i] * residuals_.secant_stiffness[j];
  }
  return levels;
}

JobResult BootstrapJobs::run(std::size_t /*group*/, std::uint64_t index) const {
  try {
    const InversionResult result =
        invert(LevelEvidence(levels_of(index)), bootstrap_.stiffness, options_);
    if (!result.summary.converged()) return {{}, result.summary.reason};
    return {found_->of(result), {}};
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

}  // namespace microslip
