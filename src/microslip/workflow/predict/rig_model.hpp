// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/output/provenance.hpp"

namespace microslip {

/// The structure of a test rig with a joint.
struct RigModel {
  ModelFile file;                 ///< points named after the channels of the rig
  std::string text;               ///< of model.toml
  std::vector<Warning> warnings;  ///< also in the text
};

/// The model of a rig with a joint in its contact, without its text.
/// @param rig         rig.toml.
/// @param joint       joint.json.
/// @param joint_path  of it, as the model names it.
/// @param modes       of the beam.
/// @throws FormatError, InputError  as the readers.
[[nodiscard]] RigModel model_of_rig(const NamedInput& rig, const JointFile& joint,
                                    const std::string& joint_path, std::size_t modes);

/// Model of a rig from files, as above.
/// @param rig      path of rig.toml.
/// @param joint    path of joint.json; none of standard input, which a model cannot name.
/// @param out      where model.toml will lie: it names the joint from there.
/// @param modes    of the beam.
/// @param command  that it is made by.
/// @throws FileError, FormatError, InputError  as the readers; for names that no model can hold.
[[nodiscard]] RigModel model_of_rig(const std::string& rig, const std::string& joint,
                                    const std::string& out, std::size_t modes,
                                    std::string_view command);

}  // namespace microslip
