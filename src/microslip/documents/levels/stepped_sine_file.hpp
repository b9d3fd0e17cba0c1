// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/mat/mat_value.hpp"
#include "microslip/rig/reduction/stepped_sine.hpp"

/// @file
/// Tables of stepped-sine sweeps.
///
///   * CSV: `frequency [Hz], force [N], acceleration [m/s^2], phase [rad]`, one row per step,
///     one sweep per file; or as a test system writes it, read as a recording is
///     (recording_csv.hpp) by names of frequency, force, acceleration and phase in any spelling.
///   * `FILE.mat:VARIABLE`: a struct with the fields `frequency`, `force`, `acceleration` or
///     `amplitude`, and `phase`, vectors of one length; a struct array has one sweep per element.
///     They are in Hz, N, m/s² and rad, or in the units of a field `units`, in this order: "Hz, N,
///     g, deg".
///   * frequency responses with the level of the response, response_sweep.hpp.

namespace microslip {

/// Whether a file of these first bytes is such a table in CSV, by its columns; also one that lacks
/// a part of it, as the phase, which those that read it say.
[[nodiscard]] bool is_stepped_sine_table(std::string_view head);

/// Parses a table in CSV.
/// @param text  all of it. @param name  of its file, for messages.
/// @throws FormatError, InputError  naming the place, where something is missing, no number or of
///                                  another unit.
[[nodiscard]] SteppedSine parse_stepped_sine(std::string text, const std::string& name);

/// Whether a variable of a MATLAB file is one, or several, by its fields.
/// @throws InputError  as MatVariable.
[[nodiscard]] bool is_stepped_sine(const MatVariable& file, std::string_view variable);

/// The sweeps of a variable of a MATLAB file.
/// @throws FormatError, InputError  as parse_stepped_sine().
[[nodiscard]] std::vector<SteppedSine> read_mat_sweeps(const MatVariable& file,
                                                       const std::string& variable);

}  // namespace microslip
