// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assembly_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "microslip/identify/posterior/spread_prior.hpp"

namespace microslip {
namespace {

/// Steps of a derivative: of logarithms, whose rows bend over changes of 1.
constexpr double kSmallStep = 1e-4;
/// Newton steps to a start, and draws after each of which rows are linearised anew.
constexpr int kNewtonSteps = 6;
constexpr int kRounds = 4;
constexpr int kDrawsOfRound = 25;
/// Correlation with the last deviations in the steps of a draw: independent proposals, which may be
/// rejected, and near ones.
constexpr double kKept[] = {0.0, 0.7, 0.0, 0.9};
/// Rounds of these and of the spreads in a draw: they take little time beside that of the density.
constexpr int kSweeps = 3;

/// Columns orthogonal to (1, …, 1) and to each other, of length 1.
Eigen::MatrixXd helmert_matrix(Eigen::Index count) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count, count - 1);
  for (Eigen::Index c = 0; c + 1 < count; ++c) {
    const auto n = static_cast<double>(c + 1);
    columns.col(c).head(c + 1).setConstant(1.0 / std::sqrt(n * (n + 1.0)));
    columns(c + 1, c) = -n / std::sqrt(n * (n + 1.0));
  }
  return columns;
}

void append_rows(Eigen::MatrixXd& all, const Eigen::MatrixXd& more) {
  if (more.rows() == 0) return;
  all.conservativeResize(all.rows() + more.rows(), more.cols());
  all.bottomRows(more.rows()) = more;
}

void append_rows(Eigen::VectorXd& all, const Eigen::VectorXd& more) {
  if (more.size() == 0) return;
  all.conservativeResize(all.size() + more.size());
  all.tail(more.size()) = more;
}

}  // namespace

AssemblyChain::AssemblyChain(const AssemblyModel& model, AssemblyStart start)
    : model_(model),
      target_(std::move(start.target)),
      helmert_(helmert_matrix(model.assemblies())),
      contrast_(helmert_.transpose() * start.deviations),
      chain_([&] {
        draw_.deviations = deviations_of(contrast_);
        common_.resize(model.stiffness_sought() ? model.assemblies() : 0);
        for (Eigen::Index j = 0; j < common_.size(); ++j) common_(j) = model.stiffness_weight(j);
        common_.normalize();
        set_rows();
        scale_.assign(3, 1.0);
        const double scatter = start.chain.scale.front();
        start.chain.scale.clear();
        for (const ChainRows& rows : target_.rows) {
          start.chain.scale.push_back(rows.scale_known ? 1.0 : scatter);
        }
        return PosteriorChain(target_, std::move(start.chain));
      }()) {
  read_middle();
}

AssemblyDeviations AssemblyChain::deviations_of(const Eigen::MatrixXd& contrast) const {
  return helmert_ * contrast;
}

Eigen::VectorXd AssemblyChain::without_common(const Eigen::VectorXd& rows) const {
  if (rows.size() == 0) return rows;
  return rows - common_ * common_.dot(rows);
}

// Rows of all assemblies as the deviations make them; limits of the areas of all.
void AssemblyChain::set_rows() {
  const Eigen::Index count = model_.assemblies();
  Eigen::MatrixXd design[3];
  Eigen::VectorXd data[3];
  for (Eigen::Index j = 0; j < count; ++j) {
    const AssemblyDesign own = model_.design(draw_.deviations, j);
    const AssemblyRows& measured = model_.measured(j);
    append_rows(design[0], own.dissipation);
    append_rows(data[0], measured.dissipation);
    append_rows(design[1], own.secant);
    append_rows(data[1], measured.secant);
    append_rows(design[2], own.stiffness);
    if (own.stiffness.rows() == 0) continue;
    const double given =
        model_.stiffness_weight(j) * std::exp(model_.log_stiffness(draw_.deviations, j));
    append_rows(data[2], (measured.stiffness.array() - given).matrix());
  }
  target_.limits.positive = design[0].cols();
  target_.limits.budget_weights.resize(design[0].cols(), count);
  for (Eigen::Index j = 0; j < count; ++j) {
    target_.limits.budget_weights.col(j) = model_.area_row(draw_.deviations, j);
  }
  target_.rows.clear();
  target_.rows.push_back({.design = std::move(design[0]),
                          .data = std::move(data[0]),
                          .more_square = model_.repeat_square(),
                          .count = model_.dissipation_count()});
  if (model_.secant_count() > 0.0) {
    target_.rows.push_back({.design = std::move(design[1]),
                            .data = std::move(data[1]),
                            .count = model_.secant_count(),
                            .least_scale = model_.least_secant_scale()});
  }
  if (design[2].rows() > 0) {
    design[2] -= common_ * (common_.transpose() * design[2]);
    target_.rows.push_back({.design = std::move(design[2]),
                            .data = without_common(data[2]),
                            .count = static_cast<double>(count) - 1.0,
                            .scale_known = true});
  }
}

