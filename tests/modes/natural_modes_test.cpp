// SPDX-License-Identifier: MIT
#include "microslip/modes/natural_modes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/modes/definite_pencil.hpp"
#include "microslip/modes/system_assembly.hpp"
#include "support/beam_matrices.hpp"
#include "support/mass_chain.hpp"
#include "support/messages.hpp"

namespace microslip::natural_modes_test {
namespace {

using test::BeamMatrices;
using test::MassChains;

VibratingSystem system_of(const MassChains& chains) {
  return assemble_system({.matrices = chains.matrices()}).system;
}

/// Lanczos where there are more than 300 rows.
constexpr std::size_t kLong = 700;

void expect_closed_form(const NaturalModes& modes, const MassChains& chains, double tolerance) {
  for (Eigen::Index i = 0; i < modes.eigenvalues.size(); ++i) {
    const std::size_t number = static_cast<std::size_t>(i) / chains.chains + 1;
    const double exact = chains.angular_frequency(number);
    EXPECT_NEAR(std::sqrt(modes.eigenvalues(i)), exact, tolerance * exact) << i;
  }
}

// The lowest ω² is 1e-6 of the largest: rounding of K costs 1e-16 · 1e6 of it.
TEST(NaturalModes, AreThoseOfAChainInClosedForm) {
  for (const std::size_t masses : {std::size_t{7}, std::size_t{100}, kLong}) {
    const MassChains chain{.masses = masses};
    const VibratingSystem system = system_of(chain);
    const NaturalModes modes = find_natural_modes(system, {.count = 6});
    ASSERT_EQ(modes.eigenvalues.size(), 6);
    EXPECT_TRUE(modes.summary.converged()) << modes.summary.full();
    EXPECT_EQ(modes.rigid_bodies, 0U);
    expect_closed_form(modes, chain, 1e-10);
    const Eigen::MatrixXd unit = modes.shapes.transpose() * (system.mass * modes.shapes);
    EXPECT_LT((unit - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-12);
    EXPECT_LT(modes.residuals.maxCoeff(), 1e-8);
  }
}

TEST(NaturalModes, HaveRigidBodies) {
  for (const std::size_t masses : {std::size_t{20}, kLong}) {
    const MassChains chains{.masses = masses, .chains = 2, .held = false};
    const NaturalModes modes = find_natural_modes(system_of(chains), {.count = 9});
    ASSERT_EQ(modes.eigenvalues.size(), 9);
    EXPECT_EQ(modes.rigid_bodies, 2U);
    EXPECT_EQ(modes.eigenvalues(0), 0.0);
    EXPECT_EQ(modes.eigenvalues(1), 0.0);
    EXPECT_TRUE(modes.summary.converged()) << modes.summary.full();
    expect_closed_form(modes, chains, 1e-9);
  }
}

// Each eigenvalue five times: Lanczos from one vector sees it once, but for rounding.
TEST(NaturalModes, OfMultipleEigenvaluesAreNotMissed) {
  const MassChains chains{.masses = 120, .chains = 5};
  const NaturalModes modes = find_natural_modes(system_of(chains), {.count = 15});
  ASSERT_EQ(modes.eigenvalues.size(), 15);
  EXPECT_TRUE(modes.summary.converged()) << modes.summary.full();
  expect_closed_form(modes, chains, 1e-10);
}

TEST(NaturalModes, UpToAFrequencyAreAllBelowIt) {
  const MassChains chain{.masses = kLong};
  const double above = 0.5 * (chain.angular_frequency(12) + chain.angular_frequency(13));
  const double hertz = above / (2.0 * std::numbers::pi);
  const NaturalModes modes = find_natural_modes(system_of(chain), {.highest_frequency = hertz});
  EXPECT_EQ(modes.eigenvalues.size(), 12);
  const auto too_low = [&] {
    return find_natural_modes(system_of(chain), {.highest_frequency = 1e-3 * hertz});
  };
  test::expect_message(test::message_or("none", too_low), "must be above the first mode, ");
}

TEST(NaturalModes, OfMoreThanThereAreAreAll) {
  const MassChains chain{.masses = 7};
  const NaturalModes modes = find_natural_modes(system_of(chain), {.count = 50});
  EXPECT_EQ(modes.eigenvalues.size(), 7);
  EXPECT_TRUE(modes.summary.converged());
}

// Every other mass is 0: the chain is one of half the masses with twice the compliance between
// them.
TEST(NaturalModes, LeaveOutWhatHasNoMass) {
  for (const std::size_t masses : {std::size_t{10}, std::size_t{800}}) {
    MassChains chain{.masses = masses};
    StructuralMatrices matrices = chain.matrices();
    for (std::size_t i = 0; i < matrices.mass.value.size(); i += 2) matrices.mass.value[i] = 0.0;
    const VibratingSystem system = assemble_system({.matrices = matrices}).system;
    const MassChains half{.masses = masses / 2, .k = 0.5 * chain.k};
    const NaturalModes modes = find_natural_modes(system, {.count = 5});
    ASSERT_EQ(modes.eigenvalues.size(), 5);
    EXPECT_TRUE(modes.summary.converged()) << modes.summary.full();
    expect_closed_form(modes, half, 1e-9);
  }
}

// A spring to the ground at the free end, in the matrix or beside it.
TEST(NaturalModes, WithSpringsBesideAreThoseWithSpringsInTheMatrix) {
  MassChains chain{.masses = kLong};
  const double k = 3e4;
  VibratingSystem beside = system_of(chain);
  beside.spring_motions = Eigen::SparseMatrix<double>(beside.size(), 1);
  beside.spring_motions.insert(beside.size() - 1, 0) = 1.0;
  beside.spring_stiffness = Eigen::VectorXd::Constant(1, k);
  StructuralMatrices matrices = chain.matrices();
  MassChains::add(matrices.stiffness, kLong - 1, kLong - 1, k);
  const VibratingSystem inside = assemble_system({.matrices = matrices}).system;
  const NaturalModes a = find_natural_modes(beside, {.count = 8});
  const NaturalModes b = find_natural_modes(inside, {.count = 8});
  EXPECT_LT((a.eigenvalues - b.eigenvalues).norm(), 1e-10 * b.eigenvalues.norm());
  EXPECT_TRUE(a.summary.converged()) << a.summary.full();
}

TEST(NaturalModes, RefuseWhatIsNoStructure) {
  MassChains chain{.masses = 8};
  StructuralMatrices matrices = chain.matrices();
  MassChains::add(matrices.stiffness, 7, 7, -2.0 * chain.k + 1.0);
  matrices.stiffness.value.back() = -0.9999 * chain.k;
  const VibratingSystem system = assemble_system({.matrices = matrices}).system;
  const std::string message =
      test::message_or("none", [&] { return find_natural_modes(system, {.count = 3}); });
  test::expect_message(message, "stiffness matrix = 1 negative eigenvalue");
  // Of a pencil that has no factor the number is not known.
  const Eigen::Matrix2d sound_mass = Eigen::Matrix2d::Identity();
  test::expect_message(
      test::message_or(
          "none",
          [&] { return definite_pairs(-2.0 * sound_mass, sound_mass, -1.0).eigenvalues.size(); }),
      "stiffness matrix = not positive definite");
  const VibratingSystem sound = system_of(chain);
  EXPECT_THROW((void)find_natural_modes(sound, {}), InputError);
  EXPECT_THROW((void)find_natural_modes(sound, {.count = 0}), InputError);
  EXPECT_THROW((void)find_natural_modes(sound, {.count = 1, .highest_frequency = 1.0}), InputError);
  EXPECT_THROW((void)find_natural_modes(sound, {.highest_frequency = -1.0}), InputError);
}

double hertz(double eigenvalue) { return std::sqrt(eigenvalue) / (2.0 * std::numbers::pi); }

/// A steel bar of 40 × 40 × 400 mm: its first bending mode is at 1329 Hz.
BeamMatrices steel_bar(std::size_t elements) {
  return {elements, 0.4, 2.1e11 * std::pow(0.04, 4) / 12.0, 7850.0 * 0.04 * 0.04};
}

NaturalModes modes_of(const StructuralMatrices& matrices, std::size_t count) {
  return find_natural_modes(assemble_system({.matrices = matrices}).system, {.count = count});
}

// Springs of 3500 N/m under its ends, 1e-8 of the stiffness of an element: √(2k/m) and √(6k/m) of
// the rigid bar, whose bending lowers them by (5.9/1329)² = 2e-5. LAPACK (dsygvd) has 5.941, 10.29
// and 1329.2 Hz. 200 elements are 402 rows, beyond the dense solution.
TEST(NaturalModes, OfAStiffBodyOnSoftSpringsAreNoRigidBodies) {
  for (const std::size_t elements : {std::size_t{10}, std::size_t{40}, std::size_t{200}}) {
    const BeamMatrices bar = steel_bar(elements);
    StructuralMatrices matrices = bar.matrices();
    BeamMatrices::hold(matrices, 0, 3500.0);
    BeamMatrices::hold(matrices, bar.rows() - 2, 3500.0);
    const NaturalModes modes = modes_of(matrices, 3);
    EXPECT_EQ(modes.rigid_bodies, 0U) << elements;
    EXPECT_TRUE(modes.summary.converged()) << modes.summary.full();
    const double heave = hertz(2.0 * 3500.0 / bar.mass());
    EXPECT_NEAR(hertz(modes.eigenvalues(0)), heave, 1e-4 * heave);
    EXPECT_NEAR(hertz(modes.eigenvalues(1)), std::sqrt(3.0) * heave, 1e-4 * heave);
    EXPECT_NEAR(hertz(modes.eigenvalues(2)), 1329.2, 0.5);
    const NaturalModes free = modes_of(bar.matrices(), 3);
    EXPECT_EQ(free.rigid_bodies, 2U) << elements;
    EXPECT_LT(hertz(free.rounding), 0.2 * heave) << elements;
  }
}

// Eight digits change ω² of the free bar by some 1e-9 of its elements' EI/l³: more than of soft
// springs. Without their number the modes would be some Hz, or below 0.
TEST(NaturalModes, OfMatricesWithFewDigitsHaveRigidBodies) {
  const BeamMatrices bar = steel_bar(30);
  StructuralMatrices matrices = bar.matrices();
  for (double& value : matrices.stiffness.value) {
    value = std::stod(fmt::format("{:.7e}", value * (1.0 + 1e-3 * std::numbers::pi)));
  }
  matrices.stiffness_rounding = 5e-8;
  const NaturalModes modes = modes_of(matrices, 3);
  EXPECT_EQ(modes.rigid_bodies, 2U);
  EXPECT_NEAR(hertz(modes.eigenvalues(2)), 1331.3, 1.0);
}

// A clamp by springs as finite-element programs write it: the cantilever in closed form, but for
// the (λ/n)⁴/720 of cubic elements and the 2EIλ²/(pL³) that the springs give, 7e-8 of mode 5.
TEST(NaturalModes, OfAClampByStiffSpringsAreThoseOfTheClamp) {
  for (const std::size_t elements : {std::size_t{20}, std::size_t{200}}) {
    for (const double p : {1e12, 1e14, 1e16}) {
      const BeamMatrices beam{.elements = elements};
      StructuralMatrices matrices = beam.matrices();
      BeamMatrices::hold(matrices, 0, p);
      BeamMatrices::hold(matrices, 1, p);
      const NaturalModes modes = modes_of(matrices, 5);
      ASSERT_EQ(modes.eigenvalues.size(), 5);
      EXPECT_EQ(modes.rigid_bodies, 0U) << elements << " " << p;
      EXPECT_TRUE(modes.summary.converged()) << elements << " " << p << modes.summary.full();
      for (Eigen::Index i = 0; i < 5; ++i) {
        const double exact = beam.cantilever_hertz(static_cast<std::size_t>(i) + 1);
        const double wave =
            BeamMatrices::root(static_cast<std::size_t>(i) + 1) / static_cast<double>(elements);
        EXPECT_NEAR(hertz(modes.eigenvalues(i)), exact, (std::pow(wave, 4) / 700 + 1e-6) * exact)
            << elements << " " << p << " mode " << i + 1;
      }
    }
  }
}

// All modes of a chain of springs of 1, 1e5 and 1e10 N/m between masses of 1 kg, by the
// coefficients of the characteristic polynomial: trace, principal minors of two rows, determinant
// k₁k₂k₃. Rounding of the entries is 1e-16 · 1e10 of the lowest ω², 1/3.
TEST(NaturalModes, OfWidelySpreadSpringsHaveTheirDigits) {
  StructuralMatrices matrices;
  matrices.stiffness.size = matrices.mass.size = 3;
  const std::array<double, 3> k = {1.0, 1e5, 1e10};
  for (std::size_t i = 0; i < 3; ++i) {
    MassChains::add(matrices.mass, i, i, 1.0);
    MassChains::add(matrices.stiffness, i, i, k[i]);
    if (i == 0) continue;
    MassChains::add(matrices.stiffness, i - 1, i - 1, k[i]);
    MassChains::add(matrices.stiffness, i, i - 1, -k[i]);
  }
  const NaturalModes modes = modes_of(matrices, 3);
  ASSERT_EQ(modes.eigenvalues.size(), 3);
  EXPECT_TRUE(modes.summary.converged()) << modes.summary.full();
  const double trace = k[0] + 2.0 * k[1] + 2.0 * k[2];
  const double minors = k[0] * k[1] + 2.0 * k[0] * k[2] + 3.0 * k[1] * k[2];
  const double determinant = k[0] * k[1] * k[2];
  EXPECT_NEAR(modes.eigenvalues.sum(), trace, 1e-12 * trace);
  const double pairs = modes.eigenvalues(0) * modes.eigenvalues(1) +
                       modes.eigenvalues(0) * modes.eigenvalues(2) +
                       modes.eigenvalues(1) * modes.eigenvalues(2);
  EXPECT_NEAR(pairs, minors, 1e-9 * minors);
  EXPECT_NEAR(modes.eigenvalues.prod(), determinant, 1e-4 * determinant);
}

TEST(NaturalModes, StopWhenAsked) {
  const VibratingSystem system = system_of({.masses = kLong});
  const auto stop = [](std::size_t done, std::size_t) { return done < 20; };
  EXPECT_THROW((void)find_natural_modes(system, {.count = 6}, stop), Cancelled);
}

}  // namespace
}  // namespace microslip::natural_modes_test
