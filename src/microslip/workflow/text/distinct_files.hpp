// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/io/config/named_values.hpp"

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

/// Warnings `same_content`, one for each file that holds what one before it does under another
/// name: "copy.csv has the same content as a.csv: the test counts twice."
/// @param files  paths with the SHA-256 of what they hold; one without it is like no other, and so
///               is a part of a file, `FILE:VARIABLE`.
/// @param what   that counts twice: "the test".
[[nodiscard]] std::vector<Warning> same_content_warnings(std::span<const InputHash> files,
                                                         std::string_view what);

}  // namespace microslip
