// SPDX-License-Identifier: MIT
#include "microslip/identify/truncated_gaussian.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr double kQuarterPeriod = 0.5 * std::numbers::pi;
/// How far inside of its limit a coefficient starts that lies on it, in standard deviations without
/// the limits.
constexpr double kInside = 1e-3;
/// A limit just left is not met again at once: that would be rounding.
constexpr double kJustLeft = 1e-9;
/// Where the mean lies far beyond many limits a trajectory meets them a hundred thousand times: it
/// ends after so many, wherever it is.
constexpr int kMostReflections = 1000;

}  // namespace

TruncatedGaussian::TruncatedGaussian(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& linear,
                                     const Eigen::VectorXd& budget_weights,
                                     const Eigen::VectorXd& start) {
  const Eigen::Index n = linear.size();
  const Eigen::LLT<Eigen::MatrixXd> factor(hessian);
  mean_ = factor.solve(linear);
  from_standard_ = factor.matrixU().solve(Eigen::MatrixXd::Identity(n, n));
  const bool budget = budget_weights.maxCoeff() > 0.0;
  limits_.resize(n + (budget ? 1 : 0), n);
  offset_.resize(limits_.rows());
  limits_.topRows(n) = from_standard_;
  offset_.head(n) = mean_;
  if (budget) {
    limits_.row(n) = -budget_weights.transpose() * from_standard_;
    offset_(n) = 1.0 - budget_weights.dot(mean_);
  }
  // Each limit in its own standard deviations.
  const Eigen::VectorXd deviation = limits_.rowwise().norm();
  limits_ = deviation.cwiseInverse().asDiagonal() * limits_;
  offset_ = offset_.cwiseQuotient(deviation);
  gram_ = limits_ * limits_.transpose();

  Eigen::VectorXd x = start.cwiseMax(kInside * deviation.head(n));
  if (budget) {
    const double used = budget_weights.dot(x);
    if (used >= 1.0) x *= (1.0 - 1e-9) / used;
  }
  position_ = factor.matrixU() * (x - mean_);
  x_ = x;
}

// A limit that a trajectory p cos t + v sin t + offset goes down through: at the phase where it is
// zero and falls.
TruncatedGaussian::Hit TruncatedGaussian::next_hit(double before, Eigen::Index last) const {
  Hit hit{before, -1};
  for (Eigen::Index j = 0; j < offset_.size(); ++j) {
    const double p = position_of_limits_(j);
    const double v = velocity_of_limits_(j);
    const double reach = std::hypot(p, v);
    if (reach <= std::abs(offset_(j))) continue;
    double time = std::acos(-offset_(j) / reach) + std::atan2(v, p);
    if (time < 0.0) time += 2.0 * std::numbers::pi;
    if (time >= hit.time || (j == last && time < kJustLeft)) continue;
    hit = {time, j};
  }
  return hit;
}

const Eigen::VectorXd& TruncatedGaussian::next(RandomStream& random) {
  velocity_.resize(position_.size());
  for (double& value : velocity_) value = random.normal();
  position_of_limits_ = limits_ * position_;
  velocity_of_limits_ = limits_ * velocity_;
  double left = kQuarterPeriod;
  Eigen::Index last = -1;
  for (int count = 0; count <= kMostReflections; ++count) {
    const Hit hit = next_hit(left, last);
    const double c = std::cos(hit.time);
    const double s = std::sin(hit.time);
    const Eigen::VectorXd moved = c * position_ + s * velocity_;
    velocity_ = c * velocity_ - s * position_;
    position_ = moved;
    const Eigen::VectorXd moved_limits = c * position_of_limits_ + s * velocity_of_limits_;
    velocity_of_limits_ = c * velocity_of_limits_ - s * position_of_limits_;
    position_of_limits_ = moved_limits;
    if (hit.limit < 0) break;
    left -= hit.time;
    last = hit.limit;
    const double speed = 2.0 * velocity_of_limits_(last);
    velocity_ -= speed * limits_.row(last).transpose();
    velocity_of_limits_ -= speed * gram_.col(last);
  }
  x_ = mean_ + from_standard_ * position_;
  return x_;
}

}  // namespace microslip
