// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip {

/// The text of a TOML file with a number of it changed.
/// @param text   of the file.
/// @param file   its name, for messages.
/// @param path   of the number, elements of arrays from 0: "structure.loss_factor[1]".
/// @param value  that it gets.
/// @throws FormatError  where the text is no TOML. @throws InputError  naming file and path, where
///                      there is no number.
[[nodiscard]] std::string toml_with_number(std::string_view text, std::string_view file,
                                           const std::string& path, double value);

/// Changes a number of a JSON file, as above.
/// @param text, file, path, value  as above.
/// @throws FormatError, InputError  as above.
[[nodiscard]] std::string json_with_number(std::string_view text, std::string_view file,
                                           const std::string& path, double value);

}  // namespace microslip
