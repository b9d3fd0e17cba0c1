// SPDX-License-Identifier: MIT
#include "microslip/modes/system_assembly.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "microslip/algebra/svd.hpp"
#include "microslip/base/error.hpp"
#include "microslip/modes/base_motion.hpp"
#include "microslip/modes/place_motion.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double, Sparse::StorageIndex>;

/// Tolerance of a motion that is none, for a rigid body whose nodes lie on a line or a point.
constexpr double kNoMotion = 1e-10;
/// A negative eigenvalue of M within this share of its diagonal is rounding of its entries.
constexpr double kMassRounding = 1e-10;

/// An index as Eigen's triplets have it.
int at(std::size_t index) { return static_cast<int>(index); }

Sparse full_matrix(const SymmetricEntries& entries, const std::string& name) {
  const std::size_t count = entries.value.size();
  if (entries.row.size() != count || entries.column.size() != count) {
    throw InputError(name,
                     fmt::format("{} rows, {} columns, {} values", entries.row.size(),
                                 entries.column.size(), count),
                     "must have a row and a column for each value");
  }
  std::vector<Triplet> triplets;
  triplets.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const int row = entries.row[i];
    const int column = entries.column[i];
    if (row < 0 || column < 0 || column > row || static_cast<std::size_t>(row) >= entries.size) {
      throw InputError(name, fmt::format("entry ({}, {})", row + 1, column + 1),
                       fmt::format("must lie on or below the diagonal of {} rows", entries.size));
    }
    if (!std::isfinite(entries.value[i])) {
      throw InputError(fmt::format("{} ({}, {})", name, row + 1, column + 1), entries.value[i],
                       "must be finite");
    }
    triplets.emplace_back(row, column, entries.value[i]);
    if (row != column) triplets.emplace_back(column, row, entries.value[i]);
  }
  Sparse matrix(static_cast<Index>(entries.size), static_cast<Index>(entries.size));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

void check_sizes(const StructuralMatrices& matrices) {
  const std::size_t size = matrices.stiffness.size;
  if (size == 0 || size > kMostDegreesOfFreedom) {
    throw InputError("rows of the stiffness matrix", static_cast<double>(size),
                     fmt::format("must be from 1 to {}", kMostDegreesOfFreedom));
  }
  if (matrices.mass.size == size) return;
  throw InputError("rows of the mass matrix", static_cast<double>(matrices.mass.size),
                   fmt::format("must be {}, those of the stiffness matrix", size));
}

/// The transformation of the rows of the matrices.
class Transformation {
 public:
  Transformation(const MeshRows& rows, const MeshedStructure& structure)
      : rows_(rows), held_(rows.size(), false), bound_(rows.size(), false) {
    for (const MeshSupport& support : structure.supports) hold(support);
    for (const MeshPoint& point : structure.points) bind(point.place);
    for (const MeshJoint& joint : structure.joints) {
      if (joint.from) bind(*joint.from);
      bind(joint.to);
    }
    leave_others();
  }

