// SPDX-License-Identifier: MIT
// The summary of joints that were found from levels of modes.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/percent.hpp"
#include "microslip/calibrate/known_together.hpp"
#include "microslip/report/figures/calibration_figures.hpp"
#include "microslip/report/figures/calibration_layers.hpp"
#include "microslip/report/sections/calibration_sections.hpp"
#include "microslip/report/sections/left_out.hpp"
#include "microslip/report/sections/prediction_reach.hpp"
#include "microslip/report/sections/verdict_block.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr const char* kCalibrate = "microslip calibrate MODEL.toml MODAL_LEVELS.csv --out DIR";

std::string names_text(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  const std::vector<std::string> first(names.begin(), names.end() - 1);
  return fmt::format("{} and {}", fmt::join(first, ", "), names.back());
}

std::size_t joint_count(const ExperimentResults& results) {
  return results.calibration ? results.calibration->joints.size() : results.densities.size();
}

/// Pairs whose sum alone is known, in words; empty where there is none.
std::string together_text(const CalibrationSummary& found) {
  std::string text;
  for (const PairSummary& pair : found.pairs) {
    if (!pair.known_only_together) continue;
    text += fmt::format(
        " {} and {} are known only together: rely on the sum of their losses, known to {}, not on "
        "either density by itself.",
        pair.first, pair.second, percent_text(pair.spread_together));
  }
  if (found.known_in_sum.size() > 1) {
    text += fmt::format(
        " {} are known only together: rely on the loss of all joints, not on any of "
        "their densities by itself.",
        names_text(found.known_in_sum));
  }
  return text;
}

std::string lead_of_calibration(const ExperimentResults& results) {
  const CalibrationSummary& found = *results.calibration;
  const std::size_t count = found.joints.size();
  std::string text = fmt::format(
      "The slip-force {} of {} found from {}{}.", count == 1 ? "density" : "densities",
      count == 1 ? "a joint was" : fmt::format("{} joints were", count),
      counted(static_cast<std::size_t>(found.levels_found), "level"),
      results.modal_levels
          ? fmt::format(" of {}", counted(rows_by_mode(*results.modal_levels).size(), "mode"))
          : "");
  if (found.status != "converged") {
    text += fmt::format(" The iteration did not converge ({}): do not rely on it.", found.status);
  }
  const std::string together = together_text(found);
  if (!together.empty()) return text + together;
  return count > 1 ? text + " The levels distinguish the joints." : text;
}

std::string scatter_text(double scatter, bool relative) {
  return relative ? percent_text(scatter) : fmt::format("{:.2f} × given σ", scatter);
}

ReportFacts key_facts_of_calibration(const ExperimentResults& results) {
  const CalibrationSummary& found = *results.calibration;
  ReportFacts facts{.prominent = true, .beside = true};
  const auto add = [&](std::string name, std::string value) {
    facts.facts.emplace_back(std::move(name), std::move(value));
  };
  add("joints found", fmt::format("{}", found.joints.size()));
  add("levels used", fmt::format("{:.0f} of {:.0f}", found.levels_found, found.levels));
  add("scatter of the losses", scatter_text(found.scatter, found.scatter_is_relative));
  if (!found.pairs.empty()) {
    const auto together = std::ranges::count_if(found.pairs, &PairSummary::known_only_together);
    const bool distinguished = together == 0 && found.known_in_sum.size() < 2;
    add("joints distinguished", distinguished ? "all" : "not all");
  }
  const std::string contradict =
      results.campaign ? count_that_contradict(*results.campaign) : std::string();
  if (!contradict.empty()) add("contradict the others", contradict);
  return facts;
}

