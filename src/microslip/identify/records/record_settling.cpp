// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_settling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

constexpr std::size_t kPathPoints = 25;
/// Passes until the noise of the records is known.
constexpr int kNoisePasses = 2;
/// First guess of the scatter, over the largest force.
constexpr double kFirstScatter = 1e-2;
constexpr double kMostCorrelation = 0.95;
/// No levels are exact to more than this, of D or of the deviations given.
constexpr double kLeastLevelScatter = 1e-6;
/// χ₀ that are tried beside 0. The slip below the resolution of a record follows from it, and k
/// with it: a power law continued to zero has more stiffness there than a density that levels off.
constexpr std::array kPowers = {-0.25, -0.5, -0.75};
/// Decrease of −2 ln likelihood: "strong" [Kass & Raftery, J. Am. Stat. Assoc. 90 (1995) 773].
constexpr double kStrongPower = 6.0;

SettledRecords run_pass(const ScaledRecords& records, const RecordPass& settings) {
  SettledRecords pass{RecordModel(records, settings), {}, settings};
  const SmoothingProblem& problem = pass.model.problem();
  std::vector<SmoothingPoint> path = problem.path(problem.lambda_grid(kPathPoints));
  pass.best = std::move(path[choose(path, SmoothingRule::kReml, problem.most_edf())]);
  return pass;
}

/// The scatter of rows, in units of the assumed one: from their residuals and degrees of freedom. 1
/// where no degrees of freedom are left.
double scatter_of(double square, double rows, double leverage) {
  const double freedom = rows - leverage;
  return freedom < 1.0 ? 1.0 : std::sqrt(square / freedom);
}

/// Scatter of levels from their residuals, relative to D of the fit.
void read_level_noise(const SettledRecords& pass, const ScaledRecords& records, RecordPass& next) {
  if (records.levels.empty()) return;
  const Eigen::VectorXd leverage = pass.model.problem().leverage(pass.best);
  for (std::size_t t = 0; t < records.levels.size(); ++t) {
    const LevelEvidence& evidence = records.levels[t];
    const Eigen::VectorXd left = pass.model.level_residual(t, pass.best.solution.x);
    const auto of_d = static_cast<Eigen::Index>(evidence.size());
    const Eigen::Index of_k = left.size() - of_d;
    const Eigen::VectorXd own = leverage.segment(pass.model.first_row(t), left.size());
    LevelPass& found = next.levels[t];
    const double repeats = evidence.repeat_sum(pass.model.level_deviations(t));
    found.scatter.dissipation = std::max(
        kLeastLevelScatter, found.scatter.dissipation *
                                scatter_of(left.head(of_d).squaredNorm() + repeats,
                                           static_cast<double>(of_d) + evidence.repeat_freedom(),
                                           own.head(of_d).sum()));
    if (of_k > 0) {
      const double least = evidence.secant_std_given()
                               ? kLeastLevelScatter
                               : LevelEvidence::kLeastSecantScatter * records.stiffness;
      found.scatter.secant_stiffness =
          std::max(least, found.scatter.secant_stiffness * scatter_of(left.tail(of_k).squaredNorm(),
                                                                      static_cast<double>(of_k),
                                                                      own.tail(of_k).sum()));
    }
    found.dissipation = pass.model.levels_of(t, pass.best.solution.x).dissipation;
  }
}

/// Noise of each record from its residual.
void read_noise(const SettledRecords& pass, const ScaledRecords& records, RecordPass& next) {
  for (std::size_t r = 0; r < records.records.size(); ++r) {
    const PathRows& path = records.records[r].rows();
    Eigen::VectorXd left = pass.model.residual(r, pass.best.solution.x);
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      left(i) *= std::sqrt(static_cast<double>(path.rows[static_cast<std::size_t>(i)].count));
    }
    const double square = std::max(left.squaredNorm(), 1e-24);
    const Eigen::Index n = left.size();
    const double alike = left.head(n - 1).dot(left.tail(n - 1)) / square;
    const double freedom =
        std::max(1.0, static_cast<double>(n) - pass.best.edf - static_cast<double>(path.groups));
    next.scatter[r] = std::sqrt(square / freedom);
    next.correlation[r] = std::clamp(alike, 0.0, kMostCorrelation);
  }
}

}  // namespace

SettledRecords settle_records(const ScaledRecords& records, bool viscous) {
  RecordPass settings;
  settings.viscous = viscous;
  for (const LevelEvidence& levels : records.levels) {
    settings.levels.push_back(
        {levels.expected_scatter(records.stiffness), levels.typical().value.dissipation});
  }
  settings.scatter.assign(records.records.size(), kFirstScatter);
  settings.correlation.assign(records.records.size(), 0.0);
  for (int i = 0; i < kNoisePasses; ++i) {
    const SettledRecords pass = run_pass(records, settings);
    read_noise(pass, records, settings);
    read_level_noise(pass, records, settings);
  }
  SettledRecords best = run_pass(records, settings);
  double lowest = best.best.likelihood;
  for (const double tried : kPowers) {
    settings.exponent = tried;
    SettledRecords other = run_pass(records, settings);
    const double score = other.best.likelihood + kStrongPower;
    if (score >= lowest) continue;
    lowest = score;
    best = std::move(other);
  }
  return best;
}

}  // namespace microslip
