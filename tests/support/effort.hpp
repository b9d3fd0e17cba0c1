// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <limits>

/// @file
/// Work that a test need not do each time: all draws of a statistic, or under the sanitizers, where
/// everything takes five to ten times as long, the work that another test does as well.

/// Where the address sanitizer is linked, and nowhere else. A test asks when it runs, not when it
/// is compiled: the sanitized build links the objects of the release build with a library of its
/// own.
extern "C" void __asan_init() __attribute__((weak));

/// Ends a test whose code another one runs under the sanitizers, too, in less time. It counts as
/// skipped.
#define MICROSLIP_OF_RELEASE_ALONE()    \
  if (!::microslip::test::kSanitized) { \
  } else /* NOLINT */                   \
    GTEST_SKIP() << "of the release build alone"

/// Ends a test of a statistic that needs many draws, or one whose code another test runs in less
/// time, but in scripts/test_studies. It counts as skipped.
#define MICROSLIP_STUDY()                \
  if (::microslip::test::in_studies()) { \
  } else /* NOLINT */                    \
    GTEST_SKIP() << "a study, run by scripts/test_studies"

namespace microslip::test {

inline const bool kSanitized = &__asan_init != nullptr;

/// Whether statistics are taken of all their draws: scripts/test_studies and
/// scripts/update_validation set MICROSLIP_STUDIES.
inline bool in_studies() { return !kSanitized && std::getenv("MICROSLIP_STUDIES") != nullptr; }

/// Draws of a statistic: as many as it needs in the studies, else one or `fewer`, which run the
/// code that all of them run.
inline std::uint64_t draws_of(std::uint64_t needed, std::uint64_t fewer = 1) {
  return in_studies() ? needed : kSanitized ? 1 : fewer;
}

/// Number of damaged files and the like, each of which is judged by itself: all in the studies and
/// under the sanitizers, which see most in them, else a fifth.
inline int cases_of(int all) { return in_studies() || kSanitized ? all : all / 5; }

/// The upper bound of a statistic of draws_of(): three times as much for few
/// draws, which scatter, none under the sanitizers. Bounds of each draw are judged everywhere.
inline double bound_of(double bound) {
  if (kSanitized) return std::numeric_limits<double>::infinity();
  return in_studies() ? bound : 3.0 * bound;
}

/// The lower bound, of a share that is reached: a third of it for few draws.
inline double least_of(double share) {
  if (kSanitized) return 0.0;
  return in_studies() ? share : share / 3.0;
}

}  // namespace microslip::test
