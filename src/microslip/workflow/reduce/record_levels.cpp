// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/record_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/identify/records/record_inversion.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/flag_meanings.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

CyclesOfRecord cycles_of(NamedForceRecord read) {
  CyclesOfRecord record{read.source, read.start, read.record.time_step, {}, std::move(read.times)};
  of_record(read.source, [&] {
    const RecordEvidence evidence(std::move(read.record), PathStart::kVirgin);
    // One loop from tip to tip turns once; whether it closes is judged with the cycles.
    if (evidence.rows().reversals != 1) check_records({&evidence, 1});
    record.found = record_cycles(evidence);
  });
  return record;
}

std::size_t sum_over(const std::vector<CyclesOfRecord>& records, std::size_t RecordCycles::*count) {
  std::size_t sum = 0;
  for (const CyclesOfRecord& record : records) sum += record.found.*count;
  return sum;
}

[[noreturn]] void throw_no_cycle(const std::vector<CyclesOfRecord>& records) {
  const std::size_t unresolved = sum_over(records, &RecordCycles::unresolved);
  const std::size_t coarse = sum_over(records, &RecordCycles::coarse);
  const std::string name = records.size() == 1
                               ? records.front().source + ": closed cycles"
                               : fmt::format("closed cycles of {} records", records.size());
  if (unresolved + coarse == 0) {
    throw InputError(name, InputState{"none"},
                     "must occur at least once: a reversal, a reversal back, and the return to the "
                     "first, after a range as large",
                     "Record two cycles or more, or identify from the record itself.");
  }
  throw InputError(
      name, InputState{fmt::format("{} below noise, {} with too few samples", unresolved, coarse)},
      "must be above noise and have at least a dozen samples",
      "Record larger cycles, or sample faster.");
}

std::string flags_text(const RecordCycle& cycle) {
  return fmt::format("{}", fmt::join(cycle.flags, " "));
}

/// Each flag once, with the number of cycles that have it.
std::vector<Warning> flag_warnings(const std::vector<CyclesOfRecord>& records) {
  std::map<std::string, std::size_t> cycles_with;
  std::size_t all = 0;
  for (const CyclesOfRecord& record : records) {
    for (const RecordCycle& cycle : record.found.cycles) {
      ++all;
      for (const std::string& flag : cycle.flags) ++cycles_with[flag];
    }
  }
  std::vector<Warning> warnings;
  for (const auto& [flag, count] : cycles_with) {
    warnings.push_back({flag, fmt::format("{} of {} are flagged {}: {}", count,
                                          counted(all, "cycle"), flag, flag_meaning(flag))});
  }
  return warnings;
}

void warn_of_left_out(const CyclesOfRecord& record, std::vector<Warning>& warnings) {
  const RecordCycles& found = record.found;
  const std::string of = record.source;
  if (found.cycles.empty()) {
    warnings.push_back({"no_cycle", fmt::format("{} has no closed cycle that could be used.", of)});
  }
  if (found.unresolved > 0) {
    warnings.push_back(
        {"cycles_in_noise",
         fmt::format("{} of {} are left out: up to a half range of {:.3g} m, D is below noise.",
                     counted(found.unresolved, "cycle"), of, found.smallest)});
  }
  if (found.coarse > 0) {
    warnings.push_back({"cycles_too_coarse",
                        fmt::format("{} of {} are left out: they have fewer than a dozen samples.",
                                    counted(found.coarse, "cycle"), of)});
  }
}

/// All cycles with a column of each.
template <typename Value>
auto column(const RecordLevels& found, const Value& value) {
  std::vector<decltype(value(found.records.front(), std::declval<const RecordCycle&>()))> values;
  for (const CyclesOfRecord& record : found.records) {
    for (const RecordCycle& cycle : record.found.cycles) values.push_back(value(record, cycle));
  }
  return values;
}

template <typename Member>
std::vector<double> numbers(const RecordLevels& found, Member RecordCycle::*member) {
  return column(found, [&](const CyclesOfRecord&, const RecordCycle& cycle) {
    return static_cast<double>(cycle.*member);
  });
}

