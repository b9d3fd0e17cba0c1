// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/rig/reduction/stepped_sine.hpp"

/// @file
/// Stepped sines as test systems keep them: of each step the frequency response H, a complex
/// acceleration, velocity or displacement per force, and the level |R| of the response. The force
/// of the step is |R|/|H|, both as accelerations, and the phase that of H.
///
///   * universal file: pairs of datasets 58 over the same frequencies, a frequency response
///     (function type 4) and a channel of an acceleration, velocity or displacement;
///   * `FILE.mat:VARIABLE`: a struct, or a struct array of one sweep per element, with the fields
///     `frequency` or `freq`, `FRF` or `H`, `response` or `level`, in any letters, and `units`, in
///     this order: "Hz, g/N, g".

namespace microslip {

/// Whether the first function of a universal file, of which these are the first bytes, is over
/// frequencies.
[[nodiscard]] bool is_over_frequency(std::string_view head);

/// The sweeps of a file over frequencies.
/// @param recordings  of the file. @param name  of it, for messages.
/// @throws InputError  where one has no frequency response, several, or no level beside it.
[[nodiscard]] std::vector<SteppedSine> response_sweeps(const Recordings& recordings,
                                                       const std::string& name);

/// Whether fields of a struct are those of such a sweep.
[[nodiscard]] bool has_response_fields(const std::vector<std::string>& fields);

/// Reads an element of a struct in a MATLAB file.
/// @param variable  its path in the file. @param fields  of it, with has_response_fields().
/// @throws InputError  naming what is missing, of another length or in another unit.
[[nodiscard]] SteppedSine read_response_sweep(const MatVariable& file, const std::string& variable,
                                              const std::vector<std::string>& fields);

}  // namespace microslip
