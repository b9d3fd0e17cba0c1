// SPDX-License-Identifier: MIT
#include "microslip/workflow/records_identification.hpp"

#include <fmt/format.h>

#include <utility>

#include "microslip/base/percent.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/workflow/identification_text.hpp"
#include "microslip/workflow/summary_text.hpp"

namespace microslip {
namespace {

RecordStart start_of(const RecordEvidence& evidence, const RecordsIdentification& options) {
  if (options.start) return {*options.start, false, 0.0};
  return shown_start(evidence);
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

IdentifiedRecords identify_records(const RecordsIdentification& options) {
  ForceRecords read = read_force_records(options.records, options.channels, options.reading);
  std::vector<RecordEvidence> evidence;
  std::vector<std::string> source;
  std::vector<double> input;
  std::vector<RecordStart> start;
  for (NamedForceRecord& one : read.records) {
    of_record(one.source, [&] {
      const RecordEvidence virgin(std::move(one.record), PathStart::kVirgin);
      start.push_back(start_of(virgin, options));
      evidence.push_back(virgin.from(start.back().start));
      check_records({&evidence.back(), 1}, options.options);
    });
    source.push_back(one.source);
    input.push_back(one.input);
  }
  IdentifiedRecords done{.source = std::move(source),
                         .input = std::move(input),
                         .start = std::move(start),
                         .inputs = std::move(read.inputs),
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
