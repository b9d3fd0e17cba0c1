// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/dmig_matrices.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/replaced.hpp"

namespace microslip::dmig_matrices_test {
namespace {

using test::message_of;

// Two masses of 2 and 3 on points 7 and 12, and a scalar point 40: K = [4 -1 0; -1 5 -2; 0 -2 6],
// as a solver punches it, in wide fields; the numbers with all exponents that the format knows.
const std::string kWide =
    "$ punched\n"
    "DMIG    KAAX           0       6       2       0                       3\n"
    "DMIG*   KAAX                           7               1\n"
    "*                      7               1 4.000000000D+00\n"
    "DMIG*   KAAX                          12               3\n"
    "*                      7               1-1.000000000D+00\n"
    "*                     12               3 5.000000000D+00\n"
    "DMIG*   KAAX                          40               0\n"
    "*                     12               3-2.000000000D+00\n"
    "*                     40               0 6.000000000D+00\n"
    "DMIG    MAAX           0       6       2       0                       3\n"
    "DMIG*   MAAX                           7               1\n"
    "*                      7               1 2.000000000D+00\n"
    "DMIG*   MAAX                          12               3\n"
    "*                     12               3 3.000000000D+00\n"
    "DMIG    VAX            0       9       2       0                       1\n"
    "DMIG*   VAX                            1               0\n"
    "*                      7               1 1.000000000D+00\n";

// The same in fields of eight columns, two entries in a line that goes on; the other triangle.
const std::string kNarrow =
    "SOL 103\nBEGIN BULK\n"
    "GRID    7               0.      0.      0.\n"
    "DMIG    MAAX    0       6       1\n"
    "DMIG    MAAX    7       1               7       1       2.\n"
    "DMIG    MAAX    12      3               12      3       .3+1\n"
    "DMIG    KAAX    0       6       1\n"
    "DMIG    KAAX    7       1               7       1       4.+0\n"
    "        12      3       -10.-1\n"
    "DMIG    KAAX    12      3               12      3       5.\n"
    "+       40              -2.E0           \n"
    "DMIG    KAAX    40                      40              6.\n"
    "ENDDATA\n";

// Between commas, whole.
const std::string kCommas =
    "DMIG,KAAX,0,1,2\n"
    "DMIG,KAAX,7,1,,7,1,4.,,\n"
    ",12,3,-1.\n"
    "DMIG,KAAX,12,3,,7,1,-1.,,\n"
    ",12,3,5.,,40,0,-2.\n"
    "DMIG,KAAX,40,0,,12,3,-2.,0.,\n"
    ",40,0,6.\n"
    "DMIG,MAAX,0,1,2\n"
    "DMIG,MAAX,7,1,,7,1,2.\n"
    "DMIG,MAAX,12,3,,12,3,3.\n";

StructuralMatrices parse(const std::string& text, const std::string& name = {}) {
  return parse_dmig_matrices({.text = text, .file = "m.pch", .name = name, .initial = 'K'},
                             {.text = text, .file = "m.pch", .initial = 'M'});
}

std::vector<double> full(const SymmetricEntries& matrix) {
  std::vector<double> all(matrix.size * matrix.size, 0.0);
  for (std::size_t i = 0; i < matrix.value.size(); ++i) {
    const auto row = static_cast<std::size_t>(matrix.row[i]);
    const auto column = static_cast<std::size_t>(matrix.column[i]);
    all[row * matrix.size + column] += matrix.value[i];
    if (row != column) all[column * matrix.size + row] += matrix.value[i];
  }
  return all;
}

TEST(DmigMatrices, AreReadInEachLayout) {
  for (const std::string& text : {kWide, kNarrow, kCommas}) {
    EXPECT_TRUE(is_dmig(text));
    const StructuralMatrices found = parse(text);
    EXPECT_EQ(found.degrees,
              (std::vector<DegreeOfFreedom>{
                  {7, NodalDirection::kX}, {12, NodalDirection::kZ}, {40, NodalDirection::kX}}));
    EXPECT_EQ(full(found.stiffness),
              (std::vector<double>{4.0, -1.0, 0.0, -1.0, 5.0, -2.0, 0.0, -2.0, 6.0}));
    EXPECT_EQ(full(found.mass), (std::vector<double>{2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0}));
  }
}

// NCOL is of rectangular matrices: pyNastran's issue 147 has 3 columns under a header of 1368678.
TEST(DmigMatrices, DoNotCountColumns) {
  for (const std::string& number : {std::string("       3"), std::string("     600")}) {
    const std::string head = "KAAX           0       6       2       0                ";
    const std::string text = test::replaced(kWide, head + "       3", head + number);
    EXPECT_EQ(full(parse(text).stiffness),
              (std::vector<double>{4.0, -1.0, 0.0, -1.0, 5.0, -2.0, 0.0, -2.0, 6.0}));
  }
}

// A punch begins with the grid, of any length.
TEST(DmigMatrices, MayComeAfterOtherBulkData) {
  const test::TemporaryFolder folder;
  std::string grid;
  for (int i = 0; i < 1200; ++i) {
    grid +=
        fmt::format("GRID    {:8}       0     {:3}.      0.      0.       0\n", 1000 + i, i % 100);
  }
  test::put(folder.file("m.pch"), grid + kWide);
  EXPECT_TRUE(is_dmig_file(folder.file("m.pch:KAAX")));
  EXPECT_EQ(read_dmig_matrices(folder.file("m.pch"), folder.file("m.pch")).degrees.size(), 3U);
  test::put(folder.file("grid.pch"), grid);
  EXPECT_FALSE(is_dmig_file(folder.file("grid.pch")));
}

TEST(DmigMatrices, AreToldByTheirText) {
  EXPECT_FALSE(is_dmig("%%MatrixMarket matrix coordinate real symmetric\n"));
  EXPECT_FALSE(is_dmig("GRID    7\n"));
  EXPECT_FALSE(is_dmig(""));
}

TEST(DmigMatrices, AreChosenByName) {
  std::string two = kWide;
  two += "DMIG    KBAX           0       6       2       0                       3\n";
  const auto refused = [](const std::string& text, const std::string& name) {
    return message_of<InputError>([&] { return parse(text, name); });
  };
  EXPECT_EQ(refused(two, ""),
            "m.pch = 2 matrices K…; must have one whose name begins so, or be named after a colon. "
            "It has KAAX, KBAX, MAAX, VAX.");
  EXPECT_EQ(parse(two, "kaax").stiffness.size, 3U);
  EXPECT_EQ(refused(two, "KCAX"),
            "m.pch = no matrix KCAX; must be one of the file. It has KAAX, KBAX, MAAX, VAX.");
  const std::size_t head = kWide.find('\n', kWide.find("KAAX")) + 1;
  EXPECT_EQ(refused(kWide.substr(head), ""),
            "m.pch = 0 matrices K…; must have one whose name begins so, or be named after a colon. "
            "It has KAAX (without a header), MAAX, VAX.");
  EXPECT_EQ(refused(kWide, "VAX"),
            "m.pch: VAX = of form 9; must be of form 6, symmetric, or 1, square");
}

TEST(DmigMatrices, NameWhatIsWrong) {
  const auto with = [](const std::string& before, const std::string& after) {
    std::string text = kWide;
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return message_of<Error>([&] { return parse(text.replace(at, before.size(), after)); });
  };
  EXPECT_EQ(with("4.000000000D+00", "4.0000000oDD+00"),
            "m.pch:4:41: expected a number, found '4.0000000oDD+00'");
  EXPECT_EQ(with("4.000000000D+00", ""), "m.pch:4:41: expected a number, found nothing");
  EXPECT_EQ(with("  12               3\n*", "  12               9\n*"),
            "m.pch:5:41: expected a component from 0 to 6, found '9'");
  EXPECT_EQ(with("7               1-1.0", "x               1-1.0"),
            "m.pch:6:9: expected the number of a point, found 'x'");
  EXPECT_EQ(with("5.000000000D+00\n", "5.000000000D+00 1.000000000D+00\n"),
            "m.pch:7:57: expected no imaginary part, found '1.000000000D+00'");
  EXPECT_EQ(with("*                     40               0 6.0",
                 "*                     12               3 6.0"),
            "m.pch: KAAX = x of 40 and z of 12; must have one entry: a matrix of form 6 has one "
            "triangle, and none is there twice");
  EXPECT_EQ(with("DMIG    MAAX           0       6", "DMIG    MAAX           0       x"),
            "m.pch:11:25: expected the form of the matrix, found 'x'");
  // Without the diagonal of its last column; with a point left blank; complex; without the end of
  // its last line.
  EXPECT_EQ(with("*                     40               0 6.000000000D+00\n", ""),
            "m.pch: KAAX = x of 40 without its diagonal entry; must have one for each degree of "
            "freedom that has others. Is the file truncated?");
  EXPECT_EQ(with("*                     40               0 6.0",
                 "*                      "
                 "                0 6.0"),
            "m.pch:10:9: expected the number of a point, found nothing");
  EXPECT_EQ(with("KAAX           0       6       2", "KAAX           0       6       4"),
            "m.pch:2:33: expected real numbers, of type 1 or 2, found '4'");
  EXPECT_EQ(
      with("12               3 3.000000000D+00\nDMIG    VAX            0       9       2       0 "
           "                      1\nDMIG*   VAX                            1               0\n*"
           "                      7               1 1.000000000D+00\n",
           "12               3 3.0"),
      "m.pch:14:1: expected an end of line after the last entry, found the end of the file: is it "
      "truncated?");
  EXPECT_EQ(with("\n*                     40", "\n*\t                     40"),
            "m.pch:10:2: expected fields of 8 columns, found a tab");
}

// Cut anywhere a file is read, or refused by name: nothing else is thrown.
TEST(DmigMatrices, CutAtEachByte) {
  for (const std::string& text : {kWide, kNarrow, kCommas}) {
    for (std::size_t size = 0; size < text.size(); ++size) {
      try {
        const StructuralMatrices found = parse(text.substr(0, size));
        EXPECT_EQ(found.stiffness.size, found.degrees.size());
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("m.pch"), std::string::npos) << error.what();
      }
    }
  }
}

TEST(DmigMatrices, OfOneTriangleAreNoSquareOnes) {
  std::string text = kCommas;
  const std::string half = "DMIG,KAAX,12,3,,7,1,-1.,,\n,12,3,5.";
  text.replace(text.find(half), half.size(), "DMIG,KAAX,12,3,,12,3,5.,,\n,7,1,-2.");
  EXPECT_EQ(message_of<InputError>([&] { return parse(text); }),
            "m.pch: KAAX: entry (2, 1) = -1; must be that of (1, 2), -2, as the matrix must be "
            "symmetric. A matrix of one triangle has form 6.");
}

// Found by scripts/fuzz: a name with a control character broke the line of the message.
TEST(DmigMatrices, NamesOfAnySortLeaveTheMessageALine) {
  const std::string text = "DMIG,KAAX,0,1,2\nDMIG,KAAX,7,1,,7,1,4.,,\nDMIG,X\x01\x7F,7,1,,7,1,2.\n";
  EXPECT_EQ(message_of<InputError>([&] { return parse(text); }),
            "m.pch = 0 matrices M…; must have one whose name begins so, or be named after a colon. "
            "It has KAAX, X??.");
}

// Found by scripts/fuzz: names of any length and number made messages of many lines' length.
TEST(DmigMatrices, NamesLeaveTheMessageShort) {
  EXPECT_EQ(message_of<FormatError>([] { parse("DMIG,ABCDEFGHIJKLMNOPQ,7,1,,7,1,4.,,\n"); }),
            "m.pch:1:6: expected the name of a matrix, at most 16 bytes, found "
            "'ABCDEFGHIJKLMNOPQ'");
  std::string many;
  for (int i = 0; i < 12; ++i) many += fmt::format("DMIG,X{:02},7,1,,7,1,2.,,\n", i);
  EXPECT_EQ(message_of<InputError>([&] { parse(many); }),
            "m.pch = 0 matrices K…; must have one whose name begins so, or be named after a colon. "
            "It has X00, X01, X02, X03, X04, X05, X06, X07, X08, X09, and 2 more.");
}

}  // namespace
}  // namespace microslip::dmig_matrices_test
