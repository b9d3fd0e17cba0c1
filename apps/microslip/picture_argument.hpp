// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/report/gnuplot.hpp"

namespace microslip::app {

/// The format that a name calls for: .svg, .png or .pdf.
/// @param option  for the message. @throws InputError  where it ends otherwise.
[[nodiscard]] PictureFormat picture_format(std::string_view option, std::string_view path);

}  // namespace microslip::app
