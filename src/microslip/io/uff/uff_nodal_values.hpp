// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_mode_shape.hpp"

/// @file
/// Common to the datasets 55 and 2414. Internal to io.

namespace microslip {

/// Finite numbers in fields of 13 columns, over as many lines as they need. @param what  they are.
[[nodiscard]] std::vector<double> read_uff_numbers(UffEnvelope& envelope, std::size_t count,
                                                   std::string_view what);

/// A field of ten columns. @throws FormatError  where it is not from 0 to `largest`.
[[nodiscard]] std::size_t read_uff_count(UffFields& fields, std::int64_t largest,
                                         std::string_view what, const TextPlace& place);

/// The nodes with their values, up to the end of the dataset.
void read_uff_nodes(UffEnvelope& envelope, bool is_complex, UffModeShape& shape);

/// Frequency and damping of a complex mode. @param eigenvalue  λ, rad/s.
void set_uff_eigenvalue(std::complex<double> eigenvalue, UffModeShape& shape);

}  // namespace microslip
