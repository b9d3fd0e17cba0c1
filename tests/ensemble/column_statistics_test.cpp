// SPDX-License-Identifier: MIT
#include "microslip/ensemble/column_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/identify/posterior/quantiles.hpp"

namespace microslip::column_statistics_test {
namespace {

using Rows = std::vector<std::vector<double>>;

RowPass pass_over(const Rows& rows) {
  return [&rows](const std::function<void(std::span<const double> row)>& take) {
    for (const std::vector<double>& row : rows) take(row);
  };
}

/// Values of every size and sign, with ties, zeros of both signs and some that are missing.
double any_value(RandomStream& random) {
  const double kind = random.uniform();
  if (kind < 0.05) return std::numeric_limits<double>::quiet_NaN();
  if (kind < 0.1) return 0.0;
  if (kind < 0.15) return -0.0;
  if (kind < 0.2) return 1.0;
  const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
  return sign * std::exp(40.0 * random.normal());
}

// Against sorting: the very same numbers, since both take order statistics and the same straight
// line between them. Moments to rounding.
TEST(ColumnStatistics, AreThoseOfSortedColumns) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomStream random(seed, 0);
    const std::size_t count = 1 + static_cast<std::size_t>(300.0 * random.uniform());
    const std::size_t columns = 1 + static_cast<std::size_t>(5.0 * random.uniform());
    const double confidence = 0.5 + 0.49 * random.uniform();
    Rows rows(count, std::vector<double>(columns));
    for (std::vector<double>& row : rows) {
      for (double& value : row) value = any_value(random);
    }
    const std::vector<ColumnStatistics> found =
        column_statistics(pass_over(rows), columns, confidence);
    for (std::size_t c = 0; c < columns; ++c) {
      std::vector<double> sorted;
      for (const std::vector<double>& row : rows) {
        if (!std::isnan(row[c])) sorted.push_back(row[c]);
      }
      ASSERT_EQ(found[c].count, sorted.size()) << "seed " << seed;
      if (sorted.empty()) {
        EXPECT_TRUE(std::isnan(found[c].median));
        continue;
      }
      const auto [lower, upper] = quantile_pair(sorted, confidence);
      EXPECT_EQ(found[c].lower, lower) << "seed " << seed;
      EXPECT_EQ(found[c].upper, upper) << "seed " << seed;
      EXPECT_EQ(found[c].median, quantile(sorted, 0.5)) << "seed " << seed;
      EXPECT_EQ(found[c].minimum, sorted.front());
      EXPECT_EQ(found[c].maximum, sorted.back());
    }
  }
}

// Of 1 … n mean (n + 1)/2 and variance n(n + 1)/12 in closed form; on a large offset, where a sum
// of squares would lose all digits.
TEST(ColumnStatistics, HaveTheMomentsOfAnArithmeticSequence) {
  constexpr std::size_t kCount = 1000;
  Rows rows;
  for (std::size_t i = 1; i <= kCount; ++i) rows.push_back({1e9 + static_cast<double>(i)});
  const ColumnStatistics found = column_statistics(pass_over(rows), 1, 0.9).front();
  EXPECT_EQ(found.mean, 1e9 + 500.5);
  EXPECT_NEAR(found.std, std::sqrt(1000.0 * 1001.0 / 12.0), 1e-9);
}

// More columns than are sought at once: the second lot are those of the second lot.
TEST(ColumnStatistics, TakeAnyNumberOfColumns) {
  constexpr std::size_t kColumns = 2100;
  Rows rows(3, std::vector<double>(kColumns));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < kColumns; ++c) {
      rows[r][c] = static_cast<double>(c) + static_cast<double>(r);
    }
  }
  const std::vector<ColumnStatistics> found = column_statistics(pass_over(rows), kColumns, 0.5);
  for (std::size_t c = 0; c < kColumns; ++c) {
    EXPECT_EQ(found[c].median, static_cast<double>(c) + 1.0);
    EXPECT_EQ(found[c].lower, static_cast<double>(c) + 0.5);
  }
}

}  // namespace
}  // namespace microslip::column_statistics_test
