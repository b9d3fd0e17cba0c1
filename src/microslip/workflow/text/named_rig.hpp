// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/rig/reduction/reduction_batch.hpp"

/// @file
/// Errors that name the files of a test. Internal to workflow.

namespace microslip {

[[nodiscard]] inline Rig parse_rig(const NamedInput& rig) {
  return parse_rig(rig.text, input_name(rig.path));
}

/// Errors that only solving the rig can find, such as a stick frequency out of reach, name the file
/// too.
template <typename Make>
auto of_rig(const NamedInput& rig, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", input_name(rig.path), rig_key(error.name())));
  }
}

/// @param done  "reduced": what was to be done with the recordings.
/// @throws InputError  where that left none.
inline void check_any_left(std::string_view done, std::size_t files, std::size_t left,
                           const std::vector<RejectedRecord>& rejected) {
  if (left > 0) return;
  throw InputError("recordings", fmt::format("{} files", files),
                   fmt::format("must include one that can be {}", done),
                   rejected.empty() ? "" : rejected.front().reason);
}

}  // namespace microslip
