// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/config/named_values.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/identify/model_frequencies.hpp"
#include "microslip/workflow/identify/result_files.hpp"

/// @file
/// A model whose joints are sought and its modal levels, to the folder of what was found.

namespace microslip {

/// Inputs and options of calibrate_model().
struct ModelCalibration {
  std::string model;                ///< path of model.toml
  std::vector<std::string> levels;  ///< paths of modal_levels.csv
  std::string out;                  ///< folder of the results
  bool keep_draws = false;          ///< writes NAME_samples.h5 of each joint
  ModelFrequencies model_frequencies = ModelFrequencies::kGiven;  ///< of model.toml
  CalibrationOptions options = {};                                ///< of the method
  std::string command;                                            ///< that the files are made by
};

/// Result of calibrate_model().
struct CalibratedModel {
  ModelFile model;                  ///< as read
  std::vector<InputHash> inputs{};  ///< model and levels
  CalibrationResult found{};        ///< of calibrate()
  std::vector<ResultFile>
      files{};  ///< NAME.json of each joint found, model.toml, calibration.csv …
};

/// The draws of a joint, to be kept.
/// @param joint       that was found.
/// @param provenance  of the draws.
/// @param seed        of them.
[[nodiscard]] JointSamples joint_samples(const CalibratedJoint& joint, const Provenance& provenance,
                                         std::uint64_t seed);

/// Reads a model whose joints are sought.
/// @throws FileError, FormatError, InputError  as read_model(); where no joint is to be found,
///     loads always act, or the name of a joint is none of a file or a column.
[[nodiscard]] ModelFile read_model_to_calibrate(const std::string& path);
/// As above, from its text. @throws FormatError, InputError  as read_model_to_calibrate().
[[nodiscard]] ModelFile model_to_calibrate(const NamedInput& input);

/// The names of the joints of a model, in its order.
[[nodiscard]] std::vector<std::string> names_of_joints(const ModelFile& model);

/// Finds the joints of `done.model` from levels that need not be a file, into `done.found`, with
/// the warnings of its modes.
/// @param options      of the method.
/// @param levels       of the modes.
/// @param levels_name  in messages.
/// @param done         with its model as read.
/// @throws InputError, Cancelled  as calibrate().
void calibrate_levels(const ModelCalibration& options, const ModalLevels& levels,
                      const std::string& levels_name, CalibratedModel& done);

/// The model with what was found, its joints in files beside it in the folder of the results.
[[nodiscard]] ModelFile model_with_found(const ModelCalibration& options,
                                         const CalibratedModel& done);

/// The draws of each joint of the model: those that were found, and as their files have them those
/// that were not; nothing of a joint without.
/// @throws FileError, FormatError, InputError  as samples_for().
[[nodiscard]] std::vector<std::optional<JointSamples>> samples_of_joints(
    const ModelCalibration& options, const CalibratedModel& done);

/// Composes `done.files`.
/// @param options  that the joints were found with.
/// @param levels   that they were found from.
/// @param done     with what was found.
void compose_calibration(const ModelCalibration& options, const ModalLevels& levels,
                         CalibratedModel& done);

/// The paths and kinds of the files that will be written, before anything is computed.
/// @throws FileError, FormatError, InputError  as read_model(); for a joint whose name is no name
///                                             of a file.
[[nodiscard]] std::vector<ResultFile> planned_files(const ModelCalibration& options);
/// As above, of a model that was read before.
[[nodiscard]] std::vector<ResultFile> planned_files(const ModelCalibration& options,
                                                    const ModelFile& model);

/// Reads, finds and composes the files.
/// @throws FileError, FormatError, InputError  as the readers and calibrate().
/// @throws Cancelled                           as the progress says.
[[nodiscard]] CalibratedModel calibrate_model(const ModelCalibration& options);

/// The summary.
[[nodiscard]] std::string describe_calibration(const ModelCalibration& options,
                                               const CalibratedModel& done);

}  // namespace microslip
