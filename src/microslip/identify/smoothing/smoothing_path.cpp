// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/smoothing_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/algebra/eigenvalues.hpp"

namespace microslip {
namespace {

constexpr double kGcvInflation = 1.4;
constexpr double kLikelihoodGuard = 1.0;
/// Smaller shares of the data in an eigenvector are rounding. Equally spaced levels leave the
/// lowest coefficients without any: a path that continued until these count would end anywhere.
constexpr double kLeastShare = 1e-12;
constexpr double kMostDetermined = 0.97;
constexpr double kMostSupported = 0.85;

/// log10 of the λ at which a falling function reaches a target.
template <typename Function>
double bisect_log10(const Function& falling, double target) {
  double low = -40.0;
  double high = 40.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (falling(std::pow(10.0, middle)) > target ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double log_determinant(const Eigen::MatrixXd& positive) {
  return 2.0 * positive.llt().matrixLLT().diagonal().array().log().sum();
}

}  // namespace

SmoothingProblem::SmoothingProblem(Eigen::MatrixXd design, Eigen::VectorXd data,
                                   Eigen::MatrixXd penalty, Eigen::VectorXd area,
                                   Eigen::Index unpenalised, KnownScatter known)
    : design_(std::move(design)),
      data_(std::move(data)),
      penalty_(std::move(penalty)),
      area_(std::move(area)),
      unpenalised_(unpenalised),
      known_(known) {
  normal_ = design_.transpose() * design_;
  roughness_ = penalty_.transpose() * penalty_;
  linear_ = design_.transpose() * data_;

  log_penalty_ = log_determinant(penalty_ * penalty_.transpose());
  normal_ridged_ = normal_;
  normal_ridged_.diagonal().array() += 1e-13 * normal_.trace() / static_cast<double>(size());
}

// With B = A + tQ both A = WKᵀWK and Q = LᵀL are diagonal in the generalised eigenvectors of (Q,
// B): Q ~ γ, A ~ 1 − tγ. B is better conditioned than either.
SmoothingProblem::Spectrum SmoothingProblem::find_spectrum() const {
  const double balance = normal_.trace() / roughness_.trace();
  Eigen::MatrixXd sum = normal_ + balance * roughness_;
  sum.diagonal().array() += 1e-14 * sum.trace() / static_cast<double>(size());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      roughness_, sum, Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  Spectrum found;
  found.data = (1.0 - balance * eigen.eigenvalues().array()).min(1.0);
  found.data = (found.data < kLeastShare).select(0.0, found.data);
  found.penalty = eigen.eigenvalues().array().max(0.0);
  found.penalty.head(unpenalised_).setZero();
  return found;
}

const SmoothingProblem::Spectrum& SmoothingProblem::spectrum() const {
  std::call_once(spectrum_->found, [this] { spectrum_->value = find_spectrum(); });
  return spectrum_->value;
}

Eigen::MatrixXd SmoothingProblem::hessian(double lambda) const {
  return normal_ridged_ + lambda * roughness_;
}

double SmoothingProblem::unconstrained_edf(double lambda) const {
  const Spectrum& shares = spectrum();
  return (shares.data / (shares.data + lambda * shares.penalty + 1e-300)).sum();
}

std::vector<double> SmoothingProblem::lambda_grid(std::size_t count) const {
  const auto edf = [this](double lambda) { return unconstrained_edf(lambda); };
  const auto q = static_cast<double>(unpenalised_);
  const auto determined = static_cast<double>((spectrum().data > 0.0).count());
  const double supported =
      std::min(static_cast<double>(rows()) + known_.freedom, static_cast<double>(size()));
  const double most = std::min(kMostSupported * supported, kMostDetermined * determined);
  const double stiff = bisect_log10(edf, q + 0.03);
  const double flexible = bisect_log10(edf, std::max(q + 0.5, most));
  std::vector<double> lambdas(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share =
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, count - 1));
    lambdas[i] = std::pow(10.0, stiff + (flexible - stiff) * share);
  }
  return lambdas;
}

// tr(H⁻¹A) on the free coefficients as their number less λ tr(H⁻¹Q), H = A + λQ. An active area
// limit takes one direction away.
double SmoothingProblem::free_edf(const QuadraticProgram::Solution& solution,
                                  const Eigen::MatrixXd& hessian, double lambda) const {
  const std::vector<Eigen::Index> index = free_coefficients(solution);
  if (index.empty()) return 0.0;
  Eigen::MatrixXd reduced = hessian(index, index);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(reduced);
  Eigen::MatrixXd columns = penalty_(Eigen::all, index).transpose();
  factor.matrixL().solveInPlace(columns);
  double edf = static_cast<double>(index.size()) - lambda * columns.squaredNorm();
  if (solution.multiplier > 0.0) {
    const Eigen::VectorXd area = area_(index);
    const Eigen::VectorXd direction = factor.solve(area);
    const double along = direction.dot(normal_(index, index) * direction);
    edf -= along / area.dot(direction);
  }
  return edf;
}

Eigen::VectorXd SmoothingProblem::leverage(const SmoothingPoint& point) const {
  const std::vector<Eigen::Index> index = free_coefficients(point.solution);
  if (index.empty()) return Eigen::VectorXd::Zero(rows());
  const Eigen::MatrixXd reduced = hessian(point.lambda)(index, index);
  const Eigen::LLT<Eigen::MatrixXd> factor(reduced);
  const Eigen::MatrixXd design = design_(Eigen::all, index);
  const Eigen::MatrixXd whitened = factor.matrixL().solve(design.transpose());
  Eigen::VectorXd result = whitened.colwise().squaredNorm().transpose();
  if (point.solution.multiplier > 0.0) {  // as in free_edf()
    const Eigen::VectorXd area = area_(index);
    const Eigen::VectorXd direction = factor.solve(area);
    result -= (design * direction).cwiseAbs2() / area.dot(direction);
  }
  return result;
}

// Residual, roughness and the criteria of the rules; edf must be set.
void SmoothingProblem::score(SmoothingPoint& point) const {
  const Eigen::VectorXd& x = point.solution.x;
  // Data without noise leave no residual; its logarithm must stay finite.
  point.residual = std::max((data_ - design_ * x).squaredNorm(), 1e-20 * data_.squaredNorm());
  point.roughness = (penalty_ * x).squaredNorm();
  const auto m = static_cast<double>(rows()) + known_.freedom;
  const double freedom = m - kGcvInflation * point.edf;
  point.gcv = freedom > 0.0 ? m * (point.residual + known_.square) / (freedom * freedom)
                            : std::numeric_limits<double>::infinity();
}

double SmoothingProblem::likelihood(const SmoothingPoint& point) const {
  const Spectrum& shares = spectrum();
  const auto m = static_cast<double>(rows()) + known_.freedom;
  const auto q = static_cast<double>(unpenalised_);
  return (m - q) * std::log(point.residual + known_.square + point.lambda * point.roughness) +
         (shares.data + point.lambda * shares.penalty + 1e-300).log().sum() -
         (static_cast<double>(size()) - q) * std::log(point.lambda);
}

double SmoothingProblem::log_volume(double lambda, const Eigen::VectorXd& precision) const {
  Eigen::MatrixXd sum = hessian(lambda);
  sum.diagonal() += precision;
  return log_determinant(sum) - log_penalty_ -
         static_cast<double>(penalty_.rows()) * std::log(lambda);
}

SmoothingPoint SmoothingProblem::solve(double lambda, std::vector<bool> start) const {
  SmoothingPoint point;
  point.lambda = lambda;
  const Eigen::MatrixXd h = hessian(lambda);
  QuadraticProgram program(area_, 1.0);
  point.solution = program.solve(h, linear_, std::move(start));
  point.edf = free_edf(point.solution, h, lambda);
  score(point);
  return point;
}

SmoothingPoint SmoothingProblem::solve_unlimited(double lambda) const {
  SmoothingPoint point;
  point.lambda = lambda;
  point.solution.x = hessian(lambda).llt().solve(linear_);
  point.solution.free.assign(static_cast<std::size_t>(size()), true);
  point.edf = unconstrained_edf(lambda);
  score(point);
  point.likelihood = likelihood(point);
  return point;
}

std::vector<SmoothingPoint> SmoothingProblem::path(const std::vector<double>& lambdas) const {
  std::vector<SmoothingPoint> points;
  points.reserve(lambdas.size());
  std::vector<bool> start(static_cast<std::size_t>(size()), true);
  for (const double lambda : lambdas) {
    points.push_back(solve(lambda, start));
    points.back().likelihood = likelihood(points.back());
    start = points.back().solution.free;
  }
  return points;
}

double SmoothingProblem::most_edf() const {
  const double m = static_cast<double>(rows()) + known_.freedom;
  return std::max(static_cast<double>(unpenalised_) + 0.2, std::min(0.7 * m, m - 3.0));
}

std::size_t choose(const std::vector<SmoothingPoint>& path, SmoothingRule rule,
                   const SmoothingBounds& bounds) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto best_of = [&](const auto& score) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (score(path[i]) < score(path[best])) best = i;
    }
    return best;
  };
  const std::size_t likeliest = best_of(
      [&](const SmoothingPoint& point) { return bounds.hold(point) ? point.likelihood : kNever; });
  if (rule == SmoothingRule::kReml) return likeliest;
  const double bound = path[likeliest].likelihood + kLikelihoodGuard;
  return best_of([&](const SmoothingPoint& point) {
    return bounds.hold(point) && point.likelihood <= bound ? point.gcv : kNever;
  });
}

}  // namespace microslip
