// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/signal/recording/resampling.hpp"
#include "microslip/workflow/reduce/recording_conversion.hpp"
#include "microslip/workflow/reduce/recording_list.hpp"
#include "microslip/workflow/text/quantity_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip::app {
namespace {

struct ConvertOptions {
  std::string in;
  std::string out;
  std::string format;
  std::string recording;
  std::vector<std::string> channels;
  std::string resample;
  RecordingArguments reading;
  bool list = false;
  bool replace = false;
};

RecordingFormat format_of(const ConvertOptions& options) {
  const std::optional<RecordingFormat> named = find_recording_format(options.format);
  return named ? *named : recording_format_of_name(options.out);
}

Recordings read(const ConvertOptions& options, bool quiet) {
  return read_recordings(options.in, read_options(options.reading, progress_bar("reading", quiet)));
}

void choose_recording(const ConvertOptions& options, std::vector<Recording>& recordings) {
  if (options.recording.empty()) return;
  const std::uint64_t number =
      parse_whole_number("--recording", options.recording, 1, recordings.size(),
                         "--list shows the contents of the file.");
  recordings = {std::move(recordings[number - 1])};
}

void check_count(const ConvertOptions& options, RecordingFormat format, std::size_t count) {
  if (format != RecordingFormat::kCsv || count == 1) return;
  throw InputError(options.in, fmt::format("{} recordings", count),
                   "must be one where the output is CSV",
                   "Choose it with --recording N (see --list), or write uff, mat or h5.");
}

void resample(const std::string& rate, std::vector<Recording>& recordings) {
  if (rate.empty()) return;
  const double hertz = parse_quantity("--resample", rate, kFrequency);
  for (Recording& recording : recordings) recording = resampled(recording, hertz);
}

void print_summary(const ConvertOptions& options, const std::vector<Recording>& recordings) {
  std::size_t channels = 0;
  for (const Recording& recording : recordings) channels += recording.channels.size();
  print_text(stdout,
             fmt::format("{}: {}, {}\n", options.out, counted(recordings.size(), "recording"),
                         counted(channels, "channel")));
}

/// A choice leaves mode shapes out.
UffContents read_contents(const ConvertOptions& options, bool quiet) {
  if (!options.recording.empty() || !options.channels.empty()) {
    return {.recordings = read(options, quiet), .mode_shapes = {}};
  }
  return read_with_mode_shapes(options.in,
                               read_options(options.reading, progress_bar("reading", quiet)));
}

int list(const ConvertOptions& options, bool quiet) {
  auto [found, mode_shapes] = read_contents(options, quiet);
  if (!quiet) show_warnings(found.warnings);
  choose_recording(options, found.recordings);
  choose_channels(options.channels, found.recordings);
  resample(options.resample, found.recordings);
  print_text(stdout, fmt::format("{}{}", list_recordings(found), list_mode_shapes(mode_shapes)));
  return kDone;
}

/// What --replace gives up must be a recording: notes pass for a table, too.
void check_given_up(const std::string& out) {
  if (!std::filesystem::is_regular_file(out) || std::filesystem::file_size(out) == 0) return;
  try {
    (void)read_recordings(out, RecordingReadOptions{});
  } catch (const Error& error) {
    throw FileError(out, "exists and is no recording; it would be replaced",
                    "Move it away or choose another name.");
  }
}

int convert(const ConvertOptions& options, bool quiet) {
  const RecordingFormat format = format_of(options);
  const Replacing replacing = options.replace ? Replacing::kAny : Replacing::kSame;
  check_output(options.out, recording_kind(format), replacing);
  if (options.replace) check_given_up(options.out);
  Recordings found = read(options, quiet);
  choose_recording(options, found.recordings);
  check_count(options, format, found.recordings.size());
  choose_channels(options.channels, found.recordings);
  resample(options.resample, found.recordings);
  add_warning_attributes(found.warnings, found.recordings);
  OutputFiles files;
  write_recordings(files, options.out, found.recordings, format, replacing);
  files.commit();
  if (quiet) return kDone;
  show_warnings(found.warnings);
  if (options.out != "-") print_summary(options, found.recordings);
  return kDone;
}

void add_options(CLI::App& command, ConvertOptions& options) {
  command
      .add_option("in", options.in,
                  "Recordings: CSV, universal file (UFF), MATLAB, Octave, HDF5, TDMS, LVM or WAV, "
                  "detected from the content; "
                  "FILE.mat:VARIABLE for a part of a MATLAB file; - is standard input")
      ->required()
      ->type_name(kRecordingValue);
  command
      .add_option("out", options.out,
                  "File to write; .csv, .uff, .unv, .uf, .mat, .h5 or .hdf5 sets the format; "
                  "- is standard output, in CSV")
      ->type_name(kRecordingValue);
  command.add_flag("--list", options.list, "List the contents of the file and write nothing");
  command
      .add_option("--format", options.format,
                  "Format to write, regardless of the name; uff is binary")
      ->check(CLI::IsMember({"csv", "uff", "uff-ascii", "mat", "h5"}));
  command.add_option("--recording", options.recording,
                     "Number of the recording to take, from 1, where the file has several");
  command.add_option("--channel", options.channels, "Channel to take; may be repeated")
      ->allow_extra_args(false);
  command.add_option(
      "--resample", options.resample,
      "Sampling rate of even times to interpolate at, in Hz; the mean rate or above, "
      "for no filter is applied");
  command.add_flag(
      "--replace", options.replace,
      "Replace an existing recording of this format; without it one of another content "
      "is left as it is");
  add_recording_arguments(command, options.reading);
}

}  // namespace

void add_convert(CLI::App& program, Call& call) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = program.add_subcommand(
      "convert", "Convert recordings from one format to another, or list the contents of a file");
  add_options(*command, *options);
  command->add_flag("--quiet", call.quiet, "No summary, no warnings, no progress");
  add_examples(*command,
               {"microslip convert level_1.csv --list", "microslip convert level_1.csv level_1.uff",
                "microslip convert level_1.csv force.csv --channel force",
                "microslip convert logger.csv level.mat \\",
                "          --assume-units time=ms --assume-units acc1=g"});
  command->callback([options, &call] {
    if (options->out.empty() && !options->list) throw CLI::RequiredError("out or --list");
    if (!options->out.empty() && options->list) throw CLI::ExcludesError("--list", "out");
    call.prints_result = options->list;
    call.run = [options, &call] {
      return options->list ? list(*options, call.quiet) : convert(*options, call.quiet);
    };
  });
}

}  // namespace microslip::app
