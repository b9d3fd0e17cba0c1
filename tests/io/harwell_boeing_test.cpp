// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/harwell_boeing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/matrices/coordinate_list.hpp"
#include "support/replaced.hpp"

namespace microslip::harwell_boeing_test {
namespace {

using test::message_of;
using test::replaced;
using Indices = std::vector<std::int32_t>;
using Numbers = std::vector<double>;

// [4 -1 0; -1 5 -2; 0 -2 6]: lower triangle, in the forms of Fortran that programs write, with a
// right-hand side behind it (Duff, Grimes, Lewis 1992, chapter 2).
const std::string kTriangle =
    "Stiffness                                                               KEY     \n"
    "             5             1             1             2             1\n"
    "RSA                        3             3             5             0\n"
    "(4I4)           (16I5)          (1P,3D16.8)         (1P,3D16.8)         \n"
    "F                          1             0\n"
    "   1   3   5   6\n"
    "    1    2    2    3    3\n"
    "  4.00000000D+00 -1.00000000D+00  5.00000000D+00\n"
    " -2.00000000D+00  6.00000000D+00\n"
    "  1.00000000D+00  0.00000000D+00  0.00000000D+00\n";

// The same, whole, one value a line as Ansys' HBMAT has it.
const std::string kWhole =
    "Written by a solver                                                     KEY     \r\n"
    "            13             4             7             7             0\r\n"
    "RUA                        3             3             7             0\r\n"
    "(1I14)          (1I14)          (1(1PE25.15))       \r\n"
    "             1\r\n             3\r\n             6\r\n             8\r\n"
    "             1\r\n             2\r\n             1\r\n             2\r\n             3\r\n"
    "             2\r\n             3\r\n"
    "    4.000000000000000E+00\r\n   -1.000000000000000E+00\r\n   -1.000000000000000E+00\r\n"
    "    5.000000000000000E+00\r\n   -2.000000000000000E+00\r\n   -2.000000000000000E+00\r\n"
    "    6.000000000000000E+00\r\n";

void expect_matrix(const SymmetricEntries& matrix) {
  EXPECT_EQ(matrix.size, 3U);
  EXPECT_EQ(matrix.row, (Indices{0, 1, 1, 2, 2}));
  EXPECT_EQ(matrix.column, (Indices{0, 0, 1, 1, 2}));
  EXPECT_EQ(matrix.value, (Numbers{4.0, -1.0, 5.0, -2.0, 6.0}));
}

TEST(HarwellBoeing, IsRead) {
  for (const std::string& text : {kTriangle, kWhole}) {
    EXPECT_TRUE(is_harwell_boeing(text.substr(0, 400)));
    expect_matrix(parse_harwell_boeing(text, "k.hb"));
  }
  EXPECT_FALSE(is_harwell_boeing("%%MatrixMarket matrix coordinate real symmetric\n1 1 1\n"));
  EXPECT_FALSE(is_harwell_boeing(""));
}

// scipy.io.hb_write() of SciPy 1.10.1 names fields of 25 columns in its header and writes 24;
// others leave no blank between numbers.
TEST(HarwellBoeing, IsReadWhereFieldsAreNarrowerOrTouch) {
  const std::string narrower =
      replaced(replaced(kTriangle, "(1P,3D16.8)         (1P", "(1P,3D17.8)         (1P"),
               " -2.00000000D+00 ", "-2.00000000D+00 ");
  expect_matrix(parse_harwell_boeing(narrower, "k.hb"));
  const std::string touching =
      replaced(replaced(kTriangle, "(1P,3D16.8)         (1P", "(1P,3D15.8)         (1P"),
               "  4.00000000D+00 -1.00000000D+00  5.00000000D+00\n -2.00000000D+00  6.00000000D+00",
               " 4.00000000D+00-1.00000000D+00 5.00000000D+00\n-2.00000000D+00 6.00000000D+00");
  expect_matrix(parse_harwell_boeing(touching, "k.hb"));
}

// scipy.io.hb_write() of SciPy 1.10.1 of numpy.float32: 14 columns for E15.7, no blank before a
// sign; and of integers.
TEST(HarwellBoeing, OfSinglePrecisionAndOfIntegersIsRead) {
  const std::string sizes =
      "Default title                                                           0       \n"
      "             4             1             1             2\n";
  const std::string lists = " 1 3 6 8\n 1 2 1 2 3 2 3\n";
  const std::string single =
      sizes + "RUA                        3             3             7             0\n" +
      "(40I2)          (40I2)          (5E15.7)            \n" + lists +
      " 4.0000000E+00-1.0000000E+00-1.0000000E+00 5.0000000E+00-2.0000000E+00\n"
      "-2.0000000E+00 6.0000000E+00\n";
  expect_matrix(parse_harwell_boeing(single, "k.hb"));
  const std::string integers =
      sizes + "IUA                        3             3             7             0\n" +
      "(40I2)          (40I2)          (26I3)              \n" + lists + "  4 -1 -1  5 -2 -2  6\n";
  EXPECT_TRUE(is_harwell_boeing(integers));
  expect_matrix(parse_harwell_boeing(integers, "k.hb"));
}

TEST(HarwellBoeingFault, IsNamedByItsPlace) {
  const auto fault = [](const std::string& text) {
    return message_of<FormatError>([&] { (void)parse_harwell_boeing(text, "k.hb"); });
  };
  EXPECT_EQ(fault(replaced(kTriangle, "RSA", "CSA")),
            "k.hb:3:1: expected a matrix RSA or RUA: real, symmetric or not, assembled, found "
            "'CSA'. Mass and stiffness are real.");
  EXPECT_EQ(fault(replaced(kTriangle, "RSA", "PSA")),
            "k.hb:3:1: expected a matrix RSA or RUA: real, symmetric or not, assembled, found "
            "'PSA'. It has a pattern and no values.");
  EXPECT_EQ(fault(replaced(kTriangle, "(4I4) ", "(4X4) ")),
            "k.hb:4:1: expected a format of Fortran, (16I5) or (5E16.8), found '(4X4)'");
  EXPECT_EQ(fault(replaced(kTriangle, "   1   3   5   6", "   1   5   3   6")),
            "k.hb:6:12: expected pointers from 1 that rise to 6, found '3'");
  EXPECT_EQ(fault(replaced(kTriangle, "    2    3    3\n", "    2    4    3\n")),
            "k.hb:7:20: expected rows from 1 to 3, found '4'");
  EXPECT_EQ(fault(replaced(kTriangle, "5.00000000D+00\n", "5.0000000*D+00\n")),
            "k.hb:8:35: expected finite numbers with a point, found '5.0000000*D+00'");
  EXPECT_EQ(fault(replaced(kTriangle, "5.00000000D+00\n", "500000000D+00\n")),
            "k.hb:8:35: expected finite numbers with a point, found '500000000D+00'");
  EXPECT_NE(fault(kWhole.substr(0, kWhole.size() - 6)).find("an end of line after the last entry"),
            std::string::npos);
  EXPECT_EQ(fault(kTriangle.substr(0, kTriangle.find(" -2.0"))),
            "k.hb:9:1: expected finite numbers with a point, found the end of the file");
  EXPECT_EQ(fault(replaced(kTriangle, "             5             0\n",
                           "    5000000000             0\n")),
            "k.hb:6:1: expected a last pointer of 5000000001, found 6");
}

// As `find(K)` of MATLAB and FORMAT=COORDINATE of Abaqus list entries.
TEST(CoordinateList, OfOneTriangleOrBothIsRead) {
  const std::string lower = "1 1 4\n2 1 -1.0e+00\n2 2 5\n\n3 2 -2\n3 3 6\n";
  EXPECT_TRUE(is_coordinate_list(lower));
  EXPECT_FALSE(is_coordinate_list("3 3 5 0\n"));
  EXPECT_FALSE(is_coordinate_list("%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 2\n"));
  EXPECT_FALSE(is_coordinate_list("0.5 1 2\n"));
  expect_matrix(parse_coordinate_list(lower, "k.txt"));
  expect_matrix(parse_coordinate_list(lower + "1 2 -1\n2 3 -2\n", "k.txt"));
  expect_matrix(parse_coordinate_list("% K\n3 3 5\n" + lower, "k.txt"));  // rows, columns, lines
  expect_matrix(parse_coordinate_list(
      "# savetxt\n1.0e+00 1.0e+00 4.0e+00\n2 1 -1\n2 2 5\n3 2 -2\n3 3 6", "k.txt"));
  EXPECT_EQ(parse_coordinate_list(lower + "1 1 2\n", "k").repeated, 1U) << "they add up";
  EXPECT_EQ(parse_coordinate_list(lower + "1 2 -1\n2 3 -2\n", "k").repeated, 0U);
  EXPECT_EQ(parse_coordinate_list(lower + "1 2 -1\n2 3 -2\n1 2 0\n1 1 1\n", "k").repeated, 2U);
  EXPECT_EQ(parse_coordinate_list("3 3 6\n2 2 5\n", "k").value.size(), 2U) << "downwards";
  const std::string cut = lower.substr(0, lower.find("3 3"));  // its line of sizes was an entry
  EXPECT_EQ(message_of<FormatError>([&] { (void)parse_coordinate_list("3 3 5\n" + cut, "k"); }),
            "k:6:7: expected 5 entries, which the first line states, found 4. The file is "
            "truncated, or its first line is an entry: then put it behind the others.");
  EXPECT_EQ(message_of<FormatError>([&] { (void)parse_coordinate_list("1 0.5 4\n", "k"); }),
            "k:1:3: expected a column from 1 to 20000000, found 0.5");
  EXPECT_EQ(message_of<InputError>([&] { (void)parse_coordinate_list(lower + "1 2 -1\n", "k"); }),
            "k: entry (3, 2) = -2; must be that of (2, 3), 0, as the matrix must be symmetric. It "
            "has some entries of both triangles: all must be there, or those of one.");
}

}  // namespace
}  // namespace microslip::harwell_boeing_test
