// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/predicted_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::predicted_curves_test {
namespace {

const std::string kEnsemble =
    "# predict\n"
    "group,output,unit,axis,at,count,mean,std,minimum,lower,median,upper,maximum\n"
    "a,displacement_lower,m,frequency [Hz],1,9,1,0,1,1,2,3,4\n"
    "a,displacement_lower,m,frequency [Hz],2,9,1,0,1,2,3,4,5\n"
    "a,displacement_upper,m,frequency [Hz],1,9,1,0,1,1.5,2.5,3.5,4\n"
    "a,displacement_upper,m,frequency [Hz],2,9,1,0,1,2.5,3.5,4.5,5\n"
    "b,area,1,,,0,,,,,,,\n";

// The two edges of a response become one curve with the outer edges; what no job has is not a
// number.
TEST(EnsembleCurves, AreReadFromTheirTable) {
  const std::vector<EnsembleCurve> curves = ensemble_curves({kEnsemble, "e.csv"});
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].output, "displacement");
  EXPECT_EQ(curves[0].unit, "m");
  EXPECT_EQ(curves[0].axis, "frequency");
  EXPECT_EQ(curves[0].axis_unit, "Hz");
  EXPECT_EQ(curves[0].at, (std::vector<double>{1, 2}));
  EXPECT_EQ(curves[0].median, (std::vector<double>{2, 3}));
  EXPECT_EQ(curves[0].band.lower, (std::vector<double>{1, 2}));
  EXPECT_EQ(curves[0].band.upper, (std::vector<double>{3.5, 4.5}));
  EXPECT_EQ(curves[1].group, "b");
  EXPECT_EQ(curves[1].axis, "");
  EXPECT_TRUE(std::isnan(curves[1].median.at(0)));
  EXPECT_EQ(curves[1].count, std::vector<double>{0});
}

TEST(EnsembleCurves, HaveNoneOfASweep) {
  EXPECT_TRUE(
      ensemble_curves({"group,output,unit,axis,at,k,value\na,area,1,,,1,0.5\n", "s.csv"}).empty());
}

TEST(EnsembleCurves, NameACellThatIsNoNumber) {
  std::string text = kEnsemble;
  text.replace(text.find(",2,3,4\n"), 7, ",x,3,4\n");
  const std::string refusal = test::message_of<FormatError>([&] {
    (void)ensemble_curves({text, "e.csv"});
  });
  EXPECT_NE(refusal.find("e.csv:3"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("a number, or nothing"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace microslip::predicted_curves_test
