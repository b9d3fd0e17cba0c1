// SPDX-License-Identifier: MIT

// Universal files cut short or with bytes changed at random: each is read as recordings that keep
// the rules, or refused with a message of one line. Run it under the sanitizers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

#include "io/uff_support.hpp"
#include "microslip/io/uff/uff55.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"

namespace microslip::uff_damaged_test {
namespace {

using test::Function58;

const int kCases = test::cases_of(2500);  // for each of four files

std::string text_file() {
  Function58 f;
  f.points = 6;
  f.ordinate_type = 5;
  f.function_type = 4;
  f.ordinate_unit = "m/s\xB2";
  const std::string line =
      "  1.00000E+00 -2.00000E+00  3.00000E+00  4.00000e-05  5.00000E+00  6.00000E-105\n";
  const std::string units = test::marker() + "   164\n         1SI: m, N                     2\n" +
                            "  1.00000000000000000D+00  1.00000000000000000D+00" +
                            "  1.00000000000000000D+00\n  0.00000000000000000D+00\n" +
                            test::marker();
  return test::marker() + "   151\nmodel\n" + test::marker() + units +
         text_dataset(f, line + line) + text_dataset(f, line + line);
}

std::string uneven_text_file() {
  Function58 f;
  f.points = 3;
  f.even = false;
  return text_dataset(f,
                      "  1.00000E+00  1.000000000000E+00  2.50000E+00  1.100000000000E+00\n"
                      "  7.00000E+00  3.333333333333E+30\n");
}

std::string binary_file() {
  Function58 f;
  f.points = 4;
  f.ordinate_type = 6;
  f.even = false;
  const std::string payload = test::doubles({0, 1, 2, 1, 3, 4, 2, 5, 6, 3, 7, 8});
  Function58 g;
  g.points = 5;
  return binary_dataset(f, payload, static_cast<long long>(payload.size())) +
         binary_dataset(g, test::doubles({1, 2, 3, 4, 5}), 40, 1, 2, "\r\n");
}

std::string shapes_file() {
  return test::marker() + "    55\nNONE\nNONE\nNONE\nNONE\nNONE\n" +
         "         1         2         2         8         2         3\n" +
         "         2         4         1         1\n" +
         "  1.00000E+01  0.00000E+00  0.00000E+00  0.00000E+00\n" +
         "         1\n -1.46518E+00 -1.46518E+00 -1.46518E+00\n" +
         "         2\n  1.50162E-01  1.50162E-01  1.50162E-01\n" + test::marker() + test::marker() +
         "  2414\n         1\nmode\n         1\nNONE\nNONE\nNONE\nNONE\nNONE\n" +
         "         1         3         2         8         5         3\n" +
         "         0         0         0         0         1         1         0         0\n" +
         "         0         0\n" +
         "  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00\n" +
         " -3.00000E+00  4.00000E+00  1.00000E+00 -2.00000E+00  0.00000E+00  0.00000E+00\n" +
         "         1\n" +
         "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00  5.00000E+00  6.00000E+00\n" +
         test::marker() + uneven_text_file();
}

/// One or more bytes changed, taken out or doubled; those that matter to the format more often.
std::string corrupted(std::string text, std::mt19937_64& random) {
  static const std::string favourites = "\n\r -1+.E0123456789b58\xB2\x7F";
  for (std::uint64_t n = 1 + random() % 3; n > 0; --n) {
    const std::size_t at = random() % text.size();
    const std::uint64_t choice = random();
    const char byte = choice % 2 == 0 ? static_cast<char>(choice >> 8U)
                                      : favourites[(choice >> 8U) % favourites.size()];
    switch ((choice >> 32U) % 6) {
      case 0:
        text.erase(at, 1 + random() % 20);
        break;
      case 1:
        text.insert(at, 1, byte);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), random() % 90));
        break;
      default:
        text[at] = byte;
    }
    if (text.empty()) return text;
  }
  return text;
}

struct Counts {
  int read = 0;
  int refused = 0;
};

class UffDamaged : public ::testing::TestWithParam<int> {
 protected:
  void read(const std::string& text, bool allow_truncated) {
    std::filesystem::remove(path_);  // some systems flush a file to the disk when it is emptied
    test::put(path_, text);
    try {
      const Recordings read = read_recordings_uff(path_, {.allow_truncated = allow_truncated});
      ASSERT_FALSE(read.recordings.empty());
      for (const Recording& recording : read.recordings) {
        check_recording(recording);
        ASSERT_LE(recording.size(), text.size());
      }
      for (const Warning& warning : read.warnings) expect_clear(warning.text);
      ++counts_.read;
    } catch (const Error& error) {
      expect_clear(error.what());
      ++counts_.refused;
    }
    try {
      (void)read_mode_shapes_uff(path_);
    } catch (const Error& error) {
      expect_clear(error.what());
    }
  }

  static void expect_clear(const std::string& message) {
    EXPECT_LT(message.size(), 600U) << message;
    EXPECT_GT(message.size(), 20U) << message;
    EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20;
    })) << message;
  }

  [[nodiscard]] static std::string original() {
    switch (GetParam()) {
      case 0:
        return text_file();
      case 1:
        return uneven_text_file();
      case 2:
        return binary_file();
      default:
        return shapes_file();
    }
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("t.uff");
  Counts counts_;
};

TEST_P(UffDamaged, Truncated) {
  std::mt19937_64 random(static_cast<std::uint64_t>(100 + GetParam()));
  const std::string whole = original();
  for (int i = 0; i < kCases; ++i) read(whole.substr(0, random() % whole.size()), i % 2 == 0);
  test::record_sum("cut [1]", kCases);
  EXPECT_GT(counts_.read, test::least_of(0.01) * kCases);
  EXPECT_GT(counts_.refused, test::least_of(0.1) * kCases);
}

TEST_P(UffDamaged, Corrupted) {
  std::mt19937_64 random(static_cast<std::uint64_t>(200 + GetParam()));
  const std::string whole = original();
  for (int i = 0; i < kCases; ++i) read(corrupted(whole, random), i % 2 == 0);
  test::record_sum("changed [1]", kCases);
  EXPECT_GT(counts_.read, test::least_of(0.01) * kCases);
  EXPECT_GT(counts_.refused, test::least_of(0.1) * kCases);
}

/// A file cut anywhere gives the values it still has, never others.
TEST_P(UffDamaged, WhatIsLeftIsRight) {
  const std::string whole = original();
  const Recordings all = test::read_uff(whole);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    Recordings cut;
    try {
      cut = test::read_uff(whole.substr(0, size), true);
    } catch (const Error&) {
      continue;
    }
    std::size_t channel = 0;
    std::vector<Channel> expected;
    for (const Recording& r : all.recordings) {
      expected.insert(expected.end(), r.channels.begin(), r.channels.end());
    }
    for (const Recording& r : cut.recordings) {
      for (const Channel& c : r.channels) {
        ASSERT_LT(channel, expected.size());
        const std::vector<double>& values = expected[channel++].values;
        ASSERT_LE(c.values.size(), values.size());
        EXPECT_TRUE(std::equal(c.values.begin(), c.values.end(), values.begin())) << size;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, UffDamaged, ::testing::Range(0, 4));

}  // namespace
}  // namespace microslip::uff_damaged_test
