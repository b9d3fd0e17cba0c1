// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/uff/uff55.hpp"

/// @file
/// Mode shapes in universal files, datasets 55 and 2414: two modes that both are written with.

namespace microslip::test {

inline UffModeShapes read_shapes(const std::string& content) {
  const TemporaryFolder folder;
  put(folder.file("t.uff"), content);
  return read_mode_shapes_uff(folder.file("t.uff"));
}

/// Values of the nodes 10 and 20 in six degrees of freedom.
inline const std::string kTwoNodes =
    "        10\n"
    "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00  5.00000E+00  6.00000E+00\n"
    "        20\n"
    " -1.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  7.00000E+00\n";

/// Mode 7 of load set 5: 55.8 Hz, modal mass 2.5, ζ = 0.01, η = 0.02, with kTwoNodes.
inline void expect_mode_7(const UffModeShape& shape) {
  EXPECT_EQ(shape.analysis, UffAnalysis::kNormalMode);
  EXPECT_EQ(shape.id_lines[1], "");  // NONE
  EXPECT_EQ(shape.load_case, 5);
  EXPECT_EQ(shape.number, 7);
  EXPECT_EQ(shape.specific_type, 8);
  EXPECT_EQ(shape.frequency, 55.8);
  EXPECT_EQ(shape.modal_mass, 2.5);
  EXPECT_EQ(shape.damping_ratio, 0.01);
  EXPECT_EQ(shape.loss_factor, 0.02);
  EXPECT_EQ(shape.nodes, (std::vector<std::int64_t>{10, 20}));
  EXPECT_EQ(shape.at(0, 2), 3.0);
  EXPECT_EQ(shape.at(1, 0), -1.0);
  EXPECT_EQ(shape.at(1, 5), 7.0);
}

/// λ = −3 + 4i rad/s: |λ| = 5 rad/s, ζ = 3/5.
inline void expect_complex_mode(const UffModeShape& shape, std::complex<double> modal_a) {
  EXPECT_EQ(shape.analysis, UffAnalysis::kComplexMode);
  EXPECT_EQ(shape.eigenvalue, std::complex(-3.0, 4.0));
  EXPECT_DOUBLE_EQ(shape.frequency, 5.0 / (2.0 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(shape.damping_ratio.value(), 0.6);
  EXPECT_EQ(shape.modal_a, modal_a);
}

}  // namespace microslip::test
