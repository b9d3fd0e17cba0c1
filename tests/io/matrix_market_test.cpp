// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/matrix_market.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::matrix_market_test {
namespace {

using test::message_of;
using Indices = std::vector<std::int32_t>;
using Numbers = std::vector<double>;

const std::string kHead = "%%MatrixMarket matrix coordinate real symmetric\n";
const std::string kWhole = "%%MatrixMarket matrix coordinate real general\n";

TEST(MatrixMarket, ReadsOneTriangle) {
  const SymmetricEntries lower = parse_matrix_market(
      kHead + "% of a mesh\n\n3 3 4\n1 1 4\n2 1 -1.5e0\n2 2 +3\n3 3 1e-400\n", "");
  EXPECT_EQ(lower.size, 3U);
  EXPECT_EQ(lower.row, (Indices{0, 1, 1, 2}));
  EXPECT_EQ(lower.column, (Indices{0, 0, 1, 2}));
  EXPECT_EQ(lower.value, (Numbers{4.0, -1.5, 3.0, 0.0}));
  const SymmetricEntries upper = parse_matrix_market(kHead + "2 2 2\r\n1 1 4\r\n1 2 -1.5\r\n", "");
  EXPECT_EQ(upper.row, (Indices{0, 1}));
  EXPECT_EQ(upper.column, (Indices{0, 0}));
}

// Both triangles, in any order, parts of one entry apart: sorted by columns, the mean of both
// sides.
TEST(MatrixMarket, ReadsBothTriangles) {
  const SymmetricEntries matrix =
      parse_matrix_market(kWhole + "2 2 5\n2 2 3\n1 2 -1\n2 1 -1.000000001\n1 1 2\n1 1 2\n", "");
  EXPECT_EQ(matrix.row, (Indices{0, 1, 1}));
  EXPECT_EQ(matrix.column, (Indices{0, 0, 1}));
  EXPECT_EQ(matrix.value, (Numbers{4.0, -1.0000000005, 3.0}));
}

TEST(MatrixMarket, ReadsArrays) {
  const SymmetricEntries general =
      parse_matrix_market("%%MatrixMarket MATRIX Array Real general\n2 2\n4\n-1\n-1\n0\n", "");
  EXPECT_EQ(general.value, (Numbers{4.0, -1.0}));
  const SymmetricEntries triangle =
      parse_matrix_market("%%MatrixMarket matrix array integer symmetric\n2 2\n4\n-1\n5", "");
  EXPECT_EQ(triangle.value, (Numbers{4.0, -1.0, 5.0}));
  EXPECT_EQ(triangle.row, (Indices{0, 1, 1}));
}

TEST(MatrixMarketFault, IsNamedByItsPlace) {
  const auto format_fault = [](const std::string& text) {
    return message_of<FormatError>([&] { return parse_matrix_market(text, "k.mtx"); });
  };
  const auto input_fault = [](const std::string& text) {
    return message_of<InputError>([&] { return parse_matrix_market(text, "k.mtx"); });
  };
  EXPECT_EQ(
      format_fault(""),
      "k.mtx: expected %%MatrixMarket matrix coordinate real symmetric, found ''. Or lines of "
      "row, column and value, *MATRIX OUTPUT of Abaqus, Harwell-Boeing, OP4, MATLAB or HDF5.");
  EXPECT_EQ(format_fault("%%MatrixMarket matrix coordinate complex symmetric\n1 1 0\n"),
            "k.mtx:1:1: expected a real or integer matrix, found 'complex'. Mass and stiffness are "
            "real.");
  EXPECT_EQ(format_fault("%%MatrixMarket matrix coordinate real skew-symmetric\n1 1 0\n"),
            "k.mtx:1:1: expected a symmetric or general matrix, found 'skew-symmetric'. Mass and "
            "stiffness are symmetric.");
  EXPECT_EQ(format_fault(kHead),
            "k.mtx:1:1: expected the numbers of rows, columns and entries, found the end of the "
            "file");
  EXPECT_EQ(
      format_fault(kHead + "2 2 1000000000\n1 1 4\n"),
      "k.mtx:2:15: expected a number of entries that the file has room for, found 1000000000, "
      "where 1 fit at most. The file is truncated, or its header is wrong.");
  EXPECT_EQ(format_fault(kHead + "99999999999 2 1\n1 1 4\n"),
            "k.mtx:2:1: expected a number of rows from 1 to 20000000, found 99999999999");
  EXPECT_EQ(
      format_fault(kHead + "2 2 2\n0 0 4\n1 1 4\n"),
      "k.mtx:3:1: expected a row from 1 to 2, found 0. Rows and columns count from 1; add 1 to "
      "those of a program that counts from 0.");
  EXPECT_EQ(format_fault(kHead + "2 2 1\n1 3 4\n"),
            "k.mtx:3:3: expected a column from 1 to 2, found 3");
  EXPECT_EQ(format_fault(kHead + "2 2 1\n1 1 nan\n"), "k.mtx:3:5: expected a number, found 'nan'");
  EXPECT_EQ(format_fault(kHead + "2 2 1\n1 1 1e999\n"),
            "k.mtx:3:5: expected a number, found '1e999'");
  EXPECT_EQ(format_fault(kHead + "2 2 1\n1 1 4 5\n"),
            "k.mtx:3:7: expected the end of the line, found '5'");
  EXPECT_EQ(format_fault(kHead + "2 2 2\n1 1 4\n\n   \n   \n"),
            "k.mtx:6:1: expected 2 entries, found the end of the file after 1");
  EXPECT_EQ(format_fault(kHead + "2 2 1\n1 1 4\n2 2 4\n"),
            "k.mtx:4:1: expected the end of the file after 1 entries, found '2 2 4'");
  EXPECT_EQ(input_fault(kHead + "2 3 1\n1 1 4\n"),
            "k.mtx: columns = 3; must be 2, the number of rows");
  EXPECT_EQ(input_fault(kHead + "3 3 2\n2 1 4\n1 3 4\n"),
            "k.mtx: entry (1, 3) = 4; must lie in the lower triangle, as those before it. Only one "
            "triangle of a symmetric matrix is stored.");
  EXPECT_EQ(
      input_fault(kWhole + "2 2 4\n1 1 4\n2 2 4\n1 2 3\n2 1 3.1\n"),
      "k.mtx: entry (2, 1) = 3.1; must be that of (1, 2), 3, as the matrix must be symmetric. "
      "If only one triangle is stored, the file must state so.");
}

}  // namespace
}  // namespace microslip::matrix_market_test
