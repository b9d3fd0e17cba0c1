// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assembly_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// Amplitudes of a table, and how far it reaches beyond the levels: cubic interpolation between
/// them is right to 1e−6 of D.
constexpr Eigen::Index kTableSize = 1200;
constexpr double kTableReach = 20.0;
/// Share of the variance of a shape that its terms contain.
constexpr double kShapeVariance = 0.99;

/// Cubic through four equally spaced values at −1, 0, 1, 2.
Eigen::Vector4d cubic_weights(double t) {
  return {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
          -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
}

Eigen::VectorXd log_of(const std::vector<double>& values, double unit) {
  return (view_of(values).array() / unit).log().matrix();
}

}  // namespace

AssemblyModel::Table::Table(const Eigen::VectorXd& amplitude, Eigen::MatrixXd rows)
    : first_(std::log(amplitude(0))),
      step_(std::log(amplitude(1) / amplitude(0))),
      rows_(rows.transpose()) {}

bool AssemblyModel::Table::reaches(double log_amplitude) const {
  const double place = (log_amplitude - first_) / step_;
  return place >= 1.0 && place <= static_cast<double>(rows_.cols()) - 3.0;
}

Eigen::MatrixXd AssemblyModel::Table::at(const Eigen::VectorXd& log_amplitude) const {
  Eigen::MatrixXd rows(rows_.rows(), log_amplitude.size());
  for (Eigen::Index i = 0; i < log_amplitude.size(); ++i) {
    const double place = std::clamp((log_amplitude(i) - first_) / step_, 1.0,
                                    static_cast<double>(rows_.cols()) - 3.0);
    const double whole = std::floor(place);
    const auto before = static_cast<Eigen::Index>(whole) - 1;
    rows.col(i).noalias() = rows_.middleCols<4>(before) * cubic_weights(place - whole);
  }
  return rows;
}

AssemblyModel::AssemblyModel(std::vector<const LevelEvidence*> levels,
                             Eigen::VectorXd log_stiffness, bool sought,
                             const InversionModel& common, bool secant)
    : levels_(std::move(levels)),
      log_stiffness_(std::move(log_stiffness)),
      sought_(sought),
      stiffness_(common.stiffness()),
      length_(common.largest_slip_force() / stiffness_),
      energy_(stiffness_ * length_ * length_),
      knots_(common.basis().knots()),
      knot_area_(common.basis().knot_area()),
      nodal_(common.largest_slip_force() * common.density_matrix()) {
  for (const LevelEvidence* one : levels_) {
    log_amplitude_.push_back(log_of(one->levels().amplitude, length_));
  }
  weights_.resize(levels_.size());
  data_.resize(levels_.size());
  set_shapes(common.basis().knot_places());
  set_tables(secant);
}

