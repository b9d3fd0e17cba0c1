// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/recordings/recording_format.hpp"
#include "microslip/io/recordings/recordings.hpp"
#include "microslip/rig/reduction/stepped_sine.hpp"

/// @file
/// The file of a test: opened, recognised and hashed once.

namespace microslip {

/// The content of a file of a test.
enum class TestContent : std::uint8_t {
  kLevels,       ///< levels.csv
  kModalLevels,  ///< modal_levels.csv
  kSteppedSine,  ///< a stepped-sine table, in CSV or in a variable of a MATLAB file
  kRecording,    ///< a recording over time, or what only its reader can refuse
  kOther,        ///< a file of this program that is no test, as a joint.json
};

/// A file of a test as open_test() found it.
struct TestFile {
  std::string path;                               ///< as it was named
  PartOfFile part = {};                           ///< its file and its variable
  TestContent content = TestContent::kRecording;  ///< by its content, not by its name
  std::string kind = {};                          ///< file_kind() of the file; empty of a variable
  std::optional<RecordingFormat> format = {};     ///< of a recording, where one is read
  std::string text = {};  ///< all of a table that is no recording; of others the first bytes
  /// Of the whole file; empty where nobody can read it, or only once, and by Hashed::kNo.
  std::string sha256 = {};
  std::optional<MatVariable> sweep = {};  ///< of a MATLAB file, where it is kSteppedSine
  bool once = false;  ///< a pipe, device or standard input, of which nothing was taken
};

/// Whether open_test() hashes a file that is read later.
enum class Hashed : bool { kNo, kYes };

/// Opens a file, recognises it, hashes it and, of a table of levels or of stepped sines, reads it.
/// Of standard input that is a file the kind alone is found; a pipe or a device counts as a
/// recording. A variable of a MATLAB file is read, and kept where it is of stepped sines.
/// @param path    a file, `FILE:VARIABLE` of a MATLAB file, or "-".
/// @param hashed  whether the SHA-256 of a recording or a variable is asked for.
/// @throws FileError  where it does not exist, is a folder or may not be read.
[[nodiscard]] TestFile open_test(const std::string& path, Hashed hashed = Hashed::kYes);

/// A test is recognised and hashed before it is read.
/// @param file  that was opened.
/// @param name  of the input, for messages.
/// @param what  that it must be: "a file".
/// @throws InputError  of what can be read only once.
void require_file(const TestFile& file, const std::string& name, std::string_view what);

/// The text of a table.
/// @throws FileError  where it was not read by open_test() and cannot be read.
[[nodiscard]] std::string text_of(const TestFile& file);

/// Reads the recordings of a file whose content is kRecording.
/// @throws FileError, FormatError, InputError, Cancelled  as read_recordings() of its path.
[[nodiscard]] Recordings read_recordings(const TestFile& file, const RecordingReadOptions& options);

/// The sweeps of a file whose content is kSteppedSine.
/// @throws FileError, FormatError, InputError  as read_mat_sweeps(), response_sweeps() and
///                                             parse_stepped_sine().
[[nodiscard]] std::vector<SteppedSine> read_stepped_sines(const TestFile& file);

}  // namespace microslip
