// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assembly_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"
#include "microslip/identify/inversion/inversion_passes.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"

namespace microslip {
namespace {

constexpr int kMostPasses = 8;
constexpr double kScalesFound = 3e-3;  // far below the accuracy of levels
/// Prior deviation of the scales, and the step of their search.
constexpr double kScalePrior = 0.7;
constexpr double kMostStep = 0.5;
/// The knots go on above the levels by these: at least, deviations of ln S, at most.
constexpr double kLeastExtension = 1.1;
constexpr double kExtendedDeviations = 2.5;
constexpr double kMostExtension = 2.5;

void add_scaled(std::vector<double>& all, const std::vector<double>& values, double factor) {
  for (const double value : values) all.push_back(factor * value);
}

/// D and A of all as those of the middle.
Levels over_each_other(std::span<const Assembly> assemblies, const Eigen::VectorXd& log_stiffness,
                       const Eigen::VectorXd& log_force) {
  Levels all;
  for (std::size_t j = 0; j < assemblies.size(); ++j) {
    const Levels& own = assemblies[j].levels.measured();
    const auto row = static_cast<Eigen::Index>(j);
    const double moved = std::exp(log_stiffness(row) - log_force(row));
    const double energy = std::exp(log_stiffness(row) - 2.0 * log_force(row));
    add_scaled(all.amplitude, own.amplitude, moved);
    add_scaled(all.dissipation, own.dissipation, energy);
    add_scaled(all.amplitude_std, own.amplitude_std, moved);
    add_scaled(all.dissipation_std, own.dissipation_std, energy);
  }
  if (all.amplitude_std.size() < all.size()) all.amplitude_std.clear();
  if (all.dissipation_std.size() < all.size()) all.dissipation_std.clear();
  return all;
}

/// The levels with knots that continue above them.
ScaledLevels extended(const LevelEvidence& levels, double stiffness, double extension) {
  ScaledLevels scaled(levels, stiffness);
  const double square = extension * extension;
  scaled.largest_slip_force *= extension;
  scaled.energy *= square;
  scaled.amplitude /= extension;
  scaled.dissipation /= square;
  scaled.floor /= square;
  scaled.typical /= square;
  return scaled;
}

/// The data of one pass, which refer to each other.
struct Pass {
  LevelEvidence levels;
  ScaledLevels scaled;
  PassedModel passed;

  Pass(std::span<const Assembly> assemblies, const StiffnessOfAssemblies& stiffness,
       const Eigen::VectorXd& log_force, double extension, const InversionOptions& options)
      : levels(over_each_other(assemblies, stiffness.log_stiffness, log_force)),
        scaled(extended(levels, stiffness.middle, extension)),
        passed([&] {
          if (levels.size() < kFewestLevels) {
            throw InputError("number of different amplitudes of all assemblies",
                             static_cast<double>(levels.size()), "must be 4 or more",
                             "Measure more levels.");
          }
          InnerSolutions inner;
          return two_passes(scaled, options, 1.0, false, inner);
        }()) {}
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;
};

/// One Gauss–Newton step of ln S of an assembly alone.
double better_scale(const AssemblyModel& model, const Eigen::VectorXd& middle,
                    AssemblyDeviations all, Eigen::Index j, double scatter) {
  constexpr double kStep = 1e-3;
  double& log_force = all(j, model.force_column());
  const double before = log_force;
  const Eigen::VectorXd left =
      model.measured(j).dissipation - model.predicted(middle, all, j).dissipation;
  log_force += kStep;
  const Eigen::VectorXd slope =
      (model.measured(j).dissipation - model.predicted(middle, all, j).dissipation - left) / kStep;
  const double precision = scatter * scatter / (kScalePrior * kScalePrior);
  const double step = -(slope.dot(left) + precision * before) / (slope.squaredNorm() + precision);
  return before + std::clamp(step, -kMostStep, kMostStep);
}

std::vector<const LevelEvidence*> levels_of(std::span<const Assembly> assemblies) {
  std::vector<const LevelEvidence*> levels;
  for (const Assembly& one : assemblies) levels.push_back(&one.levels);
  return levels;
}

AssemblyModel model_of(std::span<const Assembly> assemblies, const StiffnessOfAssemblies& stiffness,
                       const Pass& pass, bool whole) {
  const bool sought = whole && stiffness.from == AssemblyStiffness::kSought;
  return {levels_of(assemblies), stiffness.log_stiffness, sought, pass.passed.model, whole};
}

/// Deviations of these scales and no shapes.
AssemblyDeviations deviations_of(const AssemblyModel& model, const StiffnessOfAssemblies& stiffness,
                                 const Eigen::VectorXd& log_force) {
  AssemblyDeviations all = AssemblyDeviations::Zero(model.assemblies(), model.columns());
  if (model.stiffness_sought()) all.col(0) = stiffness.log_stiffness;
  all.col(model.force_column()) = log_force;
  return all;
}

/// Assemblies of one joint do not differ by so much.
void check_scales(std::span<const Assembly> assemblies, const Eigen::VectorXd& log_force) {
  constexpr double kMostScale = 8.0;
  for (Eigen::Index j = 0; j < log_force.size(); ++j) {
    const double scale = std::exp(log_force(j));
    if (scale < kMostScale && scale * kMostScale > 1.0) continue;
    throw InputError(fmt::format("slip forces of assembly '{}' over those of all",
                                 assemblies[static_cast<std::size_t>(j)].name),
                     scale, "must be from 1/8 to 8: assemblies of one joint do not differ by more",
                     "Check units and k, or identify it separately.");
  }
}

/// ln S as if all D grew as A³, mean 0: a robust start, even with wrong units.
Eigen::VectorXd first_scales(std::span<const Assembly> assemblies,
                             const StiffnessOfAssemblies& stiffness) {
  Eigen::VectorXd log_force(std::ssize(assemblies));
  for (Eigen::Index j = 0; j < log_force.size(); ++j) {
    const Levels& levels = assemblies[static_cast<std::size_t>(j)].levels.levels();
    std::vector<double> all;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels.dissipation[i] == 0.0) continue;
      all.push_back(3.0 * std::log(levels.amplitude[i]) - std::log(levels.dissipation[i]));
    }
    if (all.empty()) {
      throw InputError(
          fmt::format("dissipation of assembly '{}'", assemblies[static_cast<std::size_t>(j)].name),
          "0 at all levels", "must be positive at one level at least");
    }
    log_force(j) = median(std::move(all)) + 2.0 * stiffness.log_stiffness(j);
  }
  return (log_force.array() - log_force.mean()).matrix();
}