// Karhunen–Loève terms; the sign of a vector does not matter, but is fixed.
void AssemblyModel::set_shapes(const Eigen::VectorXd& places) {
  const Eigen::Index n = places.size();
  Eigen::MatrixXd covariance(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const double distance = (places(i) - places(j)) / kShapeLength;
      covariance(i, j) = std::exp(-0.5 * distance * distance);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> terms(covariance);
  const double all = terms.eigenvalues().sum();
  Eigen::Index count = 0;
  double included = 0.0;
  while (count < n && included < kShapeVariance * all) included += terms.eigenvalues()(n - ++count);
  shapes_.resize(n, count);
  for (Eigen::Index b = 0; b < count; ++b) {
    const Eigen::Index from = n - 1 - b;
    const auto vector = terms.eigenvectors().col(from);
    Eigen::Index largest = 0;
    vector.cwiseAbs().maxCoeff(&largest);
    const double sign = vector(largest) < 0.0 ? -1.0 : 1.0;
    shapes_.col(b) = sign * std::sqrt(terms.eigenvalues()(from)) * vector;
  }
}

void AssemblyModel::set_tables(bool secant) {
  double least = 0.0;
  double most = 0.0;
  for (const Eigen::VectorXd& one : log_amplitude_) {
    least = std::min(least, one(0));
    most = std::max(most, one(one.size() - 1));
  }
  const double reach = std::log(kTableReach);
  const Eigen::VectorXd amplitude =
      Eigen::VectorXd::LinSpaced(kTableSize, least - reach, most + reach).array().exp();
  const Eigen::VectorXd square = amplitude.cwiseAbs2().cwiseInverse();
  dissipation_table_ = Table(amplitude, square.asDiagonal() * dissipation_rows(amplitude, knots_));
  const bool measured = std::ranges::any_of(
      levels_, [](const LevelEvidence* one) { return !one->levels().secant_stiffness.empty(); });
  if (secant && measured) softening_table_ = Table(amplitude, softening_rows(amplitude, knots_));
}

Eigen::VectorXd AssemblyModel::log_scaled(const AssemblyDeviations& all, Eigen::Index j,
                                          const Eigen::VectorXd& log_amplitude) const {
  return (log_amplitude.array() + log_stiffness(all, j) - all(j, force_column())).matrix();
}

Eigen::VectorXd AssemblyModel::shape_factor(const AssemblyDeviations& all, Eigen::Index j) const {
  const Eigen::VectorXd terms = all.row(j).tail(shapes_.cols()).transpose();
  return (shapes_ * terms).array().exp().matrix();
}

Eigen::VectorXd AssemblyModel::density(const Eigen::VectorXd& middle, const AssemblyDeviations& all,
                                       Eigen::Index j) const {
  return middle.cwiseProduct(shape_factor(all, j));
}

bool AssemblyModel::possible(const Eigen::VectorXd& middle, const AssemblyDeviations& all,
                             Eigen::Index j) const {
  const Eigen::VectorXd& amplitude = log_amplitude_[static_cast<std::size_t>(j)];
  const double moved = log_stiffness(all, j) - all(j, force_column());
  return dissipation_table_.reaches(amplitude(0) + moved) &&
         dissipation_table_.reaches(amplitude(amplitude.size() - 1) + moved) &&
         area(density(middle, all, j)) <= 1.0;
}

AssemblyDesign AssemblyModel::knot_design(const AssemblyDeviations& all, Eigen::Index j) const {
  const auto index = static_cast<std::size_t>(j);
  const Weights& weights = weights_[index];
  const Eigen::VectorXd& log_amplitude = log_amplitude_[index];
  const Eigen::VectorXd at = log_scaled(all, j, log_amplitude);
  const Eigen::VectorXd factor = shape_factor(all, j);
  const double kappa = std::exp(log_stiffness(all, j));
  const Eigen::VectorXd energy =
      kappa * weights.dissipation.cwiseProduct((2.0 * log_amplitude).array().exp().matrix());
  AssemblyDesign design;
  design.dissipation =
      energy.asDiagonal() * dissipation_table_.at(at).transpose() * factor.asDiagonal();
  if (weights.secant.size() == 0) {
    design.secant.resize(0, factor.size());
    design.stiffness.resize(0, factor.size());
    return design;
  }
  const Eigen::MatrixXd secant = -kappa * softening_table_.at(at).transpose() * factor.asDiagonal();
  const Eigen::RowVectorXd mean = weights.share.transpose() * secant;
  design.secant = weights.secant.asDiagonal() * (secant.rowwise() - mean);
  if (sought_) {
    design.stiffness = weights.stiffness * mean;
  } else {
    design.stiffness.resize(0, factor.size());
  }
  return design;
}

AssemblyDesign AssemblyModel::design(const AssemblyDeviations& all, Eigen::Index j) const {
  AssemblyDesign made = knot_design(all, j);
  made.dissipation *= nodal_;
  made.secant *= nodal_;
  made.stiffness *= nodal_;
  return made;
}

Eigen::VectorXd AssemblyModel::area_row(const AssemblyDeviations& all, Eigen::Index j) const {
  return nodal_.transpose() * knot_area_.cwiseProduct(shape_factor(all, j));
}

AssemblyRows AssemblyModel::predicted(const Eigen::VectorXd& middle, const AssemblyDeviations& all,
                                      Eigen::Index j) const {
  const auto index = static_cast<std::size_t>(j);
  const Weights& weights = weights_[index];
  const Eigen::VectorXd& log_amplitude = log_amplitude_[index];
  const Eigen::VectorXd at = log_scaled(all, j, log_amplitude);
  const Eigen::VectorXd own = density(middle, all, j);
  const double kappa = std::exp(log_stiffness(all, j));
  AssemblyRows rows;
  rows.dissipation = kappa * weights.dissipation.cwiseProduct(
                                 (2.0 * log_amplitude)
                                     .array()
                                     .exp()
                                     .matrix()
                                     .cwiseProduct(dissipation_table_.at(at).transpose() * own));
  if (weights.secant.size() == 0) return rows;
  const Eigen::VectorXd secant = -kappa * (softening_table_.at(at).transpose() * own);
  const double mean = weights.share.dot(secant);
  rows.secant = weights.secant.cwiseProduct((secant.array() - mean).matrix());
  if (sought_) rows.stiffness = Eigen::VectorXd::Constant(1, weights.stiffness * (kappa + mean));
  return rows;
}

Eigen::VectorXd AssemblyModel::dissipation(const Eigen::VectorXd& middle,
                                           const AssemblyDeviations& all, Eigen::Index j,
                                           const Eigen::VectorXd& amplitude) const {
  const Eigen::VectorXd log_amplitude = (amplitude.array() / length_).log().matrix();
  const Eigen::VectorXd own = density(middle, all, j);
  return energy_ * std::exp(log_stiffness(all, j)) *
         (2.0 * log_amplitude)
             .array()
             .exp()
             .matrix()
             .cwiseProduct(dissipation_table_.at(log_scaled(all, j, log_amplitude)).transpose() *
                           own);
}

double AssemblyModel::least_secant_scale() const {
  const bool given = std::ranges::any_of(
      levels_, [](const LevelEvidence* one) { return one->secant_std_given(); });
  return given ? 1.0 : 0.0;
}

void AssemblyModel::set_weights(const Eigen::VectorXd& middle, const AssemblyDeviations& all) {
  dissipation_count_ = 0.0;
  repeat_square_ = 0.0;
  secant_count_ = 0.0;
  for (Eigen::Index j = 0; j < assemblies(); ++j) set_weights_of(j, middle, all);
}

void AssemblyModel::set_weights_of(Eigen::Index j, const Eigen::VectorXd& middle,
                                   const AssemblyDeviations& all) {
  const auto index = static_cast<std::size_t>(j);
  const LevelEvidence& evidence = *levels_[index];
  const Levels& levels = evidence.levels();
  const Eigen::VectorXd amplitude = view_of(levels.amplitude);
  LevelPrediction prediction;
  const Eigen::VectorXd d =
      dissipation(middle, all, j, amplitude).cwiseMax(view_of(evidence.dissipation_floor()));
  prediction.value.dissipation.assign(d.begin(), d.end());
  prediction.value.secant_stiffness = levels.secant_stiffness;
  if (evidence.amplitude_std_counts()) {
    const Eigen::VectorXd step = view_of(levels.amplitude_std).cwiseMin(0.5 * amplitude);
    const Eigen::VectorXd change = 0.5 * (dissipation(middle, all, j, amplitude + step) -
                                          dissipation(middle, all, j, amplitude - step));
    prediction.change.dissipation.assign(change.begin(), change.end());
  }
  const double k = stiffness_ * std::exp(log_stiffness(all, j));
  LevelScatter scatter;
  if (has_secant() && !levels.secant_stiffness.empty()) {
    scatter.secant_stiffness = evidence.expected_scatter(k).secant_stiffness;
  }
  const LevelRows deviation = evidence.deviations(prediction, scatter);
  dissipation_count_ += evidence.informative_levels(prediction) + evidence.repeat_freedom();
  repeat_square_ += evidence.repeat_sum(deviation);

  Weights& weights = weights_[index];
  AssemblyRows& data = data_[index];
  weights.dissipation = energy_ * view_of(deviation.dissipation).cwiseInverse();
  data.dissipation = weights.dissipation.cwiseProduct(view_of(levels.dissipation)) / energy_;
  if (!has_secant() || levels.secant_stiffness.empty()) return;
  weights.secant = stiffness_ * view_of(deviation.secant_stiffness).cwiseInverse();
  const Eigen::VectorXd precision = weights.secant.cwiseAbs2();
  weights.share = precision / precision.sum();
  const Eigen::VectorXd secant = view_of(levels.secant_stiffness) / stiffness_;
  const double mean = weights.share.dot(secant);
  data.secant = weights.secant.cwiseProduct((secant.array() - mean).matrix());
  secant_count_ += static_cast<double>(secant.size()) - 1.0;
  if (!sought_) return;
  // Given deviations may be an error common to neighbouring levels.
  weights.stiffness = evidence.secant_std_given() ? precision.sum() / weights.secant.sum()
                                                  : std::sqrt(precision.sum());
  data.stiffness = Eigen::VectorXd::Constant(1, weights.stiffness * mean);
}

}  // namespace microslip
