// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/documents/response/response_file.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/harmonic/curve_heights.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Draws of a model through its frequency response: bands beside the curve, and its peaks with
/// their own.

namespace microslip {

/// A peak of the curve, and where those of the draws lie.
struct PeakSpread {
  double frequency = 0.0;        ///< of the curve, Hz
  double frequency_lower = 0.0;  ///< of the draws, Hz
  double frequency_upper = 0.0;  ///< as above
  double height = 0.0;           ///< of the curve: response, or, where that is kept, force, N
  double height_lower = 0.0;     ///< of the draws
  double height_upper = 0.0;     ///< as above
  std::size_t draws = 0;         ///< that have the peak; the others do not count
};

/// Band of a curve over frequency from draws of a model.
struct ResponseSpread {
  Band band;                      ///< of the height, one per point of the curve
  std::vector<PeakSpread> peaks;  ///< one a peak of the curve
  /// Frequency, Hz, and height of peak p in draw i: [p][i]; NaN where the draw has none.
  std::vector<std::vector<double>> peak_frequency;
  std::vector<std::vector<double>> peak_height;  ///< band of its height
  DrawsTaken taken;                              ///< what became of the draws
  std::vector<Warning> warnings;                 ///< what must be known of the band
};

/// The range and what is kept of a curve over the frequency.
struct ResponseRange {
  Target kept;        ///< force amplitude or response, as they are read
  double from = 0.0;  ///< rad/s
  double to = 0.0;    ///< rad/s
};

/// Curve over frequency of one draw.
struct DrawnResponse {
  std::string failure = {};  ///< why there is none; empty where there is
  /// Least and largest height that may be meant at each point of the reference, as
  /// response_spread() says; equal where the draw has as many branches there.
  std::vector<double> lower = {};
  std::vector<double> upper = {};           ///< as above
  std::vector<double> peak_frequency = {};  ///< of each peak of the reference, Hz; NaN without
  std::vector<double> peak_height = {};     ///< as above
};

/// Curves of draws at the points of a reference. Several threads may ask at once.
class ResponseOfDraws {
 public:
  /// As response_spread(); all of them must outlive it.
  ResponseOfDraws(const HarmonicBalance& balance, const ResponseCurve& reference,
                  const ResponseRange& range);

  /// @param drawn  a structure as it may be. @throws InputError  as HarmonicBalance of it.
  [[nodiscard]] DrawnResponse of(StructureDraw drawn) const;

  /// A point of the reference: the branch that it lies on, of those at its frequency.
  struct Station {
    double angular_frequency = 0.0;  ///< rad/s
    std::size_t branch = 0;          ///< from below
    std::size_t branches = 0;        ///< how many there are
  };

 private:
  [[nodiscard]] bool add_heights(const CurveHeights& heights, double gain,
                                 DrawnResponse& response) const;
  void add_peaks(const ResponseCurve& curve, double gain, DrawnResponse& response) const;

  const HarmonicBalance& balance_;
  const ResponseCurve& reference_;
  const ResponseRange& range_;
  HarmonicBalanceOptions options_;
  std::vector<Station> stations_;
};

/// Follows the curve of each draw and tells, at the frequency of each point of the reference,
/// between which heights the share `confidence` of the draws lies.
///
/// Where the reference has several heights at a frequency, a point on its highest branch has the
/// band of the draws' highest, one on its lowest of their lowest, and one between them of the
/// branch of the same number from below of those draws that have as many. A draw with another
/// number of branches counts, where that leaves open which is meant, with its lowest at the lower
/// and its highest at the upper edge: it may vibrate on either branch.
///
/// A peak of a draw belongs to the peak of the reference whose frequency is next to its own; of
/// several the most pronounced.
///
/// @param balance    of the reference: response point and options are those of the draws, but for
///                   the accuracy, the points asked for and the tolerance, which the band does not
///                   need.
/// @param reference  its curve, converged.
/// @param range      that it was made for.
/// @param draws      of the model.
/// @param options    which of them, and the confidence.
/// @param execution  of the draws.
/// @param progress   reports the number done; may cancel.
/// @throws InputError  where all draws failed, or as DrawOptions::check().
/// @throws Cancelled   as progress says.
[[nodiscard]] ResponseSpread response_spread(
    const HarmonicBalance& balance, const ResponseCurve& reference, const ResponseRange& range,
    const StructureDraws& draws, const DrawOptions& options,
    const Execution& execution = Execution::threads(), const Progress& progress = {});

/// Comments of the table: a line a peak with its band.
/// @param spread    with the peaks.
/// @param height  of the curve: of what drives, where a response is kept.
[[nodiscard]] std::string peaks_comment(const ResponseSpread& spread, const CurveHeight& height);

/// The table of the peaks, as text.
/// @param spread    with the peaks.
/// @param height  of the curve: of what drives, where a response is kept.
/// @param heading   its comments.
/// @throws InputError  where there is no peak.
[[nodiscard]] std::string peaks_table(const ResponseSpread& spread, const CurveHeight& height,
                                      const std::string& heading);

/// The lines of a summary on the peaks.
[[nodiscard]] std::string describe_peak_spread(const ResponseSpread& spread,
                                               const CurveHeight& height);

}  // namespace microslip
