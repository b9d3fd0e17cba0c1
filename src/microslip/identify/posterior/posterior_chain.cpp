// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/posterior_chain.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/identify/posterior/chi_squared.hpp"

namespace microslip {
namespace {

/// Less probability than this between the ends of λ is rounding.
constexpr double kLeastRange = 1e-12;
/// No data are exact to more than this: those without noise leave no residual.
constexpr double kLeastScale = 1e-6;
/// Added to DᵀD over its mean diagonal: rounding.
constexpr double kRidge = 1e-13;
/// How far inside of its limit a coefficient starts that lies on it, in standard deviations given
/// all others.
constexpr double kInside = 1e-3;
constexpr int kSettling = 100;
constexpr int kStepsOfDraw = 3;
/// While the chain settles: a trajectory of more reflections than the first is watched, ends at the
/// second, and a coefficient that has more than the third is kept near its value, to half of its
/// deviation.
constexpr int kManyReflections = 60;
constexpr int kMostReflections = 300;
constexpr int kManyOfOne = 8;

}  // namespace

PosteriorChain::PosteriorChain(const ChainTarget& target, ChainStart start)
    : target_(target),
      nearness_(Eigen::VectorXd::Zero(start.x.size())),
      scale_(std::move(start.scale)),
      x_(std::move(start.x)),
      gaussian_(target.limits),
      moved_(target.limits) {
  for (std::size_t g = 0; g < target.rows.size(); ++g) {
    scale_[g] = std::max({scale_[g], target.rows[g].least_scale, kLeastScale});
  }
  read_rows();
  for (const auto& row : target.penalty.rowwise()) {
    std::vector<Eigen::Index>& columns = penalised_.emplace_back();
    for (Eigen::Index j = 0; j < row.size(); ++j) {
      if (row(j) != 0.0) columns.push_back(j);
    }
  }
  std::vector<ChainBlock> blocks = target.blocks;
  if (blocks.empty()) {
    blocks.push_back({target.penalty.rows(), target.least_lambda, target.most_lambda});
  }
  Eigen::Index begin = 0;
  for (const ChainBlock& block : blocks) {
    const double lambda = std::clamp(start.lambda, block.least_lambda, block.most_lambda);
    const bool varies = block.most_lambda > block.least_lambda;
    Smoothing& smoothing = smoothing_.emplace_back(
        Smoothing{begin, block, lambda, {block.rows, varies ? target.local_deviation : 0.0}, {}});
    smoothing.roughness = roughness(smoothing, smoothing.local);
    begin += block.rows;
  }
  hessian_.setZero(x_.size(), x_.size());
  for (std::size_t g = 0; g < scale_.size(); ++g) {
    hessian_ += information_[g] / (scale_[g] * scale_[g]);
  }
  const Eigen::VectorXd given_others = whole_hessian().diagonal().cwiseSqrt().cwiseInverse();
  x_ = target.limits.moved_inside(x_, kInside * given_others);
}

void PosteriorChain::read_rows() {
  information_.clear();
  for (const ChainRows& rows : target_.rows) {
    Eigen::MatrixXd& information = information_.emplace_back(rows.design.transpose() * rows.design);
    if (!rows.scale_known) {
      information.diagonal().array() += kRidge * information.diagonal().mean();
    }
  }
  set_error(0.0);
}

void PosteriorChain::renew() {
  read_rows();
  gaussian_.set_limits(target_.limits);
  moved_.set_limits(target_.limits);
}

// All but the smoothing, with a ~ N(x, w²) near coefficients that need it.
void PosteriorChain::gather_data(RandomStream& random) {
  hessian_ = nearness_.asDiagonal();
  linear_.setZero(x_.size());
  for (Eigen::Index j = 0; j < x_.size(); ++j) {
    if (nearness_(j) > 0.0) {
      linear_(j) = nearness_(j) * x_(j) + std::sqrt(nearness_(j)) * random.normal();
    }
  }
  add_data(hessian_, linear_);
}

void PosteriorChain::add_data(Eigen::MatrixXd& hessian, Eigen::VectorXd& linear) const {
  for (std::size_t g = 0; g < scale_.size(); ++g) {
    const double precision = 1.0 / (scale_[g] * scale_[g]);
    hessian += precision * information_[g];
    linear += precision * projected_[g];
  }
}

// Without limits p(λ, l, x) = p(λ, l) N(x | λ, l), and at the same z any λ and l have the
// probability p(λ, l), which is the integral over x.
bool PosteriorChain::moves_along(double log_ratio, RandomStream& random) {
  const double uniform = random.uniform();
  const Eigen::VectorXd x = moved_.from_standardised(gaussian_.standardised(x_));
  if (!target_.limits.hold(x)) return false;
  log_ratio += moved_.log_integral() - gaussian_.log_integral();
  if (std::log(uniform) >= log_ratio) return false;
  x_ = x;
  std::swap(gaussian_, moved_);
  return true;
}

Eigen::MatrixXd PosteriorChain::whole_hessian() const {
  const Smoothing& first = smoothing_.front();
  return hessian_with(first, first.lambda, first.roughness);
}

// A new sum, not an update of the present one: subtracting a λ many decades above the new one
// would leave rounding, which is not definite.
Eigen::MatrixXd PosteriorChain::hessian_with(const Smoothing& own, double lambda,
                                             const Eigen::MatrixXd& roughness) const {
  Eigen::MatrixXd sum = hessian_;
  for (const Smoothing& smoothing : smoothing_) {
    if (&smoothing == &own) {
      sum += lambda * roughness;
    } else {
      sum += smoothing.lambda * smoothing.roughness;
    }
  }
  return sum;
}

// Steps of ln λ have a Cauchy distribution: some small, some as large as its range.
void PosteriorChain::move_with_lambda(Smoothing& smoothing, RandomStream& random) {
  const double step = 0.5 * std::tan(std::numbers::pi * (random.uniform() - 0.5));
  const double lambda = smoothing.lambda * std::exp(step);
  if (!(lambda >= smoothing.block.least_lambda && lambda <= smoothing.block.most_lambda)) return;
  moved_.set(hessian_with(smoothing, lambda, smoothing.roughness), linear_);
  const double rank = static_cast<double>(smoothing.block.rows);
  if (moves_along(0.5 * rank * std::log(lambda / smoothing.lambda), random)) {
    smoothing.lambda = lambda;
  }
}

void PosteriorChain::move_with_local(Smoothing& smoothing, RandomStream& random) {
  LocalSmoothing local = smoothing.local.proposed(random);
  Eigen::MatrixXd rough = roughness(smoothing, local);
  moved_.set(hessian_with(smoothing, smoothing.lambda, rough), linear_);
  if (!moves_along(0.0, random)) return;  // the mean of ln l is 0
  smoothing.local = std::move(local);
  smoothing.roughness = std::move(rough);
}

// A row of L has three coefficients other than 0.
Eigen::MatrixXd PosteriorChain::roughness(const Smoothing& smoothing,
                                          const LocalSmoothing& local) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(x_.size(), x_.size());
  for (Eigen::Index own = 0; own < smoothing.block.rows; ++own) {
    const Eigen::Index r = smoothing.begin + own;
    for (const Eigen::Index i : penalised_[static_cast<std::size_t>(r)]) {
      for (const Eigen::Index j : penalised_[static_cast<std::size_t>(r)]) {
        sum(i, j) += local.factors()(own) * target_.penalty(r, i) * target_.penalty(r, j);
      }
    }
  }
  return sum;
}

