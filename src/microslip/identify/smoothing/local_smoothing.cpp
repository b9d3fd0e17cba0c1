// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/local_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

constexpr Eigen::Index kNodes = 10;
/// Neighbouring slices are correlated; they cost little compared with a draw of the coefficients.
constexpr int kSlices = 3;
constexpr double kCircle = 2.0 * std::numbers::pi;

}  // namespace

LocalSmoothing::LocalSmoothing(Eigen::Index rows, double deviation)
    : deviation_(deviation), factors_(Eigen::VectorXd::Ones(rows)) {
  if (deviation == 0.0 || rows < 2) return;
  const Eigen::Index count = std::min(kNodes, rows);
  nodes_.setZero(count);
  interpolation_.setZero(rows, count);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double at =
        static_cast<double>(i) / static_cast<double>(rows - 1) * static_cast<double>(count - 1);
    const Eigen::Index left = std::min(static_cast<Eigen::Index>(at), count - 2);
    interpolation_(i, left + 1) = at - static_cast<double>(left);
    interpolation_(i, left) = 1.0 - interpolation_(i, left + 1);
  }
  interpolation_.rowwise() -= interpolation_.colwise().mean().eval();
}

double LocalSmoothing::log_likelihood(const Eigen::VectorXd& nodes,
                                      const Eigen::VectorXd& squares) const {
  const Eigen::ArrayXd logarithm = (interpolation_ * nodes).array();
  return 0.5 * (logarithm - logarithm.exp() * squares.array()).sum();
}

void LocalSmoothing::set(const Eigen::VectorXd& nodes) {
  nodes_ = nodes;
  factors_ = (interpolation_ * nodes_).array().exp().matrix();
}

LocalSmoothing LocalSmoothing::proposed(RandomStream& random) const {
  LocalSmoothing other = *this;
  const double angle = 0.25 * kCircle * std::pow(random.uniform(), 2);
  Eigen::VectorXd nodes = std::cos(angle) * nodes_;
  for (double& value : nodes) value += std::sin(angle) * deviation_ * random.normal();
  other.set(nodes);
  return other;
}

void LocalSmoothing::draw(const Eigen::VectorXd& squares, RandomStream& random) {
  if (!varies()) return;
  for (int i = 0; i < kSlices; ++i) {
    Eigen::VectorXd other(nodes_.size());
    for (double& value : other) value = deviation_ * random.normal();
    const double height = log_likelihood(nodes_, squares) + std::log(random.uniform());
    double angle = kCircle * random.uniform();
    double low = angle - kCircle;
    double high = angle;
    while (true) {  // it ends at the nodes themselves, at an angle of 0
      const Eigen::VectorXd tried = std::cos(angle) * nodes_ + std::sin(angle) * other;
      if (log_likelihood(tried, squares) > height || high - low < 1e-12) {
        set(tried);
        break;
      }
      (angle < 0.0 ? low : high) = angle;
      angle = low + (high - low) * random.uniform();
    }
  }
}

}  // namespace microslip
