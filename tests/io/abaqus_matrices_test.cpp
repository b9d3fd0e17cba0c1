// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/abaqus_matrices.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/replaced.hpp"

namespace microslip::abaqus_matrices_test {
namespace {

using test::message_of;
using test::replaced;

// The form of the Abaqus Keywords Reference Guide, *MATRIX INPUT: node, degree of freedom, node,
// degree of freedom, value; "lower triangular, upper triangular, or square".
const std::string kStiffness =
    "** stiffness of two nodes\n"
    "*MATRIX INPUT, NAME=K, TYPE=SYMMETRIC\n"
    "12,3, 12,3,  5.000000000000000e+00\r\n"
    "7,1, 7,1,  4.0D+00\n"
    "12,3, 7,1,  -1.000000000000000e+00\n"
    "\n"
    "-1,1, -1,1, 6.0\n"
    "-1,1, 12,3, -2.0\n";
const std::string kMass = "7,1, 7,1, 2\n12,3, 12,3, 3\n";

StructuralMatrices parse(const std::string& stiffness, const std::string& mass = kMass) {
  return parse_abaqus_matrices({stiffness, "k.mtx"}, {mass, "m.mtx"});
}

void expect_system(const StructuralMatrices& matrices) {
  // Nodes rise: -1, an internal one, 7, 12.
  EXPECT_EQ(matrices.degrees,
            (std::vector<DegreeOfFreedom>{
                {-1, NodalDirection::kX}, {7, NodalDirection::kX}, {12, NodalDirection::kZ}}));
  std::vector<double> full(9, 0.0);
  for (std::size_t i = 0; i < matrices.stiffness.value.size(); ++i) {
    const auto row = static_cast<std::size_t>(matrices.stiffness.row[i]);
    const auto column = static_cast<std::size_t>(matrices.stiffness.column[i]);
    EXPECT_GE(row, column);
    full[row * 3 + column] += matrices.stiffness.value[i];
  }
  EXPECT_EQ(full, (std::vector<double>{6.0, 0.0, 0.0, 0.0, 4.0, 0.0, -2.0, -1.0, 5.0}));
  EXPECT_EQ(matrices.mass.size, 3U);
  EXPECT_EQ(matrices.mass.value, (std::vector<double>{2.0, 3.0}));
}

TEST(AbaqusMatrices, OfOneTriangleOrBothAreRead) {
  EXPECT_TRUE(is_abaqus_matrix(kStiffness));
  expect_system(parse(kStiffness));
  expect_system(parse(kStiffness + "7,1, 12,3, -1.\n12,3, -1,1, -2.\n"));
}

TEST(AbaqusMatrices, AreNotTakenForOthers) {
  EXPECT_FALSE(is_abaqus_matrix("1 1 5.0\n"));
  EXPECT_FALSE(is_abaqus_matrix("DMIG,KAAX,0,1,2\n"));
  EXPECT_FALSE(is_abaqus_matrix("%%MatrixMarket matrix coordinate real symmetric\n"));
  EXPECT_FALSE(is_abaqus_matrix(""));
}

TEST(AbaqusMatricesFault, IsNamedByItsPlace) {
  const auto format_fault = [](const std::string& text) {
    return message_of<FormatError>([&] { (void)parse(text); });
  };
  const auto input_fault = [](const std::string& text) {
    return message_of<InputError>([&] { (void)parse(text); });
  };
  EXPECT_EQ(format_fault(kStiffness + "7,1, 7\n"),
            "k.mtx:9:1: expected node, degree of freedom, node, degree of freedom, value, found "
            "'7,1, 7'");
  EXPECT_EQ(format_fault(replaced(kStiffness, "7,1, 7,1", "7,1, 7,8")),
            "k.mtx:4:8: expected a degree of freedom from 1 to 6, found '8'. Others, as warping, "
            "pressure and temperature, are no displacements: generate the matrices of a model "
            "without them.");
  EXPECT_EQ(format_fault(replaced(kStiffness, "4.0D+00", "nan")),
            "k.mtx:4:10: expected a finite number, found 'nan'");
  EXPECT_EQ(format_fault(kStiffness + "7,1, 8,1, 1.0e-0"),
            "k.mtx:9:1: expected an end of line after the last entry, found the end of the file: "
            "is it truncated?");
  EXPECT_EQ(format_fault(kStiffness + "*MATRIX INPUT, NAME=M\n"),
            "k.mtx:9:1: expected one matrix, found another *MATRIX INPUT");
  EXPECT_EQ(input_fault(kStiffness + "12,3, 7,1, -1.\n"),
            "k.mtx = z of 12 and x of 7; must have one entry: those that are there twice would add "
            "up");
  EXPECT_EQ(input_fault(kStiffness + "7,1, 12,3, -1.5\n12,3, -1,1, -2.\n"),
            "k.mtx: entry (3, 2) = -1; must be that of (2, 3), -1.5, as the matrix must be "
            "symmetric. The file has some entries of both triangles: it must have all, or those of "
            "one.");
  EXPECT_EQ(input_fault(replaced(kStiffness, "-1,1, -1,1, 6.0\n", "")),
            "k.mtx = x of -1 without its diagonal entry; must have one for each degree of freedom "
            "that has others. Is the file truncated?");
}

}  // namespace
}  // namespace microslip::abaqus_matrices_test
