// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/records_identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "microslip/base/percent.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/config/named_value_access.hpp"
#include "microslip/workflow/identify/found_joint.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/predict/joint_draws.hpp"
#include "microslip/workflow/reduce/level_table.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/summary_text.hpp"

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
  if (options.fit_drift) record.emplace_back("drift", "fit");
  record.emplace_back("samples", static_cast<double>(options.options.draws));
  record.emplace_back("assume_units", list_of_texts(options.assumed_units));
  record.emplace_back("allow_truncated", options.reading.allow_truncated ? "yes" : "no");
  if (options.reading.rate) record.emplace_back("rate_Hz", *options.reading.rate);
  if (!options.levels.empty()) {
    record.emplace_back("inner_reversals", options.use_inner_reversals ? "use" : "leave-out");
  }
  if (!options.samples_out.empty()) record.emplace_back("samples_out", options.samples_out);
  return record;
}

Provenance records_provenance(const RecordsIdentification& options, const IdentifiedRecords& done,
                              std::string_view command) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = command;
  provenance.inputs = done.from.inputs;
  provenance.options = record_of_options(options);
  provenance.seed = options.options.seed;
  return provenance;
}

/// Where the start of a record is known from.
std::string_view origin_of(const RecordStart& start, const RecordsIdentification& options) {
  if (options.start) return "given";
  const bool shown = start.start == PathStart::kUnknown || start.shown;
  return shown ? "shown" : "assumed";
}

/// Sources of the records, and how their initial state was determined.
void set_sources(const RecordsIdentification& options, const IdentifiedRecords& done,
                 std::vector<RecordFound>& records) {
  for (std::size_t r = 0; r < records.size(); ++r) {
    records[r].start_from = origin_of(done.from.start[r], options);
    records[r].source = done.from.records[r];
    records[r].input = done.from.input[r];
    if (!done.from.drift[r]) continue;
    records[r].displacement_drift = done.from.drift[r]->drift.displacement;
    records[r].force_drift = done.from.drift[r]->drift.force;
  }
}

std::string describe_start(const RecordStart& start) {
  if (start.start == PathStart::kUnknown) {
    return start.early_misfit > 0.0 ? "had slipped before, detected from its first samples"
                                    : "unknown, as given";
  }
  return start.shown ? "virgin, detected from its first samples" : "virgin, not verified";
}

/// "+2.98e-06 m (σ 2e-08)", "none found".
std::string describe_drift(const std::vector<double>& drift, double deviation,
                           std::string_view unit) {
  if (drift.empty()) return "none found";
  return fmt::format("{:+.3g} {} (σ {:.1g})", drift_at(drift, 1.0), unit, deviation);
}

std::string describe_drift(const std::optional<DriftFit>& fit) {
  if (!fit) return {};
  return line("", "drift subtracted, first to last sample:") +
         line("", "  displacement " +
                      describe_drift(fit->drift.displacement, fit->displacement_std, "m")) +
         line("", "  force " + describe_drift(fit->drift.force, fit->force_std, "N"));
}

std::string describe_record(const std::string& source, const RecordStart& start,
                            const std::optional<DriftFit>& drift, const RecordFit& fit) {
  return line("record", shortened(source, 56)) + line("", describe_start(start)) +
         describe_drift(drift) +
         line("", fmt::format("force scatters by {:.2g} N per sample; {} of it unexplained",
                              fit.scatter, percent_text(fit.unexplained)));
}

std::string describe_table(const std::string& path, std::size_t count, const LevelFit& fit) {
  return line("levels", shortened(path, 56)) +
         line("", fmt::format("{}, D scatters by {}", counted(count, "level"),
                              fit.scatter_is_relative
                                  ? percent_text(fit.scatter.dissipation)
                                  : fmt::format("{:.2f} times the given standard deviations",
                                                fit.scatter.dissipation)));
}

/// Evidence read from the files, with their hashes.
struct EvidenceOfFiles {
  SourcedEvidence evidence = {};
  std::vector<Warning> warnings = {};
};

void gather_records(const RecordsIdentification& options, EvidenceOfFiles& all) {
  check_distinct_files(options.records);
  check_opened(options.opened, options.records);
  ForceRecords read = options.opened.empty()
                          ? read_force_records(options.records, options.channels, options.reading)
                          : read_force_records(options.opened, options.channels, options.reading);
  for (const NamedForceRecord& record : read.records) all.evidence.add(record, options);
  all.evidence.from.inputs = std::move(read.inputs);
  all.warnings = std::move(read.warnings);
}

void gather_levels(const RecordsIdentification& options, EvidenceOfFiles& all) {
  check_distinct_files(options.levels);
  for (const std::string& path : options.levels) {
    LevelTable table = read_level_table(path, {.use_inner_reversals = options.use_inner_reversals,
                                               .assemblies = options.assemblies});
    all.evidence.add(path, table.used.levels);
    all.evidence.from.inputs.push_back({path, sha256(table.input.text)});
    for (const Warning& warning : table.warnings) {
      all.warnings.push_back({warning.code, path + ": " + warning.text});
    }
  }
}

}  // namespace