/// Largest variance reduction of the density of each joint, 1; NaN where it is not known.
double largest_reduction(const ExperimentResults& results, const std::string& joint) {
  const auto density = std::ranges::find(results.densities, joint, &DensityFound::name);
  if (density == results.densities.end() || density->variance_reduction.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::ranges::max(density->variance_reduction);
}

/// Whether the levels do not determine the density of the joint by itself.
bool is_doubtful(const CalibrationSummary& found, const std::string& joint, double reduction) {
  return reduction < kDetermined || known_only_together(found, joint);
}

ReportTable joints_table(const ExperimentResults& results) {
  const CalibrationSummary& found = *results.calibration;
  ReportTable table{
      .title = "Joints",
      .caption =
          "Variance reduction: the largest share of the prior variance of the density that the "
          "levels removed. Do not rely on a marked joint by itself.",
      .columns = {{.name = "joint"},
                  {.name = "k", .unit = "kN/m"},
                  {.name = "slipping", .unit = "%", .digits = 3},
                  {.name = "up to", .unit = "N", .digits = 3},
                  {.name = "var. red.", .unit = "%", .digits = 3},
                  {.name = "DoF", .unit = "1", .digits = 3}},
      .beside = true};
  for (const JointSummary& joint : found.joints) {
    const double reduction = largest_reduction(results, joint.name);
    if (is_doubtful(found, joint.name, reduction)) table.marked.push_back(table.rows.size());
    table.rows.push_back({joint.name, joint.stiffness / kKilonewtonPerMetre,
                          joint.slipping_share / kPercent, joint.covered_to, reduction / kPercent,
                          joint.degrees_of_freedom});
  }
  return table;
}

bool band_of_stiffness_is_wide(const JointSummary& joint) {
  constexpr double kExact = 1e-3;  // as given, but for what the method leaves
  return joint.stiffness_upper - joint.stiffness_lower > kExact * joint.stiffness;
}

ReportFacts certainty_of_calibration(const CalibrationSummary& found) {
  ReportFacts facts{.title = "Uncertainty", .facts = {}};
  const auto add = [&](std::string name, std::string value) {
    facts.facts.emplace_back(std::move(name), std::move(value));
  };
  for (const JointSummary& joint : found.joints) {
    if (!band_of_stiffness_is_wide(joint)) continue;
    add(fmt::format("stuck stiffness of {}, {:.0f} % band", joint.name, 100.0 * found.confidence),
        fmt::format("{:.4g} to {:.4g} kN/m", joint.stiffness_lower / kKilonewtonPerMetre,
                    joint.stiffness_upper / kKilonewtonPerMetre));
  }
  add("scatter of the losses", scatter_text(found.scatter, found.scatter_is_relative));
  if (found.frequency_scatter > 0.0) {
    add("scatter of the frequencies", found.frequency_scatter_is_relative
                                          ? fmt::format("{:.1e} of them", found.frequency_scatter)
                                          : scatter_text(found.frequency_scatter, false));
  }
  if (!found.frequency_use.empty()) add("frequencies used", found.frequency_use);
  double freedom = 0.0;
  for (const JointSummary& joint : found.joints) freedom += joint.degrees_of_freedom;
  add("degrees of freedom of all densities", fmt::format("{:.1f}", freedom));
  add("solver", found.status);
  return facts;
}

/// @param doubtful  names of the joints whose density is doubtful.
std::string belief_text(const std::vector<std::string>& doubtful, std::size_t joints) {
  if (doubtful.size() > 1) {
    return fmt::format("Do not rely on the densities of {} by themselves.", names_text(doubtful));
  }
  if (doubtful.size() == 1) {
    return fmt::format("Do not rely on the density of {} by itself.", doubtful.front());
  }
  return joints == 1 ? "The levels determine the density." : "The levels determine each density.";
}

/// The verdict on joints that were found together.
ReportVerdict verdict_on_joints(const ExperimentResults& results,
                                const std::vector<Warning>& warnings) {
  const CalibrationSummary& found = *results.calibration;
  ReportVerdict verdict{.text = {}, .codes = codes_of(warnings)};
  if (found.status != kConvergedStatus) {
    verdict.text =
        fmt::format("The iteration did not converge ({}): do not rely on it. ", found.status);
  }
  std::vector<std::string> doubtful;
  for (const JointSummary& joint : found.joints) {
    if (is_doubtful(found, joint.name, largest_reduction(results, joint.name))) {
      doubtful.push_back(joint.name);
    }
  }
  verdict.doubtful = !verdict.text.empty() || !doubtful.empty();
  verdict.text += belief_text(doubtful, found.joints.size());
  put_contradictions(results, verdict);
  return verdict;
}

void add_calibration(const ExperimentResults& results, ReportSection& section) {
  const auto add = [&section](auto block) { section.blocks.emplace_back(std::move(block)); };
  const CalibrationSummary& found = *results.calibration;
  ReportWarnings warnings{.warnings = results.warnings, .beside = true};
  std::ranges::copy(found.warnings, std::back_inserter(warnings.warnings));
  if (results.comparison) {
    std::ranges::copy(results.comparison->warnings, std::back_inserter(warnings.warnings));
  }
  add(verdict_on_joints(results, warnings.warnings));
  if (results.densities.empty()) {
    add(ReportMissing{"No densities: no identifiability.csv in this folder.", kCalibrate});
  } else {
    add(ReportFigure{.figure = densities_figure(results)});
  }
  add(key_facts_of_calibration(results));
  add(joints_table(results));
  add(reach_of_calibration(results));
  add(warnings);
  add(ReportText{lead_of_calibration(results)});
  add(certainty_of_calibration(found));
  add(ReportText{fmt::format(
      "Not examined: whether the modes of the model, the stiffness of the joints, their "
      "shapes and the gains of the sensors are right{}.",
      unknown_repeatability(results))});
}

}  // namespace

bool has_calibration(const ExperimentResults& results) {
  return results.calibration || results.modal_levels || !results.densities.empty();
}

ReportSection calibration_summary_section(const ExperimentResults& results) {
  ReportSection section{.title = "Summary", .blocks = {}};
  if (results.calibration) {
    add_calibration(results, section);
    return section;
  }
  section.blocks.emplace_back(ReportMissing{
      joint_count(results) > 0
          ? "No calibration.json in this folder: joints known only together, scatter and "
            "warnings are not available."
          : "Modal levels as measured: no joint was identified from them yet.",
      kCalibrate});
  if (!results.densities.empty()) {
    section.blocks.emplace_back(ReportFigure{.figure = densities_figure(results)});
  }
  section.blocks.emplace_back(ReportWarnings{.warnings = results.warnings, .beside = true});
  return section;
}

}  // namespace microslip
