// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "microslip/base/interpolation.hpp"
#include "microslip/base/median.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// Share of D that the knots follow a density with kinks to: less scatter proves no edge.
constexpr double kResolved = 3e-3;
/// Degrees of freedom that the levels must leave the scatter.
constexpr double kLeastFreedom = 10.0;

/// ν₀ of few levels where σ was given and where it was not; it falls to 0 between these numbers of
/// levels, as more determine their scatter by themselves.
constexpr double kFreedomOfGiven = 10.0;
constexpr double kFreedomOfUsual = 4.0;
constexpr double kFew = 12.0;
constexpr double kEnough = 20.0;
/// Repeats determine the scatter, and nothing between their amplitudes: so many levels of each
/// count at most, in the mean.
constexpr double kMostRepeated = 2.0;
/// The usual scatter of D.
constexpr double kUsualScatter = 0.01;

/// Prior knowledge of a scatter of s, in units of 1/W.
KnownScatter prior_scatter(double share, bool given, double s) {
  const double freedom = share * (given ? kFreedomOfGiven : kFreedomOfUsual);
  return {freedom * s * s, freedom};
}

/// kResolved of D in units of its scatter, by the levels above the floor.
double unresolved_of(const ScaledLevels& levels, const Eigen::VectorXd& weights) {
  std::vector<double> signal_to_noise;
  for (Eigen::Index i = 0; i < levels.dissipation.size(); ++i) {
    if (levels.dissipation(i) > levels.floor(i))
      signal_to_noise.push_back(weights(i) * levels.dissipation(i));
  }
  return signal_to_noise.empty() ? 0.0 : kResolved * median(std::move(signal_to_noise));
}

/// Weights of the second differences at equally spaced knots, at other places.
Eigen::VectorXd weights_at(const Eigen::VectorXd& middles, const Eigen::VectorXd& weights) {
  std::vector<double> knots(static_cast<std::size_t>(weights.size()));
  std::iota(knots.begin(), knots.end(), 1.0);
  const std::vector<double> values(weights.begin(), weights.end());
  return middles.unaryExpr([&](double at) { return interpolate(knots, values, at); });
}

}  // namespace

ScaledLevels::ScaledLevels(const LevelEvidence& levels, double k)
    : evidence(levels),
      stiffness(k),
      largest_slip_force(k * levels.levels().amplitude.back()),
      energy(largest_slip_force * levels.levels().amplitude.back()),
      amplitude(view_of(levels.levels().amplitude) / levels.levels().amplitude.back()),
      dissipation(view_of(levels.levels().dissipation) / energy),
      floor(view_of(levels.dissipation_floor()) / energy),
      typical(view_of(levels.typical().value.dissipation) / energy) {
  if (levels.levels().secant_stiffness.empty()) return;
  softening = (1.0 - view_of(levels.levels().secant_stiffness).array() / k).matrix();
  unit = levels.expected_scatter(k);
}

struct InversionModel::Columns {
  double theta_scale = 1.0;
  double damping_scale = 0.0;
  double atom_scale = 0.0;
  Eigen::Index damping_column = -1;
  Eigen::Index atom_column = -1;
  Eigen::MatrixXd dissipation;
  Eigen::MatrixXd softening;
  Eigen::VectorXd area;
  Eigen::MatrixXd penalty;
  Eigen::VectorXd weights;       // D rows, then k_eq rows
  Eigen::VectorXd offset_share;  // of each k_eq row in their weighted mean
  double informative_rows = 0.0;
  double few_share = 0.0;
  KnownScatter prior;
  KnownScatter prior_softening;
  KnownScatter known;  // with repeats

  Columns(const ScaledLevels& levels, const PassOptions& options, const InversionBasis& basis);

 private:
  void set_weights(const ScaledLevels& levels, const PassOptions& options);
  void add_column(const Eigen::VectorXd& d, const Eigen::VectorXd& soft, double weight);
};