  /// T.
  [[nodiscard]] Sparse matrix() const {
    Sparse matrix(static_cast<Index>(rows_.size()), columns_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }

  /// Whether a row is a degree of freedom by itself.
  [[nodiscard]] bool leaves(std::size_t row) const { return !held_[row] && !bound_[row]; }

  [[nodiscard]] bool is_trivial() const {
    return bodies_.empty() && std::ranges::none_of(held_, [](bool held) { return held; });
  }

 private:
  void hold(const MeshSupport& support) {
    bool holds = false;
    for (const std::size_t row : support.rows) {
      held_[rows_.checked(support.name, row)] = true;
      holds = true;
    }
    for (const std::int64_t node : support.nodes) {
      for (const auto& [direction, row] : rows_.rows(support.name, node)) {
        if (!support.held[static_cast<std::size_t>(direction)]) continue;
        held_[row] = true;
        holds = true;
      }
    }
    if (!holds) {
      throw InputError(support.name, "a support that fixes nothing",
                       "must fix a degree of freedom of the matrices",
                       "Check its directions: the nodes may have others.");
    }
  }

  /// The nodes of a rigid spider become one body; a place that is used twice is one.
  void bind(const MeshPlace& place) {
    if (place.spider != Spider::kRigid || place.nodes.size() < 2) return;
    const std::set<std::int64_t> nodes(place.nodes.begin(), place.nodes.end());
    if (!bodies_.insert(nodes).second) return;
    const NodeArms body = node_arms(rows_, place);
    std::vector<std::size_t> bound;
    std::vector<Eigen::Matrix<double, 1, 6>> motions;
    const double size = std::max(std::sqrt(body.arms.colwise().squaredNorm().maxCoeff()), 1e-300);
    for (std::size_t i = 0; i < place.nodes.size(); ++i) {
      const Eigen::Vector3d arm = body.arms.col(static_cast<Index>(i)) / size;
      std::set<NodalDirection> known;
      for (const auto& [direction, row] : rows_.rows(place.name, place.nodes[i])) {
        if (!known.insert(direction).second) refuse_faces(place, place.nodes[i]);
        claim(place, row);
        bound.push_back(row);
        motions.push_back(rigid_motion(direction, arm, size));
      }
    }
    add_body(bound, motions);
  }

  /// Where the faces of a shell are, half its thickness off the node, no file tells.
  [[noreturn]] static void refuse_faces(const MeshPlace& place, std::int64_t node) {
    throw InputError(place.name, fmt::format("node {}", node),
                     "must have one row per direction in a rigid spider, not those of the faces of "
                     "a shell or beam",
                     "Use spider = \"average\", or model it with solid elements.");
  }

  void claim(const MeshPlace& place, std::size_t row) {
    if (held_[row]) {
      throw InputError(place.name, rows_.name(row), "must not be fixed in a rigid spider",
                       "Leave the node out of the support or of the set.");
    }
    if (bound_[row]) {
      throw InputError(place.name, rows_.name(row), "must not be in two rigid spiders",
                       "Use one set for both, or spider = \"average\".");
    }
    bound_[row] = true;
  }

  /// Motion of a row by the translation of the centre and the rotation times the size of the body.
  static Eigen::Matrix<double, 1, 6> rigid_motion(NodalDirection direction,
                                                  const Eigen::Vector3d& arm, double size) {
    Eigen::Matrix<double, 1, 6> motion = Eigen::Matrix<double, 1, 6>::Zero();
    const auto k = static_cast<Index>(direction);
    if (k >= 3) {
      motion(k) = 1.0 / size;
      return motion;
    }
    motion(k) = 1.0;
    // e_k·(θ × s) = θ·(s × e_k)
    motion.tail<3>() = arm.cross(Eigen::Vector3d::Unit(k)).transpose();
    return motion;
  }

  void add_body(const std::vector<std::size_t>& bound,
                const std::vector<Eigen::Matrix<double, 1, 6>>& motions) {
    Eigen::Matrix<double, Eigen::Dynamic, 6> all(static_cast<Index>(motions.size()), 6);
    for (std::size_t i = 0; i < motions.size(); ++i) all.row(static_cast<Index>(i)) = motions[i];
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all, Eigen::ComputeThinU);
    for (Index j = 0; j < svd.singularValues().size(); ++j) {
      if (svd.singularValues()(j) <= kNoMotion * svd.singularValues()(0)) break;
      for (std::size_t i = 0; i < bound.size(); ++i) {
        const double value = svd.matrixU()(static_cast<Index>(i), j);
        if (value != 0.0) entries_.emplace_back(at(bound[i]), static_cast<int>(columns_), value);
      }
      ++columns_;
    }
  }

  void leave_others() {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      if (held_[row] || bound_[row]) continue;
      entries_.emplace_back(at(row), static_cast<int>(columns_), 1.0);
      ++columns_;
    }
    if (columns_ > 0) return;
    throw InputError("degrees of freedom", 0.0, "must be left free by the supports");
  }

  const MeshRows& rows_;
  std::vector<bool> held_;
  std::vector<bool> bound_;
  std::set<std::set<std::int64_t>> bodies_;
  std::vector<Triplet> entries_;
  Index columns_ = 0;
};

void check_names(const std::vector<std::string>& names, std::string_view of) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!name.empty() && seen.insert(name).second) continue;
    throw InputError(fmt::format("name of a {}", of), fmt::format("'{}'", name),
                     "must not be empty, and no two the same");
  }
}

