// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/coefficient_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/signal/harmonic/harmonic_basis.hpp"

namespace microslip {
namespace {

using Eigen::Index;

constexpr Index kLeastBlocks = 8;

/// Blocks of about the cube root of the number of cycles, at which bias and scatter of the variance
/// of a mean of correlated values are balanced [H. R. Künsch, Ann. Statist. 17 (1989) 1217]; but of
/// fewer where that leaves fewer than 16.
Index number_of_blocks(const HarmonicFit& fit) {
  constexpr double kWantedBlocks = 16.0;
  const double cycles = fit.big_omega / std::numbers::pi;
  const double per_block =
      std::min(std::round(std::cbrt(cycles)), std::floor(cycles / kWantedBlocks));
  return static_cast<Index>(cycles / std::max(1.0, per_block));
}

/// Residual variance of each signal.
Eigen::VectorXd variances(const HarmonicRegression& regression, const HarmonicFit& fit,
                          const Eigen::MatrixXd& residuals) {
  const double freedom = static_cast<double>(regression.times().points() - fit.unknowns());
  return residuals.colwise().squaredNorm().transpose() / freedom;
}

/// Weights 1/σ² for signals of the order of 1; rounding is the least σ.
Eigen::VectorXd weights(const Eigen::VectorXd& variance) {
  constexpr double kLeastVariance = 1e-30;
  return variance.cwiseMax(kLeastVariance).cwiseInverse();
}

CoefficientErrors white_errors(const HarmonicFit& fit, const Eigen::VectorXd& variance,
                               bool fix_omega) {
  CoefficientErrors errors;
  const double variance_of_omega = fix_omega ? 0.0 : 1.0 / weights(variance).dot(fit.curvature);
  const Index unknowns = fit.unknowns();
  const Eigen::VectorXd diagonal =
      fit.gram.solve(Eigen::MatrixXd::Identity(unknowns, unknowns)).diagonal();
  const Eigen::MatrixXd g = fit.gram.solve(fit.slope);
  errors.big_omega = std::sqrt(variance_of_omega);
  errors.coefficients =
      (diagonal * variance.transpose() + variance_of_omega * g.cwiseAbs2()).cwiseSqrt();
  return errors;
}

/// Aᵀr and r·x′ of one block.
struct Score {
  Eigen::MatrixXd columns;  ///< unknowns × signals
  Eigen::VectorXd slope;    ///< per signal
};

class Scores {
 public:
  Scores(const HarmonicRegression& regression, const HarmonicFit& fit,
         const Eigen::MatrixXd& residuals)
      : regression_(regression),
        fit_(fit),
        turned_(fit.turned_harmonics()),
        basis_(regression.times(), fit.big_omega, fit.order),
        columns_(residuals.rows(), 2 * residuals.cols()) {
    const Eigen::VectorXd s = Eigen::VectorXd::NullaryExpr(
        residuals.rows(), [&regression](Index i) { return regression.times().s(i); });
    columns_ << residuals, s.asDiagonal() * residuals;
  }

  [[nodiscard]] Score of(PointRange block) const {
    const Index signals = regression_.signals();
    const Eigen::MatrixXcd sums = basis_.sums(columns_, block, fit_.order);
    Score score;
    score.columns.resize(fit_.unknowns(), signals);
    const Index constants = regression_.degree() + 1;
    score.columns.topRows(constants).noalias() =
        regression_.polynomials(block).transpose() *
        columns_.block(block.first, 0, block.size(), signals);
    for (Index n = 0; n < fit_.order; ++n) {
      score.columns.row(constants + 2 * n) = sums.row(n).head(signals).real();
      score.columns.row(constants + 2 * n + 1) = sums.row(n).head(signals).imag();
    }
    const auto weighted = sums.rightCols(signals);
    score.slope = (turned_.real().cwiseProduct(weighted.real()) +
                   turned_.imag().cwiseProduct(weighted.imag()))
                      .colwise()
                      .sum()
                      .transpose();
    return score;
  }

 private:
  const HarmonicRegression& regression_;
  const HarmonicFit& fit_;
  Eigen::MatrixXcd turned_;
  HarmonicBasis basis_;
  Eigen::MatrixXd columns_;
};

CoefficientErrors block_errors(const HarmonicRegression& regression, const HarmonicFit& fit,
                               const Eigen::MatrixXd& residuals, const Eigen::VectorXd& variance,
                               Index blocks, bool fix_omega) {
  const Scores scores(regression, fit, residuals);
  const Eigen::MatrixXd g = fit.gram.solve(fit.slope);
  const Eigen::VectorXd weight = weights(variance);
  const double information = weight.dot(fit.curvature);
  const Index points = regression.times().points();
  double omega_square = 0.0;
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(fit.unknowns(), regression.signals());
  for (Index b = 0; b < blocks; ++b) {
    const Score score = scores.of({b * points / blocks, (b + 1) * points / blocks});
    const Eigen::VectorXd projected =
        score.slope - score.columns.cwiseProduct(g).colwise().sum().transpose();
    const double omega = fix_omega ? 0.0 : weight.dot(projected) / information;
    omega_square += omega * omega;
    squares += (fit.gram.solve(score.columns) - omega * g).cwiseAbs2();
  }
  const double count = static_cast<double>(blocks);
  const double factor = count / (count - 1.0) * static_cast<double>(points) /
                        static_cast<double>(points - fit.unknowns());
  return {std::sqrt(factor * omega_square), (factor * squares).cwiseSqrt()};
}

}  // namespace

CoefficientErrors coefficient_errors(const HarmonicRegression& regression, const HarmonicFit& fit,
                                     const Eigen::MatrixXd& residuals, ResidualModel model,
                                     bool fix_omega) {
  const Eigen::VectorXd variance = variances(regression, fit, residuals);
  const Index blocks = number_of_blocks(fit);
  if (model == ResidualModel::kWhite || blocks < kLeastBlocks) {
    return white_errors(fit, variance, fix_omega);
  }
  return block_errors(regression, fit, residuals, variance, blocks, fix_omega);
}

}  // namespace microslip
