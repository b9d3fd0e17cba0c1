// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/io/recordings/mat_tree.hpp"
#include "microslip/io/recordings/recordings.hpp"

namespace microslip {

/// The recordings in a tree, see mat_recording.hpp. Takes the numbers out of it.
[[nodiscard]] Recordings recordings_of(MatValue& root, std::string_view variable,
                                       const std::string& path,
                                       const RecordingReadOptions& options);

/// Did microslip write this struct?
[[nodiscard]] bool is_own_recording(MatValue& value, std::size_t element);
[[nodiscard]] Recording own_recording(MatValue& value, std::size_t element,
                                      const std::string& place);

}  // namespace microslip
