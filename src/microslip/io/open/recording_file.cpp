// SPDX-License-Identifier: MIT
#include "microslip/io/open/recording_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/plausibility.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/memory_limit.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/loggers/logger_recording.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/output/write_error.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/recordings/sampling.hpp"
#include "microslip/io/uff/uff_recording.hpp"

namespace microslip {
namespace {

struct FormatEntry {
  std::string_view name;  ///< on the command line
  RecordingFormat format;
  std::string_view kind;
};

constexpr std::array kFormats{
    FormatEntry{"csv", RecordingFormat::kCsv, ""},
    FormatEntry{"uff", RecordingFormat::kUffBinary, "a universal file"},
    FormatEntry{"uff-ascii", RecordingFormat::kUff, "a universal file"},
    FormatEntry{"mat", RecordingFormat::kMat, "a MATLAB file"},
    FormatEntry{"h5", RecordingFormat::kHdf5, "an HDF5 file"},
};

/// Formats that are read alone.
constexpr std::array kReadFormats{
    FormatEntry{"mat73", RecordingFormat::kMat73, "a MATLAB file"},
    FormatEntry{"tdms", RecordingFormat::kTdms, "a TDMS file of LabVIEW"},
    FormatEntry{"lvm", RecordingFormat::kLvm, "an LVM file of LabVIEW"},
    FormatEntry{"wav", RecordingFormat::kWav, "a WAV file"},
};

struct Ending {
  std::string_view text;
  RecordingFormat format;
};

constexpr std::array kEndings{
    Ending{".csv", RecordingFormat::kCsv},       Ending{".uff", RecordingFormat::kUffBinary},
    Ending{".unv", RecordingFormat::kUffBinary}, Ending{".uf", RecordingFormat::kUffBinary},
    Ending{".mat", RecordingFormat::kMat},       Ending{".h5", RecordingFormat::kHdf5},
    Ending{".hdf5", RecordingFormat::kHdf5},
};

/// HDF5 may begin after 512 bytes, 1024, and so on.
bool is_hdf5_after_other(std::string_view head) {
  for (std::size_t start = 512; start < head.size(); start *= 2) {
    if (signature(head.substr(start)) == "an HDF5 file") return true;
  }
  return false;
}

/// A file of MATLAB 7.3: one of HDF5 behind 512 bytes.
bool is_mat73(std::string_view head) {
  return head.starts_with("MATLAB 7.3") && head.size() > 512 &&
         signature(head.substr(512)) == "an HDF5 file";
}

/// Whether a part of a file of this format has a name.
bool holds_variables(RecordingFormat format) {
  return format == RecordingFormat::kMat || format == RecordingFormat::kMat73;
}

/// Whether a line of a universal file announces binary data.
bool has_binary_dataset(std::string_view head) {
  return head.find("\n    58b") != std::string_view::npos;
}

constexpr std::string_view kExpected =
    "a recording in CSV, a universal file, MATLAB, Octave, HDF5, TDMS, LVM or WAV";

RecordingFormat format_of(std::string_view head, const std::string& name) {
  if (const auto format = find_recording_format_of(head)) return *format;
  const std::string_view found = signature(head);
  const KnownKind* const known = known_kind_of(head);
  if (known != nullptr) {
    throw FormatError({name, 0, 0}, kExpected, known->words, "Is it the right file?");
  }
  throw FormatError({name, 0, 0}, kExpected, found, remedy_for_signature(found));
}

[[noreturn]] void fail_as_pipe(const InputStream& file) {
  throw FileError(file.name(), "is a pipe or a device, which supports recordings in CSV only",
                  "Save them in a file and name that.");
}

void require_rewind(InputStream& file) {
  if (!file.rewind()) fail_as_pipe(file);
}

/// What is not CSV is opened again, for which a pipe would wait.
void require_file(const InputStream& file, RecordingFormat format) {
  if (format != RecordingFormat::kCsv && !file.size()) fail_as_pipe(file);
}

/// By readers that open the file themselves.
Recordings read_by_path(const PartOfFile& part, RecordingFormat format,
                        const RecordingReadOptions& options) {
  switch (format) {
    case RecordingFormat::kMat:
      return read_recordings_mat(part.file, part.variable, options);
    case RecordingFormat::kMat73:
      return read_recordings_mat73(part.file, part.variable, options);
    case RecordingFormat::kHdf5:
      return read_recordings_hdf5_or_octave(part.file, options);
    case RecordingFormat::kTdms:
      return read_recordings_tdms(part.file, options);
    case RecordingFormat::kLvm:
      return read_recordings_lvm(part.file, options);
    case RecordingFormat::kWav:
      return read_recordings_wav(part.file, options);
    default:
      return read_recordings_uff(part.file, options);
  }
}

Recordings read_format(InputStream& file, const PartOfFile& part,
                       const RecordingReadOptions& options) {
  const std::string_view head = file.peek(kKindHeadSize);
  const RecordingFormat format = format_of(head, file.name());
  const KnownKind* const known = known_kind_of(head);
  if (known != nullptr && !known->is_recording) {
    throw FormatError({file.name(), 0, 0}, kExpected, known->words, "Is it the right file?");
  }
  if (!part.variable.empty() && !holds_variables(format)) {
    throw InputError(part.file, in_quotes(":" + part.variable),
                     "must follow a MATLAB file, to name a variable in it",
                     "Name the file alone; all its recordings are read.");
  }
  if (format == RecordingFormat::kCsv) return read_recordings_csv(file, options);
  if (format == RecordingFormat::kUff || format == RecordingFormat::kUffBinary) {
    require_rewind(file);  // "-" is read on from where it stands
  } else if (part.file == "-") {
    throw FileError(file.name(), "supports only recordings in CSV or a universal file",
                    "Save them in a file and name that.");
  }
  require_file(file, format);
  if (format == RecordingFormat::kMat) return read_recordings_mat(file, part.variable, options);
  return read_by_path(part, format, options);
}

void write_csv(OutputFiles& files, const std::string& path, std::span<const Recording> recordings,
               Replacing replacing) {
  if (recordings.size() != 1) {
    throw InputError(path, fmt::format("{} recordings", recordings.size()),
                     "must be one in a CSV file",
                     "Choose one of them, or a format for several: uff, mat or h5.");
  }
  if (path == "-") {
    files.add(path, format_recording_csv(recordings.front()));
  } else {
    write_recording_csv(files.stage(path, replacing), recordings.front());
  }
}

void write_format(OutputFiles& files, const std::string& path,
                  std::span<const Recording> recordings, RecordingFormat format,
                  Replacing replacing) {
  switch (format) {
    case RecordingFormat::kCsv:
      return write_csv(files, path, recordings, replacing);
    case RecordingFormat::kUff:
    case RecordingFormat::kUffBinary:
      return write_recordings_uff(files.stage(path, replacing), recordings,
                                  format == RecordingFormat::kUffBinary);
    case RecordingFormat::kMat:
      return write_recordings_mat(files.stage(path, replacing), recordings);
    case RecordingFormat::kHdf5:
      return write_recordings_hdf5(files.stage(path, replacing), recordings);
    case RecordingFormat::kMat73:
    case RecordingFormat::kTdms:
    case RecordingFormat::kLvm:
    case RecordingFormat::kWav:
      throw InputError("format", recording_kind(format), "can be read, not written",
                       "Write csv, uff, mat or h5.");
  }
}

/// Where a rate is stated the points may be untimed.
RecordingReadOptions with_untimed(RecordingReadOptions options) {
  if (options.rate) check_rate(*options.rate);
  options.allow_untimed = options.allow_untimed || options.rate;
  return options;
}

void finish_reading(const RecordingReadOptions& options, const std::string& file,
                    Recordings& recordings) {
  if (options.rate) require_rate_used(*options.rate, file, recordings);
  finish_units(options.assumed_units, recordings);
}

}  // namespace

RecordingFormat recording_format(const std::string& path) {
  InputStream file(path);
  const RecordingFormat format = format_of(file.peek(kKindHeadSize), file.name());
  if (path == "-") require_rewind(file);
  require_file(file, format);
  return format;
}

std::optional<RecordingFormat> find_recording_format_of(std::string_view head) {
  const std::string_view found = signature(head);
  if (found == "a universal file") {
    return has_binary_dataset(head) ? RecordingFormat::kUffBinary : RecordingFormat::kUff;
  }
  if (is_mat_signature(found)) {
    return is_mat73(head) ? RecordingFormat::kMat73 : RecordingFormat::kMat;
  }
  const auto* const read_alone = std::ranges::find(kReadFormats, found, &FormatEntry::kind);
  if (read_alone != kReadFormats.end()) return read_alone->format;
  if (found == "an HDF5 file" || (found.empty() && is_hdf5_after_other(head))) {
    return RecordingFormat::kHdf5;
  }
  if (found.empty()) return RecordingFormat::kCsv;
  return std::nullopt;
}

std::optional<RecordingFormat> find_recording_format_of_name(std::string_view path) {
  std::string name(path);
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const auto* found =
      std::ranges::find_if(kEndings, [&](const Ending& e) { return name.ends_with(e.text); });
  if (found == kEndings.end()) return std::nullopt;
  return found->format;
}

RecordingFormat recording_format_of_name(std::string_view path) {
  if (path == "-") return RecordingFormat::kCsv;
  if (const auto format = find_recording_format_of_name(path)) return *format;
  throw InputError("name of the output", in_quotes(path),
                   "must end in .csv, .uff, .unv, .uf, .mat, .h5 or .hdf5",
                   "Or give the format with `format`.");
}

std::optional<RecordingFormat> find_recording_format(std::string_view name) {
  const auto* found = std::ranges::find(kFormats, name, &FormatEntry::name);
  if (found == kFormats.end()) return std::nullopt;
  return found->format;
}

std::string_view recording_kind(RecordingFormat format) {
  const auto* const read_alone = std::ranges::find(kReadFormats, format, &FormatEntry::format);
  if (read_alone != kReadFormats.end()) return read_alone->kind;
  return std::ranges::find(kFormats, format, &FormatEntry::format)->kind;
}

Recordings read_recordings(const std::string& path, const RecordingReadOptions& options) {
  const PartOfFile part = part_of_file(path);
  InputStream file(part.file);
  const RecordingReadOptions reading = with_untimed(options);
  Recordings result = within_memory(file.name(), [&] { return read_format(file, part, reading); });
  finish_reading(options, file.name(), result);
  return result;
}

Recordings read_recordings(const PartOfFile& file, RecordingFormat format,
                           const RecordingReadOptions& options) {
  if (format == RecordingFormat::kCsv) return read_recordings(file.file, options);
  const RecordingReadOptions reading = with_untimed(options);
  Recordings result = within_memory(file.file, [&] { return read_by_path(file, format, reading); });
  finish_reading(options, file.file, result);
  return result;
}

void finish_units(const AssumedUnits& units, Recordings& recordings) {
  assume_units(units, recordings.recordings);
  for (const Recording& recording : recordings.recordings) {
    for (const Channel& channel : recording.channels) {
      if (!channel.dimension || !channel.imaginary.empty()) continue;
      const auto [least, greatest] = std::ranges::minmax(channel.values);
      const double amplitude = 0.5 * greatest - 0.5 * least;
      auto warning = implausible_value(
          fmt::format("{}: channel {}", recording.source, in_quotes(channel.name)),
          *channel.dimension, amplitude);
      if (warning) recordings.warnings.push_back(*std::move(warning));
    }
  }
}

void write_recordings(OutputFiles& files, const std::string& path,
                      std::span<const Recording> recordings, RecordingFormat format,
                      Replacing replacing) {
  try {
    write_format(files, path, recordings, format, replacing);
  } catch (const WriteError& error) {
    throw error.renamed(path);  // its own is that of a temporary file
  }
}

}  // namespace microslip
