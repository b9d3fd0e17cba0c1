// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// @file
/// Marks by which a picture of gnuplot shows that microslip made it, where its format has a place
/// for the program. By them has_own_mark() knows pictures that may be replaced. What is no picture
/// of the form that gnuplot gives it stays as it is.

namespace microslip {

/// In `<desc>`. @param picture  of SVG.
void mark_svg(std::string& picture);

/// In a text Software. @param picture  of PNG.
void mark_png(std::string& picture);

/// In Producer, whose length stays. @param picture  of PDF.
void mark_pdf(std::string& picture);

}  // namespace microslip
