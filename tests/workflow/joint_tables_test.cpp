// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/joint_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/virgin_curve.hpp"
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
  const JointTable table =
      loop_of({uniform_joint(), {}, {}}, {x, {}}, NormalLoadLaw::kTotal, 10, "call");
  EXPECT_TRUE(table.warnings.empty());
  const std::vector<double> force = CsvTable(table.text, "loop").numbers("force", kForce);
  double area = 0.0;
  for (std::size_t i = kPoints; i < 3 * kPoints; ++i) {
    area += 0.5 * (force[i] + force[i + 1]) * (x[i + 1] - x[i]);
  }
  EXPECT_NEAR(area / exact_dissipation(3e-4), 1.0, 1e-5);  // trapezoids: 1/400²
}

TEST(JointTables, DissipationOfAUniformJoint) {
  const JointTable table = dissipation_of({uniform_joint(), {}, {}}, {1e-4, 2e-4}, "call");
  const CsvTable read(table.text, "curve");
  const std::vector<double> d = read.numbers("dissipation", kEnergy);
  const std::vector<double> k = read.numbers("secant_stiffness", kStiffness);
  const std::vector<double> eta = read.numbers("loss_factor", kDimensionless);
  EXPECT_NEAR(d[1] / exact_dissipation(2e-4), 1.0, 1e-12);
  EXPECT_NEAR(eta[0] * std::numbers::pi * k[0] * 1e-8 / d[0], 1.0, 1e-12);
}

// ---- Draws. ----

constexpr std::size_t kDraws = 1000;
constexpr double kLoad = 0.1;

LoneJointDraws loads(std::size_t count, Execution execution = Execution::threads()) {
  LoneJointDraws draws =
      draws_of({uniform_joint(), {}, {}}, {.normal_load = kLoad}, {.count = count});
  draws.execution = std::move(execution);
  return draws;
}

/// Of `name` over the value between which the share of 95 % lies: e^{±1.96 p σ} of what grows with
/// the power p of the load, within four standard deviations of a quantile of N draws, 2.67 pσ/√N.
void expect_edges(const CsvTable& table, const std::string& name, const Dimension& dimension,
                  double power, double allowance = 0.0) {
  const double tolerance =
      4.0 * 2.67 * std::abs(power) * kLoad / std::sqrt(static_cast<double>(kDraws)) + allowance;
  const double value = table.numbers(name, dimension).back();
  const double lower = table.numbers(name + "_lower", dimension).back();
  const double upper = table.numbers(name + "_upper", dimension).back();
  EXPECT_NEAR(std::log(lower / value), -1.96 * std::abs(power) * kLoad, tolerance) << name;
  EXPECT_NEAR(std::log(upper / value), 1.96 * std::abs(power) * kLoad, tolerance) << name;
}

// D = 2k²A³/(3·40 N e) below macro-slip: ∝ 1/e. At 0.01 mm a fortieth of the stiffness slips, so
// that the secant stiffness hardly moves, and with it the loss factor goes as D.
TEST(JointTables, DrawsOfTheNormalLoadAreThoseOfTheClosedForm) {
  const JointTable table =
      dissipation_of({uniform_joint(), {}, {}}, {1e-6, 1e-5}, "call", loads(kDraws));
  ASSERT_TRUE(table.taken);
  EXPECT_EQ(table.taken->failed(), 0U);
  const CsvTable read(table.text, "curve");
  expect_edges(read, "dissipation", kEnergy, -1.0);
  expect_edges(read, "loss_factor", kDimensionless, -1.0, 0.01);
  // k_eq = k(1 − c/e), c small: lower for the smaller load.
  EXPECT_LT(read.numbers("secant_stiffness_lower", kStiffness).back(),
            read.numbers("secant_stiffness", kStiffness).back());
  EXPECT_NE(table.text.find("# draws = 1000 of seed 1, 95 %"), std::string::npos) << table.text;
  EXPECT_EQ(table.text.find("joint_linear_dissipation"), std::string::npos);
}

// F = kx − k²x²/(2·40 N e): linear in 1/e, so that quantiles go over into each other.
TEST(JointTables, DrawsOfALoopAreThoseOfTheClosedForm) {
  const std::vector<double> x{0.0, 1e-4, 2e-4};
  const JointTable table =
      loop_of({uniform_joint(), {}, {}}, {x, {}}, NormalLoadLaw::kTotal, 10, "call", loads(kDraws));
  const CsvTable read(table.text, "loop");
  const double elastic = 20.0;  // kx, N
  const auto softening = [&](const std::string& name) {
    return elastic - read.numbers(name, kForce).back();
  };
  EXPECT_EQ(read.numbers("lower", kForce).front(), 0.0);
  const double tolerance = 4.0 * 2.67 * kLoad / std::sqrt(static_cast<double>(kDraws));
  EXPECT_NEAR(std::log(softening("lower") / softening("force")), 1.96 * kLoad, tolerance);
  EXPECT_NEAR(std::log(softening("upper") / softening("force")), -1.96 * kLoad, tolerance);
}

TEST(JointTables, DrawsAreTheSameOnAnyNumberOfThreads) {
  const auto text = [](Execution execution) {
    return dissipation_of({uniform_joint(), {}, {}}, {1e-5, 1e-4}, "call",
                          loads(60, std::move(execution)))
        .text;
  };
  EXPECT_EQ(text(Execution::serial()), text(Execution::threads(2)));
}

// A joint by itself is drawn as in a structure: draw 7 of one is that of the other.
TEST(JointTables, DrawsAreThoseOfAStructure) {
  const JointedStructure structure(ModalModel({{1.0, 0.01}}, {{"mass", {1.0}}}),
                                   {{"joint", uniform_joint(), {1.0}}}, {{"mass"}});
  const StructureDraws whole(structure, {.normal_load = {kLoad}}, {}, JointPairing::kIndependent,
                             1);
  const Joint joint = uniform_joint();
  const Joint alone = loads(40).joint.draw({&joint, 1}, 7).front().joint;
  EXPECT_EQ(whole.draw(7).structure.joints()[0].joint.virgin_force(1e-4), alone.virgin_force(1e-4));
  EXPECT_NE(alone.virgin_force(1e-4), joint.virgin_force(1e-4));
}

TEST(JointTables, DrawsOfNothingAreRefused) {
  const JointFile file{uniform_joint(), {}, {}};
  EXPECT_THROW((void)draws_of(file, {}, {.count = 100}), InputError);
  EXPECT_THROW((void)draws_of(file, {.normal_load = -0.1}, {.count = 100}), InputError);
  EXPECT_THROW((void)draws_of(file, {.normal_load = 0.1}, {.count = 39}), InputError);
}

TEST(JointTables, DrawsBeyondTheMemoryAreRefused) {
  EXPECT_NO_THROW(DrawOptions({.count = 1024}).check_size(1U << 17U, ""));
  EXPECT_THROW(DrawOptions({.count = 1025}).check_size(1U << 17U, ""), InputError);
}

}  // namespace
}  // namespace microslip::joint_tables_test
