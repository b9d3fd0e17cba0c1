// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/joint_draws.hpp"

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void read_levels(const Identification& found, const InvertedDensity& inverted,
                 JointSamples& samples) {
  const InversionResult& result = inverted.result;
  const double k = found.joint.stiffness();
  samples.method = "posterior of levels";
  for (const double f : result.slip_force) samples.slip_displacement.push_back(f / k);
  if (result.atom_slip_force) samples.atom_slip_displacement = *result.atom_slip_force / k;
  for (const DensitySample& draw : inverted.samples) {
    samples.stiffness.push_back(k);
    for (const double phi : draw.density) samples.stiffness_density.push_back(k * k * phi);
    if (result.atom_slip_force) samples.atom_weight.push_back(draw.atom_weight);
    if (result.linear_damping) samples.linear_damping.push_back(draw.linear_damping);
  }
}

void read_draws_of_records(const RecordInversionResult& result, JointSamples& samples) {
  samples.method = "posterior of records";
  samples.slip_displacement = result.slip_displacement;
  for (const StiffnessDraw& draw : result.draws) {
    samples.stiffness.push_back(draw.stiffness);
    samples.stiffness_density.insert(samples.stiffness_density.end(), draw.density.begin(),
                                     draw.density.end());
    if (result.viscous) samples.viscous.push_back(draw.viscous);
  }
}

}  // namespace

JointSamples joint_samples(const Identification& found, const Provenance& provenance) {
  JointSamples samples;
  samples.seed = provenance.seed.value_or(0);
  samples.provenance = provenance;
  if (const auto* inverted = std::get_if<InvertedDensity>(&found.free)) {
    read_levels(found, *inverted, samples);
  } else if (const RecordInversionResult* records = found.records()) {
    read_draws_of_records(*records, samples);
  }
  if (samples.size() == 0) {
    throw InputError("draws of the density", "none", "must be 1 or more to be written",
                     "Identify the joint with `samples`.");
  }
  return samples;
}

}  // namespace microslip
