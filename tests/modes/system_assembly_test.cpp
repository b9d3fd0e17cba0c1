// SPDX-License-Identifier: MIT
#include "microslip/modes/system_assembly.hpp"

#include <gtest/gtest.h>

#include <string>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/error.hpp"
#include "support/mass_chain.hpp"
#include "support/messages.hpp"

namespace microslip::system_assembly_test {
namespace {

using test::MassChains;

/// Three nodes at the corners of a triangle, each a mass that springs hold in x, y and z.
MeshedStructure triangle() {
  MeshedStructure structure;
  structure.nodes = {{1, {0.0, 0.0, 0.0}}, {2, {0.3, 0.0, 0.0}}, {3, {0.0, 0.4, 0.0}}};
  StructuralMatrices& all = structure.matrices;
  all.stiffness.size = all.mass.size = 9;
  for (std::size_t i = 0; i < 9; ++i) {
    MassChains::add(all.mass, i, i, 2.0);
    MassChains::add(all.stiffness, i, i, 1e4);
    all.degrees.push_back(
        {static_cast<std::int64_t>(i / 3 + 1), static_cast<NodalDirection>(i % 3)});
  }
  return structure;
}

MeshPlace whole(Spider spider) { return {.name = "all", .nodes = {1, 2, 3}, .spider = spider}; }

// Equal springs at equal masses: as one rigid body it has six modes, all at √(k/m).
TEST(SystemAssembly, RigidSpidersLeaveABody) {
  MeshedStructure structure = triangle();
  structure.points.push_back({.name = "body", .place = whole(Spider::kRigid)});
  const AssembledSystem assembled = assemble_system(structure);
  ASSERT_EQ(assembled.system.size(), 6);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      Eigen::MatrixXd(assembled.system.stiffness), Eigen::MatrixXd(assembled.system.mass));
  for (const double eigenvalue : modes.eigenvalues()) EXPECT_NEAR(eigenvalue, 5e3, 1e-9 * 5e3);
  // Σ (φᵀb)² over all modes is 1/m of the motion: three masses of 2 kg.
  const Eigen::VectorXd point = assembled.points.toDense();
  EXPECT_NEAR((modes.eigenvectors().transpose() * point).squaredNorm(), 1.0 / 6.0, 1e-13);
}

TEST(SystemAssembly, AverageSpidersLeaveAllAsItIs) {
  MeshedStructure structure = triangle();
  structure.points.push_back({.name = "body", .place = whole(Spider::kAverage)});
  EXPECT_EQ(assemble_system(structure).system.size(), 9);
}

TEST(SystemAssembly, SupportsHoldDirections) {
  MeshedStructure structure = triangle();
  structure.supports = {{.name = "s", .nodes = {1}},
                        {.name = "t", .nodes = {2}, .held = {false, true, false}},
                        {.name = "u", .nodes = {}, .rows = {8}}};
  EXPECT_EQ(assemble_system(structure).system.size(), 4);
}

TEST(SystemAssembly, NamesWhatIsWrong) {
  const auto message = [](const auto& change) {
    MeshedStructure structure = triangle();
    change(structure);
    return test::message_or("none", [&] { return assemble_system(structure); });
  };
  using S = MeshedStructure&;
  const auto expect = [&](const auto& change, const std::string& part) {
    test::expect_message(message(change), part);
  };
  expect([](S s) { s.matrices.mass.size = 8; }, "rows of the mass matrix = 8; must be 9");
  expect([](S s) { s.matrices.mass.value[4] = -1.0; }, "mass of node 2 y = -1");
  expect([](S s) { s.matrices.stiffness.value[4] = -1.0; }, "stiffness of node 2 y = -1");
  expect([](S s) { s.matrices.stiffness.value[4] = s.matrices.mass.value[4] = 0.0; },
         "node 2 y is without stiffness and mass");
  expect([](S s) { MassChains::add(s.matrices.mass, 1, 0, 3.0); },
         "mass matrix = 1 negative eigenvalue");
  expect(
      [](S s) {
        s.matrices.mass.value[0] = 0.0;
        MassChains::add(s.matrices.mass, 1, 0, 0.1);
      },
      "mass matrix = entries off a diagonal of 0");
  expect([](S s) { MassChains::add(s.matrices.mass, 9, 0, 3.0); }, "entry (10, 1)");
  expect([](S s) { MassChains::add(s.matrices.mass, 1, 0, std::nan("")); }, "mass matrix (2, 1)");
  expect(
      [](S s) {
        s.supports.push_back({.name = "s", .nodes = {1}});
        s.points.push_back({.name = "p", .place = whole(Spider::kRigid)});
      },
      "all = node 1 x; must not be fixed in a rigid spider");
  expect(
      [](S s) {
        s.points.push_back({.name = "p", .place = whole(Spider::kRigid)});
        s.points.push_back(
            {.name = "q", .place = {.name = "two", .nodes = {1, 2}, .spider = Spider::kRigid}});
      },
      "two = node 1 x; must not be in two rigid spiders");
  expect(
      [](S s) {
        s.supports.push_back(
            {.name = "s", .nodes = {1}, .held = {false, false, false, true, true, true}});
      },
      "s = a support that fixes nothing; must fix a degree of freedom");
  expect(
      [](S s) {
        s.supports.push_back({.name = "s", .nodes = {1, 2, 3}});
      },
      "degrees of freedom = 0; must be left");
  expect([](S s) { s.points.resize(2, {.name = "p", .place = whole(Spider::kAverage)}); },
         "name of a point = 'p'");
  expect(
      [](S s) {
        s.supports.push_back({.name = "s", .nodes = {1}});
        s.joints.push_back({.name = "j", .to = {.name = "n", .nodes = {1}}, .stiffness = 1.0});
      },
      "joint 'j' is without motion");
  expect(
      [](S s) {
        s.joints.push_back({.name = "j",
                            .from = whole(Spider::kRigid),
                            .to = {.name = "n", .nodes = {7}},
                            .stiffness = 1.0});
      },
      "n = node 7; must be a node of the matrices");
}

}  // namespace
}  // namespace microslip::system_assembly_test
