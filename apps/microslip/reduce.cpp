// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/io/reduction_file.hpp"
#include "microslip/io/rig_file.hpp"
#include "microslip/io/sha256.hpp"
#include "microslip/io/stepped_sine_file.hpp"
#include "microslip/rig/reduction.hpp"
#include "microslip/rig/reduction_batch.hpp"
#include "microslip/rig/stepped_sine.hpp"
#include "microslip/workflow/provenance.hpp"
#include "progress_bar.hpp"
#include "recording_arguments.hpp"
#include "reduction_report.hpp"

namespace microslip::app {
namespace {

struct ReduceOptions {
  std::string rig;
  std::vector<std::string> recordings;
  std::string out;
  std::string frequency;
  std::size_t order = 10;
  std::size_t modes = 0;
  bool no_vibrometer = false;
  RecordingArguments reading;
  bool skip_faulty = false;
};

ReductionOptions reduction_options(const ReduceOptions& options) {
  ReductionOptions reduction;
  reduction.fit.order = static_cast<int>(options.order);
  reduction.modes = options.modes;
  reduction.use_vibrometer = !options.no_vibrometer;
  reduction.fit.frequency_guess = frequency_guess(options.frequency);
  return reduction;
}

/// More recordings than this share one digest.
constexpr std::size_t kMostNamed = 4;

/// The call. Of many recordings the first and the last stand for all: one name after the other,
/// they would make a line that nobody reads.
std::string short_call(const ReduceOptions& options, const Call& call) {
  const std::string& line = call.command_line;
  const std::vector<std::string>& names = options.recordings;
  if (names.size() <= kMostNamed) return line;
  const std::size_t first = line.find(names.front());
  const std::size_t last = line.rfind(names.back());
  if (first == std::string::npos || last == std::string::npos || last <= first) return line;
  const std::size_t begin = first + names.front().size();
  const std::string between = line.substr(begin, last - begin);
  const bool names_only =
      between.find('\'') == std::string::npos && between.find(" -") == std::string::npos;
  return names_only ? line.substr(0, begin) + " ... " + line.substr(last) : line;
}

/// Of a recording that was read; of standard input, which cannot be read again, nothing.
std::string digest_of(const std::string& path) {
  return path == "-" ? std::string() : sha256(read_file(part_of_file(path).file));
}

/// Version, call, and digests of what was read. That of many recordings is what
/// `sha256sum RECORDINGS | sha256sum` says.
std::string reduction_provenance(const ReduceOptions& options, const Call& call,
                                 const std::string& rig, const std::vector<std::string>& digests) {
  std::string text = fmt::format("microslip {}: {}\n{}: sha256 {}", kVersion,
                                 short_call(options, call), input_name(options.rig), sha256(rig));
  std::string list;
  std::size_t count = 0;
  for (std::size_t i = 0; i < digests.size(); ++i) {
    if (digests[i].empty()) continue;
    const std::string file = part_of_file(options.recordings[i]).file;
    list += fmt::format("{}  {}\n", digests[i], file);
    ++count;
    if (digests.size() <= kMostNamed) text += fmt::format("\n{}: sha256 {}", file, digests[i]);
  }
  if (digests.size() > kMostNamed && count > 0) {
    text += fmt::format("\n{} recordings: sha256sum | sha256sum {}", count, sha256(list));
  }
  return text;
}

/// Stepped-sine tables have no scatter: a column that only some levels could have would be missing
/// in all.
[[noreturn]] void throw_mixed(const std::string& path, std::string_view found,
                              std::string_view wanted) {
  throw InputError(path, found, fmt::format("must be {}, as the first file is", wanted),
                   "Reduce the two kinds one after the other.");
}

std::vector<ReducedLevel> reduce_table(const Reducer& reducer, const std::string& path) {
  if (!is_stepped_sine(path)) {
    (void)read_file_head(part_of_file(path).file, 1);  // no table for it is no file?
    throw_mixed(path, "a record in time", "a stepped-sine table");
  }
  std::vector<ReducedLevel> levels;
  for (const SteppedSine& sweep : read_stepped_sines(path)) {
    levels.push_back(reduce_stepped_sine(reducer, sweep));
  }
  return levels;
}

ReductionBatch reduce_tables(const Reducer& reducer, const ReduceOptions& options,
                             std::vector<std::string>& digests) {
  ReductionBatch batch;
  for (std::size_t i = 0; i < options.recordings.size(); ++i) {
    try {
      std::ranges::move(reduce_table(reducer, options.recordings[i]),
                        std::back_inserter(batch.levels));
      digests[i] = digest_of(options.recordings[i]);
    } catch (const Error& error) {
      if (!options.skip_faulty) throw;
      batch.rejected.push_back({i, error.what()});
    }
  }
  return batch;
}

ReductionBatch reduce_records(const Reducer& reducer, const ReduceOptions& options, bool quiet,
                              std::vector<std::string>& digests,
                              std::vector<std::vector<Warning>>& warnings) {
  const RecordingReadOptions reading = read_options(options.reading);
  const auto read = [&](std::size_t i) {
    const std::string& path = options.recordings[i];
    if (is_stepped_sine(path)) throw_mixed(path, "a stepped-sine table", "a record in time");
    std::vector<Recording> recordings = read_named_recordings(path, reading, warnings[i]);
    digests[i] = digest_of(path);
    return recordings;
  };
  ReductionBatch batch = reduce_batch(
      reducer, options.recordings.size(), read,
      {.skip_faulty = options.skip_faulty, .progress = progress_bar("records", quiet)});
  if (!quiet) std::ranges::for_each(warnings, show_warnings);
  return batch;
}

/// The flags say more of the cause than a D below 0.
std::string causes(const ReducedLevel& level) {
  std::string text;
  for (const Warning& flag : level.flags) text += (text.empty() ? "" : " ") + flag.text;
  return text;
}

/// A table of levels has D ≥ 0, as every reader of it expects.
std::vector<ReducedLevel> writable_levels(const std::vector<ReducedLevel>& levels) {
  std::vector<ReducedLevel> result;
  std::ranges::copy_if(levels, std::back_inserter(result), [](const ReducedLevel& level) {
    return !level.has_flag(kNegativeDissipation);
  });
  if (!result.empty()) return result;
  const ReducedLevel& first = levels.front();
  throw InputError(first.source + ": dissipation", fmt::format("{:.3g} J", first.dissipation.value),
                   "must be above 0 in one level at least", causes(first));
}

/// What only solving the rig can find, such as a stick frequency out of reach, names the file too.
Reducer reducer_of(const ReduceOptions& options, const std::string& text) {
  const Rig rig = parse_rig(text, input_name(options.rig));
  const ReductionOptions reduction = reduction_options(options);
  try {
    return Reducer(rig, reduction);
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", input_name(options.rig), error.name()));
  }
}

int run(const ReduceOptions& options, const Call& call) {
  check_output(options.out, kLevelsKind);
  constexpr std::size_t kLargestRig = std::size_t{1} << 20U;
  const std::string rig = read_file(options.rig, kLargestRig);
  const Reducer reducer = reducer_of(options, rig);
  std::vector<std::string> digests(options.recordings.size());
  std::vector<std::vector<Warning>> warnings(options.recordings.size());
  const ReductionBatch batch =
      is_stepped_sine(options.recordings.front())
          ? reduce_tables(reducer, options, digests)
          : reduce_records(reducer, options, call.quiet, digests, warnings);
  if (batch.levels.empty()) {
    throw InputError("recordings", fmt::format("{} files", options.recordings.size()),
                     "must hold one that can be reduced",
                     batch.rejected.empty() ? "" : batch.rejected.front().reason);
  }
  CsvWriter table = reduction_table(writable_levels(batch.levels));
  table.add_comment(reduction_provenance(options, call, rig, digests));
  add_warnings(joined_warnings(warnings), table);
  add_warnings(reduction_warnings(batch), table);
  write_file(options.out, table.str());
  if (!call.quiet) {
    fmt::print(options.out == "-" ? stderr : stdout, "{}", describe_reduction(reducer, batch));
  }
  return kDone;
}

}  // namespace

void add_reduce(CLI::App& program, Call& call) {
  auto options = std::make_shared<ReduceOptions>();
  CLI::App* command =
      program.add_subcommand("reduce", "Levels of a frictional-support test from its recordings");
  command->add_option("rig", options->rig, "Description of the test, rig.toml")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("recordings", options->recordings,
                   "Steady records, one a level (CSV, UFF, MAT, HDF5), or stepped-sine tables: CSV "
                   "with frequency [Hz], force [N], acceleration [m/s^2], phase [rad], or "
                   "FILE.mat:VARIABLE with such fields")
      ->required()
      ->type_name(kRecordingValue);
  command->add_option("--out", options->out, "levels.csv to write; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_option("--frequency", options->frequency,
                      "Frequency of the drive, to 3 %, in Hz; found if it is not given");
  command->add_option("--order", options->order, "Harmonics that are fitted")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command
      ->add_option("--modes", options->modes,
                   "Modes of the beam [default: those of the rig's [test], or 30]")
      ->check(CLI::Range(1, 200));
  command->add_flag("--no-vibrometer", options->no_vibrometer,
                    "Joint displacement from the accelerometers even if there is a vibrometer");
  add_recording_arguments(*command, options->reading);
  command->add_flag("--skip-faulty", options->skip_faulty,
                    "Leave out what cannot be read or reduced, and say so");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip reduce rig.toml level_*.csv --out levels.csv",
                          "microslip reduce rig.toml test.h5 --no-vibrometer --out levels.csv",
                          "microslip reduce modes.toml sweep.csv --out levels.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
