// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/progress.hpp"

namespace microslip::app {

/// A bar with the share done and the time left, on standard error. An empty function when standard
/// error is not a terminal or with `quiet`.
[[nodiscard]] Progress progress_bar(std::string what, bool quiet);

}  // namespace microslip::app
