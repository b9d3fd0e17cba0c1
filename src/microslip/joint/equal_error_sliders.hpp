// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>

#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/joint.hpp"

namespace microslip {

/// As few Jenkins elements as a joint can be taken for, and by how much they are wrong.
struct EqualErrorSliders {
  JenkinsNetwork network;  ///< of the elements, and of a spring where something never slips
  /// ε, the largest |F_n(x) − F(x)| up to the reach, N: of the force on first loading. A branch of
  /// a loop is 2F(x/2), so that it is off by up to 2ε more than the force it begins with.
  double error;
};

/// The n elements whose virgin curve, a line with a kink where each of them slips, deviates least
/// from F: within the band F ± ε with the smallest ε. Its kinks lie on F + ε and its lines touch
/// F − ε, so that all of them are wrong by as much and a kink every 4√(ε/|F″|) suffices, where
/// equal steps waste elements on what is nearly straight. The stiffness k of the stuck joint, the
/// elastic remainder and the macro-slip force are kept exactly, and so are the atoms of the
/// density. What slips beyond the reach is stuck there, and becomes a spring.
/// @param joint  any.
/// @param n      from 1 to 1e5, and above the number of atoms within reach where more than atoms
///               slip there. Fewer are made where they are exact.
/// @param reach  the largest |x|, m; > 0, infinite: any.
/// @throws InputError  for another n or reach.
[[nodiscard]] EqualErrorSliders equal_error_sliders(
    const Joint& joint, std::size_t n, double reach = std::numeric_limits<double>::infinity());

/// Atoms of a joint that slip at x up to a reach, m.
[[nodiscard]] std::size_t atoms_within(const Joint& joint, double reach);

/// The joint that a network is, its elements as atoms of the density: for all that is computed of a
/// joint.
[[nodiscard]] Joint joint_of(const JenkinsNetwork& network);

}  // namespace microslip
