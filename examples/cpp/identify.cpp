#include <cstdio>

#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/joint/dissipation.hpp"

int main() {
  using namespace microslip;
  const Joint truth =
      Joint::four_parameter(400.0, 252660.0, -0.5, 1.0);  // F_S [N], K_T [N/m], χ, β
  Levels levels;
  for (double amplitude = 20e-6; amplitude < 2.2e-3; amplitude *= 1.1) {  // m
    levels.amplitude.push_back(amplitude);
    levels.dissipation.push_back(dissipation(truth, amplitude));  // J per cycle
  }
  const InversionResult found = invert(levels, truth.stiffness());
  std::printf("%s\n%.3f of the stiffness slips\n", found.summary.brief().c_str(), found.area);
}
