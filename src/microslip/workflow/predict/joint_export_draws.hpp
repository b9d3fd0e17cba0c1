// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/workflow/predict/joint_export.hpp"
#include "microslip/workflow/predict/joint_tables.hpp"

/// @file
/// Draws of a joint for another program, a file each, so that it can propagate their spread.

namespace microslip {

/// More files in a folder are a mistake.
inline constexpr std::size_t kMostExportedDraws = 10'000;

/// Names of the files of draws: those of numbers from 1, with zeros before them so that their
/// alphabetical order is that of the draws: bolt_01.tcl.
/// @param request  with target and name. @param count  how many.
/// @throws InputError  where the target calls a file by its name and it is too long.
[[nodiscard]] std::vector<std::string> draw_file_names(const ExportRequest& request,
                                                       std::size_t count);

/// Refuses a folder with draws of another call, which nothing would tell from those to come.
/// @param folder  that is there. @param names  of the files to come.
/// @throws FileError  where it holds other files that export wrote and that are named by number.
void check_other_draws(const std::string& folder, const std::vector<std::string>& names);

/// A draw of a joint, exported.
struct ExportedDraw {
  JointExport result;              ///< its text and errors
  double stiffness = 0.0;          ///< k of the draw, N/m
  double macroslip_force = 0.0;    ///< N
  double elastic_stiffness = 0.0;  ///< k times the elastic remainder, N/m
};

/// export_joint() of the draws that loop_of() and the other predictions take: draw i of a seed is
/// the same in all of them.
/// @param file     of the joint, for what draws have in common.
/// @param draws    of it; its progress is told and may cancel.
/// @param request  of each; without a number of sliders each draw has as many as it needs.
/// @param remarks  as of export_joint(); the number of the draw is added.
/// @throws InputError, Error  as export_joint(). @throws Cancelled  as the progress says.
[[nodiscard]] std::vector<ExportedDraw> export_draws(const JointFile& file,
                                                     const LoneJointDraws& draws,
                                                     const ExportRequest& request,
                                                     const std::string& remarks);

/// draws.csv: number and file of each draw, with what differs between them.
/// @param exported  of export_draws(). @param names  of their files. @param draws  as taken.
/// @param command   as of loop_of().
[[nodiscard]] std::string exported_draws_table(const std::vector<ExportedDraw>& exported,
                                               const std::vector<std::string>& names,
                                               const LoneJointDraws& draws,
                                               const std::string& command);

/// What was exported, in some lines.
/// @param exported  of export_draws(). @param request  as there. @param folder  of the files.
[[nodiscard]] std::string exported_draws_summary(const std::vector<ExportedDraw>& exported,
                                                 const ExportRequest& request,
                                                 const std::string& folder);

}  // namespace microslip
