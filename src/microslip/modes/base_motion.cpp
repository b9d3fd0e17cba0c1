// SPDX-License-Identifier: MIT
#include "microslip/modes/base_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

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

/// Rows that may be no translations, and which of them move.
class DoubtfulRows {
 public:
  DoubtfulRows(const MeshedStructure& structure, const VectorXd& motion, const Sparse& stiffness)
      : stiffness_(stiffness),
        motion_(motion),
        own_(VectorXd::Zero(motion.size())),
        step_(VectorXd::Zero(motion.size())),
        force_(stiffness * motion) {
    std::map<std::int64_t, Rows> nodes;
    for (Index row = 0; row < motion.size(); ++row) {
      const std::int64_t node = structure.matrices.degrees[static_cast<std::size_t>(row)].node;
      if (motion(row) == 0.0 ||
          !std::ranges::binary_search(structure.nodes_without_element, node)) {
        continue;
      }
      nodes[node].push_back(row);
      own_(row) = motion(row);
    }
    for (auto& [node, rows] : nodes) nodes_.push_back(std::move(rows));
  }

  /// The motion of least energy that is found: for the nodes that stiffness connects, a node at a
  /// time from all of them and from none.
  VectorXd least() {
    for (const std::vector<Rows>& group : connected_nodes()) {
      Rows rows;
      for (const Rows& node : group) rows.insert(rows.end(), node.begin(), node.end());
      const double moving = settled(group);
      const VectorXd kept = motion_(rows);
      const Change stop = change_to(rows, 0.0);
      take(rows, 0.0);
      const double resting = moving + stop.energy + settled(group);
      if (resting < moving - kEnergyGained * stop.alone) continue;
      for (std::size_t i = 0; i < rows.size(); ++i) put(rows[i], kept(static_cast<Index>(i)));
    }
    return motion_;
  }

 private:
  using Rows = std::vector<Index>;

  /// What a step changes of the energy rᵀKr, and the energy of the step alone.
  struct Change {
    double energy;
    double alone;
  };

  /// Nodes that entries of K connect, through each other.
  [[nodiscard]] std::vector<std::vector<Rows>> connected_nodes() const {
    std::map<Index, std::size_t> node_of;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (const Index row : nodes_[i]) node_of[row] = i;
    }
    std::vector<bool> seen(nodes_.size(), false);
    std::vector<std::vector<Rows>> groups;
    for (std::size_t first = 0; first < nodes_.size(); ++first) {
      if (seen[first]) continue;
      seen[first] = true;
      std::vector<std::size_t> reached = {first};
      for (std::size_t i = 0; i < reached.size(); ++i) {
        for (const Index row : nodes_[reached[i]]) {
          for (Sparse::InnerIterator entry(stiffness_, row); entry; ++entry) {
            const auto other = node_of.find(entry.row());
            if (entry.value() == 0.0 || other == node_of.end() || seen[other->second]) continue;
            seen[other->second] = true;
            reached.push_back(other->second);
          }
        }
      }
      groups.emplace_back();
      for (const std::size_t node : reached) groups.back().push_back(nodes_[node]);
    }
    return groups;
  }

  /// Of the motion of rows by a share of their own.
  [[nodiscard]] Change change_to(const Rows& rows, double share) {
    for (const Index row : rows) step_(row) = share * own_(row) - motion_(row);
    Change change{0.0, 0.0};
    for (const Index row : rows) {
      change.energy += 2.0 * force_(row) * step_(row);
      for (Sparse::InnerIterator entry(stiffness_, row); entry; ++entry) {
        change.alone += step_(row) * entry.value() * step_(entry.row());
      }
    }
    change.energy += change.alone;
    for (const Index row : rows) step_(row) = 0.0;
    return change;
  }

  void put(Index row, double motion) {
    const double step = motion - motion_(row);
    if (step == 0.0) return;
    motion_(row) = motion;
    for (Sparse::InnerIterator entry(stiffness_, row); entry; ++entry) {
      force_(entry.row()) += entry.value() * step;
    }
  }

  void take(const Rows& rows, double share) {
    for (const Index row : rows) put(row, share * own_(row));
  }

  /// Starts or stops nodes while that takes energy away. @return the change of the energy
  double settled(const std::vector<Rows>& group) {
    double sum = 0.0;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      bool changed = false;
      for (const Rows& rows : group) {
        const double share = motion_(rows.front()) == 0.0 ? 1.0 : 0.0;
        const Change change = change_to(rows, share);
        if (!(change.energy < -kEnergyGained * change.alone)) continue;
        take(rows, share);
        sum += change.energy;
        changed = true;
      }
      if (!changed) break;
    }
    return sum;
  }

  const Sparse& stiffness_;
  VectorXd motion_;
  VectorXd own_;   ///< of the doubtful rows alone, where all move
  VectorXd step_;  ///< 0 but within change_to()
  VectorXd force_;
  std::vector<Rows> nodes_;
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
