// SPDX-License-Identifier: MIT

// The eight layouts of dataset 58, as text and binary, in the formats and byte orders of 58b.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "io/uff_support.hpp"

namespace microslip::uff_layouts_test {
namespace {

using test::Function58;

/// Seven points that single precision and six digits hold; the number is odd, so that lines of text
/// end within a record.
const std::vector<double> kX{0.0, 0.5, 1.25, 2.0, 3.0, 4.5, 7.0};
const std::vector<double> kReal{1.5, -2.25, 3.0, 0.0, -1024.0, 6.5, 0.0078125};
const std::vector<double> kImaginary{-1.0, 0.5, 0.0, 8.0, 16.5, -3.25, 2.0};

struct Layout {
  int ordinate_type;  ///< 2 real4, 4 real8, 5 complex4, 6 complex8
  bool even;

  [[nodiscard]] bool is_double() const { return ordinate_type == 4 || ordinate_type == 6; }
  [[nodiscard]] bool is_complex() const { return ordinate_type >= 5; }
};

std::vector<Layout> layouts() {
  std::vector<Layout> all;
  for (const int type : {2, 4, 5, 6}) {
    for (const bool even : {true, false}) all.push_back({type, even});
  }
  return all;
}

Function58 function_of(const Layout& layout) {
  Function58 f;
  f.ordinate_type = layout.ordinate_type;
  f.even = layout.even;
  f.points = static_cast<long long>(kX.size());
  f.step = layout.even ? " 5.00000E-01" : " 0.00000E+00";
  return f;
}

/// The values in the order of the file; `is_x` tells the abscissae.
std::vector<std::pair<double, bool>> stream_of(const Layout& layout) {
  std::vector<std::pair<double, bool>> stream;
  for (std::size_t i = 0; i < kX.size(); ++i) {
    if (!layout.even) stream.emplace_back(kX[i], true);
    stream.emplace_back(kReal[i], false);
    if (layout.is_complex()) stream.emplace_back(kImaginary[i], false);
  }
  return stream;
}

/// 6E13.5, 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
std::string text_of(const Layout& layout) {
  const std::size_t per_line = !layout.is_double()   ? 6
                               : layout.even         ? 4
                               : layout.is_complex() ? 3
                                                     : 4;
  std::string text;
  std::size_t on_line = 0;
  for (const auto& [value, is_x] : stream_of(layout)) {
    const bool narrow = is_x || !layout.is_double();
    text += narrow ? fmt::format("{:13.5E}", value) : fmt::format("{:20.12E}", value);
    if (++on_line == per_line) {
      text += '\n';
      on_line = 0;
    }
  }
  return on_line == 0 ? text : text + '\n';
}

void expect_values(const Recordings& read, const Layout& layout, const std::string& what) {
  ASSERT_EQ(read.recordings.size(), 1U) << what;
  EXPECT_TRUE(read.warnings.empty()) << what << ": " << read.warnings[0].text;
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.axis.dimension, kTime) << what;
  EXPECT_EQ(recording.axis.values, layout.even ? std::vector<double>{} : kX) << what;
  if (layout.even) {
    EXPECT_EQ(recording.axis.step, 0.5) << what;
  }
  const Channel& force = recording.channel("force");
  EXPECT_EQ(force.dimension, kForce) << what;
  EXPECT_EQ(force.values, kReal) << what;
  EXPECT_EQ(force.imaginary, layout.is_complex() ? kImaginary : std::vector<double>{}) << what;
}

TEST(UffLayouts, Text) {
  for (const Layout& layout : layouts()) {
    const std::string what = fmt::format("type {} even {}", layout.ordinate_type, layout.even);
    expect_values(test::read_uff(text_dataset(function_of(layout), text_of(layout))), layout, what);
  }
}

TEST(UffLayouts, BinaryIeee) {
  for (const Layout& layout : layouts()) {
    for (const bool little : {true, false}) {
      std::string payload;
      for (const auto& [value, is_x] : stream_of(layout)) {
        payload += layout.is_double() ? test::ieee8(value, little) : test::ieee4(value, little);
      }
      const std::string what =
          fmt::format("type {} even {} little {}", layout.ordinate_type, layout.even, little);
      expect_values(
          test::read_uff(binary_dataset(function_of(layout), payload,
                                        static_cast<long long>(payload.size()), little ? 1 : 2)),
          layout, what);
    }
  }
}

TEST(UffLayouts, BinaryWithAbscissaeOfFourBytes) {
  for (const Layout& layout : {Layout{4, false}, Layout{6, false}}) {
    for (const bool little : {true, false}) {
      std::string payload;
      for (const auto& [value, is_x] : stream_of(layout)) {
        payload += is_x ? test::ieee4(value, little) : test::ieee8(value, little);
      }
      expect_values(
          test::read_uff(binary_dataset(function_of(layout), payload,
                                        static_cast<long long>(payload.size()), little ? 1 : 2)),
          layout, "x of 4 bytes");
    }
  }
}

TEST(UffLayouts, BinaryOfDecAndIbmIsRefused) {
  Function58 f;
  f.points = 2;
  const std::string payload(16, '\0');
  EXPECT_NE(test::uff_fault(binary_dataset(f, payload, 16, 1, 1))
                .find("found format 1 (DEC VMS), byte order 1, 8 bytes per value"),
            std::string::npos);
  EXPECT_NE(test::uff_fault(binary_dataset(f, payload, 16, 2, 3))
                .find("found format 3 (IBM), byte order 2, 8 bytes per value"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::uff_layouts_test
