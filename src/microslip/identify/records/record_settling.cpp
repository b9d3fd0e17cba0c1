// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_settling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "microslip/base/interpolation.hpp"

namespace microslip {
namespace {

constexpr std::size_t kPathPoints = 25;
/// Passes until the noise of the records is known.
constexpr int kNoisePasses = 2;
/// First guess of the scatter, over the largest force.
constexpr double kFirstScatter = 1e-2;
constexpr double kMostCorrelation = 0.95;
/// Of the residuals at least this share is scatter of the force.
constexpr double kLeastOwnScatter = 0.1;
constexpr int kBisections = 40;
/// No levels are exact to more than this, of D or of the deviations given.
constexpr double kLeastLevelScatter = 1e-6;
/// The slip below the resolution of a record follows from χ₀, and k with it: a power law continued
/// to zero has more stiffness there than a density that levels off.
constexpr std::array kExponents = {0.0, -0.25, -0.5, -0.75};
/// Decrease of −2 ln likelihood: "strong" [Kass & Raftery, J. Am. Stat. Assoc. 90 (1995) 773].
constexpr double kStrongPower = 6.0;

/// Knots that follow the force add place, width and height of a population: each costs ln n of
/// −2 ln likelihood with n rows, and its choice among m knots 2 ln m [Chen & Chen, Biometrika 95
/// (2008) 759].
constexpr double kAddedByKnots = 3.0;
/// A density ends where less than this share of the slip forces is beyond, times this factor, if it
/// then takes less than that of the range.
constexpr double kNoForce = 1e-4;
constexpr double kBeyondEnd = 1.3;
constexpr double kMostOfRange = 0.5;
/// Share of the knots that stay evenly spread.
constexpr double kEvenKnots = 0.5;
constexpr int kMostMoves = 3;
/// Priors less probable than this beside the likeliest are left out.
constexpr double kLeastWeight = 0.01;

using RecordsPointer = std::shared_ptr<const ScaledRecords>;

SettledRecords run_pass(const RecordsPointer& records, const RecordPass& settings) {
  SettledRecords pass{records, RecordModel(*records, settings), {}, settings};
  const SmoothingProblem& problem = pass.model.problem();
  std::vector<SmoothingPoint> path = problem.path(problem.lambda_grid(kPathPoints));
  pass.best = std::move(path[choose(path, SmoothingRule::kReml, {problem.most_edf()})]);
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

/// The scatter s of single samples with Σ r²/(s² + a²) = freedom, a by the noise of the path: an
/// error of u counts as one of the force by the slope of the loop.
double scatter_beside(const Eigen::VectorXd& left, const Eigen::ArrayXd& of_path, double freedom) {
  const double all = std::sqrt(std::max(left.squaredNorm(), 1e-24) / freedom);
  const auto excess = [&](double s) {
    return (left.array().square() / (of_path + s * s)).sum() - freedom;
  };
  double low = kLeastOwnScatter * all;
  double high = all;
  if (excess(low) <= 0.0) return low;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = std::sqrt(low * high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return high;
}

/// Deviation of the force of rows by the error of the turn behind them: that moves a branch, and
/// all behind it by the force at its end. A virgin joint begins at a sample, of which the noise is
/// in no mean of neighbours.
Eigen::VectorXd deviation_by_turn(const RecordEvidence& record, const Eigen::VectorXd& slope) {
  const std::vector<PathRow>& rows = record.rows().rows;
  Eigen::VectorXd deviation(slope.size());
  Eigen::Index end = slope.size() - 1;
  for (Eigen::Index i = end; i >= 0; --i) {
    const PathRow& row = rows[static_cast<std::size_t>(i)];
    if (row.turns != rows[static_cast<std::size_t>(end)].turns) end = i;
    const bool from_start = record.rows().turns[row.turns].empty();
    deviation(i) =
        (slope(i) - slope(end)) * (from_start ? record.path().noise : record.path().left);
  }
  return deviation;
}

/// Noise of each record from its residual. The smoothing leaves errors of the path that as many
/// neighbours share as it combined: as many samples of the whole noise know as little.
void read_noise(const SettledRecords& pass, const ScaledRecords& records, RecordPass& next) {
  for (std::size_t r = 0; r < records.records.size(); ++r) {
    const PathRows& path = records.records[r].rows();
    const SmoothedPath& smoothed = records.records[r].path();
    Eigen::VectorXd left = pass.model.residual(r, pass.best.solution.x);
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      left(i) *= std::sqrt(static_cast<double>(path.rows[static_cast<std::size_t>(i)].count));
    }
    const Eigen::VectorXd slope = pass.model.slope(r, pass.best.solution.x);
    const double freedom = std::max(
        1.0, static_cast<double>(left.size()) - pass.best.edf - static_cast<double>(path.groups));
    const Eigen::ArrayXd of_path = (slope * (smoothed.left / records.length)).array().square();
    next.scatter[r] = scatter_beside(left, of_path, freedom);
    const Eigen::VectorXd unit =
        (left.array() / (of_path + next.scatter[r] * next.scatter[r]).sqrt()).matrix();
    const Eigen::Index n = unit.size();
    const double alike =
        unit.head(n - 1).dot(unit.tail(n - 1)) / std::max(unit.squaredNorm(), 1e-24);
    next.correlation[r] = std::clamp(alike, 0.0, kMostCorrelation);
    next.by_path[r] = slope * (smoothed.noise / records.length);
    next.by_turn[r] = deviation_by_turn(records.records[r], slope) / records.length;
  }
}

/// Two passes that find the noise.
void settle_noise(const RecordsPointer& records, RecordPass& settings) {
  for (int i = 0; i < kNoisePasses; ++i) {
    const SettledRecords pass = run_pass(records, settings);
    read_noise(pass, *records, settings);
    read_level_noise(pass, *records, settings);
  }
}

/// −2 ln likelihood of a prior and its solution.
double score_of(const SettledRecords& settled) {
  return settled.best.likelihood + (settled.settings.exponent == 0.0 ? 0.0 : kStrongPower);
}

/// The likeliest exponent for a noise.
SettledRecords likeliest_power(const RecordsPointer& records, RecordPass settings) {
  settings.exponent = kExponents.front();
  SettledRecords best = run_pass(records, settings);
  for (const double tried : std::span(kExponents).subspan(1)) {
    settings.exponent = tried;
    SettledRecords other = run_pass(records, settings);
    if (score_of(other) < score_of(best)) best = std::move(other);
  }
  return best;
}

/// Where a density may end that is 0 from there on but for a negligible force.
std::optional<double> shorter_end(const SettledRecords& settled) {
  const std::vector<double>& knots = settled.model.basis().knots();
  const Eigen::VectorXd density = settled.model.density_matrix() * settled.best.solution.x;
  std::vector<double> force(knots.size(), 0.0);  // of what slips beyond each knot
  for (std::size_t j = knots.size() - 1; j > 0; --j) {
    const auto at = static_cast<Eigen::Index>(j);
    force[j - 1] = force[j] + 0.5 * (knots[j] - knots[j - 1]) *
                                  (knots[j - 1] * density(at - 1) + knots[j] * density(at));
  }
  std::size_t end = knots.size() - 1;
  while (end > 0 && force[end - 1] <= kNoForce * force.front()) --end;
  const double place = kBeyondEnd * knots[end];
  if (end == 0 || place > kMostOfRange * settled.records->top) return {};
  return place;
}

/// Replaces the best by the likeliest with other knots where −2 ln likelihood falls by more than a
/// price at the same noise; then its noise is found anew. @return whether it did.
bool take_if_likelier(const RecordsPointer& records, double price, SettledRecords& best) {
  const SettledRecords other = likeliest_power(records, best.settings);
  if (score_of(other) + price >= score_of(best)) return false;
  RecordPass settings = other.settings;
  settle_noise(records, settings);
  best = likeliest_power(records, settings);
  return true;
}

/// Places of knots of which a part is where the force slips: with shares of ∫s p ds between them as
/// equal as may be. A population of sliders that is narrow among even knots is wide among these.
std::vector<double> places_by_force(const SettledRecords& settled) {
  const std::vector<double>& knots = settled.model.basis().knots();
  const std::vector<double>& places = settled.records->places;
  const std::size_t tail = knots.size() - places.size();
  const Eigen::VectorXd density = settled.model.density_matrix() * settled.best.solution.x;
  std::vector<double> force{0.0};
  for (std::size_t j = 1; j < places.size(); ++j) {
    const double l = knots[tail + j - 1];
    const double r = knots[tail + j];
    const auto at = static_cast<Eigen::Index>(tail + j);
    force.push_back(force.back() + 0.5 * (r - l) * (l * density(at - 1) + r * density(at)));
  }
  const double last = places.back();
  const double whole = std::max(force.back(), std::numeric_limits<double>::min());
  std::vector<double> share;
  for (std::size_t j = 0; j < places.size(); ++j) {
    share.push_back(kEvenKnots * places[j] + (1.0 - kEvenKnots) * last * force[j] / whole);
  }
  std::vector<double> moved;
  for (std::size_t j = 0; j < places.size(); ++j) {
    moved.push_back(interpolate(share, places, static_cast<double>(j)));
  }
  moved.front() = 0.0;
  moved.back() = last;
  return moved;
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
  for (const RecordEvidence& record : records.records) {
    settings.by_path.emplace_back(
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(record.rows().rows.size())));
    settings.by_turn.push_back(settings.by_path.back());
  }
  const auto whole = std::make_shared<const ScaledRecords>(records);
  settle_noise(whole, settings);
  SettledRecords best = likeliest_power(whole, settings);
  const double cost = kAddedByKnots * std::log(static_cast<double>(best.model.problem().rows())) +
                      2.0 * std::log(static_cast<double>(records.coefficients));
  while (const std::optional<double> end = shorter_end(best)) {
    const auto shorter = std::make_shared<const ScaledRecords>(best.records->up_to(*end));
    if (!take_if_likelier(shorter, 0.0, best)) break;
  }
  for (int i = 0; i < kMostMoves; ++i) {
    const auto moved =
        std::make_shared<const ScaledRecords>(best.records->with_knots(places_by_force(best)));
    if (!take_if_likelier(moved, cost, best)) break;
  }
  return best;
}

SettledRecords nearest_in_force(const SettledRecords& settled) {
  RecordPass settings = settled.settings;
  const double most = std::ranges::max(settings.correlation);
  settings.alike_rows = (1.0 + most) / (1.0 - most);
  std::ranges::fill(settings.correlation, 0.0);
  for (Eigen::VectorXd& of_path : settings.by_path) of_path.setZero();
  for (Eigen::VectorXd& of_turn : settings.by_turn) of_turn.setZero();
  return run_pass(settled.records, settings);
}

std::span<const double> tried_exponents() { return kExponents; }

std::vector<PossiblePrior> possible_priors(const SettledRecords& settled) {
  std::vector<PossiblePrior> priors{{settled, 1.0}};
  RecordPass settings = settled.settings;
  double sum = 1.0;
  for (const double exponent : kExponents) {
    if (exponent == settled.settings.exponent) continue;
    settings.exponent = exponent;
    SettledRecords other = run_pass(settled.records, settings);
    const double weight = std::exp(0.5 * (settled.best.likelihood - other.best.likelihood));
    if (weight < kLeastWeight) continue;
    priors.push_back({std::move(other), weight});
    sum += weight;
  }
  for (PossiblePrior& prior : priors) prior.weight /= sum;
  return priors;
}

}  // namespace microslip
