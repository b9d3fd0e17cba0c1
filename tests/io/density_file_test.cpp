// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/density_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::density_file_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

std::string fault(const std::string& text) {
  return message_of<FormatError>([&] { return parse_density(text, "density.csv"); });
}

TEST(DensityFile, SurvivesTheRoundTrip) {
  const DensityTable density{.slip_force = {0.0, 0.1, 0.1, 1e3},
                             .density = {1.0 / 3.0, 5e-324, 0.0, 0.25},
                             .lower = {0.0, 0.0, 0.0, 0.2},
                             .upper = {1.0, 1.0, 0.0, 0.3}};
  const std::string text = density_table(density).str();
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "slip_force [N],density [1/N],lower [1/N],upper [1/N]");
  const DensityTable back = parse_density(text, "");
  EXPECT_EQ(back.slip_force, density.slip_force);
  EXPECT_EQ(back.density, density.density);
  EXPECT_EQ(back.lower, density.lower);
  EXPECT_EQ(back.upper, density.upper);
}

TEST(DensityFile, TheBandIsOptional) {
  const DensityTable density = parse_density("slip_force [kN],density [1/kN]\n1,2\n", "");
  EXPECT_EQ(density.slip_force, Numbers{1000.0});
  EXPECT_EQ(density.density, Numbers{0.002});
  EXPECT_TRUE(density.lower.empty());
  EXPECT_EQ(density_table(density).str(), "slip_force [N],density [1/N]\n1000,0.002\n");
}

TEST(DensityFileFault, ValuesThatBreakARule) {
  EXPECT_EQ(fault("slip_force [N],density [1/N]\n1,1\n3,1\n2,1\n"),
            "density.csv:4:1: expected a number not below that of the row before it in column 1 "
            "'slip_force [N]', found '2'. Sort the rows by slip force.");
  EXPECT_EQ(fault("slip_force [N],density [1/N]\n1,-1\n"),
            "density.csv:2:3: expected a number of 0 or more in column 2 'density [1/N]', found "
            "'-1'. A slip-force density cannot be negative.");
  EXPECT_NE(fault("slip_force [N],density [1/N]\n-1,1\n").find("density.csv:2:1"),
            std::string::npos);
  EXPECT_EQ(
      fault("slip_force [N],density [1/N],lower [1/N],upper [1/N]\n1,2,3,2\n"),
      "density.csv:2:7: expected a number not below that of 'lower' in column 4 'upper [1/N]', "
      "found '2'. Are the two swapped?");
  EXPECT_NE(
      fault("slip_force [N],density [1/N],lower [1/N]\n1,2,1\n").find("a column 'upper [1/N]'"),
      std::string::npos);
}

}  // namespace
}  // namespace microslip::density_file_test
