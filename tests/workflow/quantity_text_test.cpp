// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/quantity_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"

namespace microslip::quantity_text_test {
namespace {

TEST(QuantityText, NumbersWithAndWithoutUnits) {
  EXPECT_EQ(parse_quantity("x", "300um", kLength), 3e-4);
  EXPECT_EQ(parse_quantity("x", " 3e-4 ", kLength), 3e-4);
  EXPECT_EQ(parse_quantity("x", "0.2%", kDimensionless), 0.002);
  EXPECT_THROW((void)parse_quantity("x", "3 N", kLength), InputError);
}

// The longer of the two was found by scripts/fuzz: the message held all of a text of thousands of
// bytes.
TEST(QuantityText, ADecimalCommaIsToldWithWhatToWrite) {
  const auto refusal = [](const std::string& text) {
    return test::message_of<InputError>([&] { (void)parse_quantity("x", text, kLength); });
  };
  EXPECT_EQ(refusal("1,5 mm"), "x = '1,5 mm'; must have a decimal point. Write 1.5 mm.");
  EXPECT_EQ(refusal("1,5" + std::string(1000, 'm')),
            "x = '1,5" + std::string(37, 'm') +
                "…' (1003 bytes); must have a decimal point. Write a decimal point instead of the "
                "comma.");
}

TEST(QuantityText, RangesInTheirOwnUnit) {
  EXPECT_EQ(parse_range("x", "50um:300um:6", kLength)[1], 1e-4);
  const std::vector<double> log = parse_range("x", "1:100:3:log", kLength);
  EXPECT_NEAR(log[1], 10.0, 1e-13);
  EXPECT_THROW((void)parse_range("x", "3:1:5", kLength), InputError);
  EXPECT_EQ(parse_values("x", "1,2mm", kLength), (std::vector{1.0, 2e-3}));
}

// csaps takes the amplitude in the unit that p was chosen in; λ goes with its cube.
TEST(QuantityText, SmoothingOfASplineNeedsItsUnit) {
  IdentificationOptions options;
  options.method = IdentificationMethod::kSpline;
  EXPECT_THROW(set_smoothing("lambda=8", {}, options), InputError);
  set_smoothing("lambda=8", "mm", options);
  EXPECT_NEAR(std::get<FixedLambda>(options.spline.smoothing).lambda, 8e-9, 1e-22);
  options.method = IdentificationMethod::kInversion;
  set_smoothing("lambda=0.5", {}, options);
  EXPECT_EQ(options.inversion.lambda, 0.5);
}

}  // namespace
}  // namespace microslip::quantity_text_test
