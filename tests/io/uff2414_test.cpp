// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/mode_shapes.hpp"
#include "io/uff_support.hpp"
#include "microslip/io/uff/uff55.hpp"
#include "support/messages.hpp"
#include "support/replaced.hpp"

// Files by hand after the description of dataset 2414 ("Analysis Data") that the Structural
// Dynamics Research Laboratory, University of Cincinnati, publishes: records 1 to 13, then 14 and
// 15 a node.

namespace microslip::uff2414_test {
namespace {

using test::marker;
using test::read_shapes;

/// A normal mode of two nodes with rotations, load set 5, mode 7.
const std::string kNormal =
    "         1\n"
    "NORMAL MODE  7, DISPLACEMENTS                                                   \n"
    "         1\n"
    "first\nNONE\nNONE\nNONE\nlast\n"
    "         1         2         3         8         2         6\n"
    "         0         0         3         2         5         7         0         0\n"
    "         0         0\n"
    "  0.00000E+00  5.58000E+01  1.22921E+05  2.50000E+00  1.00000E-02  2.00000E-02\n"
    "  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n" +
    test::kTwoNodes;

/// λ = −3 + 4i rad/s, modal A = 1 − 2i.
const std::string kComplex =
    "         2\nCOMPLEX MODE\n         1\nNONE\nNONE\nNONE\nNONE\nNONE\n"
    "         1         3         2         8         5         3\n"
    "         0         0         0         0         1         2         0         0\n"
    "         0         0\n"
    "  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n"
    " -3.00000E+00  4.00000E+00  1.00000E+00 -2.00000E+00  0.00000E+00  0.00000E+00\n"
    "         1\n"
    "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00  5.00000E+00  6.00000E+00\n";

std::string dataset(const std::string& body) { return marker() + "  2414\n" + body + marker(); }

TEST(Uff2414, NormalModeWithRotations) {
  const UffModeShapes read = read_shapes(dataset(kNormal));
  EXPECT_TRUE(read.warnings.empty());
  ASSERT_EQ(read.shapes.size(), 1U);
  const UffModeShape& shape = read.shapes[0];
  EXPECT_EQ(shape.dataset, 2414);
  EXPECT_EQ(shape.id_lines[0], "first");
  EXPECT_EQ(shape.id_lines[4], "last");
  test::expect_mode_7(shape);
}

TEST(Uff2414, ComplexModeHasItsEigenvalueAndModalA) {
  for (const std::string analysis : {"         3", "         7"}) {  // first, second order
    const std::string body = test::replaced(kComplex, "         3         2         8",
                                            analysis + "         2         8");
    const UffModeShape shape = read_shapes(dataset(body)).shapes.at(0);
    test::expect_complex_mode(shape, {1.0, -2.0});
    EXPECT_EQ(shape.values, (std::vector<double>{1, 3, 5}));
    EXPECT_EQ(shape.imaginary, (std::vector<double>{2, 4, 6}));
  }
}

// Data types 4 and 6 say that the program had doubles. Wider fields are recognised by the blanks.
TEST(Uff2414, OfDoublePrecision) {
  std::string body = test::replaced(kComplex, "         5         3\n", "         6         3\n");
  body = test::replaced(
      body, "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00  5.00000E+00  6.00000E+00\n",
      "   1.2345678901234567E+00   2.0000000000000000E+00   3.0000000000000000E+00\n"
      "   4.0000000000000000E+00   5.0000000000000000E+00   6.0000000000000000E+00\n");
  const UffModeShape shape = read_shapes(dataset(body)).shapes.at(0);
  EXPECT_EQ(shape.values, (std::vector<double>{1.2345678901234567, 3, 5}));
  EXPECT_EQ(shape.imaginary, (std::vector<double>{2, 4, 6}));
}

TEST(Uff2414, TakesTheUnitsBeforeIt) {
  const std::string units =
      "    -1\n   164\n         5MM: mm_milli-newton          2\n"
      "  1.00000000000000000D+03  1.00000000000000000D+03  1.00000000000000000D+00\n"
      "  2.73149999999999977D+02\n    -1\n";
  const UffModeShape shape = read_shapes(units + dataset(kNormal)).shapes.at(0);
  EXPECT_DOUBLE_EQ(shape.length_unit.value(), 1e-3);
  EXPECT_DOUBLE_EQ(shape.force_unit.value(), 1e-3);
}

TEST(Uff2414, OfOtherAnalysesIsNoMode) {
  const auto analysis_of = [](const std::string& analysis) {
    return read_shapes(dataset(test::replaced(kNormal, "         1         2         3",
                                              "         1" + analysis + "         3")))
        .shapes.at(0)
        .analysis;
  };
  EXPECT_EQ(analysis_of("         5"), UffAnalysis::kFrequencyResponse);
  EXPECT_EQ(analysis_of("         1"), UffAnalysis::kOther);
}

// A program that writes shapes writes their stresses, too: these are left out, and named.
TEST(Uff2414, LeavesOutWhatIsNoMotionOfNodes) {
  const std::string stress =
      test::replaced(kNormal, "         3         8", "         4         2");
  const std::string elements =
      test::replaced(kNormal, "\n         1\nfirst", "\n         2\nfirst");
  const UffModeShapes read =
      read_shapes(dataset(stress) + dataset(kNormal) + dataset(elements) + dataset(kComplex));
  ASSERT_EQ(read.shapes.size(), 2U);
  EXPECT_EQ(read.shapes[1].analysis, UffAnalysis::kComplexMode);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "uff_no_motion");
  test::expect_message(read.warnings[0].text, "dataset 1 (2414) has result type 2 at nodes");
  test::expect_message(read_shapes(dataset(elements)).warnings.at(0).text,
                       "result type 8 on elements, no motion of nodes");
}

TEST(Uff2414, RefusesByName) {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    const std::string body = test::replaced(kNormal, from, to);
    test::expect_message(
        test::message_or<FormatError>("", [&] { return read_shapes(dataset(body)).shapes.size(); }),
        part);
  };
  refused("         2         6\n", "         1         6\n", "the data type 2 or 4 (real)");
  refused("         3         8", "         4         8", "the data characteristic 2 or 3");
  refused("         2         6\n", "         2         0\n", "values of a node above 0, found 0");
  refused("  5.58000E+01", "          NaN", "finite");
  refused("        20\n", "      twenty\n", "a node number");
  refused("  0.00000E+00  0.00000E+00  7.00000E+00\n", "\n", "values of a node");
}

}  // namespace
}  // namespace microslip::uff2414_test
