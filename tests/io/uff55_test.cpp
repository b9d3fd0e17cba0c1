// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff55.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "io/mode_shapes.hpp"
#include "io/uff_support.hpp"

namespace microslip::uff55_test {
namespace {

using test::marker;
using test::read_shapes;

std::string shape_text(const std::string& form, const std::string& body) {
  return marker() + "    55\nmode\nNONE\nNONE\nNONE\nNONE\n" + form + body + marker();
}

const std::string kNormalForm =
    "         1         2         3         8         2         6\n"
    "         2         4         5         7\n"
    "  5.58000E+01  2.50000E+00  1.00000E-02  2.00000E-02\n";

TEST(Uff55, NormalModeOfSixDegreesOfFreedom) {
  const UffModeShapes read = read_shapes(shape_text(kNormalForm, test::kTwoNodes));
  ASSERT_EQ(read.shapes.size(), 1U);
  EXPECT_EQ(read.shapes[0].id_lines[0], "mode");
  test::expect_mode_7(read.shapes[0]);
}

TEST(Uff55, ComplexModeOverTwoLines) {
  const UffModeShapes read = read_shapes(
      shape_text("         1         3         3         8         5         4\n"
                 "         2         6         1         1\n"
                 " -3.00000E+00  4.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n",
                 "         1\n  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00  5.00000E+00"
                 "  6.00000E+00\n  7.00000E+00  8.00000E+00\n"));
  const UffModeShape& shape = read.shapes.at(0);
  test::expect_complex_mode(shape, {0.0, 0.0});
  EXPECT_EQ(shape.modal_mass, std::nullopt);
  EXPECT_EQ(shape.values, (std::vector<double>{1, 3, 5, 7}));
  EXPECT_EQ(shape.imaginary, (std::vector<double>{2, 4, 6, 8}));
}

// What a file does not tell is no 0.
TEST(Uff55, TellsDampingAndMassOnlyWhereTheyAre) {
  const std::string form =
      "         1         2         2         8         2         3\n"
      "         2         1         1         1\n  1.00000E+01\n";
  const UffModeShape shape = read_shapes(shape_text(form, "")).shapes.at(0);
  EXPECT_EQ(shape.frequency, 10.0);
  EXPECT_EQ(shape.modal_mass, std::nullopt);
  EXPECT_EQ(shape.damping_ratio, std::nullopt);
  EXPECT_EQ(shape.loss_factor, std::nullopt);
}

// Each in the units that were given last; those of one file do not reach into another behind it.
TEST(Uff55, HasTheUnitsOfDataset164) {
  const std::string shape = shape_text(kNormalForm, "");
  const std::string header =
      marker() + "   151\nmodel\nNONE\nNONE\nNONE\nNONE\nNONE\nNONE\n" + marker();
  const UffModeShapes read =
      read_shapes(shape + test::units164(5, "1.00000000000000000D+03", "1.00000000000000000D+00") +
                  shape + header + shape);
  ASSERT_EQ(read.shapes.size(), 3U);
  EXPECT_EQ(read.shapes[0].length_unit, std::nullopt);
  EXPECT_EQ(read.shapes[1].length_unit, 1e-3);
  EXPECT_EQ(read.shapes[1].force_unit, 1.0);
  EXPECT_EQ(read.shapes[2].length_unit, std::nullopt);
}

TEST(Uff55, SkipsOtherDatasets) {
  test::Function58 f;
  f.points = 2;
  const std::string values = "\n    -1\n    -1 \n";  // bytes of two doubles
  ASSERT_EQ(values.size(), 16U);
  const UffModeShapes read =
      read_shapes(binary_dataset(f, values, 16) + marker() + "    15\n         1\n" + marker() +
                  shape_text(kNormalForm, ""));
  ASSERT_EQ(read.shapes.size(), 1U);
  EXPECT_TRUE(read.shapes[0].nodes.empty());
}

TEST(Uff55, SaysWhatIsMissing) {
  const auto fault = [](const std::string& content) {
    const std::string message = test::message_of<FormatError>([&] { return read_shapes(content); });
    return message.substr(std::min(message.find("t.uff"), message.size()));
  };
  EXPECT_EQ(fault(shape_text(kNormalForm, "        10\n  1.00000E+00\n")),
            "t.uff:13: expected values of a node of dataset 1, found the line '    -1' that closes "
            "it");
  EXPECT_NE(fault(shape_text("         1         2         3         8         4         6\n", ""))
                .find("the data type 2 (real) or 5 (complex), found 4"),
            std::string::npos);
  EXPECT_NE(fault(shape_text("         1         2         3         8         2 999999999\n", ""))
                .find("the number of values of a node from 0 to 1000"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::uff55_test
