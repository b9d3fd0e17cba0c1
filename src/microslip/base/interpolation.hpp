// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace microslip {

/// The value of the function that is linear between knots and constant beyond them.
/// @param knots   rising, one at least.
/// @param values  one per knot.
/// @param x       the argument; the result is NaN where x is.
/// @throws InputError  without knots, or where the number of values differs.
[[nodiscard]] double interpolate(const std::vector<double>& knots,
                                 const std::vector<double>& values, double x);

/// Its integral from the first knot to the last. @throws InputError  as above.
[[nodiscard]] double integral(const std::vector<double>& knots, const std::vector<double>& values);

}  // namespace microslip
