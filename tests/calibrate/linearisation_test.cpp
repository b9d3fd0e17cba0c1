// SPDX-License-Identifier: MIT
#include "microslip/calibrate/linearisation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "support/chain_structure.hpp"

namespace microslip::linearisation_test {
namespace {

constexpr double kLossStd = 0.005;
constexpr double kFrequencyStd = 1e-4;

JointedStructure two_joints() {
  const std::vector<testing::ChainJoint> joints{
      {"a", 1, 2, Joint(8e5, SlipDensity({UniformPart{0.0, 120.0, 0.5}}))},
      {"b", -1, 3, Joint(5e5, SlipDensity({UniformPart{0.0, 150.0, 0.4}}))}};
  return testing::chain_structure({4.0, 3.0, 3.0, 2.5}, {8e5, 6e5, 3e5, 5e5, 0.0}, joints, 0.003,
                                  {8e5, 5e5});
}

/// Three levels of each of two modes. Errors of their losses and frequencies do not matter here:
/// the test is about their weights.
ModalLevels some_levels(double displacement_std) {
  ModalLevels levels;
  for (const std::size_t mode : {std::size_t{0}, std::size_t{1}}) {
    for (const double displacement : {1e-5, 2e-5, 3e-5}) {
      levels.mode.push_back(mode);
      levels.displacement.push_back(displacement);
      levels.displacement_std.push_back(displacement_std * displacement);
      levels.frequency.push_back(40.0);
      levels.frequency_std.push_back(40.0 * kFrequencyStd);
      levels.dissipation.push_back(1e-5);
      levels.dissipation_std.push_back(kLossStd * 1e-5);
    }
  }
  return levels;
}

/// All levels, solved with two uniform densities.
class Solved {
 public:
  explicit Solved(const ModalLevels& levels, FrequencyUse frequency = FrequencyUse::kAbsolute)
      : levels_(levels),
        evidence_{.levels = levels_,
                  .frequency = frequency,
                  .fit_stiffness = false,
                  .stuck_shapes = false,
                  .forcing = Forcing::kExcitation,
                  .column = {CalibrationEvidence::kNone, CalibrationEvidence::kNone},
                  .loss_std_given = true,
                  .frequency_std_given = true},
        states_(two_joints(), "p1", {}, levels_, Execution::serial()),
        unknowns_({0, 1}, {JointUnknowns(8e5, 1e-4, 0.01, 0.0, 20),
                           JointUnknowns(5e5, 1e-4, 0.01, 0.0, 20)}),
        all_(levels_.size()) {
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    states_.solve(all_);
  }

  [[nodiscard]] LinearEvidence linear() const {
    return in_terms_of(
        evidence_, unknowns_,
        linearise(evidence_, unknowns_, states_, all_, Eigen::VectorXd::Ones(unknowns_.size())));
  }
  [[nodiscard]] LevelDeviations deviations(std::size_t level) const {
    return deviations_about(evidence_, unknowns_, states_, level);
  }
  /// Measured minus fitted loss, and measured over fitted frequency.
  [[nodiscard]] double loss_error(std::size_t level) const {
    const SteadyVibration& vibration = *states_.at(level);
    double error = measured_loss(levels_, level, vibration).value;
    for (const auto& joint : vibration.joints) error -= joint.dissipation;
    return error;
  }
  [[nodiscard]] double frequency_ratio(std::size_t level) const {
    return 1.0 + frequency_error(levels_, level, *states_.at(level));
  }
  [[nodiscard]] bool whole() const {
    for (const std::size_t i : all_) {
      if (!states_.at(i)) return false;
    }
    return true;
  }

