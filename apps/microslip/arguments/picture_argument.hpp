// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/report/drawing/gnuplot.hpp"

namespace microslip::app {

/// The format that a name calls for: .svg, .png or .pdf.
/// @param option  for the message. @throws InputError  where it ends otherwise.
[[nodiscard]] PictureFormat picture_format(std::string_view option, std::string_view path);

/// "svg", "png", "pdf".
[[nodiscard]] const char* ending_of(PictureFormat format);

/// Kind of such a file, for check_output().
[[nodiscard]] std::string_view kind_of(PictureFormat format);

}  // namespace microslip::app
