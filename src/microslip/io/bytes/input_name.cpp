// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/input_name.hpp"

namespace microslip {

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace microslip
