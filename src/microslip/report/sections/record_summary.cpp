// SPDX-License-Identifier: MIT
// The summary of a joint that was identified from records of force and displacement.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/percent.hpp"
#include "microslip/observe/sensor_drift.hpp"
#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/sections/prediction_reach.hpp"
#include "microslip/report/sections/record_sections.hpp"
#include "microslip/report/sections/verdict_block.hpp"
#include "microslip/workflow/results/verdict.hpp"
#include "microslip/workflow/text/departure_meanings.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// A departure in one record.
struct Judged {
  std::size_t record;  // from 0
  DepartureFound found;
};

/// Orders departures: those found after those not found, then by their share over that of noise.
bool stands_out_less(const Judged& a, const Judged& b) {
  if (a.found.broken != b.found.broken) return b.found.broken;
  return a.found.share * b.found.noise < b.found.share * a.found.noise;
}

/// Each departure in the record where it stands out most.
std::vector<Judged> verdicts_of(const FoundByRecords& found) {
  std::vector<Judged> all;
  for (std::size_t r = 0; r < found.records.size(); ++r) {
    for (const DepartureFound& one : found.records[r].verdicts) {
      const Judged judged{r, one};
      const auto known = std::ranges::find_if(
          all, [&](const Judged& other) { return other.found.departure == one.departure; });
      if (known == all.end()) {
        all.push_back(judged);
      } else if (stands_out_less(*known, judged)) {
        *known = judged;
      }
    }
  }
  std::ranges::stable_sort(all,
                           [](const Judged& a, const Judged& b) { return stands_out_less(b, a); });
  return all;
}

std::size_t broken_count(const std::vector<Judged>& verdicts) {
  return static_cast<std::size_t>(
      std::ranges::count_if(verdicts, [](const Judged& one) { return one.found.broken; }));
}

/// "270.3 ± 2.0 kN/m": half the width of the band, to two digits and k to as many places.
std::string stiffness_text(const IdentifiedJoint& joint) {
  const double k = joint.joint.stiffness() / kKilonewtonPerMetre;
  if (!joint.by_records->stiffness) return fmt::format("{:.4g} kN/m", k);
  const BandedValue& band = *joint.by_records->stiffness;
  const double half = 0.5 * (band.upper - band.lower) / kKilonewtonPerMetre;
  if (!(half > 0.0)) return fmt::format("{:.4g} kN/m", k);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(half))), 0, 6);
  return fmt::format("{:.{}f} ± {:.{}f} kN/m", k, places, half, places);
}

double most_unexplained(const FoundByRecords& found) {
  return std::ranges::max_element(found.records, {}, &RecordFound::unexplained)->unexplained;
}

std::string lead_of_records(const ExperimentResults& results) {
  const IdentifiedJoint& joint = *results.joint;
  const std::size_t broken = broken_count(verdicts_of(*joint.by_records));
  std::string text = fmt::format(
      "A joint was identified from {} of force and displacement{}. ",
      counted(joint.by_records->records.size(), "record"),
      joint.by_records->stiffness ? ", and its stuck stiffness k with it" : " with k as given");
  text += broken == 0
              ? "The records do not contradict a Masing joint under constant normal load."
              : "It is not a Masing joint under constant normal load: its density is only that of "
                "the nearest such joint.";
  return text;
}

ReportFacts key_facts_of_records(const IdentifiedJoint& joint) {
  const FoundByRecords& found = *joint.by_records;
  const std::vector<Judged> verdicts = verdicts_of(found);
  ReportFacts facts{.prominent = true, .beside = true};
  const auto add = [&](std::string name, std::string value) {
    facts.facts.emplace_back(std::move(name), std::move(value));
  };
  add(found.stiffness
          ? fmt::format("stuck stiffness k, {:.0f} % band", 100.0 * joint.band_confidence)
          : "stuck stiffness k, as given",
      stiffness_text(joint));
  if (joint.covered_from && joint.covered_to) {
    add("slip forces determined",
        fmt::format("{:.3g} to {:.3g} N", *joint.covered_from, *joint.covered_to));
  }
  add(found.records.size() > 1 ? "force unexplained, at most" : "force unexplained",
      percent_text(most_unexplained(found)));
  if (!verdicts.empty()) {
    const std::size_t broken = broken_count(verdicts);
    add("departures found", broken == 0 ? fmt::format("none of {}", verdicts.size())
                                        : fmt::format("{} of {}", broken, verdicts.size()));
  }
  return facts;
}

