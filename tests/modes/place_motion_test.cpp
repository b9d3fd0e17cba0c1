// SPDX-License-Identifier: MIT
#include "microslip/modes/place_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "support/messages.hpp"

namespace microslip::place_motion_test {
namespace {

/// Nodes 1 to n at random with translations, and node 100 with rotations too.
MeshedStructure cloud(std::size_t nodes, std::uint64_t stream) {
  MeshedStructure structure;
  RandomStream random(5, stream);
  for (std::size_t i = 1; i <= nodes; ++i) {
    MeshNode node{.number = static_cast<std::int64_t>(i), .position = {}};
    for (double& value : node.position) value = random.normal();
    structure.nodes.push_back(node);
    for (int k = 0; k < 3; ++k) {
      structure.matrices.degrees.push_back({node.number, static_cast<NodalDirection>(k)});
    }
  }
  structure.nodes.push_back({.number = 100, .position = {0.3, -0.2, 0.1}});
  for (int k = 0; k < 6; ++k) {
    structure.matrices.degrees.push_back({100, static_cast<NodalDirection>(k)});
  }
  structure.matrices.stiffness.size = structure.matrices.degrees.size();
  return structure;
}

std::vector<std::int64_t> first_nodes(std::size_t count) {
  std::vector<std::int64_t> nodes;
  for (std::size_t i = 1; i <= count; ++i) nodes.push_back(static_cast<std::int64_t>(i));
  return nodes;
}

/// Motion of the place when all nodes move as one body: t + θ × r.
double moved(const MeshedStructure& structure, const Motion& motion, const Eigen::Vector3d& t,
             const Eigen::Vector3d& theta) {
  double sum = 0.0;
  for (const auto& [row, weight] : motion) {
    const DegreeOfFreedom degree = structure.matrices.degrees[row];
    const auto node = std::ranges::find(structure.nodes, degree.node, &MeshNode::number);
    const Eigen::Vector3d r = Eigen::Map<const Eigen::Vector3d>(node->position.data());
    const Eigen::Vector3d u = t + theta.cross(r);
    const auto k = static_cast<Eigen::Index>(degree.direction);
    sum += weight * (k < 3 ? u(k) : theta(k - 3));
  }
  return sum;
}

// A body that moves rigidly is determined exactly, at any point, along any direction, about any
// axis.
TEST(PlaceMotion, OfARigidBodyIsThatOfTheBody) {
  const MeshedStructure structure = cloud(6, 1);
  const MeshRows rows(structure);
  const Eigen::Vector3d t(0.3, -0.1, 0.7);
  const Eigen::Vector3d theta(-0.2, 0.4, 0.1);
  const Eigen::Vector3d at(2.0, -1.0, 0.5);
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -2.0) / 3.0;
  const Vector3 direction = {axis.x(), axis.y(), axis.z()};
  for (const std::vector<std::int64_t>& nodes : {first_nodes(6), {std::int64_t{100}}}) {
    MeshPlace place{.name = "body", .nodes = nodes, .at = Vector3{at.x(), at.y(), at.z()}};
    const Motion along = place_motion(rows, place, {.axis = direction, .turns = false});
    EXPECT_NEAR(moved(structure, along, t, theta), axis.dot(t + theta.cross(at)), 1e-13);
    const Motion about = place_motion(rows, place, {.axis = direction, .turns = true});
    EXPECT_NEAR(moved(structure, about, t, theta), axis.dot(theta), 1e-13);
  }
}

// Without a point the mean of the nodes, by weights of 1/n each.
TEST(PlaceMotion, OfSeveralNodesIsTheirMean) {
  const MeshedStructure structure = cloud(5, 2);
  const MeshRows rows(structure);
  const Motion motion =
      place_motion(rows, {.name = "set", .nodes = first_nodes(5)}, {.axis = {0.0, 1.0, 0.0}});
  ASSERT_EQ(motion.size(), 5U);
  for (const auto& [row, weight] : motion) {
    EXPECT_EQ(structure.matrices.degrees[row].direction, NodalDirection::kY);
    EXPECT_DOUBLE_EQ(weight, 0.2);
  }
}

TEST(PlaceMotion, NamesWhatIsMissing) {
  MeshedStructure structure = cloud(3, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = static_cast<double>(i);
    structure.nodes[i].position = {along, 2.0 * along, 0.0};
  }
  const MeshRows rows(structure);
  const auto message = [&](const MeshPlace& place, const MeshDirection& direction) {
    return test::message_or("none", [&] { return place_motion(rows, place, direction); });
  };
  const MeshDirection x;
  const MeshDirection about_x{.axis = {1.0, 0.0, 0.0}, .turns = true};
  test::expect_message(message({.name = "joint 'a'", .nodes = {9}}, x),
                       "joint 'a' = node 9; must be a node of the matrices");
  test::expect_message(message({.name = "p", .nodes = {2}}, about_x),
                       "p = node 2 rx; must be a degree of freedom of the matrices: of this node "
                       "they have x, y, z");
  test::expect_message(
      message({.name = "p", .nodes = {1, 2, 3}}, {.axis = {1.0, 2.0, 0.0}, .turns = true}),
      "3 nodes on one line");
  test::expect_message(message({.name = "p", .nodes = {}, .row = 99}, x),
                       "p = row 100; must be from 1 to 15");
  structure.nodes.clear();
  test::expect_message(
      test::message_or(
          "none",
          [&] {
            return place_motion(MeshRows(structure), {.name = "p", .nodes = {1, 2}}, about_x);
          }),
      "must have a position");
}

// Numbers of nodes have gaps: what a message says of a number within one.
TEST(MeshRows, SayWhichNodesThereAre) {
  const auto refusal = [](const std::vector<std::int64_t>& nodes, RowsOf of) {
    MeshedStructure structure;
    structure.matrices.stiffness.size = nodes.size();
    for (const std::int64_t node : nodes) {
      structure.matrices.degrees.push_back({node, NodalDirection::kX});
    }
    structure.nodes.push_back({.number = 9});
    return test::message_or("", [&] { return MeshRows(structure, of).rows("here", 9); });
  };
  test::expect_message(refusal({1, 7, 41}, RowsOf::kTest),
                       "here = node 9; must be a node of the test. It has nodes 1, 7 and 41 "
                       "alone. It is a node of the mesh without values.");
  test::expect_message(refusal({1, 2, 3}, RowsOf::kMatrices), "They have nodes 1 to 3. It is a");
  test::expect_message(refusal({4}, RowsOf::kMatrices), "They have node 4 alone.");
  test::expect_message(
      refusal({1, 2, 3, 4, 5, 6, 7, 8, 12, 13}, RowsOf::kMatrices),
      "10 nodes from 1 to 13, with gaps; the one before is 8; the one after is 12");
}

// Of a shell each face has a row: the node is between them.
TEST(PlaceMotion, OfANodeWithSeveralRowsIsTheirMean) {
  MeshedStructure structure = cloud(2, 4);
  structure.matrices.degrees[3] = structure.matrices.degrees[0];
  structure.matrices.expanded = true;
  const MeshRows rows(structure);
  const std::int64_t node = structure.matrices.degrees[0].node;
  const Motion motion = place_motion(rows, {.name = "node", .nodes = {node}}, {});
  EXPECT_EQ(motion, (Motion{{0, 0.5}, {3, 0.5}}));
}

TEST(MeshRows, RefuseDegreesOfFreedomThatAreTwice) {
  MeshedStructure structure = cloud(2, 4);
  structure.matrices.degrees[3] = structure.matrices.degrees[0];
  test::expect_message(test::message_or("none", [&] { return MeshRows(structure); }),
                       "must be that of one row, not of 1 and 4");
  structure.matrices.degrees.pop_back();
  test::expect_message(test::message_or("none", [&] { return MeshRows(structure); }),
                       "degrees of freedom = 11; must be 12");
}

}  // namespace
}  // namespace microslip::place_motion_test
