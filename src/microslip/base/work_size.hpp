// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

/// @file
/// What a call takes is known before it begins. A count of legal form can ask for more memory than
/// there is, or for days: it is refused before the work, with what is at fault, the bound and what
/// to do. Bounds are the same on every machine.

namespace microslip {

/// What a call may keep of what it makes, bytes: 1 GiB, which a computer of 4 GiB has beside
/// others.
inline constexpr double kMostMemory = 1024.0 * 1024.0 * 1024.0;

/// Steps in time: a good hour, at some 0.4 µs each of one mode and one joint.
inline constexpr double kMostTimeSteps = 1e10;

/// How many may be kept, at so many bytes each.
[[nodiscard]] std::size_t most_kept(double bytes_each);

/// Nothing where `count` of them can be kept.
/// @param what        as of InputError: "`draws`", "values of `amplitude`".
/// @param bytes_each  what each takes until it is written, its text in a table included.
/// @param remedy      a sentence: "Take fewer."
/// @throws InputError  for more than most_kept(): "`draws` = 2000; must be 1118 at most: each takes
///                     960000 bytes here, and the limit is 1 GiB. Take fewer."
void check_memory(std::string_view what, double count, double bytes_each, std::string_view remedy);

/// Nothing for kMostTimeSteps and less.
/// @param made_of  why they are so many: "1e+09 s in steps of 0.00046 s".
/// @throws InputError  for more.
void check_steps(std::string_view what, double count, std::string_view made_of,
                 std::string_view remedy);

}  // namespace microslip
