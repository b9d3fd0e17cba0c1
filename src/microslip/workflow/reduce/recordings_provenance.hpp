// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/output/provenance.hpp"

/// @file
/// Provenance of a table of levels: the recordings it was made from. Internal to workflow.

namespace microslip {

/// Version, call, and digests of what was read. That of many recordings is what
/// `sha256sum RECORDINGS | sha256sum` says.
/// @param test        what describes it: rig.toml.
/// @param recordings  paths as asked for. @param digests  one each; some may be empty.
[[nodiscard]] std::string recordings_provenance(const std::string& command, const NamedInput& test,
                                                const std::vector<std::string>& recordings,
                                                const std::vector<std::string>& digests);

/// Warnings `same_content` of such recordings.
[[nodiscard]] std::vector<Warning> copied_recordings(const std::vector<std::string>& recordings,
                                                     const std::vector<std::string>& digests);

}  // namespace microslip
