// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/truncated_gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kQuarterPeriod = 0.5 * std::numbers::pi;
/// A limit just left is not met again at once: that would be rounding.
constexpr double kJustLeft = 1e-9;
/// Share of the budget that is left where x would use all of it.
constexpr double kLeftOfBudget = 1e-9;
/// Ridge on the diagonal of H where rounding makes it indefinite, and how often it is increased.
constexpr double kLeastRidge = 1e-14;
constexpr int kRidges = 8;

/// One step on circles: positions and velocities after a phase of cosine c and sine s.
void turn(double c, double s, Eigen::VectorXd& position, Eigen::VectorXd& velocity) {
  for (Eigen::Index i = 0; i < position.size(); ++i) {
    const double before = position(i);
    position(i) = c * before + s * velocity(i);
    velocity(i) = c * velocity(i) - s * before;
  }
}

}  // namespace

bool LinearLimits::hold(const Eigen::VectorXd& x) const {
  return x.head(positive).minCoeff() >= 0.0 && (budget_weights.transpose() * x).maxCoeff() <= 1.0;
}

Eigen::VectorXd LinearLimits::moved_inside(const Eigen::VectorXd& x,
                                           const Eigen::VectorXd& least) const {
  Eigen::VectorXd moved = x;
  moved.head(positive) = x.head(positive).cwiseMax(least.head(positive));
  const double used = (budget_weights.transpose() * moved).maxCoeff();
  if (used >= 1.0) moved.head(positive) *= (1.0 - kLeftOfBudget) / used;
  return moved;
}

void TruncatedGaussian::set(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear) {
  const double typical = hessian.trace() / static_cast<double>(hessian.rows());
  double ridge = 0.0;
  for (int i = 0; i <= kRidges; ++i) {
    factor_ = hessian;
    factor_.diagonal().array() += ridge;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(factor_);
    if (in_place.info() == Eigen::Success && std::isfinite(factor_.sum())) break;
    if (i == kRidges || !std::isfinite(typical)) {
      throw InputError("posterior", InputState{"without bounds"}, "must be that of finite numbers",
                       "Take a posterior as it was found, unchanged.");
    }
    ridge = i == 0 ? kLeastRidge * typical : 10.0 * ridge;
  }
  limits_set_ = false;
  half_ = factor_.triangularView<Eigen::Lower>().solve(linear);
  mean_ = factor_.triangularView<Eigen::Lower>().transpose().solve(half_);
}

double TruncatedGaussian::log_integral() const {
  return 0.5 * half_.squaredNorm() - factor_.diagonal().array().log().sum();
}

Eigen::VectorXd TruncatedGaussian::standard_deviation() const {
  const Eigen::Index n = mean_.size();
  const Eigen::MatrixXd inverse =
      factor_.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
  return inverse.colwise().norm().transpose();
}

Eigen::VectorXd TruncatedGaussian::standardised(const Eigen::VectorXd& x) const {
  return factor_.triangularView<Eigen::Lower>().transpose() * (x - mean_);
}

Eigen::VectorXd TruncatedGaussian::from_standardised(const Eigen::VectorXd& z) const {
  return mean_ + factor_.triangularView<Eigen::Lower>().transpose().solve(z);
}

void TruncatedGaussian::prepare_limits() {
  const Eigen::Index n = mean_.size();
  const Eigen::Index positive = limits_.positive;
  const Eigen::Index budgets =
      limits_.budget_weights.maxCoeff() > 0.0 ? limits_.budget_weights.cols() : 0;
  normals_.setZero(n, positive + budgets);
  normals_.leftCols(positive).diagonal().setOnes();
  normals_.rightCols(budgets) = -limits_.budget_weights.leftCols(budgets);
  factor_.triangularView<Eigen::Lower>().solveInPlace(normals_);
  offset_.resize(normals_.cols());
  offset_.head(positive) = mean_.head(positive);
  for (Eigen::Index b = 0; b < budgets; ++b) {
    offset_(positive + b) = 1.0 - limits_.budget_weights.col(b).dot(mean_);
  }
  const Eigen::VectorXd scale = normals_.colwise().norm().cwiseInverse();
  limits_set_ = true;
  normals_ *= scale.asDiagonal();
  offset_ = offset_.cwiseProduct(scale);
  cosines_.resize(offset_.size(), offset_.size());
  has_cosines_.assign(static_cast<std::size_t>(offset_.size()), false);
}

// A limit that a trajectory p cos t + v sin t + offset goes down through: at the phase where it is
// zero and falls. It falls no faster than by √(p² + v²).
TruncatedGaussian::Hit TruncatedGaussian::next_hit(double before, Eigen::Index last) const {
  Hit hit{before, -1};
  for (Eigen::Index j = 0; j < offset_.size(); ++j) {
    const double p = position_of_limits_(j);
    const double v = velocity_of_limits_(j);
    const double reach = std::sqrt(p * p + v * v);
    if (reach <= std::abs(offset_(j)) || p + offset_(j) > hit.time * reach) continue;
    double time = std::acos(-offset_(j) / reach) + std::atan2(v, p);
    // On the limit, and going out: before, by rounding, is now.
    if (time < 0.0) time = time > -kJustLeft ? 0.0 : time + 2.0 * std::numbers::pi;
    if (time >= hit.time || (j == last && time < kJustLeft)) continue;
    hit = {time, j};
  }
  return hit;
}

void TruncatedGaussian::reflect(Eigen::Index limit) {
  const double speed = 2.0 * velocity_of_limits_(limit);
  velocity_ -= speed * normals_.col(limit);
  std::vector<bool>::reference known = has_cosines_[static_cast<std::size_t>(limit)];
  if (!known) cosines_.col(limit).noalias() = normals_.transpose() * normals_.col(limit);
  known = true;
  velocity_of_limits_ -= speed * cosines_.col(limit);
}

void TruncatedGaussian::move(Eigen::VectorXd& x, RandomStream& random, int most_reflections) {
  if (!limits_set_) prepare_limits();
  reflections_.assign(static_cast<std::size_t>(offset_.size()), 0);
  position_ = standardised(x);
  velocity_.resize(position_.size());
  for (double& value : velocity_) value = random.normal();
  position_of_limits_.noalias() = normals_.transpose() * position_;
  velocity_of_limits_.noalias() = normals_.transpose() * velocity_;
  double left = kQuarterPeriod;
  Eigen::Index last = -1;
  for (int count = 0; count <= most_reflections; ++count) {
    const Hit hit = next_hit(left, last);
    const double c = std::cos(hit.time);
    const double s = std::sin(hit.time);
    turn(c, s, position_, velocity_);
    turn(c, s, position_of_limits_, velocity_of_limits_);
    if (hit.limit < 0) break;
    left -= hit.time;
    last = hit.limit;
    ++reflections_[static_cast<std::size_t>(last)];
    reflect(last);
  }
  x = from_standardised(position_);
  x.head(limits_.positive) = x.head(limits_.positive).cwiseMax(0.0);  // but for rounding
}

}  // namespace microslip
