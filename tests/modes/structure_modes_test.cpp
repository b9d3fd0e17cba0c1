// SPDX-License-Identifier: MIT
#include "microslip/modes/structure_modes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/io/matrices/matrix_market.hpp"
#include "microslip/structure/entry_rounding.hpp"
#include "support/beam_matrices.hpp"
#include "support/figures.hpp"
#include "support/mass_chain.hpp"
#include "support/messages.hpp"

namespace microslip::structure_modes_test {
namespace {

using test::MassChains;

const std::string kTwoJoints = MICROSLIP_TEST_DATA "/two_joints/";

/// The structure of tests/data/two_joints: a joint between masses 2 and 3, one from mass 6 to
/// ground.
MeshedStructure two_joints() {
  MeshedStructure structure;
  structure.matrices.stiffness = read_matrix_market(kTwoJoints + "stiffness.mtx");
  structure.matrices.mass = read_matrix_market(kTwoJoints + "mass.mtx");
  structure.points.push_back({.name = "drive", .place = {.name = "row", .nodes = {}, .row = 0}});
  structure.joints.push_back({.name = "joint1",
                              .from = MeshPlace{.name = "row", .nodes = {}, .row = 1},
                              .to = {.name = "row", .nodes = {}, .row = 2},
                              .stiffness = 9e5});
  structure.joints.push_back(
      {.name = "joint2", .to = {.name = "row", .nodes = {}, .row = 5}, .stiffness = 5e5});
  return structure;
}

Eigen::MatrixXd dense(const SymmetricEntries& entries) {
  const auto size = static_cast<Eigen::Index>(entries.size);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    matrix(entries.row[i], entries.column[i]) = entries.value[i];
    matrix(entries.column[i], entries.row[i]) = entries.value[i];
  }
  return matrix;
}

// Against Eigen's dense generalised eigenvalues of K with the springs in it.
TEST(StructureModes, OfSmallMatricesAreThoseOfADenseSolver) {
  const MeshedStructure structure = two_joints();
  const StructureModes stuck =
      compute_structure_modes(structure, {.count = 6, .joints = JointsInModes::kStuck});
  Eigen::MatrixXd stiffness = dense(structure.matrices.stiffness);
  Eigen::VectorXd first = Eigen::VectorXd::Zero(6);
  first(2) = 1.0;
  first(1) = -1.0;
  stiffness += 9e5 * first * first.transpose();
  stiffness(5, 5) += 5e5;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> exact(
      stiffness, dense(structure.matrices.mass));
  for (std::size_t i = 0; i < 6; ++i) {
    test::record_deviation("frequency", stuck.model.modes()[i].angular_frequency,
                           std::sqrt(exact.eigenvalues()(static_cast<Eigen::Index>(i))));
    const Eigen::VectorXd shape = exact.eigenvectors().col(static_cast<Eigen::Index>(i));
    EXPECT_NEAR(std::abs(stuck.joint_shapes[0][i]), std::abs(first.dot(shape)), 1e-12);
  }
  EXPECT_EQ(stuck.model.size(), 6U);  // nothing is left for attachments
  EXPECT_TRUE(stuck.warnings.empty());
}

/// A chain fixed at its first end, a joint between its last mass and the ground.
MeshedStructure chain_with_joint(std::size_t masses) {
  const MassChains chain{.masses = masses,
                         .m = 10.0 / static_cast<double>(masses),
                         .k = 1e6 * static_cast<double>(masses)};
  MeshedStructure structure{.matrices = chain.matrices()};
  const auto last = static_cast<std::int64_t>(masses);
  structure.points.push_back({.name = "drive", .place = {.name = "node", .nodes = {last / 3}}});
  structure.joints.push_back(
      {.name = "joint", .to = {.name = "node", .nodes = {last}}, .stiffness = 2e6});
  return structure;
}

JointedStructure jointed(const StructureModes& modes, const MeshedStructure& structure) {
  std::vector<Mode> damped(modes.model.modes().begin(), modes.model.modes().end());
  for (Mode& mode : damped) mode.loss_factor = 0.003;
  const double k = structure.joints[0].stiffness;
  const double spring = modes.joints == JointsInModes::kStuck ? k : 0.0;
  const SlipDensity density({UniformPart{.from = 0.0, .to = 40.0, .weight = 0.8}});
  return {ModalModel(damped, {modes.model.points().begin(), modes.model.points().end()}),
          {{.name = "joint",
            .joint = Joint(k, density),
            .shape = modes.joint_shapes[0],
            .spring_in_modes = spring}},
          {{.point = "drive"}},
          DampingLaw::kHysteretic};
}

/// The response at the first resonance under a force that makes most of the joint slip.
double peak(const MeshedStructure& structure, const ModesOptions& options) {
  const StructureModes modes = compute_structure_modes(structure, options);
  const HarmonicBalance balance(jointed(modes, structure), {"drive"});
  const VibrationResult found = balance.solve({Quantity::kForceAmplitude, 2.4}, kPhaseResonance);
  EXPECT_TRUE(found.summary.converged()) << found.summary.full();
  EXPECT_GT(found.vibration.joints[0].amplitude * structure.joints[0].stiffness, 20.0);
  return found.vibration.response;
}

// All 60 modes of the chain are the structure itself. Of a quarter of them the joint moves too
// little unless the attachment brings what is missing.
TEST(StructureModes, WithAttachmentsNeedAQuarterOfTheModes) {
  const MeshedStructure structure = chain_with_joint(60);
  for (const JointsInModes joints : {JointsInModes::kFree, JointsInModes::kStuck}) {
    const double exact = peak(structure, {.count = 60, .joints = joints});
    const auto error = [&](std::size_t count, bool attachment) {
      const ModesOptions options{
          .count = count, .joints = joints, .attachment = attachment, .attached_points = {"drive"}};
      return std::abs(peak(structure, options) / exact - 1.0);
    };
    test::record_largest("peak with a quarter of the modes [1]", error(15, true));
    test::record_largest("peak with three modes [1]", error(3, true));
    EXPECT_GT(error(15, false), 10.0 * error(15, true));
  }
}

// The joint's spring in the modes or beside them is the same structure, where nothing is damped
// twice: all modes, and a frequency at which the joint sticks.
TEST(StructureModes, FreeAndStuckAreOneStructure) {
  const MeshedStructure structure = chain_with_joint(30);
  const auto stuck_frequencies = [&](JointsInModes joints) {
    return jointed(compute_structure_modes(structure, {.count = 30, .joints = joints}), structure)
        .stuck_frequencies();
  };
  const std::vector<double> free = stuck_frequencies(JointsInModes::kFree);
  const std::vector<double> stuck = stuck_frequencies(JointsInModes::kStuck);
  for (std::size_t i = 0; i < 30; ++i) EXPECT_NEAR(free[i], stuck[i], 1e-9 * stuck[i]) << i;
}

TEST(StructureModes, WarnOfRigidBodiesThatNothingHolds) {
  const MassChains chains{.masses = 12, .chains = 2, .held = false};
  MeshedStructure structure{.matrices = chains.matrices()};
  const auto joint = [](const std::string& name, std::int64_t from, std::int64_t to) {
    return MeshJoint{.name = name,
                     .from = MeshPlace{.name = "node", .nodes = {from}},
                     .to = {.name = "node", .nodes = {to}},
                     .stiffness = 1e5};
  };
  structure.joints.push_back(joint("between", 12, 13));
  const StructureModes loose = compute_structure_modes(structure, {.count = 6});
  EXPECT_EQ(loose.rigid_bodies, 2U);
  ASSERT_EQ(loose.warnings.size(), 1U);
  test::expect_message(loose.warnings[0].text,
                       "1 mode of 0 Hz is restrained by nothing, no joint either");
  structure.joints.push_back(
      {.name = "ground", .to = {.name = "node", .nodes = {24}}, .stiffness = 1e5});
  EXPECT_TRUE(compute_structure_modes(structure, {.count = 6}).warnings.empty());
}

TEST(StructureModes, SayWhatAJointLacksWithoutAttachment) {
  const StructureModes modes =
      compute_structure_modes(chain_with_joint(60), {.count = 3, .attachment = false});
  ASSERT_EQ(modes.warnings.size(), 1U);
  EXPECT_EQ(modes.warnings[0].code, "compliance_lacks");
  const StructureModes with = compute_structure_modes(chain_with_joint(60), {.count = 3});
  EXPECT_TRUE(with.warnings.empty());
  EXPECT_NEAR(with.compliances[0].in_model, with.compliances[0].exact,
              1e-10 * with.compliances[0].exact);
}

TEST(StructureModes, NamePointsAndStiffnesses) {
  MeshedStructure structure = chain_with_joint(5);
  test::expect_message(test::message_or("none",
                                        [&] {
                                          return compute_structure_modes(
                                              structure,
                                              {.count = 2, .attached_points = {"dirve"}});
                                        }),
                       "point = 'dirve'; is not one of the structure. Points there are: 'drive'");
  structure.joints[0].stiffness = 0.0;
  test::expect_message(test::message_or("none",
                                        [&] {
                                          return compute_structure_modes(
                                              structure,
                                              {.count = 2, .joints = JointsInModes::kStuck});
                                        }),
                       "stiffness of joint 'joint' = 0; must be positive");
}

// A clamped chain on a shaken clamp: Γ = φᵀM·1, and all modes together move all of the mass,
// Σ Γ² = 1ᵀM1, which is that of the masses.
TEST(StructureModes, OfABaseMoveItsMass) {
  MeshedStructure structure = chain_with_joint(12);
  structure.bases.push_back({.name = "table", .direction = {.axis = {1.0, 0.0, 0.0}}});
  const StructureModes all = compute_structure_modes(structure, {.count = 12, .attachment = false});
  ASSERT_EQ(all.model.bases().size(), 1U);
  const ModalBase& base = all.model.bases()[0];
  EXPECT_EQ(base.point_motion, (std::vector<double>{1.0}));
  ASSERT_EQ(all.base_masses.size(), 1U);
  EXPECT_NEAR(all.base_masses[0].total, 10.0, 1e-12);
  EXPECT_NEAR(all.base_masses[0].in_modes, 10.0, 1e-10);
  EXPECT_TRUE(all.warnings.empty());  // a spring to the clamp shares no mass
  // The first mode of a clamped chain in closed form: φ_i ∝ sin((i + 1)θ), θ = π/(2n + 1).
  double participation = 0.0;
  double square = 0.0;
  for (int i = 1; i <= 12; ++i) {
    const double shape = std::sin(i * std::numbers::pi / 25.0);
    participation += 10.0 / 12.0 * shape;
    square += 10.0 / 12.0 * shape * shape;
  }
  EXPECT_NEAR(std::abs(base.participation[0]), participation / std::sqrt(square), 1e-10);
}

// With an attachment two modes hold all of the static motion under an acceleration of the base.
TEST(StructureModes, OfABaseHaveItsStaticMotionAttached) {
  MeshedStructure structure = chain_with_joint(30);
  structure.bases.push_back({.name = "table", .direction = {.axis = {1.0, 0.0, 0.0}}});
  const StructureModes found =
      compute_structure_modes(structure, {.count = 2, .attached_points = {"table"}});
  EXPECT_EQ(found.model.size(), 4U);
  const StaticCompliance& of_base = found.compliances.back();
  EXPECT_EQ(of_base.place, YieldingPlace::kBase);
  EXPECT_EQ(unit_of(of_base), "kg s^2");
  EXPECT_NEAR(of_base.in_model / of_base.exact, 1.0, 1e-9);
  EXPECT_LT(of_base.in_modes / of_base.exact, 1.0 - 1e-6);
  double sum = 0.0;
  for (std::size_t i = 0; i < found.model.size(); ++i) {
    sum += std::pow(
        found.model.bases()[0].participation[i] / found.model.modes()[i].angular_frequency, 2);
  }
  EXPECT_NEAR(sum / of_base.exact, 1.0, 1e-9);
}

// Beside a free chain of 30 masses of 2 kg: an inner degree of freedom that stretches with the
// first spring, k/2 (θ − x₂ + x₁)², of 5 kg, which must not move with a base, and a mass of 3 kg on
// a spring, of a node that the mesh lacks as well, which must.
TEST(StructureModes, OfABaseLeaveInnerDegreesOfFreedomAtRest) {
  const MassChains chain{.masses = 30, .held = false};
  MeshedStructure structure{.matrices = chain.matrices()};
  structure.matrices.stiffness.size = structure.matrices.mass.size = 32;
  structure.matrices.degrees.push_back({100, NodalDirection::kX});
  structure.matrices.degrees.push_back({101, NodalDirection::kX});
  const double k = chain.k;
  for (const auto& [row, column, value] : {std::tuple{0U, 0U, k},
                                           {1U, 1U, k},
                                           {1U, 0U, -k},
                                           {30U, 30U, k},
                                           {30U, 0U, k},
                                           {30U, 1U, -k},
                                           {29U, 29U, k},
                                           {31U, 31U, k},
                                           {31U, 29U, -k}}) {
    MassChains::add(structure.matrices.stiffness, row, column, value);
  }
  MassChains::add(structure.matrices.mass, 30, 30, 5.0);
  MassChains::add(structure.matrices.mass, 31, 31, 3.0);
  structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 29}});
  structure.bases.push_back({.name = "table"});
  structure.nodes_without_element = {100, 101};
  const StructureModes found = compute_structure_modes(structure, {.count = 2});
  EXPECT_NEAR(found.base_masses[0].total, 30 * 2.0 + 3.0, 1e-9);
  structure.bases[0].rows = {30};  // as it is asked for
  EXPECT_NEAR(compute_structure_modes(structure, {.count = 2}).base_masses[0].total, 5.0, 1e-9);
}

