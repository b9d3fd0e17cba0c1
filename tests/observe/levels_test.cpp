// SPDX-License-Identifier: MIT
#include "microslip/observe/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::levels_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Levels three() {
  Levels levels;
  levels.amplitude = {1e-5, 2e-5, 3e-5};
  levels.dissipation = {0.0, 1e-4, 2e-4};
  return levels;
}

std::string message(const Levels& levels) {
  try {
    check_levels(levels);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Levels, Rules) {
  EXPECT_EQ(message(three()), "accepted");
  EXPECT_EQ(message({}), "number of levels = 0; must be at least 1");
  Levels levels = three();
  levels.amplitude[1] = 0.0;
  EXPECT_EQ(message(levels), "amplitude of level 2 = 0; must be positive and finite");
  levels.amplitude[1] = kNan;
  EXPECT_EQ(message(levels), "amplitude of level 2 = nan; must be positive and finite");
  levels = three();
  levels.dissipation[2] = -1e-9;
  EXPECT_EQ(message(levels), "dissipation of level 3 = -1e-09; must be 0 or more, and finite");
  levels.dissipation[2] = kInfinity;
  EXPECT_EQ(message(levels), "dissipation of level 3 = inf; must be 0 or more, and finite");
  levels.dissipation.pop_back();
  EXPECT_EQ(message(levels), "length of dissipation = 2; must be the number of levels, 3");
  levels = three();
  levels.secant_stiffness = {1e5, 1e5, 0.0};
  EXPECT_EQ(message(levels), "secant_stiffness of level 3 = 0; must be positive and finite");
  levels = three();
  levels.dissipation_std = {0.0, 1.0};
  EXPECT_EQ(message(levels), "length of dissipation_std = 2; must be the number of levels, 3");
  levels.dissipation_std = {0.0, 1.0, -1.0};
  EXPECT_EQ(message(levels), "dissipation_std of level 3 = -1; must be 0 or more, and finite");
  levels = three();
  levels.amplitude_std = {kNan, 0.0, 0.0};
  EXPECT_EQ(message(levels), "amplitude_std of level 1 = nan; must be 0 or more, and finite");
  levels = three();
  levels.frequency = {80.0, 0.0, 80.0};
  EXPECT_EQ(message(levels), "frequency of level 2 = 0; must be positive and finite");
  levels.frequency = {80.0, 80.0, 80.0};
  levels.frequency_std = {0.1};
  EXPECT_EQ(message(levels), "length of frequency_std = 1; must be the number of levels, 3");
}

TEST(Levels, SortsAllColumnsAlike) {
  Levels levels;
  levels.amplitude = {3.0, 1.0, 2.0};
  levels.dissipation = {0.3, 0.1, 0.2};
  levels.amplitude_std = {0.03, 0.01, 0.02};
  levels.dissipation_std = {0.003, 0.001, 0.002};
  levels.secant_stiffness = {30, 10, 20};
  levels.secant_stiffness_std = {0.3, 0.1, 0.2};
  levels.frequency = {83, 81, 82};
  levels.frequency_std = {0.3, 0.1, 0.2};
  const MergedLevels merged = sort_and_merge(levels);
  EXPECT_EQ(merged.levels.amplitude, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(merged.levels.dissipation, (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(merged.levels.amplitude_std, (std::vector<double>{0.01, 0.02, 0.03}));
  EXPECT_EQ(merged.levels.secant_stiffness, (std::vector<double>{10, 20, 30}));
  EXPECT_EQ(merged.levels.secant_stiffness_std, (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(merged.levels.frequency, (std::vector<double>{81, 82, 83}));
  EXPECT_EQ(merged.levels.frequency_std, (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(merged.count, (std::vector<std::size_t>{1, 1, 1}));
  EXPECT_EQ(merged.levels.dissipation_std, (std::vector<double>{0.001, 0.002, 0.003}));
}

// Weights 1/σ²: (1·4 + 3·1)/5 with the deviation 1/√(1/0.25 + 1/1); equal ones without σ.
TEST(Levels, MergesEqualAmplitudes) {
  Levels levels;
  levels.amplitude = {2.0, 1.0, 2.0};
  levels.dissipation = {1.0, 9.0, 3.0};
  const MergedLevels plain = sort_and_merge(levels);
  EXPECT_EQ(plain.levels.dissipation, (std::vector<double>{9.0, 2.0}));
  EXPECT_TRUE(plain.levels.dissipation_std.empty());
  EXPECT_EQ(plain.count, (std::vector<std::size_t>{1, 2}));

  levels.dissipation_std = {0.5, 1.0, 1.0};
  const MergedLevels weighted = sort_and_merge(levels);
  EXPECT_DOUBLE_EQ(weighted.levels.dissipation[1], 7.0 / 5.0);
  EXPECT_DOUBLE_EQ(weighted.levels.dissipation_std[1], 1.0 / std::sqrt(5.0));

  levels.dissipation_std = {0.0, 1.0, 1.0};  // a zero cannot weigh: the mean, σ = ½√(0 + 1)
  const MergedLevels zero = sort_and_merge(levels);
  EXPECT_DOUBLE_EQ(zero.levels.dissipation[1], 2.0);
  EXPECT_DOUBLE_EQ(zero.levels.dissipation_std[1], 0.5);
}

}  // namespace
}  // namespace microslip::levels_test
