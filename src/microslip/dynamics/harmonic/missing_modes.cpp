// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/missing_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/dynamics/structure/residual_flexibility.hpp"
#include "microslip/dynamics/structure/spring_shares.hpp"
#include "microslip/structure/static_compliance.hpp"

namespace microslip {
namespace {

using Eigen::Index;

constexpr double kOrthogonal = 1e-3;  // of two shapes, relative: files may have four digits
constexpr double kLargeResidual =
    100.0;                          // over what vibrations have: a local spring may be far softer
constexpr double kFirst = 0.75;     // of i′: between bars fixed at one end, ½, and free ones, 1
constexpr double kFlattest = 0.75;  // p: plates have 1, beams 2
constexpr double kSteepest = 3.0;
/// Of the trend: springs that are all that holds a joint leave nothing but rounding.
constexpr double kNothingLeft = 1e-9;
constexpr double kConvergent = 0.5;  // of 2p − s − 1: at 0 no number of modes would be enough

double overlap_of(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Points at masses of their own, of a structure that has no more: φ of all modes are orthogonal
/// there.
bool seems_whole(const ModalModel& linear) {
  const std::span<const ModalPoint> points = linear.points();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double own = overlap_of(points[p].shape, points[p].shape);
    for (std::size_t q = 0; q < p; ++q) {
      const double other = overlap_of(points[q].shape, points[q].shape);
      const double shared = std::abs(overlap_of(points[p].shape, points[q].shape));
      if (shared > kOrthogonal * std::sqrt(own * other)) return false;
    }
  }
  return points.size() > 1 && points.size() >= linear.size();
}

/// The numbers of the elastic modes, from the slowest on.
std::vector<std::size_t> elastic_modes(std::span<const Mode> modes) {
  std::vector<std::size_t> elastic;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].angular_frequency > 0.0) elastic.push_back(i);
  }
  std::ranges::stable_sort(elastic, {}, [&](std::size_t i) { return modes[i].angular_frequency; });
  return elastic;
}

double largest_square(std::span<const std::size_t> numbers, std::span<const double> shape) {
  double most = 0.0;
  for (const std::size_t i : numbers) most = std::max(most, shape[i] * shape[i]);
  return most;
}

/// The slope over ln i′ from the last of the lower half to the last of all.
double slope(double lower, double upper, std::size_t below, std::size_t all) {
  const double from = static_cast<double>(below) - 1.0 + kFirst;
  const double to = static_cast<double>(all) - 1.0 + kFirst;
  return std::log(upper / lower) / std::log(to / from);
}

/// R of a place, m/N. @param elastic  two or more.
double beyond(std::span<const Mode> modes, std::span<const std::size_t> elastic,
              std::span<const double> shape) {
  const std::size_t n = elastic.size();
  const std::size_t below = n / 2;
  const double last = modes[elastic.back()].angular_frequency;
  const double p = std::clamp(slope(modes[elastic[below - 1]].angular_frequency, last, below, n),
                              kFlattest, kSteepest);
  const double lower = largest_square(elastic.first(below), shape);
  const double upper = largest_square(elastic.subspan(below), shape);
  const bool grows = lower > 0.0 && upper > lower;
  const double most = 2.0 * p - 1.0 - kConvergent;
  const double s = grows ? std::clamp(slope(lower, upper, below, n), 0.0, most) : 0.0;
  const double end = static_cast<double>(n) - 1.0 + kFirst;
  return std::max(lower, upper) / (last * last) * end *
         std::pow(1.0 + 0.5 / end, 1.0 + s - 2.0 * p) / (2.0 * p - s - 1.0);
}

/// F of (R⁻¹ + B⁻¹)⁻¹ = FFᵀ of R = diag(trend), so that rounding makes it no less than 0: with
/// W = diag(√(kR)) and A = I − K^½CK^½, F = R^½ V diag(√g) of the eigenvectors V and eigenvalues
/// g, from 0 to 1, of I − W(A + W²)⁻¹W, without those that are 0.
Eigen::MatrixXd beside_springs(const JointedStructure& structure, const Eigen::VectorXd& trend) {
  const Eigen::MatrixXd shares = spring_shares(structure.linear().modes(), structure.joints());
  const Index size = shares.rows();
  const Eigen::VectorXd scaled = spring_roots(structure.joints()).cwiseProduct(trend.cwiseSqrt());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> rest(
      (Eigen::MatrixXd::Identity(size, size) - shares).eval());
  const Eigen::MatrixXd sum = rest.eigenvectors() * rest.eigenvalues().cwiseMax(0.0).asDiagonal() *
                              rest.eigenvectors().transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      (sum + Eigen::MatrixXd(scaled.cwiseAbs2().asDiagonal())).eval());
  // Where the sum is 0, W is.
  const double least = static_cast<double>(size) * std::numeric_limits<double>::epsilon() *
                       std::max(1.0, solver.eigenvalues().maxCoeff());
  const Eigen::VectorXd inverse = solver.eigenvalues().unaryExpr(
      [&](double value) { return value > least ? 1.0 / value : 0.0; });
  const Eigen::MatrixXd moved = scaled.asDiagonal() * solver.eigenvectors();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> left(
      (Eigen::MatrixXd::Identity(size, size) - moved * inverse.asDiagonal() * moved.transpose())
          .eval());
  const Index held = (left.eigenvalues().array() < kNothingLeft).count();  // the first
  return trend.cwiseSqrt().asDiagonal() * left.eigenvectors().rightCols(size - held) *
         left.eigenvalues().tail(size - held).cwiseSqrt().asDiagonal();
}