// A steel bar of 30 elements on springs of 3500 N/m, 5.9 Hz: eight digits of its matrix hide what
// lies below 84 Hz, more than a hundredth of the 1329 Hz of its first bending mode.
TEST(StructureModes, SayWhatTheDigitsOfTheMatrixHide) {
  const test::BeamMatrices bar{30, 0.4, 2.1e11 * std::pow(0.04, 4) / 12.0, 7850.0 * 0.04 * 0.04};
  MeshedStructure structure{.matrices = bar.matrices()};
  test::BeamMatrices::hold(structure.matrices, 0, 3500.0);
  test::BeamMatrices::hold(structure.matrices, bar.rows() - 2, 3500.0);
  structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 0}});
  const auto code = [&] {
    const StructureModes found = compute_structure_modes(structure, {.count = 4});
    return found.warnings.empty() ? "" : found.warnings.back().code;
  };
  EXPECT_EQ(code(), "");
  structure.matrices.stiffness_rounding = 5e-8;
  EXPECT_EQ(code(), "rigid_bodies_doubtful");
}

/// The warning of a code, "" without it.
std::string warning_of(const StructureModes& found, std::string_view code) {
  const auto one = std::ranges::find(found.warnings, code, &Warning::code);
  return one == found.warnings.end() ? "" : one->text;
}

