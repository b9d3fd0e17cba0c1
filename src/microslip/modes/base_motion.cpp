// SPDX-License-Identifier: MIT
#include "microslip/modes/base_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kHolds = 1e-6;         // of the stiffness of a row
constexpr double kEnergyGained = 1e-9;  // of the energy of rows that move alone
constexpr int kMostPasses = 10;

/// r along the direction of a base, of all rows.
VectorXd motion_along(const MeshedStructure& structure, const MeshBase& base,
                      const std::string& name) {
  if (structure.matrices.degrees.empty()) {
    throw InputError(name, InputState{"a direction"},
                     "must be given by rows: the degrees of freedom of the rows are not given",
                     "Give rows = [...], or degrees_of_freedom.");
  }
  if (base.direction.turns) {
    throw InputError(name, InputState{"a rotation"}, "must move along a direction");
  }
  VectorXd motion = VectorXd::Zero(static_cast<Index>(structure.matrices.degrees.size()));
  for (Index row = 0; row < motion.size(); ++row) {
    const auto k = static_cast<std::size_t>(
        structure.matrices.degrees[static_cast<std::size_t>(row)].direction);
    if (k < base.direction.axis.size()) motion(row) = base.direction.axis[k];
  }
  return motion;
}

/// Rows that may be no translations, a node each, and which of them move.
class DoubtfulRows {
 public:
  DoubtfulRows(const MeshedStructure& structure, const VectorXd& motion, const Sparse& stiffness)
      : stiffness_(stiffness), motion_(motion), own_(VectorXd::Zero(motion.size())) {
    std::map<std::int64_t, std::vector<Index>> nodes;
    for (Index row = 0; row < motion.size(); ++row) {
      const std::int64_t node = structure.matrices.degrees[static_cast<std::size_t>(row)].node;
      if (motion(row) == 0.0 ||
          !std::ranges::binary_search(structure.nodes_without_element, node)) {
        continue;
      }
      nodes[node].push_back(row);
      own_(row) = motion(row);
    }
    for (auto& [node, rows] : nodes) groups_.push_back(std::move(rows));
  }

  /// The motion of least energy, by a node at a time from the better of all and none.
  VectorXd least() {
    if (groups_.empty()) return motion_;
    const VectorXd without = motion_ - own_;
    if (without.dot(stiffness_ * without) < motion_.dot(stiffness_ * motion_)) motion_ = without;
    force_ = stiffness_ * motion_;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      bool changed = false;
      for (const std::vector<Index>& rows : groups_) changed = turn_over(rows) || changed;
      if (!changed) break;
    }
    return motion_;
  }

 private:
  /// Starts or stops the rows of a node where that takes energy away.
  bool turn_over(const std::vector<Index>& rows) {
    const double sign = motion_(rows.front()) == 0.0 ? 1.0 : -1.0;
    const auto step = [&](Index row) {
      return std::ranges::find(rows, row) == rows.end() ? 0.0 : sign * own_(row);
    };
    double alone = 0.0;
    double with_others = 0.0;
    for (const Index row : rows) {
      with_others += 2.0 * force_(row) * step(row);
      for (Sparse::InnerIterator entry(stiffness_, row); entry; ++entry) {
        alone += step(row) * entry.value() * step(entry.row());
      }
    }
    if (!(with_others + alone < -kEnergyGained * alone)) return false;
    for (const Index row : rows) {
      motion_(row) += step(row);
      for (Sparse::InnerIterator entry(stiffness_, row); entry; ++entry) {
        force_(entry.row()) += entry.value() * step(row);
      }
    }
    return true;
  }

  const Sparse& stiffness_;
  VectorXd motion_;
  VectorXd own_;  ///< of the doubtful rows alone, where all move
  VectorXd force_;
  std::vector<std::vector<Index>> groups_;
};

}  // namespace

BaseMotion base_motion(const MeshRows& rows, const MeshedStructure& structure, const MeshBase& base,
                       const Sparse& stiffness) {
  const std::string name = fmt::format("base '{}'", base.name);
  BaseMotion found{.rows = VectorXd::Zero(static_cast<Index>(rows.size()))};
  for (const std::size_t row : base.rows) {
    found.rows(static_cast<Index>(rows.checked(name, row))) = 1.0;
  }
  if (base.rows.empty()) {
    found.rows = DoubtfulRows(structure, motion_along(structure, base, name), stiffness).least();
  }
  const VectorXd force = stiffness * found.rows;
  for (Index row = 0; row < force.size(); ++row) {
    const bool restrained = std::abs(force(row)) > kHolds * stiffness.coeff(row, row);
    found.restrained.push_back(restrained);
    if (found.rows(row) == 0.0) continue;
    ++found.moved;
    if (restrained) ++found.strained;
  }
  return found;
}

bool lacks_mass(const BaseMotion& base, const Sparse& mass) {
  for (Index row = 0; row < mass.cols(); ++row) {
    if (!base.restrained[static_cast<std::size_t>(row)]) continue;
    for (Sparse::InnerIterator entry(mass, row); entry; ++entry) {
      if (entry.row() != row && entry.value() != 0.0) return true;
    }
  }
  return false;
}

}  // namespace microslip
