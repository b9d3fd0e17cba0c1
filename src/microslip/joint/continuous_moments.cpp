// SPDX-License-Identifier: MIT
#include "microslip/joint/continuous_moments.hpp"

#include <cstddef>

namespace microslip {

PartialMoments continuous_moments(const SlipDensity& density, double s) {
  PartialMoments m = density.moments(s);
  const AtomsPart& atoms = density.atoms();
  for (std::size_t i = 0; i < atoms.slip_force.size() && atoms.slip_force[i] <= s; ++i) {
    const double f = atoms.slip_force[i];
    m.zeroth -= atoms.weight[i];
    m.first -= atoms.weight[i] * f;
    m.second -= atoms.weight[i] * f * f;
  }
  return m;
}

}  // namespace microslip