/// A matrix as a file of so many digits has it.
SymmetricEntries written(const SymmetricEntries& entries, int digits) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> sums;
  for (std::size_t i = 0; i < entries.value.size(); ++i) {
    sums[{entries.row[i], entries.column[i]}] += entries.value[i];
  }
  SymmetricEntries rounded{.size = entries.size, .row = {}, .column = {}, .value = {}};
  for (const auto& [place, value] : sums) {
    MassChains::add(rounded, static_cast<std::size_t>(place.first),
                    static_cast<std::size_t>(place.second),
                    std::stod(fmt::format("{:.{}e}", value, digits - 1)));
  }
  return rounded;
}

// A uniform free bar has six different entries, too few to know that they are rounded: its two
// rigid bodies have up to some 40 Hz then, or a negative ω². The truth is 0 Hz.
TEST(StructureModes, SayWhatTheDigitsOfAFewEntriesMayHide) {
  for (const std::size_t elements : {4U, 30U}) {
    for (int digits = 7; digits <= 10; ++digits) {
      const test::BeamMatrices bar{
          elements, 0.4,
          2.1e11 * std::pow(0.04, 4) / 12.0 * (1.0 + 1e-3 * digits * std::numbers::pi),
          7850.0 * 0.04 * 0.04};
      MeshedStructure structure{.matrices = bar.matrices()};
      structure.matrices.stiffness = written(structure.matrices.stiffness, digits);
      EXPECT_EQ(entry_rounding(structure.matrices.stiffness), 0.0);
      structure.matrices.possible_rounding = possible_entry_rounding(structure.matrices.stiffness);
      structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 0}});
      const StructureModes found = compute_structure_modes(structure, {.count = 4});
      EXPECT_TRUE(found.rigid_bodies == 2 || !warning_of(found, "rigid_bodies_doubtful").empty())
          << elements << " elements, " << digits << " digits";
      EXPECT_TRUE(found.summary.converged()) << found.summary.full();
    }
  }
}

