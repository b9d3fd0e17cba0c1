// SPDX-License-Identifier: MIT
#include "microslip/identify/bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/check_result.hpp"
#include "microslip/identify/inversion_model.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestSamples = 20;
// See sample_density(): the share of λ that samples are smoothed with, and c.
constexpr double kSampleLambda = 1.0 / 8.0;
constexpr double kPriorNoise = 0.5;

void check_options(const BandOptions& options) {
  if (options.samples < kFewestSamples) {
    throw InputError("number of band samples", static_cast<double>(options.samples),
                     "must be 20 or more", "1000 give smooth bands.");
  }
  if (!(options.confidence > 0.0 && options.confidence < 1.0)) {
    throw InputError("confidence", options.confidence, "must be between 0 and 1");
  }
}

/// What a sample needs.
void check_errors(const InversionResult& result, const BandOptions& options) {
  check_result(result);
  const auto check_gain = [](std::string_view name, double value) {
    if (!(std::isfinite(value) && value >= 0.0 && value < 0.3)) {
      throw InputError(name, value, "must be a relative standard deviation from 0 to 0.3");
    }
  };
  check_gain("dissipation_gain_std", options.dissipation_gain_std);
  check_gain("amplitude_gain_std", options.amplitude_gain_std);
  check_gain("loss_factor_std", options.loss_factor_std);
  if (options.loss_factor_std == 0.0) return;
  const std::vector<double>& loss = result.levels.linear_dissipation;
  if (loss.empty()) {
    throw InputError("loss_factor_std", options.loss_factor_std,
                     "needs the linear loss of the levels, linear_dissipation",
                     "`microslip reduce` writes it.");
  }
  if (loss.size() == result.levels.size()) return;
  throw InputError("number of linear_dissipation", static_cast<double>(loss.size()),
                   fmt::format("must be {}, one a level", result.levels.size()));
}

/// The λ of one sample: drawn with its likelihood over the path, within the guard.
const SmoothingPoint& draw_point(const InversionModel& model, double uniform) {
  if (model.lambda_fixed) return model.solution();
  double lowest = model.solution().likelihood;
  for (const SmoothingPoint& point : model.path) {
    if (point.edf <= model.most_edf) lowest = std::min(lowest, point.likelihood);
  }
  const auto weight = [&](const SmoothingPoint& point) {
    return point.edf <= model.most_edf ? std::exp(-0.5 * (point.likelihood - lowest)) : 0.0;
  };
  double total = 0.0;
  for (const SmoothingPoint& point : model.path) total += weight(point);
  double left = uniform * total;
  for (const SmoothingPoint& point : model.path) {
    left -= weight(point);
    if (left <= 0.0) return point;
  }
  return model.solution();
}

/// With true D = e·D and true A = c·A, (7) holds for φ(f*) = e/c³ φ_found(f*/c).
void apply_gains(const std::vector<double>& knots, double e, double c, DensitySample& sample) {
  if (e == 1.0 && c == 1.0) return;
  const std::vector<double> found = sample.density;
  for (std::size_t j = 0; j < knots.size(); ++j) {
    sample.density[j] = e / (c * c * c) * interpolate(knots, found, knots[j] / c);
  }
  sample.atom_weight *= e / (c * c);
  sample.linear_damping *= e / (c * c);
  sample.area = sample.atom_weight;
  for (std::size_t j = 1; j < knots.size(); ++j) {
    sample.area += 0.5 * (knots[j] - knots[j - 1]) * (sample.density[j] + sample.density[j - 1]);
  }
  // More stiffness than k cannot slip: such gains are not possible with that much density.
  if (sample.area <= 1.0) return;
  for (double& value : sample.density) value /= sample.area;
  sample.atom_weight /= sample.area;
  sample.area = 1.0;
}

std::pair<double, double> quantiles(std::vector<double>& values, double confidence) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const double position = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(position);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (position - static_cast<double>(low)) * (values[high] - values[low]);
  };
  return {at(0.5 * (1.0 - confidence)), at(0.5 * (1.0 + confidence))};
}

