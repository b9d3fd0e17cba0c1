// SPDX-License-Identifier: MIT
#include "microslip/workflow/joint_tables.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>

#include "microslip/io/csv.hpp"
#include "workflow/results.hpp"

namespace microslip::joint_tables_test {
namespace {

using test::uniform_joint;

// By hand: D′ = 4Φ1(kA) = 2(kA)²/40 N, so D = 2k²A³/(3·40 N).
double exact_dissipation(double a) { return 2.0 * 1e10 * a * a * a / (3.0 * 40.0); }

TEST(JointTables, TheAreaOfTheCycleIsTheDissipation) {
  constexpr std::size_t kPoints = 400;
  const std::vector<double> x = loading_and_cycle(3e-4, kPoints);
  ASSERT_EQ(x.size(), 3 * kPoints + 1);
  const JointTable table = loop_of({uniform_joint(), {}, {}}, {x, {}}, NormalLoadLaw::kTotal, 10);
  EXPECT_TRUE(table.warnings.empty());
  const std::vector<double> force = CsvTable(table.text, "loop").numbers("force", kForce);
  double area = 0.0;
  for (std::size_t i = kPoints; i < 3 * kPoints; ++i) {
    area += 0.5 * (force[i] + force[i + 1]) * (x[i + 1] - x[i]);
  }
  EXPECT_NEAR(area / exact_dissipation(3e-4), 1.0, 1e-5);  // trapezoids: 1/400²
}

TEST(JointTables, DissipationOfAUniformJoint) {
  const JointTable table = dissipation_of({uniform_joint(), {}, {}}, {1e-4, 2e-4});
  const CsvTable read(table.text, "curve");
  const std::vector<double> d = read.numbers("dissipation", kEnergy);
  const std::vector<double> k = read.numbers("secant_stiffness", kStiffness);
  const std::vector<double> eta = read.numbers("loss_factor", kDimensionless);
  EXPECT_NEAR(d[1] / exact_dissipation(2e-4), 1.0, 1e-12);
  EXPECT_NEAR(eta[0] * std::numbers::pi * k[0] * 1e-8 / d[0], 1.0, 1e-12);
}

}  // namespace
}  // namespace microslip::joint_tables_test