ReportTable verdict_table(const FoundByRecords& found) {
  const bool several = found.records.size() > 1;
  ReportTable table{
      .title = "Is it a Masing joint?",
      .caption = fmt::format(
          "Share of the force that a departure explains besides the joint, against that of noise "
          "alone{}. It is found where it is far above noise.",
          several ? "; each in the record where it stands out most" : ""),
      .columns = {{.name = "departure"}}};
  if (several) table.columns.push_back({.name = "record", .unit = "1", .digits = 0});
  table.columns.push_back({.name = "of the force", .unit = "%", .digits = 2});
  table.columns.push_back({.name = "by noise", .unit = "%", .digits = 2});
  table.columns.push_back({.name = "found"});
  table.beside = true;
  for (const Judged& judged : verdicts_of(found)) {
    if (judged.found.broken) table.marked.push_back(table.rows.size());
    std::vector<ReportCell>& row = table.rows.emplace_back();
    row.emplace_back(departure_meaning(judged.found.departure));
    if (several) row.emplace_back(static_cast<double>(judged.record + 1));
    row.emplace_back(judged.found.share / kPercent);
    row.emplace_back(judged.found.noise / kPercent);
    row.emplace_back(judged.found.broken ? "yes" : "no");
  }
  return table;
}

std::string banded_text(const BandedValue& value, double unit, std::string_view name) {
  return fmt::format("{:.4g} {}, band {:.4g} to {:.4g}", value.value / unit, name,
                     value.lower / unit, value.upper / unit);
}

/// The drifts of both sensors over a record; empty where none was subtracted.
std::string drift_text(const RecordFound& record) {
  std::string text;
  if (!record.displacement_drift.empty()) {
    text = fmt::format("{:+.3g} µm", drift_at(record.displacement_drift, 1.0) / kMicrometre);
  }
  if (!record.force_drift.empty()) {
    text += fmt::format("{}{:+.3g} N", text.empty() ? "" : ", ", drift_at(record.force_drift, 1.0));
  }
  return text.empty() ? text : text + " from its first sample to its last";
}

ReportFacts certainty_of_records(const IdentifiedJoint& joint) {
  const FoundByRecords& found = *joint.by_records;
  ReportFacts facts{.title = "Results and uncertainty", .facts = {}};
  const auto add = [&](std::string name, std::string value) {
    facts.facts.emplace_back(std::move(name), std::move(value));
  };
  if (found.stiffness) {
    add("stuck stiffness k", banded_text(*found.stiffness, kKilonewtonPerMetre, "kN/m"));
  }
  if (found.elastic) {
    add("elastic part K_e", banded_text(*found.elastic, kKilonewtonPerMetre, "kN/m"));
  }
  add("slipping fraction of k", percent_text(joint.joint.density().total().zeroth));
  if (found.viscous) add("viscous part c", banded_text(*found.viscous, 1.0, "N s/m"));
  for (std::size_t r = 0; r < found.records.size(); ++r) {
    const std::string drift = drift_text(found.records[r]);
    if (!drift.empty()) add(fmt::format("drift subtracted from record {}", r + 1), drift);
  }
  if (const auto width = typical_half_width(joint)) {
    add("density known to", fmt::format("± {} (median half-width of the {:.0f} % band)",
                                        percent_text(*width), 100.0 * joint.band_confidence));
  }
  if (joint.band_samples) add("posterior draws", fmt::format("{:.0f}", *joint.band_samples));
  add("solver", joint.status);
  add("total slip force", fmt::format("{:.4g} N", joint.joint.macroslip_force()));
  return facts;
}

}  // namespace

ReportSection record_summary_section(const ExperimentResults& results) {
  const IdentifiedJoint& joint = *results.joint;
  ReportSection section{.title = "Summary", .blocks = {}};
  const auto add = [&section](auto block) { section.blocks.emplace_back(std::move(block)); };
  const ReportWarnings warnings{.warnings = warnings_of(results, {}), .beside = true};
  std::vector<DepartureFound> looked_for;
  for (const RecordFound& record : joint.by_records->records) {
    std::ranges::copy(record.verdicts, std::back_inserter(looked_for));
  }
  add(verdict_on_joint(looked_for, joint.status, warnings.warnings));
  if (joint.joint.density().largest_slip_force() > 0.0) {
    add(ReportFigure{.figure = density_figure(results)});
  } else {
    add(ReportMissing{"No density: no part of the joint slips."});
  }
  add(key_facts_of_records(joint));
  add(verdict_table(*joint.by_records));
  add(reach_of_records(results));
  add(warnings);
  add(ReportText{lead_of_records(results)});
  add(certainty_of_records(joint));
  add(
      ReportText{"Not examined: whether the gains of force and displacement are right, whether the "
                 "displacement is that across the joint alone, and whether the test repeats."});
  return section;
}

}  // namespace microslip