/// ln S of all, mean 0.
Eigen::VectorXd find_scales(std::span<const Assembly> assemblies,
                            const StiffnessOfAssemblies& stiffness,
                            const InversionOptions& options) {
  Eigen::VectorXd log_force = first_scales(assemblies, stiffness);
  for (int i = 0; i < kMostPasses; ++i) {
    const Pass pass(assemblies, stiffness, log_force, kLeastExtension, options);
    AssemblyModel model = model_of(assemblies, stiffness, pass, false);
    const Eigen::VectorXd middle = model.middle(pass.passed.model.solution().solution.x);
    const AssemblyDeviations all = deviations_of(model, stiffness, log_force);
    model.set_weights(middle, all);
    Eigen::VectorXd better(log_force.size());
    for (Eigen::Index j = 0; j < better.size(); ++j) {
      better(j) = better_scale(model, middle, all, j, pass.passed.model.scatter);
    }
    better.array() -= better.mean();
    const double change = (better - log_force).cwiseAbs().maxCoeff();
    log_force = better;
    if (change < kScalesFound) break;
  }
  return log_force;
}

double extension_of(const Eigen::VectorXd& log_force) {
  const double deviation =
      std::sqrt(log_force.squaredNorm() / static_cast<double>(log_force.size() - 1));
  return std::clamp(std::exp(kExtendedDeviations * deviation), kLeastExtension, kMostExtension);
}

}  // namespace

StartOfAssemblies start_of_assemblies(std::span<const Assembly> assemblies,
                                      const StiffnessOfAssemblies& stiffness, int coefficients) {
  InversionOptions options;
  options.edges = false;
  options.coefficients = coefficients;
  const Eigen::VectorXd log_force = find_scales(assemblies, stiffness, options);
  check_scales(assemblies, log_force);
  const double extension = extension_of(log_force);
  const Pass pass(assemblies, stiffness, log_force, extension, options);
  const InversionModel& common = pass.passed.model;
  const SmoothingProblem& problem = common.problem();

  StartOfAssemblies found{.model = model_of(assemblies, stiffness, pass, true)};
  found.covered = 1.0 / extension;
  found.start.deviations = deviations_of(found.model, stiffness, log_force);
  const Eigen::VectorXd& x = common.solution().solution.x;
  found.model.set_weights(found.model.middle(x), found.start.deviations);

  const double scatter = std::max(common.scatter, 1e-6);  // levels without noise leave none
  const double of_unit = 1.0 / (scatter * scatter);
  found.start.target.penalty = problem.penalty();
  found.start.target.least_lambda = of_unit * common.path.back().lambda;
  found.start.target.most_lambda = of_unit * common.path.front().lambda;
  found.start.chain = {x, of_unit * common.solution().lambda, {scatter}};
  return found;
}

}  // namespace microslip
