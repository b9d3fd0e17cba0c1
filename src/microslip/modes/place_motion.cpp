// SPDX-License-Identifier: MIT
#include "microslip/modes/place_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// An arm or a moment of inertia below this share of the largest is rounding of positions.
constexpr double kRounding = 1e-10;
constexpr std::size_t kNodesListed = 8;  // of nodes with gaps in their numbers

NodalDirection along(std::size_t k) { return static_cast<NodalDirection>(k); }
NodalDirection about(std::size_t k) { return static_cast<NodalDirection>(k + 3); }

std::string_view direction_name(NodalDirection direction) {
  return kNodalDirectionNames[static_cast<std::size_t>(direction)];
}

std::string node_name(std::int64_t node) { return fmt::format("node {}", node); }

/// Adds a degree of freedom of a node: the mean of its rows.
void add_degree(const MeshRows& rows, const std::string& place, std::int64_t node,
                NodalDirection direction, double weight, Motion& motion) {
  const std::vector<std::size_t> own = rows.rows_of(place, node, direction);
  const double share = weight / static_cast<double>(own.size());
  for (const std::size_t row : own) motion.emplace_back(row, share);
}

/// Adds θ·m of one node by its own rotations.
void add_own_rotation(const MeshRows& rows, const MeshPlace& place, const Eigen::Vector3d& m,
                      Motion& motion) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = m(static_cast<Eigen::Index>(k));
    if (weight != 0.0) {
      add_degree(rows, place.name, place.nodes.front(), about(k), weight, motion);
    }
  }
}

/// θ·m = Σ u_i·(w × s_i), w = I⁻¹ m.
void add_fitted_rotation(const MeshRows& rows, const MeshPlace& place, const Eigen::Vector3d& m,
                         Motion& motion) {
  const Eigen::Matrix3Xd arms = node_arms(rows, place).arms;
  const Eigen::Matrix3d inertia =
      arms.squaredNorm() * Eigen::Matrix3d::Identity() - arms * arms.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  const double least = kRounding * axes.eigenvalues()(2);
  const Eigen::Vector3d along_axes = axes.eigenvectors().transpose() * m;
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (std::abs(along_axes(k)) <= kRounding * m.norm()) continue;
    if (!(axes.eigenvalues()(k) > least)) {
      throw InputError(place.name, fmt::format("{} nodes on one line", place.nodes.size()),
                       "must have nodes beside it to determine a rotation about it",
                       "Give another direction, or a set with more nodes.");
    }
    turned += axes.eigenvectors().col(k) * (along_axes(k) / axes.eigenvalues()(k));
  }
  for (std::size_t i = 0; i < place.nodes.size(); ++i) {
    const Eigen::Vector3d weight = turned.cross(arms.col(static_cast<Eigen::Index>(i)));
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = weight(static_cast<Eigen::Index>(k));
      if (value != 0.0) add_degree(rows, place.name, place.nodes[i], along(k), value, motion);
    }
  }
}

void add_rotation(const MeshRows& rows, const MeshPlace& place, const Eigen::Vector3d& m,
                  Motion& motion) {
  if (place.nodes.size() == 1) {
    add_own_rotation(rows, place, m, motion);
  } else {
    add_fitted_rotation(rows, place, m, motion);
  }
}

void add_mean(const MeshRows& rows, const MeshPlace& place, const Vector3& direction,
              Motion& motion) {
  const double share = 1.0 / static_cast<double>(place.nodes.size());
  for (const std::int64_t node : place.nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (direction[k] != 0.0) {
        add_degree(rows, place.name, node, along(k), share * direction[k], motion);
      }
    }
  }
}

}  // namespace

MeshRows::MeshRows(const MeshedStructure& structure, RowsOf rows_of)
    : structure_(structure), rows_of_(rows_of) {
  const std::vector<DegreeOfFreedom>& degrees = structure.matrices.degrees;
  if (!degrees.empty() && degrees.size() != size()) {
    throw InputError("degrees of freedom", static_cast<double>(degrees.size()),
                     fmt::format("must be {}, one per row of the matrices", size()));
  }
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const auto first = rows_.find(degrees[i]);
    if (first != rows_.end() && !structure.matrices.expanded) {
      throw InputError(
          "degree of freedom",
          fmt::format("node {} {}", degrees[i].node, direction_name(degrees[i].direction)),
          fmt::format("must be that of one row, not of {} and {}", first->second + 1, i + 1));
    }
    rows_.emplace(degrees[i], i);
  }
  for (std::size_t i = 0; i < structure.nodes.size(); ++i) {
    if (nodes_.emplace(structure.nodes[i].number, i).second) continue;
    throw InputError("node", static_cast<double>(structure.nodes[i].number),
                     "must occur only once");
  }
}

std::size_t MeshRows::size() const { return structure_.matrices.stiffness.size; }

std::vector<std::size_t> MeshRows::rows_of(const std::string& place, std::int64_t node,
                                           NodalDirection direction) const {
  std::vector<std::size_t> found;
  const auto [begin, end] = rows_.equal_range({node, direction});
  for (auto at = begin; at != end; ++at) found.push_back(at->second);
  if (!found.empty()) return found;
  std::string there;
  for (const auto& [its, row] : rows(place, node)) {
    there += fmt::format("{}{}", there.empty() ? "" : ", ", direction_name(its));
  }
  const std::string degree = fmt::format("{} {}", node_name(node), direction_name(direction));
  if (rows_of_ == RowsOf::kTest) {
    throw InputError(place, degree, "must be measured: of this node the test has " + there);
  }
  throw InputError(place, degree,
                   fmt::format("must be a degree of freedom of the matrices: of this node they "
                               "have {}",
                               there),
                   "It may be fixed, or depend on others, where the matrices were made.");
}

