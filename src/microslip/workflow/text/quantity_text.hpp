// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"

/// @file
/// Values as people write them: on a command line, in the options that a file records.

namespace microslip {

/// Parts of a text between its separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// Whether the text is a number with a unit of this dimension.
[[nodiscard]] bool is_quantity(std::string_view text, const Dimension& dimension);

/// A number, with or without a unit right behind it: "3e-4", "300um", "0.3mm". Without one it is
/// SI.
/// @param option  for messages, for instance "`amplitude`".
/// @throws InputError  where it is neither, or the unit is of another dimension.
[[nodiscard]] double parse_quantity(std::string_view option, std::string_view text,
                                    const Dimension& dimension);

/// A unit alone. @throws InputError  naming the option, where it is unknown or of another
/// dimension.
[[nodiscard]] Unit parse_option_unit(std::string_view option, std::string_view text,
                                     const Dimension& dimension);

/// A whole number in digits. @throws InputError  where it is none, or outside of the range.
[[nodiscard]] std::uint64_t parse_whole_number(std::string_view option, std::string_view text,
                                               std::uint64_t from, std::uint64_t to,
                                               std::string_view remedy = {});

/// FROM:TO. @throws InputError  where it has another form, or FROM is not below TO.
[[nodiscard]] std::pair<double, double> parse_interval(std::string_view option,
                                                       std::string_view text,
                                                       const Dimension& dimension);

/// FROM:TO, in either order. @throws InputError  where it has another form, or both are the same.
[[nodiscard]] std::pair<double, double> parse_ends(std::string_view option, std::string_view text,
                                                   const Dimension& dimension);

/// Values between commas, or FROM:TO:COUNT[:log] as in parse_range().
/// @throws InputError  where one is none.
[[nodiscard]] std::vector<double> parse_values(std::string_view option, std::string_view text,
                                               const Dimension& dimension);

/// FROM:TO:COUNT[:log]: COUNT values from FROM to TO, equally spaced or in equal ratios.
/// @throws InputError  where it has another form, FROM is not below TO, COUNT is no whole number
///                     from 2 to 10 million, or `log` comes with FROM = 0 or less.
[[nodiscard]] std::vector<double> parse_range(std::string_view option, std::string_view text,
                                              const Dimension& dimension);

/// A displacement, m, of something that vibrates.
/// @throws InputError  beyond 1e-15 to 1e6 m, where products leave the range of doubles.
void check_displacement(std::string_view option, double displacement);

}  // namespace microslip
