// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/io/config/json_input.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// Records as JSON. Internal to io: no public header includes it.

namespace microslip {

[[nodiscard]] NamedValues read_named_values(const Json& object);

/// Values that are not of the form of Provenance go to its `other`.
[[nodiscard]] Provenance read_provenance(const Json& object);

/// Appends a JSON string.
void append_string(std::string& text, std::string_view value);

/// Appends a JSON array on one line.
void append_numbers(std::string& text, const std::vector<double>& values);

/// Appends a JSON object, one entry per line.
/// @throws InputError  where a number is not finite, a JsonText is no JSON, or a name comes twice.
void append_named_values(std::string& text, const NamedValues& record, std::string_view indent);

/// The entries of a provenance in their order, `other` last.
[[nodiscard]] NamedValues provenance_values(const Provenance& provenance);

}  // namespace microslip
