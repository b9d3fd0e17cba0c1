// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

/// @file
/// Limits on the size of a call, checked before it begins. A valid count can require more memory
/// than there is, or days of computing: it is refused before the work, with the cause, the bound
/// and the remedy. Bounds are the same on every machine.

namespace microslip {

/// The most memory that a call may keep for its results, bytes: 1 GiB, which a computer with 4 GiB
/// can spare.
inline constexpr double kMostMemory = 1024.0 * 1024.0 * 1024.0;

/// The most time steps: a good hour, at some 0.4 µs each for one mode and one joint.
inline constexpr double kMostTimeSteps = 1e10;

/// The largest number of items of `bytes_each` that may be kept.
[[nodiscard]] std::size_t most_kept(double bytes_each);

/// Checks that `count` items can be kept.
/// @param what        as for InputError: "`draws`", "values of `amplitude`".
/// @param bytes_each  memory of each until it is written, its text in a table included.
/// @param remedy      a sentence: "Take fewer."
/// @throws InputError  for more than most_kept(): "`draws` = 2000; must be 1118 at most: each takes
///                     960000 bytes here, and the limit is 1 GiB. Take fewer."
void check_memory(std::string_view what, double count, double bytes_each, std::string_view remedy);

/// Checks that there are at most kMostTimeSteps.
/// @param made_of  the origin of the count: "1e+09 s in steps of 0.00046 s".
/// @throws InputError  for more.
void check_steps(std::string_view what, double count, std::string_view made_of,
                 std::string_view remedy);

}  // namespace microslip
