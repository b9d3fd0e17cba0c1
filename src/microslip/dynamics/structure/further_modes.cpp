// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/further_modes.hpp"

#include <cstddef>
#include <utility>

namespace microslip {
namespace {

/// Γ of a joint between the previous modes, with rows and columns of 0 for the added ones.
std::vector<double> padded(const std::vector<double>& shortening, std::size_t before,
                           std::size_t after) {
  if (shortening.empty()) return {};
  std::vector<double> rows(after * after, 0.0);
  for (std::size_t i = 0; i < before; ++i) {
    for (std::size_t j = 0; j < before; ++j) rows[i * after + j] = shortening[i * before + j];
  }
  return rows;
}

ModalModel extended(const ModalModel& linear, const std::vector<FurtherMode>& further) {
  std::vector<Mode> modes(linear.modes().begin(), linear.modes().end());
  std::vector<ModalPoint> points(linear.points().begin(), linear.points().end());
  std::vector<ModalBase> bases(linear.bases().begin(), linear.bases().end());
  for (const FurtherMode& each : further) {
    modes.push_back(each.mode);
    for (std::size_t p = 0; p < points.size(); ++p) points[p].shape.push_back(each.points[p]);
    for (std::size_t b = 0; b < bases.size(); ++b) {
      bases[b].participation.push_back(each.participation.empty() ? 0.0 : each.participation[b]);
    }
  }
  return {std::move(modes), std::move(points), std::move(bases),
          linear.static_modes() + further.size()};
}

}  // namespace

JointedStructure with_further_modes(const JointedStructure& structure,
                                    const std::vector<FurtherMode>& modes) {
  if (modes.empty()) return structure;
  ModalModel linear = extended(structure.linear(), modes);
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    for (const FurtherMode& each : modes) joints[j].shape.push_back(each.joints[j]);
    joints[j].shortening = padded(joints[j].shortening, structure.linear().size(), linear.size());
  }
  return {std::move(linear),
          std::move(joints),
          {structure.excitations().begin(), structure.excitations().end()},
          structure.damping(),
          {structure.static_loads().begin(), structure.static_loads().end()}};
}

}  // namespace microslip
