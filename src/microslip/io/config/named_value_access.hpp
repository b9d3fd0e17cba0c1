// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/config/named_values.hpp"

/// @file
/// Value that a record of joint.json or calibration.json, its results or its options, has under a
/// name. What is of another kind counts as missing.

namespace microslip {

[[nodiscard]] std::optional<double> number_in(const NamedValues& record, std::string_view name);

[[nodiscard]] std::optional<std::string> text_in(const NamedValues& record, std::string_view name);

/// Empty where there is none.
[[nodiscard]] std::vector<double> numbers_in(const NamedValues& record, std::string_view name);

/// A JSON list of texts; empty where there is none.
[[nodiscard]] std::vector<std::string> texts_in(const NamedValues& record, std::string_view name);

}  // namespace microslip