// Scatter of each row at the d of an earlier fit. Noise in A acts through the slope of D, close to
// that of the power law d ∝ a^(3+χ₀).
void InversionModel::Columns::set_weights(const ScaledLevels& levels, const PassOptions& options) {
  const LevelEvidence& evidence = levels.evidence;
  LevelPrediction prediction;
  prediction.value.secant_stiffness = evidence.levels().secant_stiffness;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double d = levels.energy * std::max(options.fit(row), levels.floor(row));
    prediction.value.dissipation.push_back(d);
    if (!evidence.amplitude_std_counts()) continue;
    const double relative = evidence.levels().amplitude_std[i] / evidence.levels().amplitude[i];
    prediction.change.dissipation.push_back((3.0 + options.exponent) * d * relative);
  }
  const LevelRows deviation = evidence.deviations(prediction, levels.unit);
  informative_rows = evidence.informative_levels(prediction);
  const auto amplitudes = static_cast<double>(evidence.size());
  const double n = std::min(amplitudes + evidence.repeat_freedom(), kMostRepeated * amplitudes);
  few_share = std::clamp((kEnough - n) / (kEnough - kFew), 0.0, 1.0);
  const bool given = evidence.dissipation_std_given();
  prior = prior_scatter(few_share, given, given ? 1.0 : kUsualScatter / levels.unit.dissipation);
  prior_softening = prior_scatter(few_share, evidence.secant_std_given(), 1.0);
  known.square = prior.square + evidence.repeat_sum(deviation);
  known.freedom = prior.freedom + evidence.repeat_freedom();
  const Eigen::Index rows = levels.dissipation.size();
  weights.resize(rows + levels.softening.size());
  weights.head(rows) = levels.energy * view_of(deviation.dissipation).cwiseInverse();
  if (levels.softening.size() == 0) return;
  weights.tail(levels.softening.size()) =
      levels.stiffness * view_of(deviation.secant_stiffness).cwiseInverse();
  informative_rows += static_cast<double>(levels.softening.size()) - 1.0;
  const Eigen::VectorXd precision = weights.tail(levels.softening.size()).cwiseAbs2();
  offset_share = precision / precision.sum();
}

void InversionModel::Columns::add_column(const Eigen::VectorXd& d, const Eigen::VectorXd& soft,
                                         double weight) {
  const Eigen::Index column = dissipation.cols();
  dissipation.conservativeResize(Eigen::NoChange, column + 1);
  dissipation.col(column) = d;
  softening.conservativeResize(softening.rows(), column + 1);
  if (softening.rows() > 0) softening.col(column) = soft;
  area.conservativeResize(column + 1);
  area(column) = weight;
}

// Each column is scaled so that its coefficient is of the order of 1: of θ such that θ = 1 fits D
// best, of βa² such that it alone would.
InversionModel::Columns::Columns(const ScaledLevels& levels, const PassOptions& options,
                                 const InversionBasis& basis) {
  set_weights(levels, options);
  const Eigen::VectorXd& a = levels.amplitude;
  const auto d_weights = weights.head(a.size());
  const Eigen::VectorXd target = d_weights.cwiseProduct(levels.dissipation);
  const auto best_scale = [&](const Eigen::VectorXd& column) {
    const Eigen::VectorXd weighted = d_weights.cwiseProduct(column);
    return std::max(1e-300, target.dot(weighted) / weighted.squaredNorm());
  };

  dissipation = basis.dissipation(a);
  theta_scale = best_scale(dissipation.rowwise().sum());
  dissipation *= theta_scale;
  softening = levels.softening.size() > 0 ? Eigen::MatrixXd(theta_scale * basis.softening(a))
                                          : Eigen::MatrixXd(0, basis.size());
  area = theta_scale * basis.area();

  const Eigen::VectorXd none = Eigen::VectorXd::Zero(levels.softening.size());
  if (options.linear_damping) {
    damping_column = dissipation.cols();
    const Eigen::VectorXd square = a.cwiseAbs2();
    damping_scale = best_scale(square);
    add_column(damping_scale * square, none, 0.0);
  }
  if (options.atom) {
    atom_column = dissipation.cols();
    atom_scale = 0.2;
    add_column(atom_scale * atom_dissipation(a, options.top),
               atom_scale * atom_softening(a, options.top), atom_scale);
  }

  const Eigen::MatrixXd differences = basis.second_differences();
  penalty = Eigen::MatrixXd::Zero(differences.rows(), dissipation.cols());
  penalty.leftCols(basis.size()) = differences;
  const Eigen::VectorXd middles = basis.middles();
  if (options.trend != 0.0) {
    const Eigen::ArrayXd share = middles.array() / (options.coefficients - 1.0) - 0.5;
    penalty = (0.5 * options.trend * share).exp().matrix().asDiagonal() * penalty;
  }
  if (options.penalty_weights.size() > 0) {
    penalty = weights_at(middles, options.penalty_weights).asDiagonal() * penalty;
  }
}

InversionModel::InversionModel(const ScaledLevels& levels, const PassOptions& options)
    : InversionModel(levels, options,
                     InversionBasis(levels.amplitude(0), options.top, options.exponent,
                                    options.coefficients, options.edges)) {}

