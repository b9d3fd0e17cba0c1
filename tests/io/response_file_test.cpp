// SPDX-License-Identifier: MIT
#include "microslip/documents/response/response_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/structures.hpp"

namespace microslip::response_file_test {
namespace {

constexpr double pi = std::numbers::pi;

const std::vector<double> kResponses{0.01, 0.1, 0.5, 1.0, 2.0, 5.0};

HarmonicBalance one_mass() {
  return HarmonicBalance(testing::one_mass(testing::iwan_joint()), {"mass"});
}

ResponseCurve sample_curve() { return one_mass().frequency_response(0.1, 0.8, 1.1); }

template <typename Value>
void expect_column(const CsvTable& table, std::string_view name, const Dimension& dimension,
                   const ResponseCurve& curve, Value value) {
  const std::vector<double> column = table.numbers(name, dimension);
  ASSERT_EQ(column.size(), curve.points.size());
  for (std::size_t i = 0; i < column.size(); ++i) {
    EXPECT_EQ(column[i], value(curve.points[i])) << name << " " << i;
  }
}

void expect_energies(const CsvTable& table, const ResponseCurve& curve) {
  const auto loss = [](const auto& point) { return point.joints[0].dissipation; };
  expect_column(table, "dissipation", kEnergy, curve, loss);
  expect_column(table, "dissipation_joint", kEnergy, curve, loss);
  expect_column(table, "linear_dissipation", kEnergy, curve,
                [](const auto& point) { return point.linear_dissipation; });
  expect_column(table, "amplitude_joint", kLength, curve,
                [](const auto& point) { return point.joints[0].amplitude; });
  expect_column(table, "reversals_joint", kDimensionless, curve,
                [](const auto& point) { return double(point.joints[0].reversals); });
  expect_column(table, "energy_imbalance", kDimensionless, curve,
                [](const auto& point) { return point.energy_imbalance; });
}

TEST(ResponseTable, HoldsTheCurve) {
  const ResponseCurve curve = sample_curve();
  const std::string text = response_table(one_mass(), curve).str();
  EXPECT_EQ(file_kind(text), kResponseKind);
  const CsvTable table(text, "frf.csv");
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  ASSERT_EQ(frequency.size(), curve.points.size());
  for (std::size_t i = 0; i < frequency.size(); ++i) {  // to 15 digits
    EXPECT_NEAR(frequency[i] / curve.points[i].frequency(), 1.0, 6e-15) << i;
  }
  expect_column(table, "force", kForce, curve, [](const auto&) { return 0.1; });
  expect_column(table, "displacement", kLength, curve,
                [](const auto& point) { return point.response; });
  expect_column(table, "phase", kAngle, curve, [](const auto& p) { return p.phase_lag; });
  expect_energies(table, curve);
}

// 30 Hz is 30 in the table, not 29.999999999999996: whole numbers, decimal fractions, powers of
// ten, and numbers of 15 random digits.
TEST(ResponseTable, HoldsAFrequencyByItsNumber) {
  ResponseCurve curve = sample_curve();
  curve.peaks.clear();
  curve.peak_points.clear();
  std::vector<double> asked;
  for (int i = 1; i <= 20000; ++i) {
    asked.push_back(i);
    asked.push_back(i / 100.0);
  }
  RandomStream random(1, 1);
  for (int i = 0; i < 20000; ++i) {
    const auto digits = static_cast<std::int64_t>(1e14 + 9e14 * random.uniform());
    const auto exponent = static_cast<int>(18.0 * random.uniform()) - 23;  // up to 1e9 Hz
    asked.push_back(std::stod(std::to_string(digits) + "e" + std::to_string(exponent)));
  }
  const SteadyVibration one = curve.points.front();
  curve.points.assign(asked.size(), one);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    curve.points[i].angular_frequency = 2.0 * pi * asked[i];
  }
  const CsvTable table(response_table(one_mass(), curve).str(), "frf.csv");
  const std::vector<double> found = table.numbers("frequency", kFrequency);
  ASSERT_EQ(found.size(), asked.size());
  std::size_t others = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) others += found[i] == asked[i] ? 0 : 1;
  EXPECT_EQ(others, 0U);
}

TEST(ResponseTable, TellsHowItEndedAndWhereThePeaksAre) {
  ResponseCurve curve = sample_curve();
  curve.turning_points = {3};
  curve.points[3].angular_frequency = 2.0 * pi * 0.125;
  const std::string text = response_table(one_mass(), curve, "made by a test").str();
  EXPECT_TRUE(
      text.starts_with("# made by a test\n# harmonic balance, continuation: converged: "
                       "reached the end of the range\n# peak: frequency 0.14608"))
      << text.substr(0, 400);
  EXPECT_NE(text.find("\n# turns back: frequency 0.125 Hz, force 0.1 N, displacement "),
            std::string::npos);
  curve.warnings = {{"one", "of one\nthing"}, {"two", "of another"}};
  EXPECT_NE(response_table(one_mass(), curve)
                .str()
                .find("\n# warning: one: of one thing\n# warning: two: of another\n"),
            std::string::npos);
  curve.summary.stop = Stop::kNoProgress;
  curve.summary.reason = "a test\nsays so";
  EXPECT_NE(response_table(one_mass(), curve)
                .str()
                .find("# harmonic balance, continuation: NOT CONVERGED: a test"),
            std::string::npos);
}

TEST(ResponseTable, LeavesOutWhatIsNoNumber) {
  ResponseCurve curve = sample_curve();
  const std::size_t size = curve.points.size();
  curve.points.back().energy_imbalance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CsvTable(response_table(one_mass(), curve).str(), "t").numbers("force", kForce).size(),
            size - 1);
  curve.points.clear();
  EXPECT_EQ(test::message_of<InputError>([&] { return response_table(one_mass(), curve); }),
            "points of the curve = 0; must be 1 or more, with finite values, in a table to be "
            "written");
}

// Without damping no energy comes or goes: 0/0 of the input is missing.
TEST(ResponseTable, TakesAStructureWithoutLoss) {
  ResponseCurve curve = sample_curve();
  curve.points[1].input_energy = 0.0;
  curve.points[1].energy_imbalance = std::numeric_limits<double>::quiet_NaN();
  const CsvTable table(response_table(one_mass(), curve).str(), "frf.csv");
  EXPECT_EQ(table.numbers("frequency", kFrequency).size(), curve.points.size());
  EXPECT_EQ(table.numbers("energy_imbalance", kDimensionless)[1], 0.0);
}

TEST(BackboneTable, HoldsTheCurve) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  const ResponseCurve curve = balance.backbone(kResponses);
  const std::string text = backbone_table(one_mass(), curve, "made by a test").str();
  EXPECT_TRUE(
      text.starts_with("# made by a test\n# harmonic balance, backbone: converged: all "
                       "responses reached\n"))
      << text.substr(0, 400);
  EXPECT_EQ(file_kind(text), kBackboneKind);
  const CsvTable table(text, "backbone.csv");
  expect_column(table, "displacement", kLength, curve,
                [](const auto& point) { return point.response; });
  expect_column(table, "force", kForce, curve,
                [](const auto& point) { return point.force_amplitude; });
  expect_column(table, "frequency", kFrequency, curve,
                [](const auto& point) { return point.angular_frequency / (2.0 * pi); });
  expect_column(table, "damping_ratio", kDimensionless, curve,
                [](const auto& point) { return point.damping_ratio(); });
  expect_energies(table, curve);
}

}  // namespace
}  // namespace microslip::response_file_test