/// (Lx)_j² of a block.
Eigen::VectorXd PosteriorChain::bends(const Smoothing& smoothing) const {
  const auto own = target_.penalty.middleRows(smoothing.begin, smoothing.block.rows);
  return (own * x_).cwiseAbs2();
}

// λ | x ~ Gamma(r/2) of rate ½Σ l_j (Lx)_j², between its ends.
void PosteriorChain::draw_lambda(Smoothing& smoothing, RandomStream& random) {
  const double least = smoothing.block.least_lambda;
  const double most = smoothing.block.most_lambda;
  const double shape = 0.5 * static_cast<double>(smoothing.block.rows);
  const double sum = smoothing.local.factors().dot(bends(smoothing));
  const double rate = 0.5 * std::max(sum, 1e-300);
  const double below = boost::math::gamma_p(shape, rate * least, DrawPolicy());
  const double above = boost::math::gamma_p(shape, rate * most, DrawPolicy());
  const double uniform = random.uniform();
  if (above - below < kLeastRange) {
    smoothing.lambda = rate * least > shape ? least : most;
    return;
  }
  const double drawn =
      boost::math::gamma_p_inv(shape, below + uniform * (above - below), DrawPolicy());
  smoothing.lambda = std::clamp(drawn / rate, least, most);
}

