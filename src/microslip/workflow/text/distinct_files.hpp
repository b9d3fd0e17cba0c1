// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>

/// @file
/// A file that is given twice, by another name, too, counts twice.

namespace microslip {

/// The first of some files that is the same as another, links followed, and the same part of it or
/// one that holds the other: `F.mat:X` holds `F.mat:X(2)`.
/// @param before  files, or `FILE:VARIABLE`, as part_of_file() takes them; "-" is like no other.
[[nodiscard]] std::optional<std::string> same_file(std::span<const std::string> before,
                                                   const std::string& path);

/// @throws InputError  naming both where one is there twice.
void check_distinct_files(std::span<const std::string> paths);

}  // namespace microslip
