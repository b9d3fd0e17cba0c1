// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/workflow/predict/model_draws.hpp"

/// @file
/// Draws of a model through a march in time.

namespace microslip {

/// A signal of a march as one number, and between which values those of the draws lie.
struct StatisticSpread {
  double value = 0.0;  ///< of the march of the model itself
  double lower = 0.0;  ///< of the draws
  double upper = 0.0;  ///< as above
};

/// A signal of a march.
struct MarchedSignal {
  std::string name;           ///< as its column: "displacement", "lap force"
  Dimension dimension;        ///< of its values
  StatisticSpread peak = {};  ///< max |x| at the ends of all steps
  StatisticSpread rms = {};   ///< √(∫ x² dt/T), as SignalSize
};

/// A march with what draws make of it.
struct DrawnMarch {
  MarchResult march;                   ///< of the model itself, with all warnings; no rows
  std::vector<MarchedSignal> signals;  ///< w, ẇ, ẅ of the point, u_j and F_j of each joint
  std::vector<std::size_t> times;      ///< of the axis, that are recorded
  std::vector<double> rows;            ///< of the signals, one recorded time after the other
  /// Of `rows`, point by point. Without values where the march of the model did not converge: its
  /// draws are not taken.
  Band band;
  DrawsTaken taken;  ///< what became of the draws

  /// Whether the draws were taken.
  [[nodiscard]] bool has_band() const { return !band.lower.empty(); }
};

/// Marches a model, then each of its draws with steps of its own and without an estimate of its
/// error. A force that acts at an excitation is read, and divided by the gain of the draw; normal
/// loads are as given, times what the draw says of the nominal one. A draw fails that does not
/// converge.
/// @param model      to be marched, its response point recorded.
/// @param loads      loads on it.
/// @param options    of the march; `points` is the response point alone.
/// @param draws      of the model.
/// @param drawn      which of them, and the confidence.
/// @param execution  of the draws.
/// @param marching   reports the times of the march of the model; may cancel.
/// @param drawing    reports the draws done; may cancel.
/// @throws InputError  as march(); where all draws failed; as DrawOptions::check() and
///                     check_size().
/// @throws Cancelled   as progress says.
[[nodiscard]] DrawnMarch drawn_march(const ModelFile& model, const LoadHistory& loads,
                                     MarchOptions options, const StructureDraws& draws,
                                     const DrawOptions& drawn,
                                     const Execution& execution = Execution::threads(),
                                     const Progress& marching = {}, const Progress& drawing = {});

/// Loads where a force is measured with the gain of a draw: at the excitations the force over it.
/// @param read  the loads. @param drawn  of the model.
[[nodiscard]] LoadHistory loads_over_gains(const LoadHistory& read, const StructureDraw& drawn);

/// A gain that is uncertain and meets no force.
/// @param model  with its spread. @param loads  that act.
[[nodiscard]] std::vector<Warning> gain_warnings(const ModelFile& model, const LoadHistory& loads);

/// Peaks and rms of the signals as comments: a line each.
[[nodiscard]] std::string march_peaks_comment(const DrawnMarch& march);

/// Peaks and rms as a table of two rows: `statistic`, NAME, NAME_lower, NAME_upper of each signal,
/// `draws [1]`.
/// @param march    with draws.
/// @param heading  its comments.
[[nodiscard]] std::string march_peaks_table(const DrawnMarch& march, const std::string& heading);

/// The lines of a summary on peaks and rms.
[[nodiscard]] std::string describe_march_spread(const DrawnMarch& march);

/// Writes the table of a march, with its band where there is one.
/// @param path     of the table; "-" is standard output.
/// @param model    that was marched.
/// @param loads    that acted.
/// @param heading  its first comments.
/// @param march    to be written.
/// @throws FileError  as MarchTable.
void write_drawn_march(const std::string& path, const ModelFile& model, const LoadHistory& loads,
                       const std::string& heading, const DrawnMarch& march);

}  // namespace microslip
