// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_loads.hpp"

#include <algorithm>

#include "microslip/dynamics/march/march_loops.hpp"
#include "microslip/dynamics/march/march_weights.hpp"
#include "microslip/dynamics/structure/static_equilibrium.hpp"

namespace microslip {

MarchLoads::MarchLoads(const JointedStructure& structure, const LoadHistory& loads)
    : history_(loads) {
  const std::size_t lanes = padded(structure.linear().size());
  for (const PointForce& at : loads.forces) {
    const auto shape = structure.linear().load(at.point);
    shapes_.emplace_back(shape.begin(), shape.end()).resize(lanes, 0.0);
  }
  for (const JointNormalLoad& given : loads.normal_loads) {
    const auto joint = std::ranges::find(structure.joints(), given.joint, &StructuralJoint::name);
    joints_.push_back(static_cast<std::size_t>(joint - structure.joints().begin()));
  }
  if (structure.static_loads().empty()) return;
  static_load_ = structure.static_modal_load();
  static_load_.resize(lanes, 0.0);
  std::vector<double> normal(structure.joints().size(), 1.0);
  for (std::size_t n = 0; n < joints_.size(); ++n) {
    normal[joints_[n]] = loads.normal_loads[n].load.front();
  }
  equilibrium_ = static_equilibrium(structure, normal).modal;
}

InitialState MarchLoads::start(InitialState asked) const {
  if (!equilibrium_.empty()) asked.displacement = equilibrium_;
  return asked;
}

void MarchLoads::set(std::size_t interval, MarchState::Loads& loads) const {
  const double length = history_.time[interval + 1] - history_.time[interval];
  double kept = 0.0;
  const auto add = [&](const std::vector<double>& shape, double value, double slope) {
    march_loops::add_force(shape.size() / kLanes, kept, shape.data(), value, slope,
                           loads.force.data(), loads.slope.data());
    kept = 1.0;
  };
  if (!static_load_.empty()) add(static_load_, 1.0, 0.0);
  for (std::size_t p = 0; p < shapes_.size(); ++p) {
    const double* values = history_.forces[p].force.data() + interval;
    add(shapes_[p], values[0], (values[1] - values[0]) / length);
  }
  for (std::size_t n = 0; n < joints_.size(); ++n) {
    const double* values = history_.normal_loads[n].load.data() + interval;
    loads.normal[joints_[n]] = values[0];
    loads.normal_slope[joints_[n]] = (values[1] - values[0]) / length;
  }
}

std::vector<MarchedJoint> marched_joints(const JointedStructure& structure,
                                         const LoadHistory& loads, std::size_t elements) {
  std::vector<MarchedJoint> result;
  for (const StructuralJoint& joint : structure.joints()) {
    const auto load = std::ranges::find(loads.normal_loads, joint.name, &JointNormalLoad::joint);
    if (load == loads.normal_loads.end()) {
      result.emplace_back(joint);
    } else {
      result.emplace_back(joint, load->law, elements, load->load.front());
    }
  }
  return result;
}

}  // namespace microslip