Sparse motions_matrix(const std::vector<Motion>& motions, std::size_t rows) {
  std::vector<Triplet> entries;
  for (std::size_t j = 0; j < motions.size(); ++j) {
    for (const auto& [row, weight] : motions[j]) entries.emplace_back(at(row), at(j), weight);
  }
  Sparse matrix(static_cast<Index>(rows), static_cast<Index>(motions.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void require_motion(const Sparse& motions, Index column, const std::string& name) {
  double norm = 0.0;
  for (Sparse::InnerIterator entry(motions, column); entry; ++entry) {
    norm = std::max(norm, std::abs(entry.value()));
  }
  if (norm > kNoMotion) return;
  throw InputError(name, InputState{"without motion"},
                   "must move: supports or a rigid spider fix it entirely",
                   "Check its places, its direction and the supports.");
}

void check_rows(const Sparse& stiffness, const Sparse& mass, const MeshRows& rows) {
  const Eigen::VectorXd stiff = stiffness.diagonal();
  const Eigen::VectorXd heavy = mass.diagonal();
  for (Index i = 0; i < stiff.size(); ++i) {
    const std::string name = rows.name(static_cast<std::size_t>(i));
    if (heavy(i) < 0.0) {
      throw InputError(fmt::format("mass of {}", name), heavy(i), "must be 0 or more");
    }
    if (stiff(i) < 0.0) {
      throw InputError(fmt::format("stiffness of {}", name), stiff(i), "must be 0 or more");
    }
    if (stiff(i) == 0.0 && heavy(i) == 0.0) {
      throw InputError(name, InputState{"without stiffness and mass"},
                       "must have one of them on the diagonal of the matrices",
                       "Fix it by a support, or leave it out of the matrices.");
    }
  }
}

/// Checks the pivots of M where it has a diagonal; elsewhere it must be empty.
void check_mass(const Sparse& mass) {
  const Eigen::VectorXd diagonal = mass.diagonal();
  std::vector<int> with_mass(static_cast<std::size_t>(mass.rows()), -1);
  int count = 0;
  for (Index i = 0; i < mass.rows(); ++i) {
    if (diagonal(i) > 0.0) with_mass[static_cast<std::size_t>(i)] = count++;
  }
  std::vector<Triplet> entries;
  entries.reserve(static_cast<std::size_t>(mass.nonZeros()));
  bool beside = false;
  for (Index j = 0; j < mass.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(mass, j); entry; ++entry) {
      const int row = with_mass[static_cast<std::size_t>(entry.row())];
      const int column = with_mass[static_cast<std::size_t>(entry.col())];
      if (row < 0 || column < 0) {
        beside = beside || entry.value() != 0.0;
        continue;
      }
      const double rounding = row == column ? kMassRounding * entry.value() : 0.0;
      entries.emplace_back(row, column, entry.value() + rounding);
    }
  }
  std::size_t negative = beside ? 1 : 0;
  if (count > 0 && !beside) {
    Sparse restricted(count, count);
    restricted.setFromTriplets(entries.begin(), entries.end());
    negative = SymmetricFactor(restricted).negative_eigenvalues();
  }
  if (negative == 0) return;
  throw InputError(
      "mass matrix",
      beside ? std::string("entries off a diagonal of 0")
             : fmt::format("{} negative eigenvalue{}", negative, negative == 1 ? "" : "s"),
      "must have no negative eigenvalue");
}

void add_bases(const MeshRows& rows, const MeshedStructure& structure, const Sparse& stiffness,
               const Sparse& mass, AssembledSystem& assembled) {
  const auto count = static_cast<Index>(structure.bases.size());
  assembled.base_loads.resize(mass.rows(), count);
  assembled.base_masses.resize(count);
  assembled.base_motions.resize(assembled.points.cols(), count);
  for (Index b = 0; b < count; ++b) {
    const MeshBase& base = structure.bases[static_cast<std::size_t>(b)];
    const BaseMotion moved = base_motion(rows, structure, base, stiffness);
    const Eigen::VectorXd& motion = moved.rows;
    assembled.base_loads.col(b) = mass * motion;
    assembled.base_masses(b) = motion.dot(assembled.base_loads.col(b));
    assembled.base_motions.col(b) = assembled.points.transpose() * motion;
    assembled.base_mass_missing.push_back(lacks_mass(moved, mass));
    double strained = 0.0;
    for (Index row = 0; row < motion.size(); ++row) {
      if (!moved.restrained[static_cast<std::size_t>(row)]) continue;
      strained += motion(row) * assembled.base_loads(row, b);
    }
    assembled.base_rows.push_back(
        {moved.moved, moved.strained, strained / assembled.base_masses(b)});
    if (assembled.base_masses(b) > 0.0) continue;
    throw InputError(fmt::format("base '{}'", base.name), InputState{"without mass"},
                     "must move mass", "Check its direction.");
  }
}

AssembledSystem::LooseRows loose_rows(const Sparse& stiffness, const Sparse& mass,
                                      const Sparse& joints, const MeshRows& rows,
                                      const Transformation& transformation) {
  const Eigen::VectorXd stiff = stiffness.diagonal();
  const Eigen::VectorXd heavy = mass.diagonal();
  const Eigen::VectorXd held = joints.cwiseAbs() * Eigen::VectorXd::Ones(joints.cols());
  AssembledSystem::LooseRows found;
  for (Index i = 0; i < stiff.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (stiff(i) > 0.0 || heavy(i) == 0.0 || held(i) > 0.0 || !transformation.leaves(row)) continue;
    if (found.count++ == 0) found.first = rows.name(row);
  }
  return found;
}

/// Points or joints.
struct NamedMotions {
  std::vector<std::string> names;
  std::vector<Motion> motions;
};

NamedMotions motions_of_points(const MeshedStructure& structure, const MeshRows& rows) {
  NamedMotions points;
  for (const MeshPoint& point : structure.points) {
    points.names.push_back(point.name);
    points.motions.push_back(place_motion(rows, point.place, point.direction));
  }
  return points;
}

NamedMotions motions_of_joints(const MeshedStructure& structure, const MeshRows& rows) {
  NamedMotions joints;
  for (const MeshJoint& joint : structure.joints) {
    joints.names.push_back(joint.name);
    joints.motions.push_back(joint_motion(rows, joint));
  }
  return joints;
}

void check_all_names(const MeshedStructure& structure, const NamedMotions& points,
                     const NamedMotions& joints) {
  check_names(points.names, "point");
  check_names(joints.names, "joint");
  std::vector<std::string> bases = points.names;
  for (const MeshBase& base : structure.bases) bases.push_back(base.name);
  check_names(bases, "base or point");
}

/// Brings the system to the coordinates q of u = Tq. @param matrix  T.
void reduce_system(const Sparse& matrix, Sparse& stiffness, Sparse& mass,
                   AssembledSystem& assembled) {
  stiffness = (matrix.transpose() * stiffness * matrix).pruned();
  mass = (matrix.transpose() * mass * matrix).pruned();
  assembled.points = matrix.transpose() * assembled.points;
  assembled.joints = matrix.transpose() * assembled.joints;
  assembled.base_loads = (matrix.transpose() * assembled.base_loads).eval();
}

void check_bases_move(const MeshedStructure& structure, const AssembledSystem& assembled) {
  for (std::size_t b = 0; b < structure.bases.size(); ++b) {
    const double load = assembled.base_loads.col(static_cast<Index>(b)).cwiseAbs().maxCoeff();
    if (load > kNoMotion * assembled.base_masses(static_cast<Index>(b))) continue;
    throw InputError(fmt::format("base '{}'", structure.bases[b].name),
                     InputState{"moving only fixed rows"}, "must move free mass",
                     "Name all rows that move with it, or its direction.");
  }
}

/// Each column of motions must move something. @param of  "joint" or "point".
void require_motions(const Sparse& motions, std::string_view of,
                     const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    require_motion(motions, static_cast<Index>(i), fmt::format("{} '{}'", of, names[i]));
  }
}

}  // namespace

