// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/exports/export_targets.hpp"
#include "microslip/documents/joint/joint_file.hpp"

/// @file
/// A joint as sliders for another program, and by how much these are wrong.

namespace microslip {

/// What sliders differ from a joint by.
struct SliderErrors {
  double first_loading = 0.0;       ///< of the force, over the largest that can slip, 1
  double path = 0.0;                ///< along nested_path(), over the largest force on it, 1
  std::vector<double> amplitude;    ///< A, m: from 1/1000 of the highest, where the last slips
  std::vector<double> dissipation;  ///< relative, of D at each A, 1
  std::vector<double> secant;       ///< relative, of k_eq at each A, 1
};

/// Loops within loops, m: from 0 to A and back and forth between ever nearer turns, then between
/// ever farther ones. @param amplitude  A, m. @param points  of a branch.
[[nodiscard]] std::vector<double> nested_path(double amplitude, std::size_t points);

/// What is to be exported.
struct ExportRequest {
  std::string target;                  ///< name of an ExportTarget
  std::optional<std::size_t> sliders;  ///< how many; nothing: as `error` says
  double error = 1e-3;                 ///< largest SliderErrors::path, 1; from 1e-7 to 0.5
  /// Largest displacement of the joint in the analysis, m; > 0. What slips beyond it is a spring.
  double reach = std::numeric_limits<double>::infinity();
  std::string units = "SI";      ///< name of ExportUnits
  std::string name = {};         ///< of the joint in the text; needed
  std::size_t first_number = 1;  ///< as of ExportedJoint; from 1 to 9e7
  bool amplitudes = true;        ///< whether the errors over the amplitude are computed, too
};

/// A joint exported.
struct JointExport {
  std::string text;               ///< of the file
  std::size_t sliders = 0;        ///< in it
  SliderErrors errors;            ///< of these against the joint
  std::vector<Warning> warnings;  ///< of what the sliders leave out; in the text as well
};

/// @param file     of the joint. @param request  what to write.
/// @param remarks  lines that become the first comments: provenance_of().
/// @throws InputError  where a value of the request breaks a rule, no number of sliders up to 5000
///                     is as exact as asked for, or the joint has what no slider has: a viscous
///                     part.
[[nodiscard]] JointExport export_joint(const JointFile& file, const ExportRequest& request,
                                       const std::string& remarks);

/// Table of the errors: amplitude, D, D of the sliders, and so on; CSV.
/// @param errors   of export_joint(). @param command  as of loop_of().
[[nodiscard]] std::string slider_errors_table(const SliderErrors& errors,
                                              const std::string& command);

/// What was exported, in some lines.
/// @param result   with errors over the amplitude. @param request  what was asked for.
/// @param path     of the file.
[[nodiscard]] std::string export_summary(const JointExport& result, const ExportRequest& request,
                                         const std::string& path);

}  // namespace microslip
