// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/residual_flexibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/structure/spring_shares.hpp"
#include "microslip/structure/static_compliance.hpp"

namespace microslip {
namespace {

using Eigen::Index;

constexpr double kAboveAllModes = 10.0;
constexpr double kRounded = 1e-6;  // of √(R_pp R_qq): a table may have seven digits
constexpr std::string_view kOfTheModes =
    "Take the residual of the structure with the springs across the joints, as its modes were.";
constexpr double kNothing = 1e-12;  // of a λ, of which the largest is between 1 and their number

const Mode& highest_mode(const JointedStructure& structure) {
  const std::span<const Mode> modes = structure.linear().modes();
  return *std::ranges::max_element(modes.first(structure.linear().vibrations()), {},
                                   &Mode::angular_frequency);
}

/// Index of each name in a list.
template <typename Named>
std::vector<std::size_t> indices_of(const std::vector<std::string>& names,
                                    std::span<const Named> there, const char* what) {
  std::vector<std::size_t> indices;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(there, name, &Named::name);
    const std::string key = fmt::format("{} of the residual", what);
    if (found == there.end()) {
      throw InputError(key, fmt::format("'{}'", name),
                       fmt::format("must be a {} of the model", what));
    }
    const auto index = static_cast<std::size_t>(found - there.begin());
    if (std::ranges::find(indices, index) != indices.end()) {
      throw InputError(key, fmt::format("'{}'", name), "must not occur twice");
    }
    indices.push_back(index);
  }
  return indices;
}

/// Without a compliance of its own a place has none with others either.
void check_diagonal(const Eigen::MatrixXd& matrix, Index i) {
  const bool alone =
      matrix(i, i) == 0.0 && !(matrix.row(i).isZero(0.0) && matrix.col(i).isZero(0.0));
  if (matrix(i, i) >= 0.0 && !alone) return;
  throw InputError(
      fmt::format("compliance of the residual[{}, {}]", i, i), matrix(i, i),
      alone ? "must be above 0 where others in its row are not 0" : "must be 0 or more");
}

Eigen::MatrixXd checked_matrix(const ResidualFlexibility& residual) {
  const std::size_t places = residual.points.size() + residual.joints.size();
  if (places == 0 || residual.compliance.size() != places * places) {
    throw InputError("compliance of the residual",
                     fmt::format("{} values", residual.compliance.size()),
                     fmt::format("must have {}, by rows, one per point and joint that it names",
                                 std::max<std::size_t>(places * places, 1)));
  }
  const auto size = static_cast<Index>(places);
  const Eigen::Map<const Eigen::MatrixXd> matrix(residual.compliance.data(), size, size);
  if (!matrix.allFinite()) {
    throw InputError("compliance of the residual", "not a number", "must be finite");
  }
  for (Index i = 0; i < size; ++i) {
    check_diagonal(matrix, i);
    for (Index j = 0; j < i; ++j) {
      const double scale = std::sqrt(matrix(i, i) * matrix(j, j));
      if (std::abs(matrix(i, j) - matrix(j, i)) <= kRounded * scale) continue;
      throw InputError(fmt::format("compliance of the residual[{}, {}]", j, i), matrix(i, j),
                       fmt::format("must be that of [{}, {}], {:g}", i, j, matrix(j, i)));
    }
  }
  return 0.5 * (matrix + matrix.transpose());
}

double largest_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

[[noreturn]] void refuse_beside_spring(const JointedStructure& structure,
                                       const StructuralJoint& joint, double given) {
  const double most = 1.0 / joint.spring_in_modes;
  const double in_modes = static_compliance(structure.linear().modes(), joint.shape);
  throw InputError(
      fmt::format("compliance of the residual of joint '{}'", joint.name),
      fmt::format("{:g} m/N", given),
      fmt::format("must be at most {:.4g} m/N: with the {:.4g} m/N of the modes not above "
                  "the 1/k of the spring of {:g} N/m that they contain",
                  std::max(most - in_modes, 0.0), in_modes, joint.spring_in_modes),
      std::string(kOfTheModes));
}

/// Springs that the modes contain, K = diag(k), yield K⁻¹ at most, whatever is beside them.
/// @param residual  of the joints.
void check_beside_springs(const JointedStructure& structure, const std::vector<std::size_t>& joints,
                          const Eigen::MatrixXd& residual) {
  if (joints.empty()) return;
  const Eigen::VectorXd roots = spring_roots(structure.joints());
  const Eigen::MatrixXd shares = spring_shares(structure.linear().modes(), structure.joints());
  Eigen::MatrixXd all = shares;
  for (std::size_t a = 0; a < joints.size(); ++a) {
    for (std::size_t b = 0; b < joints.size(); ++b) {
      const auto row = static_cast<Index>(joints[a]);
      const auto column = static_cast<Index>(joints[b]);
      all(row, column) +=
          roots(row) * roots(column) * residual(static_cast<Index>(a), static_cast<Index>(b));
    }
  }
  // Modes with an error may have more by themselves.
  const double allowed =
      std::max(1.0 + kSpringTolerance, (1.0 + kRounded) * largest_eigenvalue(shares));
  const double found = largest_eigenvalue(all);
  if (found <= allowed) return;
  std::string names;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto at = static_cast<Index>(joints[i]);
    const StructuralJoint& joint = structure.joints()[joints[i]];
    const double given = residual(static_cast<Index>(i), static_cast<Index>(i));
    if (all(at, at) > allowed) refuse_beside_spring(structure, joint, given);
    if (joint.spring_in_modes == 0.0) continue;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", joint.name);
  }
  throw InputError(
      "compliance of the residual of joints " + names,
      fmt::format("{:.4g} times 1/k of the springs in the modes, with the compliance of the modes",
                  found),
      "must be at most 1 times for any forces at the joints together", std::string(kOfTheModes));
}

}  // namespace

