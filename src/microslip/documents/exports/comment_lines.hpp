// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/documents/exports/exported_joint.hpp"

namespace microslip {

/// The remarks of a joint as comments, a line each, and a line that names the target, by which the
/// file is known again.
/// @param begin   of a comment in this language: "** ". @param target  of the export.
/// @param end     of each line: " */"; mostly empty.
[[nodiscard]] std::string comment_lines(const ExportedJoint& joint, std::string_view begin,
                                        std::string_view target, std::string_view end = {});

}  // namespace microslip
