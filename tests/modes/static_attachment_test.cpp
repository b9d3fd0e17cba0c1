// SPDX-License-Identifier: MIT
#include "microslip/modes/static_attachment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "microslip/algebra/core.hpp"
#include "microslip/modes/system_assembly.hpp"
#include "support/beam_matrices.hpp"
#include "support/mass_chain.hpp"

namespace microslip::static_attachment_test {
namespace {

using test::MassChains;

Eigen::SparseMatrix<double> loads_at(Eigen::Index rows, const std::vector<Eigen::Index>& at) {
  Eigen::SparseMatrix<double> loads(rows, static_cast<Eigen::Index>(at.size()));
  for (std::size_t j = 0; j < at.size(); ++j)
    loads.insert(at[j], static_cast<Eigen::Index>(j)) = 1.0;
  return loads;
}

/// Compliances between loads by modes and attachments.
Eigen::MatrixXd compliance(const NaturalModes& modes, const StaticAttachment& attached,
                           const Eigen::SparseMatrix<double>& loads) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(loads.cols(), loads.cols());
  const auto add = [&](const Eigen::VectorXd& shape, double eigenvalue) {
    const Eigen::VectorXd moved = loads.transpose() * shape;
    sum += moved * moved.transpose() / eigenvalue;
  };
  for (Eigen::Index i = static_cast<Eigen::Index>(modes.rigid_bodies); i < modes.eigenvalues.size();
       ++i) {
    add(modes.shapes.col(i), modes.eigenvalues(i));
  }
  for (Eigen::Index i = 0; i < attached.eigenvalues.size(); ++i) {
    add(attached.shapes.col(i), attached.eigenvalues(i));
  }
  return sum;
}

// Mass i of a chain has the compliance i/k; between i and j it is the smaller of both.
TEST(StaticAttachment, MakesTheComplianceExact) {
  for (const std::size_t masses : {std::size_t{40}, std::size_t{600}}) {
    const MassChains chain{.masses = masses};
    const VibratingSystem system = assemble_system({.matrices = chain.matrices()}).system;
    const NaturalModes modes = find_natural_modes(system, {.count = 4});
    const auto middle = static_cast<Eigen::Index>(masses / 2);
    const Eigen::Index last = static_cast<Eigen::Index>(masses) - 1;
    const auto loads = loads_at(system.size(), {middle, last});
    const StaticAttachment attached = attach_statically(system, modes, loads);
    ASSERT_EQ(attached.shapes.cols(), 2);
    const auto exact = [&](Eigen::Index i, Eigen::Index j) {
      return static_cast<double>(std::min(i, j) + 1) / chain.k;
    };
    const Eigen::MatrixXd found = compliance(modes, attached, loads);
    // The condition of K, some 1e6, times rounding.
    EXPECT_NEAR(found(0, 0), exact(middle, middle), 1e-10 * exact(middle, middle));
    EXPECT_NEAR(found(1, 1), exact(last, last), 1e-10 * exact(last, last));
    EXPECT_NEAR(found(0, 1), exact(middle, last), 1e-10 * exact(middle, last));
    EXPECT_NEAR(attached.compliance(1), exact(last, last), 1e-10 * exact(last, last));
    EXPECT_LT(attached.in_modes(1), exact(last, last));
    EXPECT_LT(attached.residuals.maxCoeff(), 1e-9);
    EXPECT_GT(attached.eigenvalues(0), modes.eigenvalues(3));
    Eigen::MatrixXd all(system.size(), 6);
    all << modes.shapes, attached.shapes;
    const Eigen::MatrixXd unit = all.transpose() * (system.mass * all);
    EXPECT_LT((unit - Eigen::MatrixXd::Identity(6, 6)).norm(), 1e-9);
    const Eigen::MatrixXd stiffness = all.transpose() * system.stiffness_times(all);
    const Eigen::MatrixXd off = stiffness - Eigen::MatrixXd(stiffness.diagonal().asDiagonal());
    EXPECT_LT(off.norm(), 1e-9 * stiffness.norm());
  }
}

// All modes of a free chain, a dense solution: its elastic compliance is Σ φφᵀ/ω² over those that
// strain.
TEST(StaticAttachment, OfAFreeStructureIsThatOfBalancedForces) {
  const MassChains chain{.masses = 30, .held = false};
  const VibratingSystem system = assemble_system({.matrices = chain.matrices()}).system;
  const NaturalModes all = find_natural_modes(system, {.count = 30});
  const NaturalModes few = find_natural_modes(system, {.count = 3});
  const auto loads = loads_at(system.size(), {4, 29});
  const StaticAttachment none = attach_statically(system, all, loads);
  EXPECT_EQ(none.shapes.cols(), 0);
  const Eigen::MatrixXd exact = compliance(all, none, loads);
  const StaticAttachment attached = attach_statically(system, few, loads);
  EXPECT_EQ(attached.shapes.cols(), 2);
  EXPECT_LT((compliance(few, attached, loads) - exact).norm(), 1e-11 * exact.norm());
}

// The tip of a cantilever clamped by springs of up to 1e16 N/m: L³/(3EI), and no more than that is
// in its modes. 200 elements are beyond the dense solution; cubic elements are exact at their
// nodes.
TEST(StaticAttachment, IsNotMoreThanTheWholeBesideStiffSprings) {
  for (const std::size_t elements : {std::size_t{20}, std::size_t{200}}) {
    for (const double p : {1e9, 1e12, 1e14, 1e16}) {
      const test::BeamMatrices beam{.elements = elements};
      StructuralMatrices matrices = beam.matrices();
      test::BeamMatrices::hold(matrices, 0, p);
      test::BeamMatrices::hold(matrices, 1, p);
      const VibratingSystem system = assemble_system({.matrices = matrices}).system;
      const NaturalModes modes = find_natural_modes(system, {.count = 5});
      const StaticAttachment attached =
          attach_statically(system, modes, loads_at(system.size(), {system.size() - 2}));
      const double exact = std::pow(beam.length, 3) / (3.0 * beam.bending);
      // The springs give 1/p + L²/p; rounding of EI/l³ at 200 elements is 1e-16 · 200⁴ of it.
      EXPECT_NEAR(attached.compliance(0), exact + 1.16 / p, 1e-6 * exact) << elements << " " << p;
      EXPECT_LT(attached.in_modes(0), attached.compliance(0) * (1.0 + 1e-9));
      EXPECT_GT(attached.in_modes(0), 0.999 * attached.compliance(0));
      EXPECT_LE(attached.residuals(0), 1e-9 + attached.rounding(0)) << elements << " " << p;
    }
  }
}

TEST(StaticAttachment, OfTwoEqualLoadsIsOneShape) {
  const MassChains chain{.masses = 30};
  const VibratingSystem system = assemble_system({.matrices = chain.matrices()}).system;
  const NaturalModes modes = find_natural_modes(system, {.count = 3});
  EXPECT_EQ(attach_statically(system, modes, loads_at(30, {12, 12})).shapes.cols(), 1);
}

// The last mass is 0: what its spring adds to the compliance moves no mass, and no shape can have
// it.
TEST(StaticAttachment, TellsWhatMovesWithoutMass) {
  const MassChains chain{.masses = 30};
  StructuralMatrices matrices = chain.matrices();
  matrices.mass.value.back() = 0.0;
  const VibratingSystem system = assemble_system({.matrices = matrices}).system;
  const NaturalModes modes = find_natural_modes(system, {.count = 3});
  const StaticAttachment attached = attach_statically(system, modes, loads_at(30, {29}));
  EXPECT_EQ(attached.shapes.cols(), 1);
  EXPECT_NEAR(attached.compliance(0), 30.0 / chain.k, 1e-10 * 30.0 / chain.k);
}

}  // namespace
}  // namespace microslip::static_attachment_test
