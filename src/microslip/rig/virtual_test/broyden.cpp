// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/broyden.hpp"

#include <cmath>

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VectorXd parts(const VectorXcd& z) {
  VectorXd result(2 * z.size());
  result << z.real(), z.imag();
  return result;
}

}  // namespace

Broyden::Broyden(Index size) : inverse_(Eigen::MatrixXd::Identity(2 * size, 2 * size)) {}

VectorXcd Broyden::next(const VectorXcd& x, const VectorXcd& r) {
  const VectorXd x_now = parts(x);
  const VectorXd r_now = parts(r);
  if (x_.size() > 0) {
    const VectorXd step = x_now - x_;
    const VectorXd predicted = inverse_ * (r_now - r_);
    const Eigen::RowVectorXd row = step.transpose() * inverse_;
    const double denominator = step.dot(predicted);
    // Steps of rounding do not determine the derivative.
    constexpr double kLeast = 1e-3;
    if (std::abs(denominator) > kLeast * step.squaredNorm()) {
      inverse_ += (step - predicted) * row / denominator;
    }
  }
  x_ = x_now;
  r_ = r_now;
  const VectorXd change = inverse_ * r_now;
  const Index n = x.size();
  VectorXcd result = x;
  result.real() -= change.head(n);
  result.imag() -= change.tail(n);
  return result;
}

}  // namespace microslip