/// Of the data of a sample, in units of W: the scatter of each kind of rows, and what a loss factor
/// wrong by the share δ does to D.
Eigen::VectorXd data_noise(const InversionResult& result, double scatter, double delta,
                           Eigen::VectorXd normal) {
  const InversionModel& model = *result.model;
  const Eigen::Index n = model.dissipation_rows();
  const double softening = std::max(model.softening_scatter, model.least_softening_scatter);
  normal.head(n) *= scatter * model.dissipation_scatter;
  normal.tail(normal.size() - n) *= scatter * softening;
  if (delta == 0.0) return normal;
  const double energy = model.largest_slip_force() * result.levels.amplitude.back();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double loss = result.levels.linear_dissipation[static_cast<std::size_t>(i)];
    normal(i) += delta * loss / energy * model.dissipation_weights()(i);
  }
  return normal;
}

}  // namespace

DensitySample sample_density(const InversionResult& result, const BandOptions& options,
                             std::size_t index) {
  check_errors(result, options);
  const InversionModel& model = *result.model;
  const SmoothingProblem& problem = model.problem();
  RandomStream random(options.seed, index);

  const SmoothingPoint& point = draw_point(model, random.uniform());
  const double lambda = kSampleLambda * point.lambda;
  const boost::math::chi_squared chi_squared(model.degrees_of_freedom);
  const double s = model.scatter * std::sqrt(model.degrees_of_freedom /
                                             boost::math::quantile(chi_squared, random.uniform()));
  Eigen::VectorXd normal(problem.rows());
  for (double& value : normal) value = random.normal();
  Eigen::VectorXd prior_noise(problem.penalty().rows());
  for (double& value : prior_noise) value = random.normal();
  const double dissipation_gain = 1.0 + options.dissipation_gain_std * random.normal();
  const double amplitude_gain = 1.0 + options.amplitude_gain_std * random.normal();
  const double delta = options.loss_factor_std * random.normal();
  const Eigen::VectorXd linear =
      problem.linear() +
      problem.design().transpose() * data_noise(result, s, delta, std::move(normal)) +
      kPriorNoise * s * std::sqrt(lambda) * (problem.penalty().transpose() * prior_noise);

  QuadraticProgram program(problem.area(), 1.0);
  const QuadraticProgram::Solution solution =
      program.solve(problem.hessian(lambda), linear, point.solution.free);
  const Eigen::VectorXd& x = solution.x;

  DensitySample sample;
  sample.converged = solution.optimal();
  const Eigen::VectorXd density = model.density(x);
  sample.density.push_back(density(0));
  sample.density.insert(sample.density.end(), density.begin(), density.end());
  sample.area = problem.area().dot(x);
  sample.linear_damping = model.linear_damping(x) * model.stiffness();
  sample.atom_weight = model.atom_weight(x);
  apply_gains(result.slip_force, std::max(0.0, dissipation_gain), std::max(0.1, amplitude_gain),
              sample);
  return sample;
}

DensityBands density_bands(const InversionResult& result, const BandOptions& options) {
  check_options(options);
  check_errors(result, options);
  std::vector<DensitySample> samples(options.samples);
  options.execution.for_each(
      options.samples, [&](std::size_t i) { samples[i] = sample_density(result, options, i); },
      options.progress);

  DensityBands bands;
  bands.confidence = options.confidence;
  bands.samples = options.samples;
  bands.not_converged =
      static_cast<std::size_t>(std::ranges::count(samples, false, &DensitySample::converged));
  std::vector<double> values(samples.size());
  const auto quantiles_of = [&](const auto& read) {
    std::ranges::transform(samples, values.begin(), read);
    return quantiles(values, options.confidence);
  };
  for (std::size_t j = 0; j < result.slip_force.size(); ++j) {
    const auto [lower, upper] =
        quantiles_of([j](const DensitySample& sample) { return sample.density[j]; });
    // Where φ ≥ 0 or the smoothing acts, nearly all samples may lie on one side of the estimate.
    bands.lower.push_back(std::min(lower, result.density[j]));
    bands.upper.push_back(std::max(upper, result.density[j]));
  }
  bands.area = quantiles_of([](const DensitySample& sample) { return sample.area; });
  bands.linear_damping =
      quantiles_of([](const DensitySample& sample) { return sample.linear_damping; });
  bands.atom_weight = quantiles_of([](const DensitySample& sample) { return sample.atom_weight; });
  return bands;
}

}  // namespace microslip
