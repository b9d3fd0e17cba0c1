// SPDX-License-Identifier: MIT
#include "microslip/calibrate/joint_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "microslip/base/interpolation.hpp"
#include "microslip/observe/level_rows.hpp"

namespace microslip {
namespace {

/// Parts of an interval of the basis over which a power law is drawn.
constexpr int kRefinement = 4;
constexpr int kTailFolds = 12;

Eigen::VectorXd trapezoid_weights(const std::vector<double>& knots) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(knots.size()));
  for (Eigen::Index i = 0; i + 1 < weights.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double half = 0.5 * (knots[at + 1] - knots[at]);
    weights(i) += half;
    weights(i + 1) += half;
  }
  return weights;
}

BasisEdge place_of(const InversionBasis& uniform, double s) {
  const double at = uniform.place(s);
  return {static_cast<int>(std::lround(at)), at};
}

/// As the range grows its knots move: two edges may come as close as neighbouring ones.
std::vector<BasisEdge> places_with_room(const InversionBasis& uniform, double length,
                                        int coefficients, const std::vector<double>& edges) {
  std::vector<BasisEdge> places;
  int knot = 0;
  for (const double x : edges) {
    const BasisEdge edge = place_of(uniform, x / length);
    if (edge.knot <= knot || edge.knot + 1 >= coefficients) continue;
    knot = edge.knot;
    places.push_back(edge);
  }
  return places;
}

/// Closer to each other, relative, two knots are those of an edge, or one.
constexpr double kOfAnEdge = 10.0 * InversionBasis::kWidth;
constexpr double kSameKnot = 1e-3 * InversionBasis::kWidth;

}  // namespace

JointUnknowns::JointUnknowns(double stiffness, double length, double lowest, double exponent,
                             int coefficients, const std::vector<double>& edges)
    : JointUnknowns(stiffness, length, lowest, exponent, coefficients,
                    places_with_room(InversionBasis(lowest, 1.0, exponent, coefficients), length,
                                     coefficients, edges)) {}

JointUnknowns::JointUnknowns(double stiffness, double length, double lowest, double exponent,
                             int coefficients, const std::vector<BasisEdge>& edges)
    : stiffness_(stiffness),
      length_(length),
      lowest_(lowest),
      exponent_(exponent),
      coefficients_(coefficients),
      basis_(lowest, 1.0, exponent, coefficients, edges),
      empty_(static_cast<std::size_t>(basis_.ranges()), false),
      theta_scale_(0.5 / basis_.area().sum()) {
  if (exponent != 0.0) begin_power_law();
  refine(exponent == 0.0 ? 1 : kRefinement);
  // The first coefficient includes the knots below the lowest amplitude.
  const auto below = static_cast<Eigen::Index>(basis_.knots().size()) - basis_.size();
  place_.assign(basis_.knots().begin() + below, basis_.knots().end());
  there_ = basis_.nodal().bottomRows(basis_.size()).diagonal();
  read_density();
}

void JointUnknowns::read_density() {
  slip_.assign(1, 0.0);
  for (const double s : knots_) slip_.push_back(length_ * s);
  density_ = Eigen::MatrixXd::Zero(nodal_.rows() + 1, size());
  density_.bottomLeftCorner(nodal_.rows(), nodal_.cols()) =
      (stiffness_ / length_ * theta_scale_) * nodal_;
  density_.row(0) = density_.row(1);  // constant below the first knot
  area_ = trapezoid_weights(slip_).transpose() * density_ / stiffness_;
}

JointUnknowns JointUnknowns::with_edges(const std::vector<BasisEdge>& edges) const {
  return {stiffness_, length_, lowest_, exponent_, coefficients_, edges};
}

