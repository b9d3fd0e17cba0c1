// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"

/// @file
/// Texts cut short or with bytes changed at random, and what a reader may say of them.

namespace microslip::test {

inline constexpr int kDamagedCases = 10000;

/// Bytes that matter to the formats come more often than chance would have it.
inline char any_byte(std::mt19937_64& random) {
  static const std::string favourites = "\n\r\t ,;\"#[]{}:.+-eE0919nai\\/\xEF\xBB\xBF\xB5\xFF";
  const std::uint64_t choice = random();
  return choice % 3 == 0 ? static_cast<char>(choice >> 32U)
                         : favourites[(choice >> 8U) % favourites.size()];
}

inline std::string damaged(std::string text, std::mt19937_64& random) {
  const auto position = [&] { return random() % (text.size() + 1); };
  for (std::uint64_t n = 1 + random() % 4; n > 0; --n) {
    const std::size_t at = position();
    switch (random() % 6) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text.erase(at, random() % 20);
        break;
      case 2:
        text.insert(at, 1, any_byte(random));
        break;
      case 3:
        text.insert(at, text.substr(position(), random() % 60));
        break;
      default:
        if (at < text.size()) text[at] = any_byte(random);
    }
  }
  return text;
}

/// A message of one line that names the file.
inline void expect_clear(const std::string& message, const std::string& file) {
  EXPECT_EQ(message.substr(0, file.size()), file) << message;
  EXPECT_LT(message.size(), 500U) << message;
  EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20;
  })) << message;
}

struct Counts {
  int read = 0;
  int refused = 0;
};

/// Hands texts damaged at random to `read`, which checks what it can read of them. What it refuses
/// it refuses with a clear message that begins with `file`; some are read and many refused.
template <class Read>
Counts damage(const std::string& original, std::uint64_t seed, const std::string& file,
              const Read& read) {
  Counts counts;
  std::mt19937_64 random(seed);
  const int cases = cases_of(kDamagedCases);
  for (int i = 0; i < cases; ++i) {
    const std::string text = damaged(original, random);
    (void)file_kind(text);
    try {
      read(text);
      ++counts.read;
    } catch (const Error& error) {
      ++counts.refused;
      expect_clear(error.what(), file);
    }
  }
  record_sum("cases [1]", cases);
  EXPECT_GT(counts.read, least_of(0.01) * cases);
  EXPECT_GT(counts.refused, least_of(0.1) * cases);
  return counts;
}

}  // namespace microslip::test
