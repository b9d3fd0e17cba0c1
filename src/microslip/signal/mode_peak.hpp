// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

/// @file
/// The peaks of a record's spectrum. Internal to signal.

namespace microslip {

struct SpectralPeak {
  double frequency = 0.0;  ///< Hz
  double height = 0.0;     ///< over that of the highest, 1
};

/// The highest line of the amplitude spectrum between two frequencies, and the other peaks from a
/// third of its frequency to 5/3 of it: those of 3 % of its height at least that a valley of a third
/// of their height parts from it. Within 6 % of it all counts as its own: a jointed mode moves.
struct ModePeak {
  double frequency = 0.0;                ///< Hz; 0 where there is none
  std::vector<SpectralPeak> neighbours;  ///< by frequency
};

/// @param signal    evenly sampled.
/// @param rate      Hz.
/// @param from, to  Hz.
[[nodiscard]] ModePeak find_mode(std::span<const double> signal, double rate, double from,
                                 double to);

}  // namespace microslip
