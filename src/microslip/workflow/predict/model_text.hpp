// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"

/// @file
/// Texts on predictions by a model: in tables, in summaries, as warnings.

namespace microslip {

/// heading_of() of a prediction, with a line on the linear damping of each joint, for the file.
[[nodiscard]] std::string heading_of(std::string_view command, const ModelFile& model);

/// "4672 J/m^2 beside slip": of a single joint. Empty where β is 0.
[[nodiscard]] std::string damping_text(double linear_damping);

/// "0.15915, 1.2 Hz": the natural frequencies with all joints stuck.
[[nodiscard]] std::string stuck_frequencies_text(const JointedStructure& structure);

/// The lines of a summary on the model: size and stuck resonances.
[[nodiscard]] std::string describe_model(const std::string& file,
                                         const JointedStructure& structure);

/// Lines of a summary on the linear damping of the joints: as identified, or as the model has it.
[[nodiscard]] std::string describe_damping(const ModelFile& model);

/// Warnings where joints move more than in the levels from which they were identified.
/// @param amplitude  the largest of each joint, m.
[[nodiscard]] std::vector<Warning> reach_warnings(const ModelFile& model,
                                                  const std::vector<double>& amplitude);

/// Adds those of a curve, and on losses that the model seems to contain twice, to its warnings,
/// which the table contains too.
void add_model_warnings(const ModelFile& model, ResponseCurve& curve);

/// The warning `modes_missing` of a model that is not declared to have all modes, where
/// missing_compliance() is much of that of a joint.
[[nodiscard]] std::vector<Warning> mode_warnings(const ModelFile& model);

/// Estimates the effect of higher harmonics, by judge_truncation(), and of higher modes, by
/// judge_missing_modes() unless the model is declared to have all: warnings of the curve where it
/// is large, and lines of the summary.
[[nodiscard]] std::string add_truncation(const HarmonicBalance& balance, const ModelFile& model,
                                         Quantity kept, ResponseCurve& curve);

/// The lines of a summary on warnings.
[[nodiscard]] std::string describe_warnings(const std::vector<Warning>& warnings);

/// Warnings as above for a single joint of that amplitude.
[[nodiscard]] std::vector<Warning> reach_warnings(const JointFile& file, double amplitude);

/// The line on how it ended, broken where it is long.
[[nodiscard]] std::string describe_ending(const Summary& summary);

/// The lines that both summaries begin with: model, method, how it ended.
[[nodiscard]] std::string describe_curve(const HarmonicBalance& balance, const ResponseCurve& curve,
                                         const std::string& file);

/// Adds add_model_warnings(), and a warning where there is no resonance in the range.
void add_response_warnings(const HarmonicBalance& balance, const ModelFile& model,
                           ResponseCurve& curve);

/// add_truncation() and add_response_warnings(): all checks of a frequency response.
/// @param kept  along the curve. @return as add_truncation().
std::string judge_response(const HarmonicBalance& balance, const ModelFile& model, Quantity kept,
                           ResponseCurve& curve);

/// add_truncation() and add_model_warnings(): all checks of a backbone.
std::string judge_backbone(const HarmonicBalance& balance, const ModelFile& model,
                           ResponseCurve& curve);

/// The summary of a frequency response, without warnings.
/// @param file      of the model.
/// @param of_force  at a constant response.
[[nodiscard]] std::string describe_response(const std::string& file, const HarmonicBalance& balance,
                                            const ResponseCurve& curve, bool of_force);

/// The summary of a backbone, without warnings. @param mode  from 1.
[[nodiscard]] std::string describe_backbone(const std::string& file, const HarmonicBalance& balance,
                                            const ResponseCurve& curve, std::size_t mode);

/// Warnings on a march by its model: losses that it seems to contain twice, modes that it lacks,
/// joints that moved beyond their levels.
/// @param reach  the farthest that each joint moved, m.
[[nodiscard]] std::vector<Warning> march_warnings(const ModelFile& model,
                                                  const std::vector<double>& reach);

/// march(), with march_warnings() beside those of the result.
/// @throws InputError, Cancelled  as march().
[[nodiscard]] MarchResult judged_march(const ModelFile& model, const LoadHistory& loads,
                                       const MarchOptions& options, const Progress& progress = {});

/// Marches, writes the table row by row, and adds march_warnings() to those of the result.
/// @param path     of the table; "-" is standard output.
/// @param heading  its first comments.
/// @throws FileError, InputError  as MarchTable and march_rows().
/// @throws Cancelled  as the progress says.
[[nodiscard]] MarchResult march_to_table(const std::string& path, const ModelFile& model,
                                         const LoadHistory& loads, const MarchOptions& options,
                                         const std::string& heading, const Progress& progress);

/// The summary of a march. @param file, forces  those of the model and of the loads.
/// @param draws  lines on them; empty without.
[[nodiscard]] std::string describe_march(const std::string& file, const std::string& forces,
                                         const ModelFile& model, const LoadHistory& loads,
                                         const MarchResult& result, const std::string& draws = {});

}  // namespace microslip
