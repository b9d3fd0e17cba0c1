// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "microslip/io/recordings/recordings.hpp"
#include "microslip/io/uff/uff55.hpp"

namespace microslip {

/// Contents of a file of recordings, on lines of at most 60 columns: of each recording its size and
/// rate, of each channel quantity, unit, root mean square, least and greatest value (of a complex
/// one those of its magnitude), and what the file says of them.
[[nodiscard]] std::string list_recordings(const Recordings& recordings);

/// Mode shapes of a universal file, on lines of at most 60 columns: number, frequency,
/// damping and number of nodes of each. Nothing where it has none.
[[nodiscard]] std::string list_mode_shapes(std::span<const UffModeShape> shapes);

}  // namespace microslip
