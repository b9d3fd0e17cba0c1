// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/io/cells/csv_writer.hpp"

/// @file
/// Tables of computed steady vibrations, one row each, in the order of the curve. Both end with
///
///     dissipation [J]         ΣD, of all joints, per cycle
///     linear_dissipation [J]  W_lin, of the linear structure, per cycle
///     amplitude_NAME [m], dissipation_NAME [J], reversals_NAME [1]    of each joint
///     energy_imbalance [1]    |W_ext − W_lin − ΣD|/W_ext: how well the equations are solved
///
/// and their comments state how the computation ended, "NOT CONVERGED" where it did not, and the
/// warnings of the curve.

namespace microslip {

/// Ordinate of a curve, named as its column.
struct CurveHeight {
  std::string_view name;  ///< "displacement", "force", "base_acceleration"
  Dimension dimension;    ///< of its values
  bool drives = false;    ///< whether it is the drive, found for a constant response
};

/// Ordinate of the drive of a structure: "force", or "base_acceleration" of one whose base is
/// driven.
[[nodiscard]] CurveHeight drive_of(const JointedStructure& structure);
/// Ordinate of the drive of a curve: "force" with modal forcing, whatever the model drives.
[[nodiscard]] CurveHeight drive_column(const HarmonicBalance& balance);
/// Ordinate of the first harmonic of the displacement at the response point.
[[nodiscard]] CurveHeight displacement_height();

/// Whether a point of the curve is finite, so that there is one to write.
[[nodiscard]] bool has_rows(const ResponseCurve& curve);

/// Quantiles of draws beside a curve.
struct BandColumns {
  std::string name;           ///< the columns are NAME_lower, NAME_upper; empty: lower, upper
  Dimension dimension;        ///< of both
  std::vector<double> lower;  ///< one per point of the curve
  std::vector<double> upper;  ///< one per point of the curve
};

/// frf.csv: `frequency [Hz], force [N], displacement [m], phase [rad], velocity [m/s], acceleration
/// [m/s^2]`, the columns above and `peak [1]`, 1 in the row of a peak, else 0. displacement is the
/// amplitude of the first harmonic at the response point, phase its lag behind the force, velocity
/// and acceleration ω and ω² times it. Of a structure whose base is driven `base_acceleration
/// [m/s^2]` stands in place of the force, displacement is relative to the base, and after
/// acceleration come `absolute_displacement [m]`, `absolute_acceleration [m/s^2]` and
/// `transmissibility [1]`, the last over the first harmonic of the acceleration that the bases
/// carry the point along with. With static loads `mean_displacement [m]` and `mean_NAME [m]` of
/// each joint tell about what they vibrate. Where the curve turns back frequencies are not sorted;
/// its peaks and turning points stand in the comments too, the first 100 of each. Frequencies have
/// 15 digits, so that one that was asked for is the number that was given.
/// Non-finite values, which may occur without convergence, are left out.
/// @param balance  that the curve is of.
/// @param curve    its warnings become comments.
/// @param heading  the first comment; may be empty.
/// @param bands    columns at the end.
/// @throws InputError  unless has_rows(); for a band that has not as many values as points.
[[nodiscard]] CsvWriter response_table(const HarmonicBalance& balance, const ResponseCurve& curve,
                                       std::string_view heading = {},
                                       std::span<const BandColumns> bands = {});

/// backbone.csv: `displacement [m], force [N], frequency [Hz], damping_ratio [1]` and the columns
/// above, of vibrations in phase resonance; `base_acceleration [m/s^2]` as in frf.csv, unless a
/// modal force drives. @param balance, curve, heading, bands  as for response_table().
[[nodiscard]] CsvWriter backbone_table(const HarmonicBalance& balance, const ResponseCurve& curve,
                                       std::string_view heading = {},
                                       std::span<const BandColumns> bands = {});

}  // namespace microslip
