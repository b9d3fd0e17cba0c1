// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "microslip/observe/force_record.hpp"
#include "microslip/observe/path_corners.hpp"

namespace microslip {

/// State of a joint when its record begins.
enum class PathStart {
  /// No slider has slipped: the force is that of the virgin curve from the first sample on.
  kVirgin,
  /// Unknown. Sliders of slip displacement x* below half the range of the path so far have slipped
  /// once at least, so that their force is known; the others are stuck, with a force that is
  /// constant but for the motion until the range grows: a group of samples with an offset of its
  /// own. Samples while it grows carry no information.
  kUnknown,
};

/// "virgin" or "unknown".
[[nodiscard]] std::string_view to_string(PathStart start);

/// c·v(h): a stretch of the path by the virgin curve v of half its range (Masing).
struct PathStretch {
  double coefficient = 0.0;  ///< c: ±1 on the virgin curve, ±2 after a reversal
  double half_range = 0.0;   ///< h, m; ≥ 0
};

/// Samples in a row on one stretch of the path, together. The mean force of a joint there is
///
///     F = F₀ + Σ_turns c v(h) + c mean v(h_i),
///
/// with h_i the half range of each sample, ψ(x*) the stiffness density and v(h) = K_e h + ∫ min(h,
/// x*) ψ dx* the virgin curve.
struct PathRow {
  std::size_t first = 0;      ///< sample
  std::size_t count = 0;      ///< of samples
  std::size_t group = 0;      ///< rows of one offset F₀
  std::size_t turns = 0;      ///< index into PathRows::turns
  PathStretch last = {};      ///< c and mean h of the stretch that the samples lie on
  double displacement = 0.0;  ///< mean of u from where the joint is without force, m
  double velocity = 0.0;      ///< mean of u̇, m per sample
  double force = 0.0;         ///< mean of F, N
};

/// A path as rows that are linear in the stiffness density.
struct PathRows {
  std::vector<PathRow> rows = {};                    ///< in order of time
  std::vector<std::vector<PathStretch>> turns = {};  ///< the stretches behind a row
  std::vector<double> half_range = {};               ///< h_i of the samples of all rows, m
  std::size_t groups = 0;                            ///< of rows with one offset
  double reach = 0.0;         ///< largest half range of any stretch, m: beyond it nothing slips
  double shortest = 0.0;      ///< a tenth of the half ranges between turns lies below, m
  std::size_t reversals = 0;  ///< of the whole path
};

/// Rows of a path by Madelung's rules. Where as many rows would be longer than a 64th of the range
/// of the path, most branches have rows of that length, and some, spread evenly over all, rows of a
/// 64th: a mean over a branch determines the joint as a whole, but not where it slips.
/// @param path       displacement of each sample, m.
/// @param force      of each sample, N.
/// @param start      the state that it begins in.
/// @param threshold  turns smaller than this are ignored, m; ≥ 0.
/// @param most_rows  largest number of rows, approximately; more samples are grouped.
/// @param corners    of the path: a turn that is one lies between samples and beyond them, where
///                   the path on its two sides meets.
[[nodiscard]] PathRows path_rows(std::span<const double> path, std::span<const double> force,
                                 PathStart start, double threshold, std::size_t most_rows,
                                 const std::vector<PathCorner>& corners = {});

}  // namespace microslip