// Three masses of 1 kg on a spring of 100 N/m, √(100/3) rad/s; two of them are tied by a stiff
// spring p, whose rounding in the sums of the matrix is 1.1e-16 p. Of 1e16 N/m that is 1.
TEST(StructureModes, SayWhereStiffSpringsMayHideSoftOnes) {
  for (const double p : {1e14, 1e15, 1e16}) {
    MeshedStructure structure;
    structure.matrices.stiffness.size = structure.matrices.mass.size = 3;
    for (const auto& [row, column, value] : {std::tuple{0U, 0U, p + 100.0},
                                             {1U, 0U, -p},
                                             {1U, 1U, p + 1e9},
                                             {2U, 1U, -1e9},
                                             {2U, 2U, 1e9}}) {
      MassChains::add(structure.matrices.stiffness, row, column, value);
    }
    for (std::size_t i = 0; i < 3; ++i) MassChains::add(structure.matrices.mass, i, i, 1.0);
    structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 2}});
    const StructureModes found = compute_structure_modes(structure, {.count = 2});
    if (found.rigid_bodies == 0) {
      EXPECT_NEAR(found.model.modes()[0].angular_frequency, std::sqrt(100.0 / 3.0), 0.05) << p;
      continue;
    }
    EXPECT_EQ(p, 1e16);
    EXPECT_NE(warning_of(found, "rigid_bodies_doubtful"), "");
    const std::string loose = warning_of(found, "rigid_bodies");
    EXPECT_NE(loose.find("lost in the digits"), std::string::npos) << loose;
    EXPECT_EQ(loose.find("support"), std::string::npos) << loose;
  }
}