// Reads the state of the other chain, and its residual.
void AssemblyChain::read_middle() {
  draw_.middle = model_.middle(chain_.coefficients());
  std::size_t kind = 0;
  scale_[0] = chain_.scale(kind++);
  if (model_.secant_count() > 0.0) scale_[1] = chain_.scale(kind++);
  draw_.dissipation_scatter = scale_[0];
  square_ = square_at(contrast_);
}

AssemblyChain::Residual AssemblyChain::residual(const Eigen::MatrixXd& contrast) const {
  const AssemblyDeviations all = deviations_of(contrast);
  Residual left;
  for (Eigen::Index j = 0; j < model_.assemblies(); ++j) {
    const AssemblyRows predicted = model_.predicted(draw_.middle, all, j);
    const AssemblyRows& measured = model_.measured(j);
    append_rows(left.dissipation, measured.dissipation - predicted.dissipation);
    append_rows(left.secant, measured.secant - predicted.secant);
    append_rows(left.stiffness, measured.stiffness - predicted.stiffness);
  }
  left.stiffness = without_common(left.stiffness);
  return left;
}

double AssemblyChain::square(const Residual& left) const {
  return left.dissipation.squaredNorm() / (scale_[0] * scale_[0]) +
         left.secant.squaredNorm() / (scale_[1] * scale_[1]) + left.stiffness.squaredNorm();
}

double AssemblyChain::square_at(const Eigen::MatrixXd& contrast) const {
  const AssemblyDeviations all = deviations_of(contrast);
  for (Eigen::Index j = 0; j < model_.assemblies(); ++j) {
    if (!model_.possible(draw_.middle, all, j)) return std::numeric_limits<double>::infinity();
  }
  return square(residual(contrast));
}

/// 1/σ² of the contrasts, column by column.
Eigen::VectorXd AssemblyChain::precision() const {
  Eigen::MatrixXd all(contrast_.rows(), contrast_.cols());
  const AssemblySpread& spread = draw_.spread;
  if (model_.stiffness_sought()) all.col(0).setConstant(std::pow(spread.stiffness, -2));
  all.col(model_.force_column()).setConstant(std::pow(spread.slip_force, -2));
  all.rightCols(model_.shapes().cols()).setConstant(std::pow(spread.shape, -2));
  return all.reshaped();
}

// Residuals over contrasts at the last draw, by small steps.
void AssemblyChain::linearise() {
  linear_at_ = contrast_;
  const Residual here = residual(contrast_);
  jacobian_[0].resize(here.dissipation.size(), contrast_.size());
  jacobian_[1].resize(here.secant.size(), contrast_.size());
  jacobian_[2].resize(here.stiffness.size(), contrast_.size());
  for (Eigen::Index i = 0; i < contrast_.size(); ++i) {
    Eigen::MatrixXd moved = contrast_;
    moved.reshaped()(i) += kSmallStep;
    const Residual there = residual(moved);
    jacobian_[0].col(i) = (there.dissipation - here.dissipation) / kSmallStep;
    jacobian_[1].col(i) = (there.secant - here.secant) / kSmallStep;
    jacobian_[2].col(i) = (there.stiffness - here.stiffness) / kSmallStep;
  }
}

// The Gaussian that the deviations would have with linear rows.
void AssemblyChain::approximate() {
  const Residual left = residual(linear_at_);
  const Eigen::VectorXd prior = precision();
  const double first = 1.0 / (scale_[0] * scale_[0]);
  const double second = 1.0 / (scale_[1] * scale_[1]);
  Eigen::MatrixXd hessian = prior.asDiagonal();
  hessian += first * jacobian_[0].transpose() * jacobian_[0] +
             second * jacobian_[1].transpose() * jacobian_[1] +
             jacobian_[2].transpose() * jacobian_[2];
  const Eigen::VectorXd slope = first * jacobian_[0].transpose() * left.dissipation +
                                second * jacobian_[1].transpose() * left.secant +
                                jacobian_[2].transpose() * left.stiffness +
                                prior.cwiseProduct(linear_at_.reshaped());
  approximate_.compute(hessian);
  approximate_at_ = linear_at_.reshaped() - approximate_.solve(slope);
}