Levels levels_of(const RecordLevels& found) {
  std::vector<RecordCycles> cycles;
  for (const CyclesOfRecord& record : found.records) cycles.push_back(record.found);
  return levels_of_cycles(cycles);
}

std::vector<double> times(const RecordLevels& found, std::size_t RecordCycle::*sample) {
  return column(found, [&](const CyclesOfRecord& record, const RecordCycle& cycle) {
    return record.time_of(cycle.*sample);
  });
}

std::string describe_record(const CyclesOfRecord& record) {
  const RecordCycles& found = record.found;
  std::string text = line("record", shortened(record.source, 56));
  text += line("", counted(found.cycles.size(), "cycle"));
  if (found.force_noise == 0.0 && found.path_noise == 0.0) {
    return text + line("", "no noise detected: no standard deviations");
  }
  return text + line("", fmt::format("noise per sample: {:.2g} N and {:.2g} m", found.force_noise,
                                     found.path_noise));
}

}  // namespace

std::size_t RecordLevels::count() const {
  std::size_t sum = 0;
  for (const CyclesOfRecord& record : records) sum += record.found.cycles.size();
  return sum;
}

RecordLevels find_record_levels(const RecordLevelsOptions& options) {
  check_distinct_files(options.records);
  return find_record_levels(read_force_records(options.records, options.channels, options.reading));
}

RecordLevels find_record_levels(ForceRecords read) {
  RecordLevels found;
  for (NamedForceRecord& one : read.records) found.records.push_back(cycles_of(std::move(one)));
  if (found.count() == 0) throw_no_cycle(found.records);
  found.inputs = std::move(read.inputs);
  found.warnings = std::move(read.warnings);
  std::ranges::move(same_content_warnings(found.inputs, "the record"),
                    std::back_inserter(found.warnings));
  for (const CyclesOfRecord& record : found.records) warn_of_left_out(record, found.warnings);
  std::ranges::move(flag_warnings(found.records), std::back_inserter(found.warnings));
  return found;
}

std::string levels_text(const RecordLevels& found, std::string_view command) {
  CsvWriter table = levels_table(levels_of(found));
  table.add_text("source", column(found, [](const CyclesOfRecord& record, const RecordCycle&) {
                   return record.source;
                 }));
  table.add_numbers("start_time", kTime, times(found, &RecordCycle::first));
  table.add_numbers("end_time", kTime, times(found, &RecordCycle::last));
  table.add_numbers("mean_displacement", kLength, numbers(found, &RecordCycle::mean_displacement));
  table.add_numbers("mean_force", kForce, numbers(found, &RecordCycle::mean_force));
  table.add_numbers("force_gap", kForce, numbers(found, &RecordCycle::gap));
  table.add_numbers("inner_cycles", kDimensionless, numbers(found, &RecordCycle::inner));
  table.add_text("flags", column(found, [](const CyclesOfRecord&, const RecordCycle& cycle) {
                   return flags_text(cycle);
                 }));
  std::string comment = heading_of(command);
  for (const InputHash& input : found.inputs) {
    if (!input.sha256.empty()) comment += '\n' + hash_comment(input.file, input.sha256);
  }
  table.add_comment(with_warnings(std::move(comment), found.warnings));
  return table.str();
}

std::string describe_record_levels(const RecordLevels& found) {
  const Levels levels = levels_of(found);
  const auto span = [](const std::vector<double>& values) {
    const auto [low, high] = std::ranges::minmax(values);
    return fmt::format("{:.4g} to {:.4g}", low, high);
  };
  std::string text = "Levels of closed cycles\n";
  for (const CyclesOfRecord& record : found.records) text += describe_record(record);
  text += line("cycles", fmt::format("{}, {} of them with inner cycles, removed", found.count(),
                                     std::ranges::count_if(numbers(found, &RecordCycle::inner),
                                                           [](double n) { return n > 0.0; })));
  text += line("amplitude", span(levels.amplitude) + " m");
  text += line("dissipation", span(levels.dissipation) + " J");
  text += line("secant stiffness", span(levels.secant_stiffness) + " N/m");
  return text + describe_warnings(found.warnings);
}

}  // namespace microslip
