// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/documents/structure/model_file.hpp"

/// @file
/// Restrictions on a model in uses other than prediction.

namespace microslip {

/// @param model  of the file `path`. @param who  "reduce", for the message.
/// @throws InputError  where the accelerations of a base drive it.
void require_driven_by_forces(const ModelFile& model, const std::string& path,
                              const std::string& who);

/// @param model, path, who  as above.
/// @throws InputError  where static loads act, about which cycles are not symmetric.
void require_no_static_loads(const ModelFile& model, const std::string& path,
                             const std::string& who);

}  // namespace microslip
