// SPDX-License-Identifier: MIT
#include "microslip/identify/density_posterior.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/eigen_view.hpp"
#include "microslip/identify/quadratic_program.hpp"

namespace microslip {
namespace {

// See DensityPosterior::sample(): the share of λ that samples are smoothed with, and c.
constexpr double kSampleLambda = 1.0 / 8.0;
constexpr double kPriorNoise = 0.5;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMajor> matrix_of(const PlainMatrix& m) {
  return {m.values.data(), static_cast<Eigen::Index>(m.rows()),
          static_cast<Eigen::Index>(m.columns)};
}

constexpr std::string_view kUnchanged = "Take a posterior as invert() found it, unchanged.";

void check_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(fmt::format("number of values of {} in the posterior", what),
                   static_cast<double>(length), fmt::format("must be {}", expected),
                   std::string(kUnchanged));
}

void check_shape(std::string_view what, const PlainMatrix& m, std::size_t columns,
                 std::size_t rows) {
  check_length(fmt::format("a row of {}", what), m.columns, columns);
  check_length(what, m.values.size(), rows * columns);
}

/// Of any number of rows.
void check_columns(std::string_view what, const PlainMatrix& m, std::size_t columns) {
  check_shape(what, m, m.values.empty() ? m.columns : columns, m.rows());
}

/// The λ of one sample.
const PossibleSmoothing& draw_smoothing(const std::vector<PossibleSmoothing>& all, double uniform) {
  double total = 0.0;
  for (const PossibleSmoothing& one : all) total += one.weight;
  double left = uniform * total;
  for (const PossibleSmoothing& one : all) {
    left -= one.weight;
    if (left <= 0.0) return one;
  }
  return all.back();
}

/// Adds sRᵀε, ε ~ N(0, 1): what scatter s of the rows that R stands for makes of KᵀW²d.
void add_noise(const PlainMatrix& factor, double scatter, RandomStream& random,
               Eigen::VectorXd& linear) {
  if (factor.values.empty()) return;
  Eigen::VectorXd normal(static_cast<Eigen::Index>(factor.rows()));
  for (double& value : normal) value = scatter * random.normal();
  linear += matrix_of(factor).transpose() * normal;
}

/// With true D = e·D and true A = c·A, (7) holds for φ(f*) = e/c³ φ_found(f*/c).
void apply_gains(const std::vector<double>& knots, const CommonErrorDraw& draw,
                 DensitySample& sample) {
  const double e = draw.dissipation_gain;
  const double c = draw.amplitude_gain;
  if (e == 1.0 && c == 1.0) return;
  const std::vector<double> found = sample.density;
  for (std::size_t j = 0; j < knots.size(); ++j) {
    sample.density[j] = e / (c * c * c) * interpolate(knots, found, knots[j] / c);
  }
  sample.atom_weight *= e / (c * c);
  sample.linear_damping *= e / (c * c);
  sample.area = sample.atom_weight + integral(knots, sample.density);
  // More stiffness than k cannot slip: such gains are not possible with that much density.
  if (sample.area <= 1.0) return;
  for (double& value : sample.density) value /= sample.area;
  sample.atom_weight /= sample.area;
  sample.area = 1.0;
}

}  // namespace

void DensityPosterior::check() const {
  const std::size_t n = area.size();
  if (n == 0 || smoothing.empty() || slip_force.empty()) {
    throw InputError("posterior", "empty", "must be one that was found", std::string(kUnchanged));
  }
  check_shape("density", density, n, slip_force.size());
  check_length("linear_damping", linear_damping.size(), n);
  check_length("atom_weight", atom_weight.size(), n);
  check_shape("information", information, n, n);
  check_length("data", data.size(), n);
  check_columns("dissipation_factor", dissipation_factor, n);
  check_columns("secant_factor", secant_factor, n);
  check_columns("penalty", penalty, n);
  if (common_errors.loss_factor_std > 0.0) check_length("linear_loss", linear_loss.size(), n);
  for (const PossibleSmoothing& one : smoothing) {
    check_length("coefficients", one.coefficients.size(), n);
  }
  if (!(degrees_of_freedom > 0.0)) {
    throw InputError("degrees of freedom of the posterior", degrees_of_freedom, "must be positive",
                     std::string(kUnchanged));
  }
  common_errors.check();
}

DensitySample DensityPosterior::sample(std::uint64_t seed, std::size_t index) const {
  check();
  RandomStream random(seed, index);
  const PossibleSmoothing& drawn = draw_smoothing(smoothing, random.uniform());
  const double lambda = kSampleLambda * drawn.lambda;
  const boost::math::chi_squared chi_squared(degrees_of_freedom);
  const double share =
      std::sqrt(degrees_of_freedom / boost::math::quantile(chi_squared, random.uniform()));
  const CommonErrorDraw common = common_errors.draw(random);

  const Eigen::Map<const RowMajor> roughness = matrix_of(penalty);
  Eigen::VectorXd linear = view_of(data);
  add_noise(dissipation_factor, share * dissipation_scatter, random, linear);
  add_noise(secant_factor, share * secant_scatter, random, linear);
  add_noise(penalty, kPriorNoise * share * scatter * std::sqrt(lambda), random, linear);
  if (common.loss_factor != 0.0) linear += common.loss_factor * view_of(linear_loss);

  std::vector<bool> start;
  for (const double c : drawn.coefficients) start.push_back(c > 0.0);
  const Eigen::MatrixXd hessian =
      matrix_of(information) + lambda * (roughness.transpose() * roughness);
  QuadraticProgram program(view_of(area), 1.0);
  const QuadraticProgram::Solution solution = program.solve(hessian, linear, std::move(start));
  const Eigen::VectorXd& x = solution.x;

  DensitySample found;
  found.converged = solution.optimal();
  const Eigen::VectorXd at_knots = matrix_of(density) * x;
  found.density.assign(at_knots.begin(), at_knots.end());
  found.area = view_of(area).dot(x);
  found.linear_damping = view_of(linear_damping).dot(x);
  found.atom_weight = view_of(atom_weight).dot(x);
  apply_gains(slip_force, common, found);
  return found;
}

}  // namespace microslip