std::vector<std::pair<NodalDirection, std::size_t>> MeshRows::rows(const std::string& place,
                                                                   std::int64_t node) const {
  std::vector<std::pair<NodalDirection, std::size_t>> found;
  for (auto at = rows_.lower_bound({node, NodalDirection::kX});
       at != rows_.end() && at->first.node == node; ++at) {
    found.emplace_back(at->first.direction, at->second);
  }
  if (!found.empty()) return found;
  if (rows_.empty()) {
    throw InputError(place, node_name(node),
                     "cannot be found: the degrees of freedom of the rows are not given",
                     "Name rows, or give the degrees of freedom.");
  }
  const bool of_test = rows_of_ == RowsOf::kTest;
  std::string remedy = (of_test ? "It has " : "They have ") + nodes_near(node) + ".";
  if (nodes_.contains(node)) {
    remedy += of_test ? " It is a node of the mesh without values."
                      : " It is a node of the mesh "
                        "without rows: it may be fixed, or depend on others, where they were made.";
  }
  throw InputError(place, node_name(node),
                   of_test ? "must be a node of the test" : "must be a node of the matrices",
                   remedy);
}

std::string MeshRows::nodes_near(std::int64_t node) const {
  std::vector<std::int64_t> all;
  for (const auto& [degree, row] : rows_) {
    if (all.empty() || all.back() != degree.node) all.push_back(degree.node);
  }
  if (all.size() == 1) return fmt::format("node {} alone", all.front());
  const bool in_turn = all.back() - all.front() + 1 == static_cast<std::int64_t>(all.size());
  if (in_turn) return fmt::format("nodes {} to {}", all.front(), all.back());
  if (all.size() <= kNodesListed) {
    std::string text = fmt::format("nodes {}", all.front());
    for (std::size_t i = 1; i < all.size(); ++i) {
      text += fmt::format("{}{}", i + 1 < all.size() ? ", " : " and ", all[i]);
    }
    return text + " alone";
  }
  std::string text =
      fmt::format("{} nodes from {} to {}, with gaps", all.size(), all.front(), all.back());
  const auto next = std::ranges::lower_bound(all, node);
  if (next != all.begin()) text += fmt::format("; the one before is {}", *(next - 1));
  if (next != all.end()) text += fmt::format("; the one after is {}", *next);
  return text;
}

std::size_t MeshRows::checked(const std::string& place, std::size_t row) const {
  if (row < size()) return row;
  throw InputError(place, fmt::format("row {}", row + 1),
                   fmt::format("must be from 1 to {}, the rows of the matrices", size()));
}

std::string MeshRows::name(std::size_t row) const {
  const std::vector<DegreeOfFreedom>& degrees = structure_.matrices.degrees;
  if (row >= degrees.size()) return fmt::format("row {}", row + 1);
  return fmt::format("{} {}", node_name(degrees[row].node), direction_name(degrees[row].direction));
}

Eigen::Vector3d MeshRows::position(const std::string& place, std::int64_t node) const {
  const auto found = nodes_.find(node);
  if (found != nodes_.end()) {
    return Eigen::Map<const Eigen::Vector3d>(structure_.nodes[found->second].position.data());
  }
  throw InputError(place, node_name(node), "must have a position, to determine rotations",
                   "Give the nodes with their coordinates.");
}

NodeArms node_arms(const MeshRows& rows, const MeshPlace& place) {
  NodeArms found{Eigen::Vector3d::Zero(),
                 Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(place.nodes.size()))};
  for (std::size_t i = 0; i < place.nodes.size(); ++i) {
    found.arms.col(static_cast<Eigen::Index>(i)) = rows.position(place.name, place.nodes[i]);
  }
  found.centre = found.arms.rowwise().mean();
  found.arms.colwise() -= found.centre;
  return found;
}

Motion place_motion(const MeshRows& rows, const MeshPlace& place, const MeshDirection& direction) {
  if (place.row) return {{rows.checked(place.name, *place.row), 1.0}};
  const Eigen::Map<const Eigen::Vector3d> axis(direction.axis.data());
  Motion motion;
  if (direction.turns) {
    add_rotation(rows, place, axis, motion);
    return motion;
  }
  add_mean(rows, place, direction.axis, motion);
  if (place.at) {
    const NodeArms body = node_arms(rows, place);
    const Eigen::Vector3d arm = Eigen::Map<const Eigen::Vector3d>(place.at->data()) - body.centre;
    const double size =
        std::max(arm.norm(), std::sqrt(body.arms.colwise().squaredNorm().maxCoeff()));
    const Eigen::Vector3d moment = arm.cross(axis);
    if (moment.norm() > kRounding * size) add_rotation(rows, place, moment, motion);
  }
  return motion;
}

Motion joint_motion(const MeshRows& rows, const MeshJoint& joint) {
  Motion motion = place_motion(rows, joint.to, joint.direction);
  if (!joint.from) return motion;
  for (const auto& [row, weight] : place_motion(rows, *joint.from, joint.direction)) {
    motion.emplace_back(row, -weight);
  }
  return motion;
}

}  // namespace microslip