RecordedReading recorded_reading(const NamedValues& options) {
  return {.channels = {.force = text_in(options, "force").value_or(""),
                       .displacement = text_in(options, "displacement").value_or("")},
          .reading = {.allow_truncated = text_in(options, "allow_truncated") == "yes",
                      .rate = number_in(options, "rate_Hz"),
                      .assumed_units = parse_assumed_units(texts_in(options, "assume_units"))}};
}

ReadyRecord ready_record(const ForceRecord& record, const RecordsIdentification& options) {
  const auto begun = [&](const ForceRecord& of) {
    const RecordEvidence virgin(of, PathStart::kVirgin);
    const RecordStart start = start_of(virgin, options);
    ReadyRecord ready{virgin.from(start.start), start};
    check_records({&ready.evidence, 1}, options.options);
    return ready;
  };
  if (!options.fit_drift) return begun(record);
  const auto fitted = [&](PathStart start) {
    const RecordEvidence evidence(record, start);
    DriftFit drift = fit_drift(evidence, options.stiffness, options.options);
    ReadyRecord without = begun(without_drift(record, drift.drift));
    without.drift = std::move(drift);
    return without;
  };
  // A drift hides the state at the first sample: without it the record shows it.
  const PathStart tried = options.start.value_or(PathStart::kVirgin);
  ReadyRecord ready = fitted(tried);
  if (ready.start.start != tried) ready = fitted(ready.start.start);
  return ready;
}

std::vector<Warning> drift_warnings(const IdentifiedRecords& done) {
  std::vector<Warning> warnings;
  for (std::size_t r = 0; r < done.from.drift.size(); ++r) {
    if (!done.from.drift[r]) continue;
    const SensorDrift& drift = done.from.drift[r]->drift;
    if (drift.displacement.empty() && drift.force.empty()) continue;
    const std::vector<RecordVerdict>& verdicts = done.found.records()->records[r].verdicts;
    if (std::ranges::none_of(verdicts, &RecordVerdict::broken)) continue;
    warnings.push_back(
        {"drift_uncertain",
         fmt::format("{}: a drift of its sensors was subtracted, and it is of no Masing joint even "
                     "so. Wear or a changing load looks like a drift, too: compare the result "
                     "without --drift.",
                     done.from.records[r])});
  }
  return warnings;
}

void SourcedEvidence::add(const NamedForceRecord& record, const RecordsIdentification& options) {
  of_record(record.source, [&] {
    ReadyRecord ready = ready_record(record.record, options);
    records.push_back(std::move(ready.evidence));
    from.start.push_back(ready.start);
    from.drift.push_back(std::move(ready.drift));
  });
  from.records.push_back(record.source);
  from.input.push_back(record.input);
}

void SourcedEvidence::add(const std::string& name, const Levels& table) {
  of_record(name, [&] { levels.emplace_back(table); });
  from.tables.push_back(name);
  from.levels.push_back(table.size());
}

IdentifiedRecords identify_evidence(SourcedEvidence evidence,
                                    const RecordsIdentification& options) {
  Identification found =
      identify({evidence.records, evidence.levels, evidence.from.records, evidence.from.tables},
               options.stiffness, options.options);
  IdentifiedRecords done{.from = std::move(evidence.from), .found = std::move(found)};
  std::ranges::move(drift_warnings(done), std::back_inserter(done.found.warnings));
  return done;
}

IdentifiedRecords identify_records(const RecordsIdentification& options) {
  EvidenceOfFiles all;
  gather_records(options, all);
  gather_levels(options, all);
  std::ranges::move(same_content_warnings(all.evidence.from.inputs, "it"),
                    std::back_inserter(all.warnings));
  IdentifiedRecords done = identify_evidence(std::move(all.evidence), options);
  done.found.warnings.insert(done.found.warnings.begin(), all.warnings.begin(), all.warnings.end());
  return done;
}

JointFile identified_joint(const RecordsIdentification& options, const IdentifiedRecords& done,
                           std::string_view command) {
  IdentifiedJoint found = found_joint(done.found);
  set_sources(options, done, found.by_records->records);
  return joint_file_of(found, records_provenance(options, done, command));
}

std::string joint_text(const RecordsIdentification& options, const IdentifiedRecords& done,
                       std::string_view command) {
  return format_joint(identified_joint(options, done, command));
}

std::string samples_bytes(const RecordsIdentification& options, const IdentifiedRecords& done,
                          std::string_view command) {
  return joint_samples_bytes(joint_samples(done.found, records_provenance(options, done, command)),
                             options.samples_out);
}

std::string describe_identified_records(const IdentifiedRecords& done) {
  std::string text =
      describe_identification(done.found, done.from.records.size() + done.from.tables.size());
  std::string records;
  for (std::size_t r = 0; r < done.from.records.size(); ++r) {
    records += describe_record(done.from.records[r], done.from.start[r], done.from.drift[r],
                               done.found.records()->records[r]);
  }
  for (std::size_t t = 0; t < done.from.tables.size(); ++t) {
    records +=
        describe_table(done.from.tables[t], done.from.levels[t], done.found.records()->levels[t]);
  }
  return text + records;
}

}  // namespace microslip
