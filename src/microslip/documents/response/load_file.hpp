// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/dynamics/march/march.hpp"
#include "microslip/io/tables/table_column.hpp"
#include "microslip/joint/jenkins_network.hpp"

/// @file
/// Load histories of a structure as a table:
///
///     time [s]                  rising, even or not
///     force [N]                 at the excitation of the model, of which there is one
///     force at POINT [N]        at a point of the model
///     acceleration of BASE [m/s^2]  of a base of the model
///     normal_load [1]           p = P_N/P_0 of the joint, where there is one; optional
///     normal_load of JOINT [1]  of a joint of the model; optional
///
/// with at least one column of a force or an acceleration. Other columns are left alone.

namespace microslip {

/// Loads from the text of their table.
/// @param text       the file's whole text.
/// @param file       its name, for messages.
/// @param structure  its points, excitations and joints.
/// @param law        of joints whose normal load is given.
/// @throws FormatError  at the cell or column that breaks a rule.
[[nodiscard]] LoadHistory parse_loads(std::string text, std::string_view file,
                                      const JointedStructure& structure,
                                      NormalLoadLaw law = NormalLoadLaw::kIncremental);

/// parse_loads() of a file; "-" is standard input. @throws FileError, FormatError
[[nodiscard]] LoadHistory read_loads(const std::string& path, const JointedStructure& structure,
                                     NormalLoadLaw law = NormalLoadLaw::kIncremental);

/// The column of one of the loads; "force" where it is the only one, at a point.
/// @param structure  whose bases may accelerate.
/// @param loads      that act.
/// @param at         one of them.
[[nodiscard]] TableColumn load_column(const JointedStructure& structure, const LoadHistory& loads,
                                      const PointForce& at);

/// The table that parse_loads() reads back, without normal loads.
/// @param loads      that act.
/// @param structure  that they act on.
/// @param comment    its first lines; may be empty.
[[nodiscard]] std::string format_loads(const LoadHistory& loads, const JointedStructure& structure,
                                       std::string_view comment);

}  // namespace microslip
