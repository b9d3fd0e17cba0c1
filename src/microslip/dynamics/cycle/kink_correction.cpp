// SPDX-License-Identifier: MIT
#include "microslip/dynamics/cycle/kink_correction.hpp"

#include <cmath>
#include <numbers>

#include "microslip/dynamics/cycle/trigonometric_basis.hpp"

namespace microslip {
namespace {

using Eigen::Ref;
using Eigen::VectorXd;

/// Bernoulli polynomials.
double bernoulli1(double t) { return t - 0.5; }
double bernoulli2(double t) { return t * (t - 1.0) + 1.0 / 6.0; }
double bernoulli3(double t) { return t * (t - 0.5) * (t - 1.0); }

}  // namespace

KinkCorrection::KinkCorrection(std::size_t harmonics, std::size_t samples)
    : step_(2.0 * std::numbers::pi / static_cast<double>(samples)),
      row_(coefficient_count(harmonics)),
      slope_(coefficient_count(harmonics)),
      sums_(coefficient_count(harmonics)),
      derivatives_(coefficient_count(harmonics), coefficient_count(harmonics)) {}

void KinkCorrection::reset(std::span<const double> coefficients, Wave wave) {
  coefficients_ = coefficients;
  wave_ = wave;
  sums_.setZero();
  derivatives_.setZero();
}

void KinkCorrection::add_turn(double tau, Eigen::Index next, double acceleration,
                              const Ref<const VectorXd>& row, double jump) {
  const double theta = tau / step_ - static_cast<double>(next - 1);
  derivative_of_basis(row, slope_);
  const double third = step_ * step_ / 6.0 * jump * acceleration * bernoulli3(theta);
  const double second = 0.5 * step_ * jump * bernoulli2(theta);
  for (Eigen::Index j = 0; j < row.size(); ++j) {
    sums_[j] -= third * row[j];
    const double factor = second * slope_[j];
    for (Eigen::Index i = 0; i < row.size(); ++i) derivatives_(i, j) += factor * row[i];
  }
}

void KinkCorrection::add_kink(double tau, double jump, const Ref<const VectorXd>& reference,
                              const Ref<const VectorXd>& gradient) {
  const double theta = tau / step_ - std::floor(tau / step_);
  const Motion motion = motion_at(coefficients_, tau, wave_);
  basis_at(tau, row_);
  derivative_of_basis(row_, slope_);
  const double second = 0.5 * step_ * bernoulli2(theta);
  const double third = step_ * step_ / 6.0 * bernoulli3(theta);
  sums_ += jump * ((second * motion.velocity - third * motion.acceleration) * row_ -
                   (2.0 * third * motion.velocity) * slope_);
  const auto moved = row_ - reference;
  derivatives_.noalias() +=
      (second * jump * slope_ - bernoulli1(theta) * jump * row_) * moved.transpose();
  derivatives_.noalias() +=
      second * row_ * (jump * slope_ + motion.velocity * gradient).transpose();
}

}  // namespace microslip
