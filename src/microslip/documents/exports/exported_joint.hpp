// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/documents/exports/export_units.hpp"
#include "microslip/joint/jenkins_network.hpp"

namespace microslip {

inline constexpr std::size_t kLongestExportedName = 32;         ///< letters
inline constexpr std::size_t kLargestFirstNumber = 90'000'000;  ///< of nodes, elements, …

/// A Jenkins element in the units of an export.
struct ExportedSlider {
  double stiffness;          ///< κ, force/length; > 0
  double slip_force;         ///< force; > 0
  double slip_displacement;  ///< slip_force/κ, length
};

/// A joint as another program takes it: sliders and a spring in parallel, between two points.
struct ExportedJoint {
  std::string name;                     ///< of it there: a letter, then letters, digits and _
  std::vector<ExportedSlider> sliders;  ///< by rising slip displacement
  double spring;                        ///< stiffness of what never slips, force/length; ≥ 0
  ExportUnits units;                    ///< of all numbers
  std::size_t first_number = 1;  ///< of nodes, elements, materials or tags that are made; ≥ 1
  std::string remarks = {};      ///< lines that become comments
};

/// Forces of sliders are added in so many lanes, as NetworkMemory does, for the same last digits.
inline constexpr std::size_t kExportedLanes = 8;

/// The number of sliders filled up to whole groups of lanes; at least one group.
[[nodiscard]] std::size_t padded_sliders(const ExportedJoint& joint);

/// A network in the units of an export.
/// @param network  of sliders. @param name  of the joint there. @param units  to write.
/// @throws InputError  where the name is not as ExportedJoint has it or longer than 32 letters.
[[nodiscard]] ExportedJoint exported_joint(const JenkinsNetwork& network, std::string name,
                                           const ExportUnits& units);

/// A name made of any text: letters, digits and _ of it, "joint" where nothing is left.
[[nodiscard]] std::string name_in_exports(std::string_view text);

}  // namespace microslip
