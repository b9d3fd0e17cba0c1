// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "microslip/io/uff/uff_envelope.hpp"

/// @file
/// Dataset 164, "units". Internal to io.

namespace microslip {

/// The system of units of the datasets that follow: SI = value in the file / factor.
struct Uff164 {
  std::int64_t code = 1;  ///< 1 SI, 2…8 other systems, 9 the user's own
  std::string description;
  double length = 1.0;  ///< units of length in a metre
  double force = 1.0;   ///< units of force in a newton
};

/// @throws FormatError  where a factor is not above 0.
[[nodiscard]] Uff164 read_uff164(UffEnvelope& envelope);

/// SI: metre, newton, kelvin.
[[nodiscard]] std::string format_uff164_si();

}  // namespace microslip
