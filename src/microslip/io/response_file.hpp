// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/dynamics/steady_vibration.hpp"
#include "microslip/io/csv_writer.hpp"

/// @file
/// Tables of computed steady vibrations, one row each, in the order of the curve. Both end with
///
///     dissipation [J]         ΣD, of all joints, per cycle
///     linear_dissipation [J]  W_lin, of the linear structure, per cycle
///     amplitude_NAME [m], dissipation_NAME [J], reversals_NAME [1]    of each joint
///     energy_imbalance [1]    |W_ext − W_lin − ΣD|/W_ext: how well the equations are solved
///
/// and their comments tell how the computation ended, "NOT CONVERGED" where it did not, and the
/// warnings of the curve.

namespace microslip {

/// Whether a point of the curve is finite, so that there is one to write.
[[nodiscard]] bool has_rows(const ResponseCurve& curve);

/// Quantiles of draws beside a curve.
struct BandColumns {
  std::string name;           ///< the columns are NAME_lower, NAME_upper; empty: lower, upper
  Dimension dimension;        ///< of both
  std::vector<double> lower;  ///< one a point of the curve
  std::vector<double> upper;  ///< one a point of the curve
};

/// frf.csv: `frequency [Hz], force [N], displacement [m], phase [rad]`, the columns above and
/// `peak [1]`, 1 in the row of a peak, else 0. displacement is the amplitude of the first harmonic
/// at the response point, phase its lag behind the force. Where the curve turns back frequencies
/// are not sorted; its peaks and turning points stand in the comments too, the first 100 of each.
/// Frequencies have 15 digits, so that one that was asked for is the number that was given.
/// @param curve    of a response point of the kind displacement; its warnings become comments.
/// @param heading  the first comment; may be empty.
/// @param bands    columns at the end.
/// What is not finite, as it may be where nothing converged, is left out.
/// @throws InputError  unless has_rows(); for a band that has not as many values as points.
[[nodiscard]] CsvWriter response_table(const ResponseCurve& curve, std::string_view heading = {},
                                       std::span<const BandColumns> bands = {});

/// backbone.csv: `displacement [m], force [N], frequency [Hz], damping_ratio [1]` and the columns
/// above, of vibrations in phase resonance. @param curve, heading, bands  as for response_table().
[[nodiscard]] CsvWriter backbone_table(const ResponseCurve& curve, std::string_view heading = {},
                                       std::span<const BandColumns> bands = {});

}  // namespace microslip
