// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

/// @file
/// The peaks of a record's spectrum. Internal to signal.

namespace microslip {

struct SpectralPeak {
  double frequency = 0.0;  ///< Hz
  double height = 0.0;     ///< over that of the mode (or of the highest), 1
};

/// The highest line of the amplitude spectrum between two frequencies, Hz; 0 where there is none.
/// @param signal    evenly sampled.
/// @param rate      Hz.
/// @param from, to  Hz.
[[nodiscard]] double find_mode(std::span<const double> signal, double rate, double from, double to);

/// The peaks of the spectrum of a decay that falls to 0 under cos², beginning at 1: each is the
/// highest between two places of half its power. By frequency; heights are those over the highest.
/// The skirt of a mode has none, nor has the edge of a range.
/// @param signal  evenly sampled, from where the decay begins.
/// @param rate    Hz.
[[nodiscard]] std::vector<SpectralPeak> parted_peaks(std::span<const double> signal, double rate);

/// Other oscillations during the decay of a mode.
struct ModeNeighbours {
  std::vector<SpectralPeak> peaks;  ///< by frequency
  double length = 0.0;              ///< s, of the examined stretch
};

/// The peaks of the spectrum of the first stretch of a free decay, tapered by cos⁴ so that abrupt
/// starts mask no other peaks, and as long as the mode keeps 40 % of its amplitude: 24 to 400 of
/// its periods. Peaks count that a valley of a third of their height parts from higher ones, that
/// are four lines away from the mode, 0.2 % of it, five times the median about them, and above what
/// the taper lets through of a higher one. Of many those that come through the taper the most.
/// @param signal     evenly sampled; the decay alone.
/// @param rate       Hz.
/// @param frequency  of the mode, Hz.
[[nodiscard]] ModeNeighbours neighbours_of(std::span<const double> signal, double rate,
                                           double frequency);

}  // namespace microslip