// Newton steps, halved until they lead down.
void AssemblyChain::go_to_best() {
  const Eigen::VectorXd prior = precision();
  const auto objective = [&](const Eigen::MatrixXd& contrast) {
    return square_at(contrast) + contrast.reshaped().cwiseAbs2().dot(prior);
  };
  double lowest = objective(contrast_);
  for (int i = 0; i < kNewtonSteps; ++i) {
    linearise();
    approximate();
    const Eigen::VectorXd step = approximate_at_ - contrast_.reshaped();
    bool lower = false;
    for (double share = 1.0; share > 0.05 && !lower; share *= 0.5) {
      Eigen::MatrixXd moved = contrast_;
      moved.reshaped() += share * step;
      const double value = objective(moved);
      lower = value < lowest;
      if (!lower) continue;
      lowest = value;
      contrast_ = moved;
    }
    if (!lower) break;
  }
  draw_.deviations = deviations_of(contrast_);
  square_ = square_at(contrast_);
  linearise();
}

// y = m + ρ(x − m) + √(1 − ρ²)ε keeps N(m, H⁻¹); the rest is the ratio of the true one to that.
void AssemblyChain::move_deviations(double kept, RandomStream& random) {
  const Eigen::VectorXd here = contrast_.reshaped();
  Eigen::VectorXd noise(here.size());
  for (double& value : noise) value = random.normal();
  const double uniform = random.uniform();
  Eigen::MatrixXd moved = contrast_;
  moved.reshaped() = approximate_at_ + kept * (here - approximate_at_) +
                     std::sqrt(1.0 - kept * kept) * approximate_.matrixU().solve(noise);
  const double square = square_at(moved);
  if (!std::isfinite(square)) return;
  const Eigen::VectorXd prior = precision();
  const auto beyond = [&](const Eigen::VectorXd& at, double of_rows) {
    const Eigen::VectorXd off = approximate_.matrixU() * (at - approximate_at_);
    return 0.5 * (of_rows + at.cwiseAbs2().dot(prior) - off.squaredNorm());
  };
  const double ratio = beyond(here, square_) - beyond(moved.reshaped(), square);
  if (std::log(uniform) >= ratio) return;
  contrast_ = moved;
  square_ = square;
}

// σ and the contrasts together, these as they are over σ.
void AssemblyChain::move_with_spread(double& spread, Eigen::Index column, Eigen::Index columns,
                                     RandomStream& random) {
  const double step = 0.5 * std::tan(std::numbers::pi * (random.uniform() - 0.5));
  const double uniform = random.uniform();
  const double moved = spread * std::exp(step);
  const double prior = SpreadPrior::log_density(std::log(moved));
  if (!std::isfinite(prior)) return;
  Eigen::MatrixXd contrast = contrast_;
  contrast.middleCols(column, columns) *= moved / spread;
  const double square = square_at(contrast);
  const double ratio =
      prior - SpreadPrior::log_density(std::log(spread)) + 0.5 * (square_ - square);
  if (!std::isfinite(square) || std::log(uniform) >= ratio) return;
  contrast_ = contrast;
  square_ = square;
  spread = moved;
}

void AssemblyChain::draw_spread(RandomStream& random) {
  const auto draw = [&](double& spread, Eigen::Index column, Eigen::Index columns) {
    move_with_spread(spread, column, columns, random);
    const auto own = contrast_.middleCols(column, columns);
    spread = SpreadPrior::draw(static_cast<double>(own.size()), own.squaredNorm(), random);
  };
  if (model_.stiffness_sought()) draw(draw_.spread.stiffness, 0, 1);
  draw(draw_.spread.slip_force, model_.force_column(), 1);
  draw(draw_.spread.shape, model_.shape_column(), model_.shapes().cols());
}

void AssemblyChain::settle(RandomStream& random) {
  go_to_best();
  set_rows();
  chain_.renew();
  chain_.settle(random);
  read_middle();
  for (int round = 0; round < kRounds; ++round) {
    go_to_best();
    for (int i = 0; i < kDrawsOfRound; ++i) next(random);
  }
}

const AssemblyDraw& AssemblyChain::next(RandomStream& random) {
  set_rows();
  chain_.renew();
  chain_.next(random);
  read_middle();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    approximate();
    for (const double kept : kKept) move_deviations(kept, random);
    draw_spread(random);
  }
  draw_.deviations = deviations_of(contrast_);
  return draw_;
}

}  // namespace microslip
