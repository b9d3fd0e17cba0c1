// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/io/recording_file.hpp"  // where it was once
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/joint.hpp"

/// Uses parts that need fmt, TBB, HDF5 and zlib, so that all of them must be found.
int main() {
  const auto joint = microslip::Joint::four_parameter(400.0, 1.7e5, -0.5, 1.0);
  microslip::Levels levels;
  for (double amplitude = 2e-5; amplitude < 2e-3; amplitude *= 1.2) {
    levels.amplitude.push_back(amplitude);
    levels.dissipation.push_back(microslip::dissipation(joint, amplitude));
  }
  std::printf("area = %.3f\n", microslip::invert(levels, joint.stiffness()).area);
  try {
    static_cast<void>(microslip::read_recordings("absent.h5", {}));
  } catch (const microslip::FileError& error) {
    std::printf("%s\n", error.what());
  }
}