// A stiffness that was cut after its eighth column, beside a whole mass.
TEST(StructureModes, SayWhereStiffnessIsMissing) {
  MeshedStructure structure = chain_with_joint(12);
  const SymmetricEntries whole = structure.matrices.stiffness;
  SymmetricEntries& cut = structure.matrices.stiffness;
  cut = {.size = 12, .row = {}, .column = {}, .value = {}};
  for (std::size_t i = 0; i < whole.value.size(); ++i) {
    const auto row = static_cast<std::size_t>(whole.row[i]);
    if (row >= 8) continue;
    MassChains::add(cut, row, static_cast<std::size_t>(whole.column[i]), whole.value[i]);
  }
  const std::string text =
      warning_of(compute_structure_modes(structure, {.count = 5}), "stiffness_rows_missing");
  // The joint holds the last.
  test::expect_message(text,
                       "no entry at 3 degrees of freedom with mass, the first of them node 9 x");
  const StructureModes sound = compute_structure_modes(chain_with_joint(12), {.count = 5});
  EXPECT_EQ(warning_of(sound, "stiffness_rows_missing"), "");
}

// A chain of 200 kg, and one rotation of 5000 kg m² that counts as x: 3 of 101 rows are strained.
TEST(StructureModes, OfABaseThatStrainsMuchMassSayWhatItMoves) {
  const MassChains chain{.masses = 100, .k = 1e7};
  MeshedStructure structure{.matrices = chain.matrices()};
  structure.matrices.stiffness.size = structure.matrices.mass.size = 101;
  structure.matrices.degrees.push_back({200, NodalDirection::kX});
  for (const auto& [row, column, sign] : {std::tuple{49U, 49U, 1.0},
                                          {50U, 50U, 1.0},
                                          {50U, 49U, -1.0},
                                          {100U, 100U, 1.0},
                                          {100U, 49U, 1.0},
                                          {100U, 50U, -1.0}}) {
    MassChains::add(structure.matrices.stiffness, row, column, sign * chain.k);
  }
  MassChains::add(structure.matrices.mass, 100, 100, 5000.0);
  structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 99}});
  structure.bases.push_back({.name = "table"});
  const StructureModes found = compute_structure_modes(structure, {.count = 2});
  test::expect_message(warning_of(found, "base_rows_doubtful"), "4 of the 101 rows that it moves");
}

