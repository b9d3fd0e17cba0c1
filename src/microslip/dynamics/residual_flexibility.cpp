// SPDX-License-Identifier: MIT
#include "microslip/dynamics/residual_flexibility.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Eigen::Index;

constexpr double kAboveAllModes = 4.0;
constexpr double kRounded = 1e-6;  // of the largest entry: a table may have seven digits

const Mode& highest_mode(const JointedStructure& structure) {
  return *std::ranges::max_element(structure.linear().modes(), {}, &Mode::angular_frequency);
}

/// Where each name stands in a list.
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
      throw InputError(key, fmt::format("'{}'", name), "must not stand twice");
    }
    indices.push_back(index);
  }
  return indices;
}

Eigen::MatrixXd checked_matrix(const ResidualFlexibility& residual) {
  const std::size_t places = residual.points.size() + residual.joints.size();
  if (places == 0 || residual.compliance.size() != places * places) {
    throw InputError("compliance of the residual",
                     fmt::format("{} values", residual.compliance.size()),
                     fmt::format("must have {}, by rows, one a point and joint that it names",
                                 std::max<std::size_t>(places * places, 1)));
  }
  const auto size = static_cast<Index>(places);
  const Eigen::Map<const Eigen::MatrixXd> matrix(residual.compliance.data(), size, size);
  if (!matrix.allFinite()) {
    throw InputError("compliance of the residual", "not a number", "must be finite");
  }
  const double largest = matrix.cwiseAbs().maxCoeff();
  for (Index i = 0; i < size; ++i) {
    for (Index j = 0; j < i; ++j) {
      if (std::abs(matrix(i, j) - matrix(j, i)) <= kRounded * largest) continue;
      throw InputError(fmt::format("compliance of the residual[{}, {}]", j, i), matrix(i, j),
                       fmt::format("must be that of [{}, {}], {:g}", i, j, matrix(j, i)));
    }
  }
  return 0.5 * (matrix + matrix.transpose());
}

}  // namespace

double static_mode_frequency(const JointedStructure& structure) {
  const double highest = highest_mode(structure).angular_frequency;
  if (highest > 0.0) return kAboveAllModes * highest;
  throw InputError("modes of the structure", "all of rigid bodies",
                   "must be elastic in one at least where what is left out gives way");
}

std::vector<FurtherMode> static_modes(const JointedStructure& structure,
                                      const ResidualFlexibility& residual) {
  const std::vector<std::size_t> points =
      indices_of(residual.points, structure.linear().points(), "point");
  const std::vector<std::size_t> joints = indices_of(residual.joints, structure.joints(), "joint");
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(checked_matrix(residual));
  const Eigen::VectorXd& eigenvalues = solver.eigenvalues();
  const double most = eigenvalues.cwiseAbs().maxCoeff();
  if (eigenvalues.minCoeff() < -kRounded * most) {
    throw InputError("compliance of the residual",
                     fmt::format("an eigenvalue of {:.4g} m/N", eigenvalues.minCoeff()),
                     "must have none below 0: no structure gives way towards a force",
                     "Subtract the elastic modes of the model alone from the static compliance.");
  }
  std::vector<FurtherMode> modes;
  if (!(most > 0.0)) return modes;
  const double frequency = static_mode_frequency(structure);
  for (Index m = 0; m < eigenvalues.size(); ++m) {
    if (eigenvalues(m) <= kRounded * most) continue;
    const Eigen::VectorXd shape =
        frequency * std::sqrt(eigenvalues(m)) * solver.eigenvectors().col(m);
    FurtherMode mode{.mode = {frequency, highest_mode(structure).loss_factor},
                     .points = std::vector<double>(structure.linear().points().size(), 0.0),
                     .joints = std::vector<double>(structure.joints().size(), 0.0)};
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
