// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior_chain.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <vector>

#include "microslip/identify/truncated_gaussian.hpp"

namespace microslip {
namespace {

/// Less probability than this between the ends of λ is rounding.
constexpr double kLeastRange = 1e-12;
/// No record is exact to more than this: data without noise leave no residual.
constexpr double kLeastScale = 1e-6;

}  // namespace

PosteriorChain::PosteriorChain(const SmoothingProblem& problem, double lambda,
                               const Eigen::VectorXd& start)
    : problem_(problem),
      information_(problem.hessian(0.0)),
      roughness_(problem.penalty().transpose() * problem.penalty()),
      lambda_(lambda),
      x_(start) {
  const std::vector<double> ends = problem.lambda_grid(2);
  least_lambda_ = std::min(ends.back(), lambda);
  most_lambda_ = std::max(ends.front(), lambda);
}

// λ | x ~ Gamma(r/2) of rate ½‖Lx‖², between its ends.
void PosteriorChain::draw_lambda(RandomStream& random) {
  const double shape = 0.5 * static_cast<double>(problem_.penalty().rows());
  const double rate = 0.5 * std::max((problem_.penalty() * x_).squaredNorm(), 1e-300);
  const double below = boost::math::gamma_p(shape, rate * least_lambda_);
  const double above = boost::math::gamma_p(shape, rate * most_lambda_);
  const double uniform = random.uniform();
  if (above - below < kLeastRange) {
    lambda_ = rate * least_lambda_ > shape ? least_lambda_ : most_lambda_;
    return;
  }
  const double drawn = boost::math::gamma_p_inv(shape, below + uniform * (above - below));
  lambda_ = std::clamp(drawn / rate, least_lambda_, most_lambda_);
}

// τ² | x ~ ‖Dx − d‖²/χ²_m.
void PosteriorChain::draw_scale(RandomStream& random) {
  const double residual = (problem_.data() - problem_.design() * x_).squaredNorm();
  const boost::math::chi_squared chi_squared(static_cast<double>(problem_.rows()));
  const double drawn = boost::math::quantile(chi_squared, random.uniform());
  scale_ = std::max(kLeastScale, std::sqrt(residual / drawn));
}

const Eigen::VectorXd& PosteriorChain::next(RandomStream& random) {
  const double precision = 1.0 / (scale_ * scale_);
  TruncatedGaussian given(precision * information_ + lambda_ * roughness_,
                          precision * problem_.linear(), problem_.area(), x_);
  x_ = given.next(random);
  draw_lambda(random);
  draw_scale(random);
  return x_;
}

}  // namespace microslip