// Beside a free chain of 60 kg and an inner degree of freedom of 5 kg, as above, two masses of 30
// and 40 kg that a stiff spring ties: one of them alone would strain it.
TEST(StructureModes, OfABaseMoveNodesWithoutElementTogether) {
  const MassChains chain{.masses = 30, .held = false, .k = 1e7};
  MeshedStructure structure{.matrices = chain.matrices()};
  structure.matrices.stiffness.size = structure.matrices.mass.size = 33;
  for (std::int64_t node = 100; node < 103; ++node) {
    structure.matrices.degrees.push_back({node, NodalDirection::kX});
    structure.nodes_without_element.push_back(node);
  }
  for (const auto& [row, column, value] : {std::tuple{0U, 0U, 1e7},
                                           {1U, 1U, 1e7},
                                           {1U, 0U, -1e7},
                                           {30U, 30U, 1e7},
                                           {30U, 0U, 1e7},
                                           {30U, 1U, -1e7},
                                           {29U, 29U, 1e6},
                                           {31U, 31U, 1e6 + 1e7},
                                           {31U, 29U, -1e6},
                                           {32U, 32U, 1e7},
                                           {32U, 31U, -1e7}}) {
    MassChains::add(structure.matrices.stiffness, row, column, value);
  }
  MassChains::add(structure.matrices.mass, 30, 30, 5.0);
  MassChains::add(structure.matrices.mass, 31, 31, 30.0);
  MassChains::add(structure.matrices.mass, 32, 32, 40.0);
  structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 29}});
  structure.bases.push_back({.name = "table"});
  const auto mass = [&] {
    return compute_structure_modes(structure, {.count = 2}).base_masses[0].total;
  };
  EXPECT_NEAR(mass(), 130.0, 1e-9);
  // Also where a weak spring ties the inner one to them: the least is then sought from both sides.
  for (const auto& [row, column, value] :
       {std::tuple{30U, 30U, 1e3}, {31U, 31U, 1e3}, {31U, 30U, -1e3}}) {
    MassChains::add(structure.matrices.stiffness, row, column, value);
  }
  EXPECT_NEAR(mass(), 130.0, 1e-9);
}

// Rotations that count as translations, for want of a mesh, show by what a translation strains.
TEST(StructureModes, OfABaseThatStrainsSayWhatItMoves) {
  const MassChains chain{.masses = 30};
  MeshedStructure structure{.matrices = chain.matrices()};
  structure.points.push_back({.name = "end", .place = {.name = "row", .nodes = {}, .row = 29}});
  structure.bases.push_back({.name = "table"});
  const auto warned = [&] {
    const StructureModes found = compute_structure_modes(structure, {.count = 2});
    return std::ranges::any_of(found.warnings,
                               [](const Warning& one) { return one.code == "base_rows_doubtful"; });
  };
  EXPECT_FALSE(warned());
  for (std::size_t row = 0; row < 30; row += 1) {
    MassChains::add(structure.matrices.stiffness, row, row, 1e-3 * chain.k);
  }
  EXPECT_TRUE(warned());
}

// Elements whose mass spreads over rows that something outside holds: the share of what is held
// there is not in the matrices, which a user must know.
TEST(StructureModes, OfABaseSayWhatMassIsMissing) {
  MeshedStructure structure = chain_with_joint(12);
  structure.bases.push_back({.name = "table", .direction = {.axis = {1.0, 0.0, 0.0}}});
  MassChains::add(structure.matrices.mass, 1, 0, 0.1);
  const StructureModes found = compute_structure_modes(structure, {.count = 2});
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_EQ(found.warnings.front().code, "base_mass_missing");
  structure.matrices.degrees.clear();
  structure.points.clear();
  structure.joints.clear();
  test::expect_message(
      test::message_or("", [&] { return compute_structure_modes(structure, {.count = 2}); }),
      "degrees_of_freedom");
}

}  // namespace
}  // namespace microslip::structure_modes_test
