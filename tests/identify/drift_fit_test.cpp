// SPDX-License-Identifier: MIT
// Drifts of sensors are added to records of sliders that are moved one by one. 4 s together.
#include "microslip/identify/records/drift_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "support/slider_records.hpp"

namespace microslip::drift_fit_test {
namespace {

using testing::kSliderAmplitude;
using testing::kSliderStiffness;
using testing::Motion;
using testing::Sliders;

constexpr double kDisplacementDrift = 0.1 * kSliderAmplitude;
constexpr double kForceDrift = 3.0;  // N; the records have forces of some 30 N

/// Even slip displacements up to 1.3 times the amplitude: a quarter of the joint never slips.
Sliders part_stuck() {
  return testing::sliders_of("part stuck", 0.0, [](double share) { return 1.3 * share; });
}

ForceRecord record_with(Motion motion, const SensorDrift& drift) {
  ForceRecord record =
      testing::record_of(part_stuck(), motion, {.path_noise = 5e-4, .force_noise = 2e-3});
  SensorDrift added = drift;
  for (double& c : added.displacement) c = -c;
  for (double& c : added.force) c = -c;
  return without_drift(std::move(record), added);
}

DriftFit fit_of(Motion motion, const SensorDrift& drift) {
  return fit_drift(RecordEvidence(record_with(motion, drift), PathStart::kVirgin), {}, {});
}

const std::vector<Motion> kMotions = {Motion::kSines, Motion::kTriangles,
                                      Motion::kGrowingTriangles};

}  // namespace

TEST(DriftFit, FindsNoneWhereNothingDrifts) {
  for (const Motion motion : kMotions) {
    const DriftFit fit = fit_of(motion, {});
    EXPECT_TRUE(fit.drift.displacement.empty()) << static_cast<int>(motion);
    EXPECT_TRUE(fit.drift.force.empty()) << static_cast<int>(motion);
  }
}

// Deviations are those of noise alone; the smooth density makes an error of a few per cent of a
// drift.
TEST(DriftFit, NamesTheDisplacementThatDrifts) {
  for (const Motion motion : kMotions) {
    const DriftFit fit = fit_of(motion, {.displacement = {kDisplacementDrift}});
    EXPECT_TRUE(fit.drift.force.empty()) << static_cast<int>(motion);
    EXPECT_NEAR(drift_at(fit.drift.displacement, 1.0), kDisplacementDrift,
                0.05 * kDisplacementDrift + 3.0 * fit.displacement_std)
        << static_cast<int>(motion);
  }
}

TEST(DriftFit, NamesTheForceThatDrifts) {
  for (const Motion motion : kMotions) {
    const DriftFit fit = fit_of(motion, {.force = {2.0 * kForceDrift, -kForceDrift}});
    EXPECT_TRUE(fit.drift.displacement.empty()) << static_cast<int>(motion);
    EXPECT_NEAR(drift_at(fit.drift.force, 1.0), kForceDrift,
                0.02 * kForceDrift + 3.0 * fit.force_std)
        << static_cast<int>(motion);
  }
}

TEST(DriftFit, LeavesTheJointAsItIs) {
  const ForceRecord drifting =
      record_with(Motion::kSines, {.displacement = {kDisplacementDrift}, .force = {2.0, -1.0}});
  const RecordEvidence evidence(drifting, PathStart::kVirgin);
  const DriftFit fit = fit_drift(evidence, {}, {});
  const RecordEvidence without(without_drift(drifting, fit.drift), PathStart::kVirgin);
  const RecordInversionResult found = invert_records({&without, 1}, {}, {.draws = 200});
  EXPECT_LE(found.stiffness.lower, kSliderStiffness);
  EXPECT_GE(found.stiffness.upper, kSliderStiffness);
  EXPECT_NEAR(found.stiffness.value, kSliderStiffness, 0.01 * kSliderStiffness);
  EXPECT_TRUE(std::ranges::none_of(found.records.front().verdicts, &RecordVerdict::broken));
}

TEST(SensorDriftOfARecord, IsZeroAtItsFirstSample) {
  EXPECT_EQ(drift_at({3.0, -1.0}, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(drift_at({3.0, -1.0}, 0.5), 1.25);
  const ForceRecord record = without_drift({{0.0, 1.0, 2.0}, {5.0, 6.0, 7.0}},
                                           {.displacement = {2.0}, .force = {0.0, 4.0}});
  EXPECT_EQ(record.displacement, (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_EQ(record.force, (std::vector<double>{5.0, 5.0, 3.0}));
}

}  // namespace microslip::drift_fit_test