JointUnknowns JointUnknowns::without(const std::vector<bool>& empty) const {
  JointUnknowns fewer = with_edges(basis_edges());
  fewer.empty_ = empty;
  const std::vector<Eigen::Index> columns = fewer.kept();
  fewer.nodal_ = fewer.nodal_(Eigen::all, columns).eval();
  fewer.there_ = fewer.there_(columns).eval();
  std::vector<double> places;
  for (const Eigen::Index c : columns) places.push_back(fewer.place_[static_cast<std::size_t>(c)]);
  fewer.place_ = std::move(places);
  fewer.read_density();
  return fewer;
}

/// θ of the basis that are not of empty ranges.
std::vector<Eigen::Index> JointUnknowns::kept() const {
  std::vector<Eigen::Index> columns;
  Eigen::Index begin = 0;
  for (Eigen::Index range = 0; range < basis_.ranges(); ++range) {
    const Eigen::Index end = begin + basis_.size_of(range);
    for (; begin < end; ++begin) {
      if (!empty_[static_cast<std::size_t>(range)]) columns.push_back(begin);
    }
  }
  return columns;
}

/// Rows of the second differences of the basis that are of those.
std::vector<Eigen::Index> JointUnknowns::kept_rows() const {
  std::vector<Eigen::Index> rows;
  Eigen::Index begin = 0;
  for (Eigen::Index range = 0; range < basis_.ranges(); ++range) {
    const Eigen::Index end = begin + std::max<Eigen::Index>(0, basis_.size_of(range) - 2);
    for (; begin < end; ++begin) {
      if (!empty_[static_cast<std::size_t>(range)]) rows.push_back(begin);
    }
  }
  return rows;
}

Eigen::MatrixXd JointUnknowns::penalty() const {
  return basis_.second_differences()(kept_rows(), kept());
}

Eigen::VectorXd JointUnknowns::middles() const { return basis_.middles()(kept_rows()); }

JointUnknowns JointUnknowns::by_knots(const std::vector<double>& edges) const {
  JointUnknowns all = with_edges({});
  for (const double x : edges) {
    all.knots_.push_back(x / length_);
    all.knots_.push_back(x / length_ * (1.0 + InversionBasis::kWidth));
  }
  std::ranges::sort(all.knots_);
  const auto same = [](double left, double right) { return right - left < kSameKnot * right; };
  all.knots_.erase(std::unique(all.knots_.begin(), all.knots_.end(), same), all.knots_.end());
  const auto count = static_cast<Eigen::Index>(all.knots_.size());
  all.nodal_ = Eigen::MatrixXd::Identity(count, count);
  all.place_ = all.knots_;
  all.there_ = Eigen::VectorXd::Ones(count);
  all.read_density();
  return all;
}

std::vector<double> JointUnknowns::edges() const {
  std::vector<double> all = basis_.edges();
  for (double& s : all) s *= length_;
  return all;
}

std::vector<BasisEdge> JointUnknowns::basis_edges() const {
  std::vector<BasisEdge> all;
  for (const double s : basis_.edges()) all.push_back(place_of(uniform(), s));
  return all;
}

std::vector<Eigen::Index> JointUnknowns::ranges() const {
  std::vector<Eigen::Index> counts;
  for (Eigen::Index range = 0; range < basis_.ranges(); ++range) {
    if (!empty_[static_cast<std::size_t>(range)]) counts.push_back(basis_.size_of(range));
  }
  return counts;
}

// Below the knots of the basis θ is constant and ψ goes on as the power law, on knots an e-fold
// apart: its stiffness there is small, but frequencies are known well.
void JointUnknowns::begin_power_law() {
  const double first = basis_.knots().front();
  for (int i = kTailFolds; i > 0; --i) knots_.push_back(first * std::exp(-i));
}

