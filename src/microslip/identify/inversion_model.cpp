// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion_model.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "microslip/base/median.hpp"
#include "microslip/identify/noise.hpp"

namespace microslip {
namespace {

/// Below this share of what d ∝ a³ through the largest level would be, a level counts as zero: its
/// relative weight must not grow without limit.
constexpr double kFloorShare = 1e-3;
/// A scatter of exactly zero would make weights infinite.
constexpr double kLeastScatter = 1e-9;

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

bool all_positive(const std::vector<double>& values) {
  return !values.empty() && std::ranges::all_of(values, [](double v) { return v > 0.0; });
}

double scatter(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const auto span_of = [](const Eigen::VectorXd& v) {
    return std::span<const double>(v.data(), static_cast<std::size_t>(v.size()));
  };
  return std::max(kLeastScatter, scatter_about_neighbours(span_of(x), span_of(y)));
}

/// Deviations of d of which none is below the typical relative one at the floor where d is below
/// it: else levels without dissipation would outweigh all others.
Eigen::VectorXd floored_deviations(const Eigen::VectorXd& deviation, const Eigen::VectorXd& d,
                                   const Eigen::VectorXd& floor) {
  const Eigen::ArrayXd relative = deviation.cwiseQuotient(d.cwiseMax(floor)).array();
  const double typical = median({relative.begin(), relative.end()});
  return (d.array() < floor.array()).select(deviation.cwiseMax(typical * floor), deviation);
}

}  // namespace

ScaledLevels::ScaledLevels(const MergedLevels& merged, double k)
    : stiffness(k),
      largest_amplitude(merged.levels.amplitude.back()),
      largest_slip_force(k * largest_amplitude),
      relative_std(1.0) {
  const Levels& levels = merged.levels;
  const double energy = largest_slip_force * largest_amplitude;
  amplitude = vector_of(levels.amplitude) / largest_amplitude;
  dissipation = vector_of(levels.dissipation) / energy;
  floor = kFloorShare * dissipation.maxCoeff() * amplitude.array().cube();
  repeats.resize(amplitude.size());
  for (Eigen::Index i = 0; i < repeats.size(); ++i) {
    repeats(i) = static_cast<double>(merged.count[static_cast<std::size_t>(i)]);
  }
  spread = vector_of(merged.dissipation_spread) / (energy * energy);
  if (all_positive(levels.dissipation_std)) {
    const Eigen::VectorXd given = vector_of(levels.dissipation_std) / energy;
    dissipation_std = floored_deviations(given, dissipation, floor);
    informative_levels = given.cwiseQuotient(dissipation_std).squaredNorm();
    if (!levels.amplitude_std.empty()) {
      amplitude_std = vector_of(levels.amplitude_std) / largest_amplitude;
    }
  }
  if (levels.secant_stiffness.empty()) return;

  // Two kinds of rows share one solution: what is not known of their scatter is estimated, as their
  // ratio decides which of them is believed.
  softening = (1.0 - vector_of(levels.secant_stiffness).array() / k).matrix();
  softening_std_given = all_positive(levels.secant_stiffness_std);
  if (softening_std_given) {
    softening_std = vector_of(levels.secant_stiffness_std) / k;
  } else {
    softening_std.setConstant(amplitude.size(),
                              std::max(kLeastSofteningScatter, scatter(amplitude, softening)));
    softening_std.array() /= repeats.array().sqrt();
  }
  if (!deviations_given()) {
    const Eigen::VectorXd log_d = dissipation.cwiseMax(floor).array().log();
    relative_std = scatter(amplitude.array().log(), log_d);
  }
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
  double repeat_residual = 0.0;

  Columns(const ScaledLevels& levels, const PassOptions& options, const InversionBasis& basis);

 private:
  void set_weights(const ScaledLevels& levels, const PassOptions& options);
  void add_column(const Eigen::VectorXd& d, const Eigen::VectorXd& soft, double weight);
};

// Scatter of each row at the d of an earlier fit. Noise in A acts through the slope of D, close to
// that of the power law d ∝ a^(3+χ₀).
void InversionModel::Columns::set_weights(const ScaledLevels& levels, const PassOptions& options) {
  const Eigen::ArrayXd fit = options.fit.cwiseMax(levels.floor).array();
  Eigen::ArrayXd deviation;
  if (levels.deviations_given()) {
    deviation = levels.dissipation_std.array();
    if (levels.amplitude_std.size() > 0) {
      const Eigen::ArrayXd through_slope =
          (3.0 + options.exponent) * fit * levels.amplitude_std.array() / levels.amplitude.array();
      deviation = (deviation.square() + through_slope.square()).sqrt();
    }
    informative_rows = levels.informative_levels;
  } else {
    deviation = levels.relative_std * fit / levels.repeats.array().sqrt();
    informative_rows = (levels.dissipation.array() / fit).square().min(1.0).sum();
  }
  // A single level has the deviation of their mean times √repeats.
  repeat_residual = (levels.spread.array() / (deviation.square() * levels.repeats.array())).sum();
  weights.resize(deviation.size() + levels.softening.size());
  weights.head(deviation.size()) = deviation.inverse();
  weights.tail(levels.softening.size()) = levels.softening_std.cwiseInverse();
  if (levels.softening.size() == 0) return;
  informative_rows += static_cast<double>(levels.softening.size()) - 1.0;
  const Eigen::VectorXd precision = levels.softening_std.cwiseAbs2().cwiseInverse();
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

  penalty = Eigen::MatrixXd::Zero(basis.size() - 2, dissipation.cols());
  penalty.leftCols(basis.size()) = basis.second_differences();
  if (options.penalty_weights.size() > 0) {
    penalty = options.penalty_weights.asDiagonal() * penalty;
  }
}

InversionModel::InversionModel(const ScaledLevels& levels, const PassOptions& options)
    : InversionModel(levels, options,
                     InversionBasis(levels.amplitude(0), options.top, options.exponent,
                                    options.coefficients)) {}

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
      dissipation_weights_(columns.weights.head(columns.dissipation.rows())),
      informative_rows_(columns.informative_rows),
      repeat_residual_(columns.repeat_residual),
      repeat_freedom_(levels.repeats.sum() - static_cast<double>(levels.repeats.size())),
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
                                2 + extra);
      }()) {}

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

double InversionModel::linear_damping(const Eigen::VectorXd& x) const {
  return damping_column_ < 0 ? 0.0 : damping_scale_ * x(damping_column_);
}

double InversionModel::atom_weight(const Eigen::VectorXd& x) const {
  return atom_column_ < 0 ? 0.0 : atom_scale_ * x(atom_column_);
}

}  // namespace microslip
