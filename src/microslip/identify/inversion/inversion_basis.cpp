// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_basis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// The knots reach this many e-folds below the lowest amplitude, and the tail, one knot an e-fold,
/// these further down.
constexpr double kFoldsBelow = 1.5;
constexpr int kTailKnots = 3;

double first_knot(double lowest, double top) {
  return std::min(lowest, 0.5 * top) * std::exp(-kFoldsBelow);
}

}  // namespace

// Equally spaced in s^P, P ≤ ½: at equal relative scatter of D the width that can be resolved grows
// as A^0.8, so this is finer than the data at the top and follows them down over any number of
// decades.
InversionBasis::InversionBasis(double lowest, double top, double exponent, int coefficients,
                               const std::vector<BasisEdge>& edges)
    : intervals_(coefficients - 1.0), coordinate_(coefficients + std::ssize(edges)), first_{0} {
  const double first = first_knot(lowest, top);
  set_range(first, top);
  auto edge = edges.begin();
  Eigen::Index row = 0;
  for (int j = 0; j < coefficients; ++j) {
    const bool is_edge = edge != edges.end() && edge->knot == j;
    coordinate_(row++) = is_edge ? edge->at : j;
    knots_.push_back(slip_force(coordinate_(row - 1)));
    if (!is_edge) continue;
    first_.push_back(row);
    coordinate_(row++) = edge->at;
    knots_.push_back(knots_.back() * (1.0 + kWidth));
    ++edge;
  }
  set_ends(first, top, exponent);
}

InversionBasis::InversionBasis(double lowest, double top, double exponent,
                               const std::vector<double>& places)
    : intervals_(static_cast<double>(places.size()) - 1.0),
      coordinate_(Eigen::VectorXd::LinSpaced(std::ssize(places), 0.0, intervals_)),
      first_{0} {
  const double first = first_knot(lowest, top);
  set_range(first, top);
  for (const double place : places) knots_.push_back(slip_force(place));
  set_ends(first, top, exponent);
}

/// The coordinate of the knots, and the knots of the tail.
void InversionBasis::set_range(double first, double top) {
  power_ = std::min(0.5, std::log(10.0) / std::log(1.0 / first));
  from_ = std::pow(first, power_);
  to_ = std::pow(top, power_);
  for (int i = kTailKnots; i > 0; --i) knots_.push_back(first * std::exp(-i));
}

void InversionBasis::set_ends(double first, double top, double exponent) {
  knots_[kTailKnots] = first;
  knots_.back() = top;
  nodal_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(knots_.size()), size());
  for (Eigen::Index j = 0; j < nodal_.rows(); ++j) {
    const double reference = std::pow(knots_[static_cast<std::size_t>(j)], exponent);
    nodal_(j, std::max<Eigen::Index>(0, j - kTailKnots)) = reference;
  }
}

std::vector<double> InversionBasis::edges() const {
  std::vector<double> all;
  for (Eigen::Index range = 1; range < ranges(); ++range) {
    all.push_back(slip_force(coordinate_(first_[static_cast<std::size_t>(range)])));
  }
  return all;
}

Eigen::Index InversionBasis::size_of(Eigen::Index range) const {
  const auto r = static_cast<std::size_t>(range);
  return (r + 1 < first_.size() ? first_[r + 1] : size()) - first_[r];
}

double InversionBasis::slip_force(double at) const {
  return std::pow(from_ + (to_ - from_) * (at / intervals_), 1.0 / power_);
}

double InversionBasis::place(double s) const {
  return intervals_ * (std::pow(s, power_) - from_) / (to_ - from_);
}

Eigen::MatrixXd InversionBasis::dissipation(const Eigen::VectorXd& amplitude) const {
  return dissipation_rows(amplitude, knots_) * nodal_;
}

Eigen::MatrixXd InversionBasis::softening(const Eigen::VectorXd& amplitude) const {
  return softening_rows(amplitude, knots_) * nodal_;
}

Eigen::VectorXd InversionBasis::knot_places() const {
  Eigen::VectorXd places(nodal_.rows());
  for (Eigen::Index j = 0; j < places.size(); ++j) {
    places(j) = coordinate_(std::max<Eigen::Index>(0, j - kTailKnots)) / intervals_;
  }
  return places;
}

Eigen::VectorXd InversionBasis::knot_area() const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(nodal_.rows());
  weights(0) = knots_.front();
  for (Eigen::Index j = 0; j + 1 < nodal_.rows(); ++j) {
    const double half =
        0.5 * (knots_[static_cast<std::size_t>(j) + 1] - knots_[static_cast<std::size_t>(j)]);
    weights(j) += half;
    weights(j + 1) += half;
  }
  return weights;
}

Eigen::VectorXd InversionBasis::area() const { return nodal_.transpose() * knot_area(); }

// The second derivative by three neighbours, times the root of the length that it stands for: the
// sum of squares is close to the integral of its square.
Eigen::MatrixXd InversionBasis::second_differences() const {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(size() - 2 * ranges(), size());
  Eigen::Index row = 0;
  for (Eigen::Index range = 0; range < ranges(); ++range) {
    const Eigen::Index begin = first_[static_cast<std::size_t>(range)];
    for (Eigen::Index i = begin + 1; i + 1 < begin + size_of(range); ++i, ++row) {
      const double left = (coordinate_(i) - coordinate_(i - 1)) / intervals_;
      const double right = (coordinate_(i + 1) - coordinate_(i)) / intervals_;
      const double scale = std::sqrt(0.5 * (left + right));
      rows(row, i - 1) = scale * 2.0 / (left * (left + right));
      rows(row, i) = -scale * 2.0 / (left * right);
      rows(row, i + 1) = scale * 2.0 / (right * (left + right));
    }
  }
  return rows;
}

Eigen::VectorXd InversionBasis::middles() const {
  Eigen::VectorXd at(size() - 2 * ranges());
  Eigen::Index row = 0;
  for (Eigen::Index range = 0; range < ranges(); ++range) {
    const Eigen::Index count = size_of(range) - 2;
    at.segment(row, count) =
        coordinate_.segment(first_[static_cast<std::size_t>(range)] + 1, count);
    row += count;
  }
  return at;
}

}  // namespace microslip
