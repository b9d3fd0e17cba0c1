// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/io/recordings/recordings.hpp"
#include "microslip/io/uff/uff55.hpp"

/// @file
/// Recordings in universal files: datasets 58 and 58b of the Structural Dynamics Research
/// Laboratory, University of Cincinnati ("Universal file formats for modal analysis testing"), with
/// 151 (header) and 164 (units).

namespace microslip {

/// Reads all functions of a file, text or binary, single or double precision, real or complex,
/// evenly spaced or not; datasets of other numbers are skipped.
///
/// Functions that follow each other over the same axis are a recording; dataset 151 begins another
/// one. A channel has the name of its ID line 1, or that of its point: "point 3 +Z". Its unit is
/// that of the labels, or else of the data type by dataset 164; where there is neither, the channel
/// has none. The other fields of the header are attributes, as far as they are not what
/// write_recordings_uff() writes anyway.
///
/// A sampling interval has six digits in such a file. Where 1/interval is within 1e-5 of an integer
/// number of hertz, it is taken for that.
///
/// @throws FormatError  where the file is not of this form, or ends before the points it announces.
/// @throws InputError   where values are not finite or abscissae do not rise.
/// @throws FileError    where it cannot be read.
/// @throws Cancelled    when the progress callback says so.
[[nodiscard]] Recordings read_recordings_uff(const std::string& path,
                                             const RecordingReadOptions& options = {});

/// Recordings that can be read from a file.
struct UffContents {
  Recordings recordings;                  ///< none where it has mode shapes alone
  std::vector<UffModeShape> mode_shapes;  ///< datasets 55 and 2414, in the order of the file
};

/// Reads recordings as read_recordings_uff() does, and mode shapes. One that is damaged is left out
/// with a warning, as long as there is something else.
/// @throws FormatError  where there is neither; otherwise as read_recordings_uff().
[[nodiscard]] UffContents read_contents_uff(const std::string& path,
                                            const RecordingReadOptions& options = {});

/// Writes datasets 151 and 164 (SI), then one dataset 58 a channel, for each recording.
///
/// Binary files (58b) read back as the same double for each value and axis, with the attributes
/// that are fields of the header. Where the six digits of start and step do not suffice, each point
/// is written with its abscissa. As text (58), values have 13 significant digits and the axis six:
/// a step that these do not hold is rounded. Attributes that are no field are left out, text longer
/// than its field is cut off.
///
/// @param path        is overwritten as it goes: a temporary name of OutputFiles::stage().
/// @param recordings  written in their order.
/// @param binary      datasets 58b; otherwise 58.
/// @throws InputError  where a recording is not whole (check_recording()), the name of a channel
///                     has more than 80 characters or such as do not read back, a unit needs more
///                     than 20, or the abscissae fall together in six digits.
/// @throws FileError   where the file cannot be written.
void write_recordings_uff(const std::string& path, std::span<const Recording> recordings,
                          bool binary);

}  // namespace microslip
