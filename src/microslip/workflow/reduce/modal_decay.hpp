// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/signal/decay/ring_down.hpp"
#include "microslip/signal/decay/ring_down_levels.hpp"

/// @file
/// The recording of a free decay to levels of the modes of a structure with joints.

namespace microslip {

// Codes of flags and warnings.
inline constexpr std::string_view kModesModulate = "modes_modulate";  ///< modes modulate each other
inline constexpr std::string_view kShapeAssumed = "shape_assumed";  ///< not seen by enough sensors

/// Inputs and options of reduce_modal_decay().
struct ModalDecayReduction {
  std::string recording;                   ///< path
  std::string model = {};                  ///< path of model.toml; empty: without one
  std::vector<std::string> sensors = {};   ///< CHANNEL=POINT; empty for those of the model
  std::vector<std::string> channels = {};  ///< without a model: see DecayReduction
  /// From 1; empty: all modes of the model that can be followed. One without a model.
  std::vector<std::size_t> modes = {};
  RingDownOptions analysis = {};      ///< of each mode; with a model it says where they are
  RecordingReadOptions reading = {};  ///< of the recording
  Progress progress = {};             ///< of the modes of a model, one piece each
};

/// The decay of one mode.
struct ModalDecay {
  std::size_t mode = 1;   ///< from 1
  RingDown decay;         ///< its analysis
  RingDownLevels levels;  ///< amplitudes are those of the displacement at the response point
};

/// Result of reduce_modal_decay().
struct ReducedModalDecay {
  std::string source;             ///< of the recording
  std::vector<ModalDecay> modes;  ///< those that were asked for, by their number; at least one
  std::vector<Warning> warnings;  ///< of the reader, of the analyses and of what was left out

  /// Whether each was followed to the end of the record or to the noise.
  [[nodiscard]] bool converged() const;
};

/// Follows modes of a structure in one decay.
///
/// With a model each of its modes is sought near its frequency with stuck joints, at the sensors
/// that it moves. The displacement is that of a sensor at the response point; where there is none
/// that can be followed, that of another sensor times the ratio in the model's shape, with the
/// warning and flag `shape_assumed`. The shape moves as joints slip: at a frequency it is that of
/// joints that are all softer by the same share, in the ratio and in the damping (see ShapeCourse).
///
/// Modes that ring at once in one joint modulate each other: while one is large the other slips
/// more. Levels during which the others, as far as they could be followed, move the joints by more
/// than a tenth of what this mode does, are flagged `modes_modulate`. The measure is √Σ_j k_j u_j²
/// in the shapes of the stuck structure.
///
/// Without a model the channels are those of ring_down(), the first at the response point, and the
/// mode is a number for the table.
/// @throws FileError, FormatError, InputError  as the readers and ring_down(); for a mode that the
///         model does not have or that cannot be followed; where no mode can be.
[[nodiscard]] ReducedModalDecay reduce_modal_decay(const ModalDecayReduction& options);

/// The same with a model that need not be a file; `options.model` is its name in messages.
[[nodiscard]] ReducedModalDecay reduce_modal_decay(const ModalDecayReduction& options,
                                                   const ModelFile& model);
/// As above, of a recording whose file was read before.
[[nodiscard]] ReducedModalDecay reduce_modal_decay(const ModalDecayReduction& options,
                                                   const ModelFile& model, const Recordings& file);

/// The text of modal_levels.csv: `mode [1], displacement [m], frequency [Hz], damping_ratio [1]`,
/// of the three with `_std` each, `decay_time [s], source, flags`.
[[nodiscard]] std::string modal_levels_text(const ReducedModalDecay& reduced,
                                            std::string_view command);

/// The summary.
[[nodiscard]] std::string describe_modal_decay(const ReducedModalDecay& reduced);

}  // namespace microslip
