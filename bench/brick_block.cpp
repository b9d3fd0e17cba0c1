// SPDX-License-Identifier: MIT
#include "brick_block.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace microslip::bench {
namespace {

constexpr double kYoung = 210e9;     // Pa
constexpr double kPoisson = 0.3;     // 1
constexpr double kDensity = 7850.0;  // kg/m³

using Entries = Eigen::Matrix<double, 24, 24>;

/// Matrices of one brick, node by node; node a is at x, y, z = bits 0, 1, 2 of a.
struct Brick {
  Entries stiffness = Entries::Zero();
  Entries mass = Entries::Zero();
};

/// Hooke's law between the strains xx, yy, zz, xy, yz, zx and their stresses.
Eigen::Matrix<double, 6, 6> elasticity() {
  const double lambda = kYoung * kPoisson / ((1.0 + kPoisson) * (1.0 - 2.0 * kPoisson));
  const double shear = kYoung / (2.0 * (1.0 + kPoisson));
  Eigen::Matrix<double, 6, 6> law = Eigen::Matrix<double, 6, 6>::Zero();
  law.topLeftCorner<3, 3>().setConstant(lambda);
  law.diagonal() << lambda + 2.0 * shear, lambda + 2.0 * shear, lambda + 2.0 * shear, shear, shear,
      shear;
  return law;
}

/// The shape functions of the nodes at a point, −1 to 1, and their derivatives by x, y, z.
struct Shapes {
  Eigen::Matrix<double, 8, 1> value;
  Eigen::Matrix<double, 8, 3> slope;
};
Shapes shapes_at(const Eigen::Vector3d& point, const std::array<double, 3>& edges) {
  Shapes shapes;
  for (int a = 0; a < 8; ++a) {
    Eigen::Vector3d factor;
    Eigen::Vector3d derivative;
    for (int d = 0; d < 3; ++d) {
      const double side = ((a >> d) & 1) == 1 ? 1.0 : -1.0;
      factor(d) = 0.5 * (1.0 + side * point(d));
      derivative(d) = side / edges[static_cast<std::size_t>(d)];
    }
    shapes.value(a) = factor.prod();
    shapes.slope(a, 0) = derivative(0) * factor(1) * factor(2);
    shapes.slope(a, 1) = factor(0) * derivative(1) * factor(2);
    shapes.slope(a, 2) = factor(0) * factor(1) * derivative(2);
  }
  return shapes;
}

/// The strains by the displacements of the nodes.
Eigen::Matrix<double, 6, 24> strains(const Shapes& shapes) {
  Eigen::Matrix<double, 6, 24> result = Eigen::Matrix<double, 6, 24>::Zero();
  for (int a = 0; a < 8; ++a) {
    for (int d = 0; d < 3; ++d) {
      const int next = (d + 1) % 3;
      result(d, 3 * a + d) = shapes.slope(a, d);
      result(3 + d, 3 * a + d) = shapes.slope(a, next);
      result(3 + d, 3 * a + next) = shapes.slope(a, d);
    }
  }
  return result;
}

Brick make_brick(const std::array<double, 3>& edges) {
  Brick brick;
  const double weight = edges[0] * edges[1] * edges[2] / 8.0;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d point;
    for (int d = 0; d < 3; ++d) point(d) = (((corner >> d) & 1) == 1 ? 1.0 : -1.0) / std::sqrt(3.0);
    const Shapes shapes = shapes_at(point, edges);
    const auto strain = strains(shapes);
    brick.stiffness += weight * strain.transpose() * elasticity() * strain;
    for (int a = 0; a < 8; ++a) {
      for (int b = 0; b < 8; ++b) {
        const double mass = weight * kDensity * shapes.value(a) * shapes.value(b);
        for (int d = 0; d < 3; ++d) brick.mass(3 * a + d, 3 * b + d) += mass;
      }
    }
  }
  return brick;
}

/// Which node is where.
class Grid {
 public:
  explicit Grid(const std::array<std::size_t, 3>& bricks) : bricks_(bricks) {}
  [[nodiscard]] std::size_t nodes() const {
    return (bricks_[0] + 1) * (bricks_[1] + 1) * (bricks_[2] + 1);
  }
  /// From 0; x is slowest, so that those of the face x = 0 are the first.
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j, std::size_t k) const {
    return (i * (bricks_[1] + 1) + j) * (bricks_[2] + 1) + k;
  }
  /// The rows of a brick in the order of Brick.
  [[nodiscard]] std::array<std::size_t, 24> rows(std::size_t i, std::size_t j,
                                                 std::size_t k) const {
    std::array<std::size_t, 24> result = {};
    for (std::size_t a = 0; a < 8; ++a) {
      const std::size_t at = node(i + (a & 1U), j + ((a >> 1U) & 1U), k + ((a >> 2U) & 1U));
      for (std::size_t d = 0; d < 3; ++d) result[3 * a + d] = 3 * at + d;
    }
    return result;
  }

 private:
  std::array<std::size_t, 3> bricks_;
};

/// The sum over all bricks, its lower triangle.
SymmetricEntries assemble(const Grid& grid, const std::array<std::size_t, 3>& bricks,
                          const Entries& brick) {
  std::vector<Eigen::Triplet<double>> parts;
  const auto add = [&](const std::array<std::size_t, 24>& rows) {
    for (std::size_t a = 0; a < 24; ++a) {
      for (std::size_t b = 0; b < 24; ++b) {
        const double value = brick(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
        if (rows[b] > rows[a] || value == 0.0) continue;
        parts.emplace_back(static_cast<int>(rows[a]), static_cast<int>(rows[b]), value);
      }
    }
  };
  for (std::size_t i = 0; i < bricks[0]; ++i) {
    for (std::size_t j = 0; j < bricks[1]; ++j) {
      for (std::size_t k = 0; k < bricks[2]; ++k) add(grid.rows(i, j, k));
    }
  }
  const auto size = static_cast<Eigen::Index>(3 * grid.nodes());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(parts.begin(), parts.end());
  SymmetricEntries entries{.size = 3 * grid.nodes(), .row = {}, .column = {}, .value = {}};
  for (Eigen::Index column = 0; column < size; ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator at(matrix, column); at; ++at) {
      entries.row.push_back(static_cast<std::int32_t>(at.row()));
      entries.column.push_back(static_cast<std::int32_t>(at.col()));
      entries.value.push_back(at.value());
    }
  }
  return entries;
}

}  // namespace

MeshedStructure brick_block(const std::array<std::size_t, 3>& bricks,
                            const std::array<double, 3>& edges) {
  const Grid grid(bricks);
  const Brick brick = make_brick(edges);
  MeshedStructure block{.matrices = {.stiffness = assemble(grid, bricks, brick.stiffness),
                                     .mass = assemble(grid, bricks, brick.mass)}};
  for (std::size_t node = 0; node < grid.nodes(); ++node) {
    for (const NodalDirection d : {NodalDirection::kX, NodalDirection::kY, NodalDirection::kZ}) {
      block.matrices.degrees.push_back({static_cast<std::int64_t>(node), d});
    }
  }
  MeshSupport root{.name = "root", .nodes = {}};
  for (std::size_t node = 0; node < grid.node(1, 0, 0); ++node) {
    root.nodes.push_back(static_cast<std::int64_t>(node));
  }
  block.supports.push_back(std::move(root));
  block.points.push_back(
      {.name = "tip",
       .place = {.name = "tip", .nodes = {static_cast<std::int64_t>(grid.nodes() - 1)}},
       .direction = {.axis = {0.0, 0.0, 1.0}}});
  return block;
}

}  // namespace microslip::bench
