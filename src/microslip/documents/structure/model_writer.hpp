// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/documents/structure/model_file.hpp"

namespace microslip {

/// The text of a model.toml that parse_model() reads back as the same model, but for the rounding
/// of ω/2π. The joint files are named as in `model.joint_files`, and
/// a joint without one by its stiffness; they are not written. Linear
/// damping of a joint is left out only where it is 0 and `identified_damping` shows that its file
/// has none.
/// @param model    has one joint file per joint.
/// @param comment  the first lines; may be empty.
/// @throws InputError  where the number of joint files is not that of the joints.
[[nodiscard]] std::string format_model(const ModelFile& model, std::string_view comment = "");

}  // namespace microslip
