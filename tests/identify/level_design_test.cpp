// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/level_design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "support/messages.hpp"

namespace microslip::level_design_test {
namespace {

constexpr std::size_t kDraws = 60;
constexpr std::size_t kCandidates = 5;
constexpr std::size_t kNumbers = 3;

/// Draws of correlated numbers: sums of four independent ones.
struct Case {
  FurtherLevels further;
  DesignTarget target;
};

Case random_case(bool with_secant) {
  RandomStream random(11, 0);
  const std::size_t columns = 2 * kCandidates + kNumbers;
  const Eigen::MatrixXd loads = Eigen::MatrixXd::NullaryExpr(4, static_cast<Eigen::Index>(columns),
                                                             [&] { return random.normal(); });
  Case all;
  all.further.dissipation.columns = kCandidates;
  if (with_secant) all.further.secant_stiffness.columns = kCandidates;
  all.target.draws.columns = kNumbers;
  all.target.weight = {0.5, 0.3, 0.2};
  for (std::size_t i = 0; i < kDraws; ++i) {
    const Eigen::Vector4d z = Eigen::Vector4d::NullaryExpr([&] { return random.normal(); });
    const Eigen::VectorXd row = loads.transpose() * z;
    const auto append = [&](std::vector<double>& values, std::size_t from, std::size_t count) {
      values.insert(values.end(), row.data() + from, row.data() + from + count);
    };
    append(all.further.dissipation.values, 0, kCandidates);
    if (with_secant) append(all.further.secant_stiffness.values, kCandidates, kCandidates);
    append(all.target.draws.values, 2 * kCandidates, kNumbers);
  }
  for (std::size_t c = 0; c < kCandidates; ++c) {
    all.further.amplitude.push_back(1.0 + static_cast<double>(c));
    all.further.dissipation_std.push_back(1.0 + 0.2 * static_cast<double>(c));
    if (with_secant) all.further.secant_stiffness_std.push_back(2.0 - 0.2 * static_cast<double>(c));
  }
  if (with_secant) all.further.secant_offset_std = 0.7;
  return all;
}

Eigen::MatrixXd centred(const PlainMatrix& m) {
  Eigen::MatrixXd all =
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          m.values.data(), static_cast<Eigen::Index>(m.rows()),
          static_cast<Eigen::Index>(m.columns));
  all.rowwise() -= all.colwise().mean().eval();
  return all;
}

/// S by the regression of the target on all measurements of a set at once: another method than one
/// level after the other, with noise of σ/√(1/noise) each.
double deviation_with(const Case& all, const std::vector<std::size_t>& set, double noise = 1.0) {
  const double n = static_cast<double>(kDraws - 1);
  const Eigen::MatrixXd d = centred(all.further.dissipation);
  const Eigen::MatrixXd t = centred(all.target.draws);
  const bool secant = !all.further.secant_stiffness.values.empty();
  const Eigen::Index kinds = secant ? 2 : 1;
  const auto rows = static_cast<Eigen::Index>(set.size()) * kinds;
  Eigen::MatrixXd measured(d.rows(), rows);
  Eigen::MatrixXd error = Eigen::MatrixXd::Zero(rows, rows);
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(set.size()); ++i) {
    const std::size_t c = set[static_cast<std::size_t>(i)];
    measured.col(kinds * i) = d.col(static_cast<Eigen::Index>(c));
    error(kinds * i, kinds * i) = noise * std::pow(all.further.dissipation_std[c], 2);
    if (!secant) continue;
    measured.col(2 * i + 1) =
        centred(all.further.secant_stiffness).col(static_cast<Eigen::Index>(c));
    for (Eigen::Index j = 1; j < rows; j += 2) {
      error(2 * i + 1, j) += std::pow(all.further.secant_offset_std, 2);
    }
    error(2 * i + 1, 2 * i + 1) += noise * std::pow(all.further.secant_stiffness_std[c], 2);
  }
  Eigen::VectorXd left = (t.transpose() * t / n).diagonal();
  if (rows > 0) {
    const Eigen::MatrixXd own = measured.transpose() * measured / n + error;
    const Eigen::MatrixXd with = measured.transpose() * t / n;
    left -= (with.transpose() * own.ldlt().solve(with)).diagonal();
  }
  double sum = 0.0;
  for (std::size_t j = 0; j < kNumbers; ++j) {
    sum += all.target.weight[j] * std::sqrt(left(static_cast<Eigen::Index>(j)));
  }
  return sum;
}

std::vector<std::size_t> set_of(const LevelDesign& design, std::size_t ranks) {
  std::vector<std::size_t> set;
  for (std::size_t i = 0; i < ranks; ++i) {
    set.insert(set.end(), design.levels[i].repeats, design.levels[i].candidate);
  }
  return set;
}

