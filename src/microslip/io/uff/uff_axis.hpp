// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/io/uff/uff58_header.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// The abscissa of dataset 58, and the exact axis behind its few digits. Internal to io.

namespace microslip {

/// An even axis from the numbers of a header. The step has six digits there: 1/65536 s stands as
/// 1.52588E-05. Where 1/step, in SI, is a time's rate within 1e-5 of an integer, the step is one
/// over that integer; the drift of a long record would be 0.04 rad at 100 Hz after 100 s otherwise.
[[nodiscard]] Axis even_uff_axis(double start, double step, const Unit& unit);

/// An axis from the abscissa of each point, which becomes SI. Where an even axis has just these
/// values, bit for bit, it is that: so write_recordings_uff() stores steps of more digits.
[[nodiscard]] Axis uneven_uff_axis(std::vector<double> x, const Unit& unit);

/// Whether even_uff_axis() finds this even axis, in SI, in the digits that a header has of it.
[[nodiscard]] bool header_holds(const Axis& axis);

/// The abscissae that datasets are written with so that the axis reads back bit for bit; none where
/// a header holds start and step.
[[nodiscard]] std::vector<double> uff_abscissae(const Recording& recording);

/// Says in a header that each point has its abscissa, where there are such.
void set_abscissae(const std::vector<double>& x, Uff58Header& header);

}  // namespace microslip
