// SPDX-License-Identifier: MIT
#include "microslip/identify/records/level_agreement.hpp"

#include <cmath>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/identify/records/record_model.hpp"
#include "microslip/identify/records/record_settling.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// Levels contradict where they differ by more than so many times the noise,
constexpr double kOverNoiseOfLevels = 4.0;
/// and by more than this share: of D gains of two tests, of k_eq the stiffnesses of two set-ups.
constexpr double kLeastDifferenceOfD = 0.03;
constexpr double kLeastDifferenceOfSecant = 0.01;

/// Levels as far as the others reach, with their errors.
struct WithinReach {
  Eigen::VectorXd amplitude;  // over X
  Eigen::VectorXd dissipation;
  Eigen::VectorXd dissipation_std;
  Eigen::VectorXd dissipation_scale;  // smoothed: a level far too low by scatter is no scale
  Eigen::VectorXd secant;             // empty where not measured
  Eigen::VectorXd secant_std;

  WithinReach(const LevelEvidence& table, const ScaledRecords& others) {
    const LevelRows sigma =
        table.deviations(table.typical(), table.expected_scatter(others.stiffness));
    const Levels& levels = table.levels();
    std::size_t n = 0;
    while (n < levels.size() && levels.amplitude[n] <= others.length * (1.0 + 1e-9)) ++n;
    const auto part = [&](const std::vector<double>& values, double unit) {
      Eigen::VectorXd all(values.empty() ? 0 : static_cast<Eigen::Index>(n));
      for (Eigen::Index i = 0; i < all.size(); ++i) {
        all(i) = values[static_cast<std::size_t>(i)] / unit;
      }
      return all;
    };
    amplitude = part(levels.amplitude, others.length);
    dissipation = part(levels.dissipation, others.energy());
    dissipation_std = part(sigma.dissipation, others.energy());
    dissipation_scale = part(table.typical().value.dissipation, others.energy());
    secant = part(levels.secant_stiffness, others.stiffness);
    secant_std = part(sigma.secant_stiffness, others.stiffness);
  }
};

/// A joint with its covariance.
class Predicted {
 public:
  /// Coefficients at their limits are not known to be there, either.
  explicit Predicted(const SettledRecords& settled)
      : x_(settled.best.solution.x),
        normal_(settled.model.problem().hessian(settled.best.lambda)) {}

  /// rms of the differences over `scale`, weighted by 1/variance of each, and as expected of noise.
  [[nodiscard]] LevelVerdict judge(const Eigen::MatrixXd& rows, const Eigen::VectorXd& measured,
                                   const Eigen::VectorXd& deviation, const Eigen::VectorXd& scale,
                                   double least) const {
    const Eigen::VectorXd predicted = rows * x_;
    const Eigen::MatrixXd spread = normal_.solve(rows.transpose());
    double square = 0.0;
    double weights = 0.0;
    for (Eigen::Index i = 0; i < measured.size(); ++i) {
      const double variance = deviation(i) * deviation(i) + rows.row(i).dot(spread.col(i));
      square += std::pow(measured(i) - predicted(i), 2) / variance;
      weights += scale(i) * scale(i) / variance;
    }
    const auto n = static_cast<double>(measured.size());
    LevelVerdict verdict{std::sqrt(square / weights), std::sqrt(n / weights), false};
    verdict.broken = verdict.share > std::max(least, kOverNoiseOfLevels * verdict.noise);
    return verdict;
  }

 private:
  Eigen::VectorXd x_;
  Eigen::LDLT<Eigen::MatrixXd> normal_;
};

}  // namespace

LevelAgreement agreement_of_levels(const JointEvidence& evidence, std::size_t table,
                                   std::optional<double> known, int coefficients) {
  // Another table may be the one that is wrong.
  std::vector<LevelEvidence> rest;
  for (std::size_t t = 0; t < evidence.levels.size() && evidence.records.empty(); ++t) {
    if (t != table) rest.push_back(evidence.levels[t]);
  }
  if (evidence.records.empty() && (rest.empty() || !known)) return {};
  const ScaledRecords others({.records = evidence.records, .levels = rest}, known, coefficients);
  const WithinReach levels(evidence.levels[table], others);
  if (levels.amplitude.size() == 0) return {};
  const SettledRecords settled = settle_records(others, false);
  const Predicted joint(settled);
  const std::vector<double>& knots = settled.model.basis().knots();
  LevelAgreement agreement;
  agreement.dissipation = joint.judge(
      settled.model.dissipation_matrix(dissipation_rows(levels.amplitude, knots)),
      levels.dissipation, levels.dissipation_std, levels.dissipation_scale, kLeastDifferenceOfD);
  if (levels.secant.size() == 0) return agreement;
  const Eigen::VectorXd slipping = levels.secant.array() - settled.model.secant_given();
  agreement.secant =
      joint.judge(settled.model.secant_matrix(softening_rows(levels.amplitude, knots)), slipping,
                  levels.secant_std, levels.secant, kLeastDifferenceOfSecant);
  return agreement;
}

}  // namespace microslip