// θ is linear between the knots of the basis, and ψ = s^χ₀ θ(s) is drawn through more of them:
// straight lines between those alone would lie above a power law.
void JointUnknowns::refine(int parts) {
  const std::vector<double>& coarse = basis_.knots();
  const Eigen::MatrixXd& nodal = basis_.nodal();
  const auto power = [this](double s) { return std::pow(s, exponent_); };
  const auto tail = static_cast<Eigen::Index>(knots_.size());
  const auto parts_after = [&](std::size_t i) {
    return coarse[i + 1] - coarse[i] < kOfAnEdge * coarse[i] ? 1 : parts;
  };
  Eigen::Index rows = tail + 1;
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i) rows += parts_after(i);
  nodal_.resize(rows, basis_.size());
  for (Eigen::Index i = 0; i < tail; ++i) {
    const double s = knots_[static_cast<std::size_t>(i)];
    nodal_.row(i) = power(s) / power(coarse.front()) * nodal.row(0);
  }
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::RowVectorXd left = nodal.row(row) / power(coarse[i]);
    const Eigen::RowVectorXd right = nodal.row(row + 1) / power(coarse[i + 1]);
    for (int part = 0; part < parts_after(i); ++part) {
      const double share = static_cast<double>(part) / parts_after(i);
      const double s = coarse[i] + share * (coarse[i + 1] - coarse[i]);
      nodal_.row(static_cast<Eigen::Index>(knots_.size())) =
          power(s) * ((1.0 - share) * left + share * right);
      knots_.push_back(s);
    }
  }
  nodal_.bottomRows(1) = nodal.bottomRows(1);
  knots_.push_back(coarse.back());
}

Eigen::RowVectorXd JointUnknowns::dissipation_row(double amplitude) const {
  const Eigen::VectorXd scaled = Eigen::VectorXd::Constant(1, amplitude / length_);
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(size());
  row.head(nodal_.cols()) =
      (stiffness_ * length_ * length_ * theta_scale_) * (dissipation_rows(scaled, knots_) * nodal_);
  return row;
}

Eigen::RowVectorXd JointUnknowns::secant_row(double amplitude) const {
  const Eigen::VectorXd scaled = Eigen::VectorXd::Constant(1, amplitude / length_);
  Eigen::RowVectorXd row = stiffness_ * stiffness_row();
  row.head(nodal_.cols()) -=
      (stiffness_ * theta_scale_) * (softening_rows(scaled, knots_) * nodal_);
  return row;
}

Eigen::RowVectorXd JointUnknowns::stiffness_row() const {
  Eigen::RowVectorXd row = area_;
  row(nodal_.cols()) = 1.0;
  return row;
}

Joint JointUnknowns::joint(const Eigen::VectorXd& x, bool known) const {
  const double share = stiffness_row().dot(x);
  const double k = known ? stiffness_ : stiffness_ * share;
  const Eigen::VectorXd psi = density_ * x / (known ? share : 1.0);
  PiecewiseLinearPart part;
  for (std::size_t i = 0; i < slip_.size(); ++i) {
    part.slip_force.push_back(k * slip_[i]);
    part.density.push_back(std::max(0.0, psi(static_cast<Eigen::Index>(i))) / (k * k));
  }
  return {k, SlipDensity({std::move(part)})};
}

Eigen::VectorXd JointUnknowns::stuck() const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size());
  x(size() - 1) = 1.0;
  return x;
}

Eigen::VectorXd JointUnknowns::projected(const JointUnknowns& other,
                                         const Eigen::VectorXd& x) const {
  const Eigen::VectorXd psi = other.density_ * x;
  const std::vector<double> density(psi.begin(), psi.end());
  Eigen::VectorXd found = Eigen::VectorXd::Zero(size());
  for (Eigen::Index c = 0; c < there_.size(); ++c) {
    const double s = place_[static_cast<std::size_t>(c)];
    const double at = std::min(length_ * s, other.slip_.back());
    found(c) =
        interpolate(other.slip_, density, at) / (stiffness_ / length_ * theta_scale_ * there_(c));
  }
  const double whole = other.stiffness_row().dot(x);
  const double slips = stiffness_row().dot(found);
  if (slips > whole) return whole / slips * found;
  found(size() - 1) = whole - slips;
  return found;
}

}  // namespace microslip
