// SPDX-License-Identifier: MIT
#include "microslip/io/warning_comment.hpp"

#include <fmt/format.h>

#include "microslip/io/csv_cells.hpp"

namespace microslip {

std::string warning_comment(const Warning& warning) {
  return fmt::format("warning: {}: {}", warning.code, on_one_line(warning.text));
}

}  // namespace microslip