/// F, across the joints, of the compliance FFᵀ of likely_missing_modes(), √(m/N); 0 × 0 without
/// them.
Eigen::MatrixXd likely_residual(const JointedStructure& structure) {
  const std::span<const Mode> modes = structure.linear().modes();
  const std::vector<std::size_t> elastic = elastic_modes(modes);
  if (elastic.size() < 2 || structure.joints().empty() || seems_whole(structure.linear())) {
    return {};
  }
  Eigen::VectorXd trend(static_cast<Index>(structure.joints().size()));
  for (Index j = 0; j < trend.size(); ++j) {
    trend(j) = beyond(modes, elastic, structure.joints()[static_cast<std::size_t>(j)].shape);
  }
  return beside_springs(structure, trend);
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

Warning not_estimated(const std::string& why, const std::string& remedy) {
  return {"modes_missing",
          fmt::format("the effect of modes beyond those of the model could not be estimated; it "
                      "may be large: {}. {}",
                      why, remedy)};
}

}  // namespace

std::vector<FurtherMode> likely_missing_modes(const JointedStructure& structure) {
  const Eigen::MatrixXd factor = likely_residual(structure);
  std::vector<FurtherMode> modes;
  for (Index m = 0; m < factor.cols(); ++m) {
    FurtherMode mode = static_mode_at_rest(structure);
    const Eigen::VectorXd shape = mode.mode.angular_frequency * factor.col(m);
    mode.joints.assign(shape.begin(), shape.end());
    modes.push_back(std::move(mode));
  }
  return modes;
}

std::vector<MissingCompliance> missing_compliance(const JointedStructure& structure) {
  const Eigen::MatrixXd factor = likely_residual(structure);
  std::vector<MissingCompliance> found;
  for (Index j = 0; j < factor.rows(); ++j) {
    const StructuralJoint& joint = structure.joints()[static_cast<std::size_t>(j)];
    found.push_back({joint.name, joint.joint.stiffness(),
                     static_compliance(structure.linear().modes(), joint.shape),
                     factor.row(j).squaredNorm()});
  }
  return found;
}

std::optional<CurveChange> judge_missing_modes(const HarmonicBalance& balance,
                                               const ResponseCurve& curve, Quantity kept) {
  if (curve.points.empty() || balance.structure().joints().empty()) return std::nullopt;
  const std::vector<FurtherMode> further = likely_missing_modes(balance.structure());
  if (further.empty()) return std::nullopt;
  const HarmonicBalance more(with_further_modes(balance.structure(), further), balance.response(),
                             balance.options());
  return solve_again(more, curve, kept, PointsAgain::kInResonance);
}

std::optional<Warning> missing_modes_warning(const std::vector<MissingCompliance>& missing,
                                             const std::string& remedy) {
  const auto most = std::ranges::max_element(missing, {}, &MissingCompliance::over_joint);
  if (most == missing.end() || most->over_joint() <= kMissingModesAllowed) return std::nullopt;
  return Warning{
      "modes_missing",
      fmt::format("modes beyond those of the model may add {:.2g} m/N to the static compliance of "
                  "{:.4g} m/N at '{}': {} of 1/k of the joint (estimated from the last "
                  "modes). {}",
                  most->missing, most->in_modes, most->joint, percent(most->over_joint()), remedy)};
}

std::optional<Warning> large_residual_warning(const JointedStructure& structure) {
  const std::span<const Mode> modes = structure.linear().modes();
  const std::size_t count = structure.linear().vibrations();
  for (const StructuralJoint& joint : structure.joints()) {
    const std::span<const double> shape(joint.shape);
    const double vibrating = static_compliance(modes.first(count), shape.first(count));
    const double residual = static_compliance(modes.subspan(count), shape.subspan(count));
    if (residual <= kLargeResidual * vibrating) continue;
    return Warning{"residual_large",
                   fmt::format("the residual compliance is {:.4g} m/N at '{}', that of the modes "
                               "{:.4g} m/N: check the unit, and whether the modes "
                               "were subtracted",
                               residual, joint.name, vibrating)};
  }
  return std::nullopt;
}

std::optional<Warning> changed_curve_warning(const CurveChange& change, const std::string& remedy) {
  if (change.unsolved) return not_estimated(*change.unsolved, remedy);
  if (change.frequency > kMissingModesFar) {
    return not_estimated("with an estimate of them the resonance is a different one", remedy);
  }
  if (change.level <= kMissingModesAllowed && change.dissipation <= kMissingModesAllowed &&
      change.frequency <= kMissingModesDetune) {
    return std::nullopt;
  }
  return Warning{"modes_missing",
                 fmt::format("modes beyond those of the model may change the level by {}, the "
                             "frequency by {} and the dissipation of a joint by {} (estimated from "
                             "the last modes). {}",
                             percent(change.level), percent(change.frequency),
                             percent(change.dissipation), remedy)};
}

}  // namespace microslip
