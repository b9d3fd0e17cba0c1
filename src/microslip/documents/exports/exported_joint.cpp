// SPDX-License-Identifier: MIT
#include "microslip/documents/exports/exported_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_of_name(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

ExportedJoint exported_joint(const JenkinsNetwork& network, std::string name,
                             const ExportUnits& units) {
  const bool fits = !name.empty() && name.size() <= kLongestExportedName &&
                    is_letter(name.front()) && std::ranges::all_of(name, is_of_name);
  if (!fits) {
    throw InputError("`name`", name,
                     fmt::format("must be a letter, then letters, digits and _, {} at most",
                                 kLongestExportedName));
  }
  const double stiffness_unit = units.newtons / units.metres;
  ExportedJoint joint{.name = std::move(name),
                      .sliders = {},
                      .spring = network.elastic_stiffness() / stiffness_unit,
                      .units = units};
  for (std::size_t i = 0; i < network.size(); ++i) {
    const double stiffness = network.stiffness()[i];
    const double slip = network.slip_displacement()[i];
    joint.sliders.push_back(
        {stiffness / stiffness_unit, stiffness * slip / units.newtons, slip / units.metres});
  }
  return joint;
}

std::size_t padded_sliders(const ExportedJoint& joint) {
  const std::size_t groups = (joint.sliders.size() + kExportedLanes - 1) / kExportedLanes;
  return std::max<std::size_t>(1, groups) * kExportedLanes;
}

std::string name_in_exports(std::string_view text) {
  std::string name;
  for (const char c : text) name += is_of_name(c) ? c : '_';
  const auto first = std::ranges::find_if(name, is_letter);
  name.erase(name.begin(), first);
  if (name.size() > kLongestExportedName) name.resize(kLongestExportedName);
  return name.empty() ? "joint" : name;
}

}  // namespace microslip
