// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/messages.hpp"

namespace microslip::comparison_table_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

VerifiedTests verified() {
  ComparedCurve along{.quantity = "displacement",
                      .dimension = kLength,
                      .axis = "frequency",
                      .axis_dimension = kFrequency,
                      .at = {10.0, 11.0, 12.0},
                      .measured = {1e-4, 2e-4, 3e-4},
                      .predicted = {1e-4, 2.5e-4, kNone},
                      .lower = {0.9e-4, 2.2e-4, 1e-4},
                      .upper = {1.1e-4, 2.8e-4, 4e-4},
                      .chance = 0.1};
  ComparedCurve whole{.quantity = "force_nrmse",
                      .dimension = kDimensionless,
                      .part = TestPart::kRecord,
                      .at = {kNone},
                      .measured = {kNone},
                      .predicted = {0.2}};
  ComparedTest one{.source = "a.mat:X(1)", .curves = {along}};
  one.taken = DrawsTaken{.options = {.count = 40}, .failures = {}};
  one.warnings = {{"few_inside", "few."}};
  ComparedTest two{.source = "b.csv", .kind = TestKind::kLoops, .curves = {whole}};
  return {.heading = "call",
          .tests = {one, two},
          .warnings = {{"of_file", "cut."}},
          .uncertain = "samples"};
}

TEST(ComparisonTable, HasVerdictsAndWhatItsReaderMustKnow) {
  const std::string text = comparison_table(verified());
  const CsvTable table(text, "c.csv");
  EXPECT_EQ(table.text("verdict"),
            (std::vector<std::string>{"inside", "outside", "not_found", ""}));
  EXPECT_EQ(table.text("unit"), (std::vector<std::string>{"m", "m", "m", "1"}));
  for (const char* part :
       {"# call", "# warning: of_file: cut.", "# warning: few_inside: a.mat:X(1): few.",
        "# confidence = 0.95", "# inside[a.mat:X(1): displacement] = 1",
        "# compared[a.mat:X(1): displacement] = 2", "# p_value[a.mat:X(1): displacement] = 0.1\n",
        "# draws = 40 of seed 1"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
}

TEST(ComparisonTable, ReadsBack) {
  const VerifiedTests made = verified();
  const std::vector<ComparedTest> read = compared_tests({comparison_table(made), "c.csv"});
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].source, "a.mat:X(1)");
  EXPECT_EQ(read[1].kind, TestKind::kLoops);
  const ComparedCurve& curve = read[0].curves.at(0);
  EXPECT_EQ(curve.at, made.tests[0].curves[0].at);
  EXPECT_EQ(curve.lower, made.tests[0].curves[0].lower);
  EXPECT_EQ(curve.axis, "frequency");
  EXPECT_TRUE(curve.axis_dimension == kFrequency);
  EXPECT_TRUE(curve.measured_std.empty());
  EXPECT_TRUE(std::isnan(curve.predicted[2]));
  EXPECT_FALSE(read[1].curves.at(0).has_band());
  EXPECT_EQ(read[1].curves.at(0).part, TestPart::kRecord);
}

TEST(ComparisonTable, SaysWhatIsWrongInATable) {
  const std::string header =
      "source,kind,part,quantity,unit,axis,at,measured,measured_std,predicted,lower,upper,"
      "verdict\n";
  const auto fault = [&](const std::string& row) {
    return test::message_or<FormatError>("none", [&] {
      return compared_tests({header + row, "c.csv"});
    });
  };
  test::expect_message(fault("a,jump,curve,force,N,frequency [Hz],1,1,,1,,,\n"), "c.csv:2:3");
  test::expect_message(fault("a,sweep,curve,force,furlong,frequency [Hz],1,1,,1,,,\n"), "a unit");
  test::expect_message(fault("a,sweep,curve,force,N,frequency,1,1,,1,,,\n"), "in brackets");
  test::expect_message(fault("a,sweep,curve,force,N,frequency [Hz],1,x,,1,,,\n"), "a number");
}

}  // namespace
}  // namespace microslip::comparison_table_test