/// The least S of all sets of so many candidates from `from` on.
double least_of_all(const Case& all, std::vector<std::size_t>& set, std::size_t count,
                    std::size_t from) {
  if (set.size() == count) return deviation_with(all, set);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = from; c < kCandidates; ++c) {
    set.push_back(c);
    least = std::min(least, least_of_all(all, set, count, c));
    set.pop_back();
  }
  return least;
}

// 1e-9: rounding of some hundred changes of the covariance, taken back and forth.
TEST(LevelDesign, ExpectsWhatTheRegressionOnAllLevelsAtOnceLeaves) {
  for (const bool secant : {false, true}) {
    const Case all = random_case(secant);
    const LevelDesign design = design_levels(all.further, all.target, 7);
    EXPECT_NEAR(design.now, deviation_with(all, {}), 1e-9);
    std::size_t levels = 0;
    for (std::size_t i = 0; i < design.levels.size(); ++i) {
      EXPECT_NEAR(design.levels[i].before, deviation_with(all, set_of(design, i)), 1e-9);
      EXPECT_NEAR(design.levels[i].after, deviation_with(all, set_of(design, i + 1)), 1e-9);
      levels += design.levels[i].repeats;
    }
    EXPECT_EQ(levels, 7U);
    EXPECT_NEAR(design.after, design.levels.back().after, 1e-12);
    std::vector<std::size_t> more = set_of(design, design.levels.size());
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < kCandidates; ++c) {
      more.push_back(c);
      best = std::min(best, deviation_with(all, more));
      more.pop_back();
    }
    EXPECT_NEAR(design.one_more, best, 1e-9);
  }
}

TEST(LevelDesign, FindsTheBestOfAllSets) {
  for (const bool secant : {false, true}) {
    const Case all = random_case(secant);
    for (const std::size_t count : {1U, 2U, 3U, 4U}) {
      std::vector<std::size_t> set;
      EXPECT_NEAR(design_levels(all.further, all.target, count).after,
                  least_of_all(all, set, count, 0), 1e-9)
          << count;
    }
  }
}

// Endless repeats are one level without noise.
TEST(LevelDesign, TellsWhatMoreOfTheSameComesTo) {
  for (const bool secant : {false, true}) {
    const Case all = random_case(secant);
    const LevelDesign design = design_levels(all.further, all.target, 1);
    EXPECT_NEAR(design.levels[0].endless, deviation_with(all, {design.levels[0].candidate}, 0.0),
                1e-9);
    EXPECT_LT(design.levels[0].endless, design.levels[0].after);
  }
}

// Where only one candidate measures the target, that one is chosen.
TEST(LevelDesign, GoesWhereTheTargetIs) {
  Case all = random_case(false);
  all.target.draws.columns = 1;
  all.target.weight = {1.0};
  for (std::size_t c = 0; c < kCandidates; ++c) {
    all.target.draws.values.clear();
    for (std::size_t i = 0; i < kDraws; ++i) {
      all.target.draws.values.push_back(all.further.dissipation.values[i * kCandidates + c]);
    }
    FurtherLevels exact = all.further;
    exact.dissipation_std.assign(kCandidates, 1e-3);
    const LevelDesign design = design_levels(exact, all.target, 1);
    EXPECT_EQ(design.levels[0].candidate, c);
    EXPECT_NEAR(design.after, 1e-3, 1e-6);
  }
}

TEST(LevelDesign, RefusesWhatIsNoDesign) {
  const Case good = random_case(true);
  const auto fault = [&](const auto& spoil, std::size_t count = 1) {
    Case all = good;
    spoil(all);
    return test::message_or<InputError>(
        "no error", [&] { (void)design_levels(all.further, all.target, count); });
  };
  const auto nothing = [](Case&) {};
  EXPECT_EQ(fault(nothing), "no error");
  EXPECT_NE(fault(nothing, 0).find("number of further levels = 0"), std::string::npos);
  EXPECT_NE(fault(nothing, kMostDesigned + 1).find("must be 1 to 1000"), std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.further.amplitude.clear(); }).find("amplitudes to choose"),
            std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.further.dissipation_std[1] = 0.0; }).find("must be above 0"),
            std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.further.dissipation_std.pop_back(); }).find("must be 5"),
            std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.target.weight.pop_back(); }).find("weights of the target"),
            std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.target.draws.values.resize(3); }).find("draws of the target"),
            std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.further.secant_stiffness_std[0] = -1.0; }).find("secant"),
            std::string::npos);
  EXPECT_NE(fault([](Case& c) { c.further.dissipation.values[0] = std::nan(""); }).find("finite"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::level_design_test
