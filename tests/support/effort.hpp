// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

/// @file
/// What a test need not do under the sanitizers, where everything takes five to ten times as long.

/// Ends a test of a statistic, or of bytes that are compared: it runs the same code hundreds of
/// times, which another test runs under the sanitizers, and its figure is that of the release
/// build. It counts as skipped.
#ifdef __SANITIZE_ADDRESS__
#define MICROSLIP_OF_RELEASE_ALONE() GTEST_SKIP() << "of the release build alone"
#else
#define MICROSLIP_OF_RELEASE_ALONE() static_cast<void>(0)
#endif

namespace microslip::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Draws of a statistic: as many as it needs, or one under the sanitizers, by which the code is run
/// that all of them run.
constexpr std::uint64_t draws_of(std::uint64_t needed) { return kSanitized ? 1 : needed; }

/// The bound that a statistic of draws_of() is held to: none under the sanitizers. What holds for
/// each draw is judged in both builds.
constexpr double bound_of(double bound) {
  return kSanitized ? std::numeric_limits<double>::infinity() : bound;
}

}  // namespace microslip::test
