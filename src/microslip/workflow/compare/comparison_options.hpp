// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "microslip/workflow/compare/comparison_reading.hpp"
#include "microslip/workflow/compare/tests_verification_options.hpp"

/// @file
/// Options of a verification that no test of it uses are refused, not ignored. Internal to
/// workflow.

namespace microslip {

/// Which options tests use:
///
///     sensors                              recordings of ring-downs
///     modes                                ring-downs, and one test at least each of them
///     channels, joint                      records of force and displacement; joint by a model
///     reading (assumed units, truncated)   recordings
///     harmonics, correlation               tests of the structure: sweeps and ring-downs
///
/// @param options  of the call.
/// @param read     its tests.
/// @throws InputError  naming the first that no test uses, what it is for, and what the tests are.
void check_test_options(const TestsVerification& options, std::span<const ReadTest> read);

/// Checks independent of the tests: a single joint does not use the name of one, nor a model what
/// is uncertain, which it says in its file.
/// @param alone  whether a joint by itself predicts. @throws InputError  naming the option.
void check_predictor_options(const TestsVerification& options, bool alone);

}  // namespace microslip
