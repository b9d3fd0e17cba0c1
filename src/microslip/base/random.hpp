// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace microslip {

/// Counter-based random numbers (Philox 4x64 of Random123, Salmon et al., SC'11): a pure function
/// of (seed, stream, index), so that sample i of seed s is the same on one thread or a thousand.
class RandomStream {
 public:
  /// @param seed    chosen by the user.
  /// @param stream  the number of the sample or record; streams of one seed are independent.
  RandomStream(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}

  /// Uniform on the open interval (0, 1); the next number of the stream.
  double uniform();

  /// Standard normal (mean 0, variance 1) by Box–Muller; the next number of the stream.
  double normal();

 private:
  std::uint64_t next();

  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t counter_ = 0;
  std::uint64_t block_[4] = {};
  int left_ = 0;
  double spare_normal_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace microslip