// τ² | x ~ (‖Dx − d‖² + more)/χ²_m, between its ends.
void PosteriorChain::draw_scales(RandomStream& random) {
  for (std::size_t g = 0; g < scale_.size(); ++g) {
    const ChainRows& rows = target_.rows[g];
    if (rows.scale_known) continue;
    const double square = rows.more_square + (data_[g] - rows.design * x_).squaredNorm();
    const double least = std::max(kLeastScale, rows.least_scale);
    const ChiSquared chi_squared(rows.count);
    const double most = std::max(least, rows.most_scale);
    const double below = std::isinf(most) ? 0.0 : chi_squared.below(square / (most * most));
    const double share =
        below + random.uniform() * (chi_squared.below(square / (least * least)) - below);
    scale_[g] = share < 1.0 ? least : most;
    if (share > 0.0 && share < 1.0) {
      scale_[g] = std::clamp(std::sqrt(square / chi_squared.quantile(share)), least, most);
    }
  }
}

void PosteriorChain::draw_local(Smoothing& smoothing, RandomStream& random) {
  smoothing.local.draw(smoothing.lambda * bends(smoothing), random);
  smoothing.roughness = roughness(smoothing, smoothing.local);
}

void PosteriorChain::set_error(double error) {
  data_.clear();
  projected_.clear();
  for (const ChainRows& rows : target_.rows) {
    const bool shifted = rows.shift.size() > 0 && error != 0.0;
    data_.push_back(shifted ? Eigen::VectorXd(rows.data + error * rows.shift) : rows.data);
    projected_.emplace_back(rows.design.transpose() * data_.back());
  }
}

void PosteriorChain::step(RandomStream& random, int most_reflections) {
  gather_data(random);
  gaussian_.set(whole_hessian(), linear_);
  gaussian_.move(x_, random, most_reflections);
  reflections_ = gaussian_.reflections();
  for (Smoothing& smoothing : smoothing_) {
    if (!(smoothing.block.most_lambda > smoothing.block.least_lambda)) continue;
    move_with_lambda(smoothing, random);
    if (smoothing.local.varies()) move_with_local(smoothing, random);
    draw_lambda(smoothing, random);
  }
  draw_scales(random);
  for (Smoothing& smoothing : smoothing_) {
    if (smoothing.local.varies()) draw_local(smoothing, random);
  }
}

void PosteriorChain::hold_near() {
  const std::vector<int>& counts = reflections_;
  if (std::accumulate(counts.begin(), counts.end(), 0) < kManyReflections) return;
  const Eigen::VectorXd deviation = gaussian_.standard_deviation();
  for (Eigen::Index j = 0; j < target_.limits.positive; ++j) {
    if (counts[static_cast<std::size_t>(j)] <= kManyOfOne) continue;
    nearness_(j) = std::max(nearness_(j), 4.0 / (deviation(j) * deviation(j)));
  }
}

void PosteriorChain::settle(RandomStream& random) {
  for (int i = 0; i < kSettling; ++i) {
    step(random, kMostReflections);
    hold_near();
  }
}

// The program has H and Hz = g + Lε, with H = LLᵀ.
QuadraticProgram::Solution PosteriorChain::projected(RandomStream& random) const {
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(x_.size(), x_.size());
  for (const Smoothing& smoothing : smoothing_) hessian += smoothing.lambda * smoothing.roughness;
  Eigen::VectorXd linear = Eigen::VectorXd::Zero(x_.size());
  add_data(hessian, linear);
  Eigen::VectorXd noise(x_.size());
  for (double& value : noise) value = random.normal();
  linear += Eigen::LLT<Eigen::MatrixXd>(hessian).matrixL() * noise;
  std::vector<bool> free(static_cast<std::size_t>(x_.size()), true);
  return QuadraticProgram(target_.limits.budget_weights.col(0), 1.0)
      .solve(hessian, linear, std::move(free));
}

const Eigen::VectorXd& PosteriorChain::next(RandomStream& random) {
  for (int i = 0; i < kStepsOfDraw; ++i) step(random, TruncatedGaussian::kNoEnd);
  return x_;
}

}  // namespace microslip