 private:
  ModalLevels levels_;
  CalibrationEvidence evidence_;
  LevelStates states_;
  AllUnknowns unknowns_;
  std::vector<std::size_t> all_;
};

/// Each level so many times, with deviations that leave its mean as well known as before.
ModalLevels repeated(const ModalLevels& levels, int times) {
  ModalLevels all = levels;
  for (int i = 1; i < times; ++i) append(levels, all);
  for (double& deviation : all.dissipation_std) deviation *= std::sqrt(times);
  for (double& deviation : all.frequency_std) deviation *= std::sqrt(times);
  return all;
}

// Levels that were measured n times count as their mean does, the error of their displacement,
// which averaging does not reduce, included: to the tolerance of the resonances.
TEST(Linearisation, RepeatedLevelsCountAsTheirMean) {
  for (const double displacement_std : {0.0, 0.02}) {
    for (const FrequencyUse use : {FrequencyUse::kAbsolute, FrequencyUse::kChange}) {
      const ModalLevels levels = some_levels(displacement_std);
      const Solved once(levels, use);
      const Solved thrice(repeated(levels, 3), use);
      ASSERT_TRUE(once.whole() && thrice.whole());
      const LinearEvidence of_once = once.linear();
      const LinearEvidence of_thrice = thrice.linear();
      for (const RowKind kind : {RowKind::kLoss, RowKind::kFrequency}) {
        const Eigen::MatrixXd expected =
            of_once.of(kind).design.transpose() * of_once.of(kind).design;
        const Eigen::MatrixXd found =
            of_thrice.of(kind).design.transpose() * of_thrice.of(kind).design;
        EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
      }
    }
  }
}

/// The effect on a level of a displacement with an error of its standard deviation, by solving it
/// there.
void expect_share_of_displacement(const ModalLevels& levels) {
  constexpr double kError = 1e-3;  // of the displacement: the curvature is far less
  ModalLevels more = levels;
  ModalLevels less = levels;
  ModalLevels given = levels;
  ModalLevels exact = levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    more.displacement[i] *= 1.0 + kError;
    less.displacement[i] *= 1.0 - kError;
    given.displacement_std[i] = kError * levels.displacement[i];
    exact.displacement_std[i] = 0.0;
  }
  const Solved above(more);
  const Solved below(less);
  const Solved with(given);
  const Solved without(exact);
  ASSERT_TRUE(above.whole() && below.whole() && with.whole() && without.whole());
  const auto share = [](double all, double part) { return std::sqrt(all * all - part * part); };
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double loss = 0.5 * std::abs(above.loss_error(i) - below.loss_error(i));
    EXPECT_NEAR(share(with.deviations(i).loss, without.deviations(i).loss), loss, 0.01 * loss) << i;
    const double ratio = 0.5 * std::abs(above.frequency_ratio(i) - below.frequency_ratio(i)) /
                         with.frequency_ratio(i);
    EXPECT_NEAR(share(with.deviations(i).frequency, without.deviations(i).frequency), ratio,
                0.01 * ratio)
        << i;
  }
}

/// Information of all rows of a kind or of several.
Eigen::MatrixXd information(const LinearEvidence& linear) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(linear.size(), linear.size());
  for (const RowKind kind : kMeasuredKinds) {
    sum += linear.of(kind).design.transpose() * linear.of(kind).design;
  }
  return sum;
}

// Loss and frequency of a level have the error of its displacement in common: with c its effects,
// by resonances beside, their covariance is diag σ² + ccᵀ. To the 1 % of the derivatives.
TEST(Linearisation, TheErrorOfADisplacementCountsOnceForAllRowsOfALevel) {
  constexpr double kError = 1e-3;
  ModalLevels levels = some_levels(0.0);
  ModalLevels more = levels;
  ModalLevels less = levels;
  ModalLevels given = levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    more.displacement[i] *= 1.0 + kError;
    less.displacement[i] *= 1.0 - kError;
    // Effects of some deviations of loss and frequency.
    given.displacement_std[i] = 20.0 * kError * levels.displacement[i];
  }
  const Solved above(more);
  const Solved below(less);
  const Solved with(given);
  const Solved without(levels);
  ASSERT_TRUE(above.whole() && below.whole() && with.whole() && without.whole());
  const LinearEvidence plain = without.linear();
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(plain.size(), plain.size());
  double off_diagonal = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    Eigen::MatrixXd rows(2, plain.size());  // over their own deviations
    rows << plain.of(RowKind::kLoss).design.row(at), plain.of(RowKind::kFrequency).design.row(at);
    const LevelDeviations own = without.deviations(i);
    const Eigen::Vector2d effects(
        20.0 * 0.5 * (above.loss_error(i) - below.loss_error(i)) / own.loss,
        20.0 * 0.5 * (above.frequency_ratio(i) - below.frequency_ratio(i)) / own.frequency);
    off_diagonal = std::max(off_diagonal, std::abs(effects.prod()));
    const Eigen::RowVectorXd shared = effects.transpose() * rows;  // Sherman and Morrison
    expected +=
        rows.transpose() * rows - shared.transpose() * shared / (1.0 + effects.squaredNorm());
  }
  EXPECT_GT(off_diagonal, 1.0);
  EXPECT_LT((information(with.linear()) - expected).norm(), 0.02 * expected.norm());
}

// Against resonances at other displacements. The derivatives assume that higher harmonics follow,
// which leaves 1 %.
TEST(Linearisation, ErrorsOfTheDisplacementAreThoseOfResonancesBeside) {
  ModalLevels levels = some_levels(0.0);
  // Far below the shares, so that nothing is lost where squares are subtracted.
  levels.dissipation_std.assign(levels.size(), 1e-12);
  levels.frequency_std.assign(levels.size(), 1e-7);
  expect_share_of_displacement(levels);
  levels.damping_ratio.assign(levels.size(), 0.01);
  levels.damping_ratio_std.assign(levels.size(), 1e-9);
  levels.dissipation.clear();
  levels.dissipation_std.clear();
  expect_share_of_displacement(levels);
}

}  // namespace
}  // namespace microslip::linearisation_test
