// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/model_parts.hpp"

#include <utility>

namespace microslip {

ModelFile make_model(ModalModel linear, DampingLaw law, std::vector<StructuralJoint> joints,
                     std::vector<JointSource> sources, DrivenPoints driven,
                     StructureSpread spread) {
  ModelFile model{
      JointedStructure(std::move(linear), std::move(joints), std::move(driven.excitations), law,
                       std::move(driven.static_loads)),
      std::move(driven.response),
      {}};
  for (JointSource& source : sources) {
    if (source.file.empty()) model.to_find.push_back(model.joint_files.size());
    model.joint_files.push_back(std::move(source.file));
    model.covered_to.push_back(source.covered_to);
    model.identified_damping.push_back(source.identified_damping);
    model.joint_samples.push_back(std::move(source.samples));
    model.damping_said.push_back(source.damping_said);
    spread.normal_load.push_back(source.normal_load_spread);
  }
  spread.force_gain = std::move(driven.gain_spreads);
  spread.response_gain = driven.response_gain_spread;
  model.spread = std::move(spread);
  model.force_channels = std::move(driven.channels);
  model.accelerometers = std::move(driven.accelerometers);
  return model;
}

}  // namespace microslip
