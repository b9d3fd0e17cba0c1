// SPDX-License-Identifier: MIT
#include "microslip/workflow/records_identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/units.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/workflow/identification_text.hpp"
#include "microslip/workflow/named_recordings.hpp"
#include "microslip/workflow/summary_text.hpp"

namespace microslip {
namespace {

/// The channel of that name, or the only one of that quantity.
std::string channel_of(const Recording& recording, const std::string& name,
                       const Dimension& dimension, std::string_view option) {
  if (!name.empty()) return name;
  std::vector<std::string> fits;
  for (const Channel& channel : recording.channels) {
    if (channel.dimension == dimension) fits.push_back(channel.name);
  }
  if (fits.size() == 1) return fits.front();
  throw InputError(
      fmt::format("{}: channel of {}", recording.source, dimension_name(dimension)),
      InputState{fits.empty() ? "missing" : fmt::format("there {} times", fits.size())},
      "must be there once",
      fmt::format("The channels are {}; choose by `{}`, and give units that the file lacks by "
                  "`assume_units`.",
                  names_of_channels(recording), option));
}

std::vector<double> values_of(const Recording& recording, const std::string& name,
                              const Dimension& dimension) {
  const std::span<const double> values = recording.signal(name, dimension);
  return {values.begin(), values.end()};
}

/// Recordings of all files.
struct ReadRecords {
  std::vector<Recording> recordings;
  std::vector<double> input;  // number of the file of each, from 1
  std::vector<Warning> warnings;
};

ReadRecords read_all(const RecordsIdentification& options) {
  ReadRecords all;
  std::vector<std::vector<Warning>> warnings;
  for (const std::string& path : options.records) {
    std::vector<Recording> found =
        read_named_recordings(path, options.reading, warnings.emplace_back());
    all.input.insert(all.input.end(), found.size(), static_cast<double>(warnings.size()));
    std::ranges::move(found, std::back_inserter(all.recordings));
  }
  all.warnings = joined_warnings(warnings);
  return all;
}

/// What a record is at fault for names it.
template <typename Call>
void of_record(const std::string& source, const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", source, error.name()));
  }
}

RecordStart start_of(const RecordEvidence& evidence, const RecordsIdentification& options) {
  if (options.start) return {*options.start, false, 0.0};
  return shown_start(evidence);
}

std::vector<InputHash> hashes_of(const std::vector<std::string>& paths) {
  std::vector<InputHash> hashes;
  for (const std::string& path : paths) {
    hashes.push_back({path, recording_sha256(path)});
  }
  return hashes;
}

NamedValues record_of_options(const RecordsIdentification& options) {
  NamedValues record;
  record.emplace_back("method", "inversion");
  record.emplace_back("force", options.channels.force);
  record.emplace_back("displacement", options.channels.displacement);
  record.emplace_back("start",
                      std::string(options.start ? to_string(*options.start) : "as it shows"));
  record.emplace_back("viscous", options.options.viscous ? "fit" : "none");
  record.emplace_back("samples", static_cast<double>(options.options.draws));
  record.emplace_back("assume_units", list_of_texts(options.assumed_units));
  record.emplace_back("allow_truncated", options.reading.allow_truncated ? "yes" : "no");
  return record;
}

/// Where the start of a record is known from.
std::string_view origin_of(const RecordStart& start, const RecordsIdentification& options) {
  if (options.start) return "given";
  const bool shown = start.start == PathStart::kUnknown || start.shown;
  return shown ? "shown" : "assumed";
}

/// Which recordings the records are, and who says in which state they begin.
void add_sources(const RecordsIdentification& options, const IdentifiedRecords& done,
                 NamedValues& record) {
  std::vector<std::string> start_from;
  for (const RecordStart& start : done.start) start_from.emplace_back(origin_of(start, options));
  record.emplace_back("start_from", list_of_texts(start_from));
  record.emplace_back("record_source", list_of_texts(done.source));
  record.emplace_back("record_input", done.input);
}

std::string describe_start(const RecordStart& start) {
  if (start.start == PathStart::kUnknown) {
    return start.early_misfit > 0.0 ? "had slipped before, as its first samples show"
                                    : "of unknown state, as given";
  }
  return start.shown ? "virgin, as its first samples show" : "virgin, not shown";
}

std::string describe_record(const std::string& source, const RecordStart& start,
                            const RecordFit& fit) {
  return line("record", shortened(source, 56)) + line("", describe_start(start)) +
         line("", fmt::format("force scatters by {:.2g} N a sample; {} of it unexplained",
                              fit.scatter, percent_text(fit.unexplained)));
}

}  // namespace

ForceRecord force_record(const Recording& recording, const JointChannels& channels) {
  const std::string force = channel_of(recording, channels.force, kForce, "force");
  const std::string displacement =
      channel_of(recording, channels.displacement, kLength, "displacement");
  ForceRecord record;
  record.force = values_of(recording, force, kForce);
  record.displacement = values_of(recording, displacement, kLength);
  if (!recording.axis.even()) {
    throw InputError(recording.source + ": time", InputState{"not evenly spaced"},
                     "must be evenly spaced to tell motion from noise",
                     "Resample the recording at its mean rate.");
  }
  record.time_step = recording.axis.step;
  return record;
}

IdentifiedRecords identify_records(const RecordsIdentification& options) {
  ReadRecords read = read_all(options);
  std::vector<RecordEvidence> evidence;
  std::vector<std::string> source;
  std::vector<RecordStart> start;
  for (const Recording& recording : read.recordings) {
    const ForceRecord record = force_record(recording, options.channels);
    of_record(recording.source, [&] {
      const RecordEvidence virgin(record, PathStart::kVirgin);
      start.push_back(start_of(virgin, options));
      evidence.push_back(virgin.from(start.back().start));
      check_records({&evidence.back(), 1}, options.options);
    });
    source.push_back(recording.source);
  }
  IdentifiedRecords done{.source = std::move(source),
                         .input = std::move(read.input),
                         .start = std::move(start),
                         .inputs = hashes_of(options.records),
                         .found = identify(evidence, options.stiffness, options.options)};
  done.found.warnings.insert(done.found.warnings.begin(), read.warnings.begin(),
                             read.warnings.end());
  return done;
}

std::string joint_text(const RecordsIdentification& options, const IdentifiedRecords& done,
                       std::string_view command) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = command;
  provenance.inputs = done.inputs;
  provenance.options = record_of_options(options);
  provenance.seed = options.options.seed;
  NamedValues identification = record_of_identification(done.found);
  add_sources(options, done, identification);
  return format_joint({done.found.joint, provenance, std::move(identification)});
}

std::string describe_identified_records(const IdentifiedRecords& done) {
  std::string text = describe_identification(done.found, done.source.size());
  std::string records;
  for (std::size_t r = 0; r < done.source.size(); ++r) {
    records += describe_record(done.source[r], done.start[r], done.found.records()->records[r]);
  }
  return text + records;
}

}  // namespace microslip
