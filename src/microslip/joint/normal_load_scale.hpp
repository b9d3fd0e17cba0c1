// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/joint/joint.hpp"

namespace microslip {

/// The joint under another constant normal load, s times that of the given one. By Coulomb's law
/// every slip force is s times as large, and the stuck stiffness is unchanged:
///
///     φ_s(f*) = φ(f*/s)/s,     F_s(x) = s F(x/s),     D_s(A) = s² D(A/s),
///
/// so that over slip displacement the density of stiffness is ψ_s(x*) = ψ(x*/s)/s. NetworkMemory
/// gives the same under a constant normal load of that value.
/// @param joint  under the load at which it was identified.
/// @param scale  s, 1; > 0 and finite.
/// @throws InputError  where s is not.
[[nodiscard]] Joint with_normal_load(const Joint& joint, double scale);

}  // namespace microslip