double static_mode_frequency(const JointedStructure& structure) {
  const double highest = highest_mode(structure).angular_frequency;
  if (highest > 0.0) return kAboveAllModes * highest;
  throw InputError("modes of the structure", "all of rigid bodies",
                   "must have at least one elastic mode where there is a residual");
}

FurtherMode static_mode_at_rest(const JointedStructure& structure) {
  return {.mode = {static_mode_frequency(structure), highest_mode(structure).loss_factor},
          .points = std::vector<double>(structure.linear().points().size(), 0.0),
          .joints = std::vector<double>(structure.joints().size(), 0.0)};
}

std::vector<FurtherMode> static_modes(const JointedStructure& structure,
                                      const ResidualFlexibility& residual) {
  const std::vector<std::size_t> points =
      indices_of(residual.points, structure.linear().points(), "point");
  const std::vector<std::size_t> joints = indices_of(residual.joints, structure.joints(), "joint");
  const Eigen::MatrixXd matrix = checked_matrix(residual);
  const Eigen::VectorXd size = matrix.diagonal().cwiseSqrt();
  std::vector<FurtherMode> modes;
  if (size.isZero(0.0)) return modes;
  const Eigen::VectorXd inverse = size.unaryExpr([](double s) { return s > 0.0 ? 1.0 / s : 0.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      (inverse.asDiagonal() * matrix * inverse.asDiagonal()).eval());
  const Eigen::VectorXd& eigenvalues = solver.eigenvalues();
  if (eigenvalues.minCoeff() < -kRounded) {
    throw InputError("compliance of the residual",
                     fmt::format("a negative eigenvalue, {:.4g} over the roots of its diagonal",
                                 eigenvalues.minCoeff()),
                     "must have none: no structure moves against a force",
                     "Subtract the elastic modes of the model alone from the static compliance.");
  }
  const auto of_joints = static_cast<Index>(joints.size());
  check_beside_springs(structure, joints, matrix.bottomRightCorner(of_joints, of_joints));
  const FurtherMode still = static_mode_at_rest(structure);
  for (Index m = 0; m < eigenvalues.size(); ++m) {
    if (eigenvalues(m) <= kNothing) continue;
    const Eigen::VectorXd shape = still.mode.angular_frequency * std::sqrt(eigenvalues(m)) *
                                  size.cwiseProduct(solver.eigenvectors().col(m));
    FurtherMode mode = still;
    const auto count = static_cast<Index>(points.size());
    for (Index p = 0; p < count; ++p) mode.points[points[static_cast<std::size_t>(p)]] = shape(p);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      mode.joints[joints[j]] = shape(count + static_cast<Index>(j));
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace microslip
