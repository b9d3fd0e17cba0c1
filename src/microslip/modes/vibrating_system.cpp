// SPDX-License-Identifier: MIT
#include "microslip/modes/vibrating_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using Triplet = Eigen::Triplet<double, Eigen::SparseMatrix<double>::StorageIndex>;

constexpr double kSumRounding = 16.0 * std::numeric_limits<double>::epsilon();

void add_lower(const Eigen::SparseMatrix<double>& matrix, double factor,
               std::vector<Triplet>& entries) {
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.row() < entry.col()) continue;
      entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(entry.col()),
                           factor * entry.value());
    }
  }
}

Eigen::SparseMatrix<double> bordered(const VibratingSystem& system, double shift) {
  const Eigen::Index n = system.size();
  const Eigen::Index springs = system.spring_motions.cols();
  std::vector<Triplet> entries;
  entries.reserve(static_cast<std::size_t>(system.stiffness.nonZeros() + system.mass.nonZeros() +
                                           system.spring_motions.nonZeros() + springs));
  add_lower(system.stiffness, 1.0, entries);
  add_lower(system.mass, -shift, entries);
  for (Eigen::Index j = 0; j < springs; ++j) {
    const auto row = static_cast<int>(n + j);
    for (Eigen::SparseMatrix<double>::InnerIterator entry(system.spring_motions, j); entry;
         ++entry) {
      entries.emplace_back(row, static_cast<int>(entry.row()), entry.value());
    }
    entries.emplace_back(row, row, -1.0 / system.spring_stiffness(j));
  }
  Eigen::SparseMatrix<double> lower(n + springs, n + springs);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace

Eigen::MatrixXd VibratingSystem::stiffness_times(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd force = stiffness * x;
  if (spring_motions.cols() > 0) {
    const Eigen::MatrixXd tension =
        spring_stiffness.asDiagonal() * (spring_motions.transpose() * x);
    force += spring_motions * tension;
  }
  return force;
}

double VibratingSystem::entry_error() const { return kSumRounding + stiffness_rounding; }

double VibratingSystem::possible_entry_error() const {
  return kSumRounding + std::max(stiffness_rounding, possible_rounding);
}

Eigen::VectorXd VibratingSystem::sizes_times(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd size = x.cwiseAbs();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index j = 0; j < stiffness.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, j); entry; ++entry) {
      force(entry.row()) += std::abs(entry.value()) * size(j);
    }
  }
  if (spring_motions.cols() > 0) {
    const Eigen::SparseMatrix<double> motions = spring_motions.cwiseAbs();
    const Eigen::VectorXd tension = spring_stiffness.asDiagonal() * (motions.transpose() * size);
    force += motions * tension;
  }
  return force;
}

Eigen::VectorXd VibratingSystem::rounding_times(const Eigen::VectorXd& x) const {
  return entry_error() * sizes_times(x);
}

ShiftedFactor::ShiftedFactor(const VibratingSystem& system, double shift)
    : size_(system.size()),
      springs_(system.spring_motions.cols()),
      factor_(bordered(system, shift)) {}

Eigen::MatrixXd ShiftedFactor::solve(const Eigen::MatrixXd& right_sides) const {
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(size_ + springs_, right_sides.cols());
  x.topRows(size_) = right_sides;
  factor_.solve(x);
  return x.topRows(size_);
}

std::size_t ShiftedFactor::eigenvalues_below() const {
  return factor_.negative_eigenvalues() - static_cast<std::size_t>(springs_);
}

}  // namespace microslip