InversionModel::InversionModel(const ScaledLevels& levels, const PassOptions& options,
                               InversionBasis basis)
    : InversionModel(levels, basis, Columns(levels, options, basis)) {}

InversionModel::InversionModel(const ScaledLevels& levels, const InversionBasis& basis,
                               Columns columns)
    : basis_(basis),
      stiffness_(levels.stiffness),
      largest_slip_force_(levels.largest_slip_force),
      theta_scale_(columns.theta_scale),
      damping_scale_(columns.damping_scale),
      atom_scale_(columns.atom_scale),
      damping_column_(columns.damping_column),
      atom_column_(columns.atom_column),
      dissipation_(columns.dissipation),
      softening_(columns.softening),
      weights_(columns.weights),
      informative_rows_(columns.informative_rows),
      known_(columns.known),
      few_share_(columns.few_share),
      deviations_given_(levels.evidence.dissipation_std_given()),
      known_softening_(columns.prior_softening),
      unresolved_(unresolved_of(levels, columns.weights)),
      problem_([&] {
        const Eigen::Index d_rows = columns.dissipation.rows();
        Eigen::MatrixXd design(columns.weights.size(), columns.dissipation.cols());
        design.topRows(d_rows) = columns.dissipation;
        Eigen::VectorXd data(columns.weights.size());
        data.head(d_rows) = levels.dissipation;
        if (levels.softening.size() > 0) {
          const Eigen::RowVectorXd share = columns.offset_share.transpose();
          design.bottomRows(columns.softening.rows()) =
              columns.softening.rowwise() - share * columns.softening;
          data.tail(levels.softening.size()) =
              levels.softening.array() - share.dot(levels.softening);
        }
        const Eigen::Index extra = columns.dissipation.cols() - basis.size();
        return SmoothingProblem(columns.weights.asDiagonal() * design,
                                columns.weights.cwiseProduct(data), columns.penalty, columns.area,
                                2 * basis.ranges() + extra, columns.prior);
      }()) {}

void InversionModel::take_smoothing(const InversionModel& other) {
  path = other.path;
  chosen = other.chosen;
  most_edf = other.most_edf;
  lambda_fixed = other.lambda_fixed;
  shape_sought = other.shape_sought;
  scatter = other.scatter;
  dissipation_scatter = other.dissipation_scatter;
  softening_scatter = other.softening_scatter;
  least_softening_scatter = other.least_softening_scatter;
  degrees_of_freedom = other.degrees_of_freedom;
}

double InversionModel::evidence(const SmoothingPoint& point) const {
  const double freedom =
      informative_rows_ + known_scatter().freedom - static_cast<double>(problem_.unpenalised());
  if (freedom < kLeastFreedom || !point.solution.converged) {
    return std::numeric_limits<double>::infinity();
  }
  const double square = point.residual + known_scatter().square + point.lambda * point.roughness +
                        freedom * unresolved_ * unresolved_;
  const double size =
      theta(point.solution.x).squaredNorm() / static_cast<double>(basis_.size()) + 1e-300;
  double lines = 0.0;
  Eigen::VectorXd precision = Eigen::VectorXd::Zero(problem_.size());
  Eigen::Index begin = 0;
  for (Eigen::Index range = 0; range < basis_.ranges(); ++range) {
    const Eigen::Index count = basis_.size_of(range);
    const double variance = static_cast<double>(count) * size;
    lines += 2.0 * std::log(variance);
    precision.segment(begin, count).setConstant(square / freedom / variance);
    begin += count;
  }
  return freedom * std::log(square / freedom) + freedom +
         problem_.log_volume(point.lambda, precision) + lines;
}

Eigen::VectorXd InversionModel::dissipation(const Eigen::VectorXd& x) const {
  return dissipation_ * x;
}

Eigen::VectorXd InversionModel::softening(const Eigen::VectorXd& x) const { return softening_ * x; }

Eigen::MatrixXd InversionModel::density_matrix() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(basis_.nodal().rows(), problem_.size());
  matrix.leftCols(basis_.size()) = theta_scale_ / largest_slip_force_ * basis_.nodal();
  return matrix;
}

Eigen::VectorXd InversionModel::density(const Eigen::VectorXd& x) const {
  return basis_.nodal() * (theta_scale_ / largest_slip_force_ * theta(x));
}

Eigen::VectorXd InversionModel::linear_damping_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(problem_.size());
  if (damping_column_ >= 0) row(damping_column_) = damping_scale_;
  return row;
}

Eigen::VectorXd InversionModel::atom_row() const {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(problem_.size());
  if (atom_column_ >= 0) row(atom_column_) = atom_scale_;
  return row;
}

}  // namespace microslip
