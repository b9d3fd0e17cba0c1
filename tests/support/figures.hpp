// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "support/effort.hpp"
#include "validation/bounds.hpp"

/// @file
/// A figure that a test measures, for docs/validation.md: kept as a property of the test, which
/// `--gtest_output=json` writes and scripts/update_validation reads. It is checked against its
/// bounds in tests/validation/figures.toml.

namespace microslip::test {

/// Of a figure of the test that runs.
inline validation::Bounds figure_bounds(const std::string& name) {
  const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
  return validation::bounds_of(
      fmt::format("{}.{}.{}", MICROSLIP_TEST_FOLDER, test.test_suite_name(), test.name()), name);
}

inline void expect_at_most(const std::string& name, double value) {
  const auto bound = figure_bounds(name).at_most;
  if (bound) {
    EXPECT_LE(value, *bound) << name << " in figures.toml";
  }
}

inline void expect_at_least(const std::string& name, double value) {
  const auto bound = figure_bounds(name).at_least;
  if (bound) {
    EXPECT_GE(value, *bound) << name << " in figures.toml";
  }
}

/// One figure of the test that runs, by its name with unit, `name [unit]`. Given again, the one of
/// both is kept that `keep(a, b)` returns; one that is not a number is kept whatever comes.
template <class Keep>
void record_figure(const std::string& name, double value, const Keep& keep) {
  static std::map<std::pair<const void*, std::string>, double> figures;
  const void* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto [place, first] = figures.try_emplace({test, name}, value);
  double& figure = place->second;
  if (!first && !std::isnan(figure)) figure = std::isnan(value) ? value : keep(figure, value);
  ::testing::Test::RecordProperty(name, fmt::format("{}", figure));
}

/// The largest of the values given in the test.
inline void record_largest(const std::string& name, double value) {
  record_figure(name, value, [](double a, double b) { return std::max(a, b); });
  expect_at_most(name, value);
}

/// The smallest of the values given in the test.
inline void record_smallest(const std::string& name, double value) {
  record_figure(name, value, [](double a, double b) { return std::min(a, b); });
  expect_at_least(name, value);
}

/// The largest of a statistic of draws_of(): no figure but of all of them.
inline void record_largest_of_draws(const std::string& name, double value) {
  if (in_studies()) record_largest(name, value);
}

/// The smallest of it.
inline void record_smallest_of_draws(const std::string& name, double value) {
  if (in_studies()) record_smallest(name, value);
}

/// The sum of the values given in the test.
inline void record_sum(const std::string& name, double value) {
  record_figure(name, value, [](double a, double b) { return a + b; });
}

/// The largest |value/expected − 1| as `name [1]`.
inline void record_deviation(const std::string& name, double value, double expected) {
  record_largest(name + " [1]", std::abs(value / expected - 1.0));
}

}  // namespace microslip::test
