// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"

namespace microslip::test {

inline constexpr int kDamagedFiles = 10000;

/// Fewer where each file takes a process of its own, a fifth of these but in the studies, under the
/// sanitizers, too, whose processes start slowly; all of them where MICROSLIP_ALL_DAMAGED_FILES is
/// set.
inline int damaged_files(int fewer) {
  if (!in_studies()) fewer /= 5;
  return std::getenv("MICROSLIP_ALL_DAMAGED_FILES") == nullptr ? fewer : kDamagedFiles;
}

/// The message is one line that names the file.
inline void expect_named(const std::string& message, const std::string& path) {
  EXPECT_NE(message.find(path.substr(path.rfind('/') + 1)), std::string::npos) << message;
  EXPECT_LT(message.size(), 700U) << message;
  EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20;
  })) << message;
}

/// Calls read() for the content: it must return or throw a clear Error; true where it returns.
template <class Read>
bool survives(const std::string& path, const std::string& content, const Read& read) {
  put(path, content);
  try {
    read();
    return true;
  } catch (const Error& error) {
    expect_named(error.what(), path);
    return false;
  }
}

/// Reads the file cut short at that many random places. Few of the cuts may leave a whole file.
template <class Read>
void read_cut(const std::string& path, std::uint64_t seed, const Read& read,
              int files = cases_of(kDamagedFiles)) {
  const std::string whole = get(path);
  std::mt19937_64 random(seed);
  int taken = 0;
  for (int i = 0; i < files; ++i) {
    taken += survives(path, whole.substr(0, random() % whole.size()), read) ? 1 : 0;
  }
  record_sum("cut [1]", files);
  EXPECT_LT(taken, bound_of(0.05) * files);
  put(path, whole);
  read();
}

/// Reads the file that often with one to three bytes changed at random.
template <class Read>
void read_changed(const std::string& path, std::uint64_t seed, const Read& read,
                  int files = cases_of(kDamagedFiles)) {
  const std::string whole = get(path);
  std::mt19937_64 random(seed);
  int refused = 0;
  for (int i = 0; i < files; ++i) {
    std::string content = whole;
    for (std::uint64_t n = 1 + random() % 3; n > 0; --n) {
      const std::uint64_t choice = random();
      // Small numbers and single bits hurt sizes and types more than chance does.
      char& byte = content[random() % content.size()];
      byte = choice % 3 == 0   ? static_cast<char>(choice >> 32U)
             : choice % 3 == 1 ? static_cast<char>(byte ^ (1 << (choice >> 8U) % 8))
                               : static_cast<char>((choice >> 8U) % 20);
    }
    refused += survives(path, content, read) ? 0 : 1;
  }
  record_sum("changed [1]", files);
  EXPECT_GT(refused, least_of(0.05) * files);
}

}  // namespace microslip::test
