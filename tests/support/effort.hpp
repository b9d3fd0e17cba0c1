// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

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