AssembledSystem assemble_system(const MeshedStructure& structure) {
  check_sizes(structure.matrices);
  const MeshRows rows(structure);
  const NamedMotions points = motions_of_points(structure, rows);
  const NamedMotions joints = motions_of_joints(structure, rows);
  check_all_names(structure, points, joints);

  Sparse stiffness = full_matrix(structure.matrices.stiffness, "stiffness matrix");
  Sparse mass = full_matrix(structure.matrices.mass, "mass matrix");
  check_rows(stiffness, mass, rows);
  check_mass(mass);
  const Transformation transformation(rows, structure);
  AssembledSystem assembled;
  assembled.points = motions_matrix(points.motions, rows.size());
  assembled.joints = motions_matrix(joints.motions, rows.size());
  assembled.loose_rows = loose_rows(stiffness, mass, assembled.joints, rows, transformation);
  add_bases(rows, structure, stiffness, mass, assembled);
  if (!transformation.is_trivial()) {
    reduce_system(transformation.matrix(), stiffness, mass, assembled);
  }
  check_bases_move(structure, assembled);
  require_motions(assembled.joints, "joint", joints.names);
  require_motions(assembled.points, "point", points.names);
  assembled.system.stiffness = std::move(stiffness);
  assembled.system.mass = std::move(mass);
  assembled.system.spring_motions = Sparse(assembled.system.size(), 0);
  assembled.system.stiffness_rounding = structure.matrices.stiffness_rounding;
  assembled.system.possible_rounding = structure.matrices.possible_rounding;
  return assembled;
}

}  // namespace microslip
