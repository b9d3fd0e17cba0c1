// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/path_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::path_file_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

TEST(PathFile, ReadsDisplacementAndNormalLoad) {
  const DisplacementPath path =
      parse_path("time [s],displacement [um],normal_load [%]\n0,0,100\n1,-3,0\n", "path.csv");
  EXPECT_EQ(path.displacement, (Numbers{0.0, -3e-6}));
  EXPECT_EQ(path.normal_load, (Numbers{1.0, 0.0}));
  EXPECT_TRUE(parse_path("displacement [m]\n1\n", "").normal_load.empty());
}

TEST(PathFileFault, NegativeNormalLoad) {
  EXPECT_EQ(message_of<FormatError>([] {
              return parse_path("displacement [m],normal_load [1]\n1,1\n1,-0.5\n", "path.csv");
            }),
            "path.csv:3:3: expected a number of 0 or more in column 2 'normal_load [1]', found "
            "'-0.5'. It is the normal load over its nominal value; 0 means no contact.");
}

TEST(PathFileFault, NormalLoadInNewton) {
  EXPECT_NE(message_of<FormatError>([] {
              return parse_path("displacement [m],normal_load [N]\n1,1\n", "path.csv");
            }).find("expected a unit of ratio for column 2, found 'N', a unit of force"),
            std::string::npos);
}

TEST(PathFile, LoopsAddTheForce) {
  const Numbers force{5.0, -5.0};
  EXPECT_EQ(loop_table({.displacement = {1.0, 2.0}, .normal_load = {}}, force).str(),
            "displacement [m],force [N]\n1,5\n2,-5\n");
  EXPECT_EQ(loop_table({.displacement = {1.0, 2.0}, .normal_load = {1.0, 0.5}}, force).str(),
            "displacement [m],normal_load [1],force [N]\n1,1,5\n2,0.5,-5\n");
  EXPECT_THROW(loop_table({.displacement = {1.0}, .normal_load = {}}, force), InputError);
}

}  // namespace
}  // namespace microslip::path_file_test
