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
/// What is said of predictions by a model: in tables, in summaries, as warnings.

namespace microslip {

/// heading_of() of a prediction, with a line on the linear damping of each joint and on what is to
/// be known of it: that belongs into the file.
[[nodiscard]] std::string heading_of(std::string_view command, const ModelFile& model);

/// "4672 J/m^2 beside slip": of a joint that is by itself. Empty where β is 0.
[[nodiscard]] std::string damping_text(double linear_damping);

/// "0.15915, 1.2 Hz": the natural frequencies with all joints stuck.
[[nodiscard]] std::string stuck_frequencies_text(const JointedStructure& structure);

/// The lines of a summary on the model: size and stuck resonances.
[[nodiscard]] std::string describe_model(const std::string& file,
                                         const JointedStructure& structure);

/// Lines of a summary on the linear damping of the joints: as identified, or as the model has it.
[[nodiscard]] std::string describe_damping(const ModelFile& model);

/// Where joints move more than in the levels that they were identified by.
/// @param amplitude  the largest of each joint, m.
[[nodiscard]] std::vector<Warning> reach_warnings(const ModelFile& model,
                                                  const std::vector<double>& amplitude);

/// The same of a curve, and losses that the model seems to hold twice, to its warnings: the table
/// holds them too.
void add_model_warnings(const ModelFile& model, ResponseCurve& curve);

/// The warning `modes_missing` of a model that does not say that it has all modes, where
/// missing_compliance() is much of that of a joint.
[[nodiscard]] std::vector<Warning> mode_warnings(const ModelFile& model);

/// Judges what the harmonics above leave out, by judge_truncation(), and the modes above, by
/// judge_missing_modes() where the model does not say that none are: warnings of the curve where
/// that is much, and lines of the summary.
[[nodiscard]] std::string add_truncation(const HarmonicBalance& balance, const ModelFile& model,
                                         Quantity kept, ResponseCurve& curve);

/// The lines of a summary on warnings.
[[nodiscard]] std::string describe_warnings(const std::vector<Warning>& warnings);

/// The same of a joint by itself that moves by so much.
[[nodiscard]] std::vector<Warning> reach_warnings(const JointFile& file, double amplitude);

/// The line on how it ended, broken where it is long.
[[nodiscard]] std::string describe_ending(const Summary& summary);

/// The lines that both summaries begin with: model, method, how it ended.
[[nodiscard]] std::string describe_curve(const HarmonicBalance& balance, const ResponseCurve& curve,
                                         const std::string& file);

/// The same, and that there is no resonance in the range, where there is none.
void add_response_warnings(const HarmonicBalance& balance, const ModelFile& model,
                           ResponseCurve& curve);

/// add_truncation() and add_response_warnings(): all that is said of a frequency response.
/// @param kept  along the curve. @return as add_truncation().
std::string judge_response(const HarmonicBalance& balance, const ModelFile& model, Quantity kept,
                           ResponseCurve& curve);

/// add_truncation() and add_model_warnings(): the same of a backbone.
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

/// What is to be known of a march by its model: losses that it seems to hold twice, modes that it
/// lacks, joints that moved beyond their levels.
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
