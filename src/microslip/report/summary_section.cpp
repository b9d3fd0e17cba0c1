// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/identify/density_comparison.hpp"
#include "microslip/identify/stiffness_evidence.hpp"
#include "microslip/report/flag_meanings.hpp"
#include "microslip/report/sections.hpp"

namespace microslip {
namespace {

constexpr const char* kIdentify =
    "microslip identify levels.csv --stiffness K --bands 1000 --out joint.json --density-csv "
    "density.csv";

std::string count_of(std::size_t levels) {
  return fmt::format("{} level{}", levels, levels == 1 ? "" : "s");
}

/// Of the levels, those that the joint was identified from.
std::size_t used_count(const MeasuredLevels& test) {
  return test.levels.size() - static_cast<std::size_t>(std::ranges::count(test.left_out, true));
}

/// Where the joint is from, as far as its file tells.
std::string origin(const ExperimentResults& results) {
  const IdentifiedJoint& found = *results.joint;
  const double k = found.joint.stiffness() / kKilonewtonPerMetre;
  if (found.method.empty()) {
    return fmt::format(
        "A joint of stuck stiffness {:.4g} kN/m. Its file does not tell how it was found", k);
  }
  std::string text =
      fmt::format("A joint of stuck stiffness {:.4g} kN/m was identified by {}", k, found.method);
  if (!results.levels) return text;
  return text + (found.from_these_levels
                     ? fmt::format(" from {}", count_of(used_count(*results.levels)))
                     : ", not from the levels below as far as its file tells");
}

/// What was done and found, in a sentence or two.
std::string lead(const ExperimentResults& results) {
  const IdentifiedJoint& found = *results.joint;
  const SlipDensity& density = found.joint.density();
  const PartialMoments slips =
      found.covered_to ? density.moments(*found.covered_to) : density.total();
  std::string text =
      fmt::format("{}. {} of its stiffness slips", origin(results), percent_text(slips.zeroth));
  if (!found.covered_to) return text + ".";
  constexpr double kNothing = 5e-4;  // 0.0 %
  if (1.0 - slips.zeroth < kNothing) {
    return text + fmt::format(" at slip forces up to {:.3g} N.", *found.covered_to);
  }
  return text + fmt::format(
                    " at slip forces up to {:.3g} N. The levels end there: what of the rest would "
                    "slip under larger forces they do not tell.",
                    *found.covered_to);
}

ReportFacts key_facts(const ExperimentResults& results) {
  ReportFacts facts{.prominent = true};
  const auto add = [&](const char* name, std::string value) {
    facts.facts.emplace_back(name, std::move(value));
  };
  const IdentifiedJoint& found = *results.joint;
  const SlipDensity& density = found.joint.density();
  add("stuck stiffness k",
      fmt::format("{:.4g} kN/m", found.joint.stiffness() / kKilonewtonPerMetre));
  if (found.covered_from && found.covered_to) {
    add("slip forces covered",
        fmt::format("{:.3g} to {:.3g} N", *found.covered_from, *found.covered_to));
  }
  add("stiffness that slips", percent_text(density.total().zeroth));
  add("elastic remainder", percent_text(density.elastic_remainder()));
  for (std::size_t i = 0; i < density.atoms().weight.size() && i < kMostAtomsShown; ++i) {
    add("slips at once", fmt::format("{} at {:.4g} N", percent_text(density.atoms().weight[i]),
                                     density.atoms().slip_force[i]));
  }
  add("slipped part carries at most", fmt::format("{:.4g} N", found.joint.macroslip_force()));
  return facts;
}

/// The median half-width of the band over the covered slip forces, relative to the density.
std::optional<double> typical_half_width(const IdentifiedJoint& found) {
  std::vector<double> widths;
  for (std::size_t i = 0; i < found.band_slip_force.size(); ++i) {
    const double f = found.band_slip_force[i];
    const double density = found.joint.density().density(f);
    const bool inside = f >= found.covered_from.value_or(0.0) && f <= found.covered_to.value_or(f);
    if (!inside || !(density > 0.0)) continue;
    widths.push_back(0.5 * (found.band_upper[i] - found.band_lower[i]) / density);
  }
  if (widths.empty()) return std::nullopt;
  std::ranges::nth_element(widths, widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2));
  return widths[widths.size() / 2];
}

/// The part of an NRMSE that is no noise.
double beyond_noise(const ChannelMisfit& row) {
  return std::sqrt(std::max(row.nrmse * row.nrmse - row.noise_share * row.noise_share, 0.0));
}

/// The noise of a weak signal alone can be a quarter of it.
std::string describe_predictions(const std::vector<ChannelMisfit>& comparisons) {
  const auto worst = std::ranges::max_element(comparisons, {}, beyond_noise);
  const auto noisiest = std::ranges::max_element(comparisons, {}, &ChannelMisfit::nrmse);
  return fmt::format("at most {} beyond the noise ({}, {}); NRMSE with the noise at most {}",
                     percent_text(beyond_noise(*worst)), worst->channel, file_name(worst->source),
                     percent_text(noisiest->nrmse));
}

/// What the identification of the joint said of its own levels.
std::string scatter_of(const IdentifiedJoint& found) {
  std::string text = found.scatter_is_relative
                         ? percent_text(*found.scatter) + " of D about the fit"
                         : fmt::format("D {:.2f} of the standard deviations given", *found.scatter);
  if (found.secant_scatter) text += fmt::format(", k_eq {:.2f} of its own", *found.secant_scatter);
  return text;
}

std::string smoothing_of(const IdentifiedJoint& found) {
  std::string text =
      fmt::format("λ = {:.3g}{}", *found.lambda, found.method == "spline" ? " m³" : "");
  if (found.degrees_of_freedom) {
    text += fmt::format(", {:.1f} degrees of freedom", *found.degrees_of_freedom);
  }
  return text + (found.smoothing.empty() ? "" : fmt::format(" ({})", found.smoothing));
}

/// How far D of these levels is from that of the joint, whoever identified it.
std::string misfit_of(const ExperimentResults& results) {
  const Misfit misfit = misfit_of_levels(results);
  return misfit.in_deviations
             ? fmt::format("{:.3g} of the standard deviations of D, rms", misfit.rms)
             : fmt::format("{} of D, rms", percent_text(misfit.rms));
}

/// Nothing where the truth has no density to compare with.
std::optional<std::string> error_against_truth(const ExperimentResults& results) {
  if (!results.truth || !results.joint->covered_to) return std::nullopt;
  try {
    const double error = density_error(results.joint->joint.density(), *results.joint->covered_to,
                                       results.truth->density());
    return fmt::format("{} of the density, relative L2 over 5 to 95 % of the range",
                       percent_text(error));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

ReportFacts certainty(const ExperimentResults& results) {
  ReportFacts facts{.title = "How sure", .facts = {}};
  const auto add = [&](const char* name, std::string value) {
    facts.facts.emplace_back(name, std::move(value));
  };
  const IdentifiedJoint& found = *results.joint;
  add("method", found.method.empty() ? "not told by the file" : found.method);
  if (results.levels && found.from_these_levels) {
    add("levels", fmt::format("{}", used_count(*results.levels)));
  }
  add("solver", found.status);
  if (const auto width = typical_half_width(found)) {
    add("density known to",
        fmt::format("± {} by scatter alone (median half-width of the {:.0f} % band)",
                    percent_text(*width), 100.0 * found.band_confidence));
  } else {
    add("density known to", "not told: no band was computed (identify --bands 1000)");
  }
  // Of a parametric model they are those of the free density that it was compared with.
  if (found.parameters.empty()) {
    if (found.scatter) add("scatter of its levels", scatter_of(found));
    if (found.lambda) add("smoothing", smoothing_of(found));
  }
  if (results.levels) add("misfit to the levels shown", misfit_of(results));
  for (const auto& [name, value] : found.parameters) add(name.c_str(), value);
  if (found.linear_damping) {
    add("linear damping fitted",
        fmt::format("{:.4g} J/m² (adds to D with A²)", *found.linear_damping));
  }
  if (const auto error = error_against_truth(results)) add("error against the truth", *error);
  if (!results.comparisons.empty()) {
    add("error of the prediction", results.predictions_are_of_this_joint
                                       ? describe_predictions(results.comparisons)
                                       : "not told: the predictions are of another joint or rig");
  }
  return facts;
}

/// A joint far off the levels: it is of others, does not fit, or was changed since.
std::optional<Warning> foreign_misfit(const ExperimentResults& results,
                                      const std::optional<MethodComparison>& methods) {
  constexpr double kLargest = 3.0;  // times the scatter
  if (!results.joint || !results.levels) return std::nullopt;
  const IdentifiedJoint& joint = *results.joint;
  const Misfit misfit = misfit_of_levels(results);
  double scatter = 1.0;
  if (joint.from_these_levels && joint.scatter &&
      joint.scatter_is_relative != misfit.in_deviations) {
    scatter = std::max(*joint.scatter, misfit.in_deviations ? 1.0 : 0.0);
  } else if (!misfit.in_deviations) {
    if (!methods || !methods->inversion.inversion->scatter_is_relative) return std::nullopt;
    scatter = methods->inversion.inversion->scatter;
  }
  if (!(misfit.rms > kLargest * scatter)) return std::nullopt;
  return Warning{
      "joint_misses_levels",
      fmt::format("D of the joint is off that of the levels by {}, far beyond their scatter: the "
                  "joint {}.",
                  misfit_of(results),
                  joint.from_these_levels ? "does not fit, or was changed after its identification"
                                          : "is not that of these levels")};
}

/// The stiffness of the levels held against the joint, as its identification does it. The resonance
/// where it was measured, else the drive.
std::vector<Warning> judge_stiffness(const ExperimentResults& results) {
  const MeasuredLevels& test = *results.levels;
  Levels levels = test.levels;
  if (!test.resonance_frequency.empty()) {
    levels.frequency = test.resonance_frequency;
  } else {
    levels.frequency = test.frequency;
  }
  if (levels.frequency_std.size() != levels.frequency.size()) levels.frequency_std.clear();
  return diagnose(stiffness_evidence(levels, results.joint->joint), results.joint->joint);
}

/// One for each code, with the number of records that carry it.
std::vector<Warning> flags_of_predictions(const std::vector<ChannelMisfit>& comparisons) {
  std::map<std::string, std::set<std::string>> records;
  std::set<std::string> all;
  for (const ChannelMisfit& one : comparisons) {
    all.insert(one.source);
    std::istringstream words(one.flags);
    for (std::string code; words >> code;) records[code].insert(one.source);
    if (!one.status.empty() && one.status != to_string(Status::kConverged)) {
      records["prediction_not_converged"].insert(one.source);
    }
  }
  std::vector<Warning> warnings;
  for (const auto& [code, sources] : records) {
    const std::string_view meaning = flag_meaning(code);
    warnings.push_back(
        {code, fmt::format("{} of {} predicted records: {}.", sources.size(), all.size(),
                           meaning.empty() ? std::string_view("see the table") : meaning)});
  }
  return warnings;
}

/// The texts where the levels tell them again, else the codes as the file has them.
ReportWarnings all_warnings(const ExperimentResults& results,
                            const std::optional<MethodComparison>& methods) {
  ReportWarnings block{results.warnings};
  const auto add = [&](const std::string& code, const std::string& text) {
    const auto same = [&](const Warning& known) { return known.code == code; };
    if (std::ranges::none_of(block.warnings, same)) block.warnings.push_back({code, text});
  };
  if (const auto misfit = foreign_misfit(results, methods)) add(misfit->code, misfit->text);
  if (results.joint && results.levels) {
    for (const Warning& warning : judge_stiffness(results)) add(warning.code, warning.text);
  }
  if (results.joint && results.levels && results.joint->method.empty()) {
    add("joint_of_unknown_origin",
        "joint.json does not tell how it was found: nothing shows that it belongs to the levels "
        "below.");
  }
  if (methods) {
    for (const Warning& warning : methods->warnings) add(warning.code, warning.text);
  }
  if (results.joint) {
    for (const std::string& code : results.joint->warnings)
      add(code, "Said by the identification:");
  }
  for (const auto& [code, text] : flags_of_predictions(results.comparisons)) add(code, text);
  if (results.levels) {
    const auto flagged = std::ranges::count_if(results.levels->flags,
                                               [](const std::string& f) { return !f.empty(); });
    if (flagged > 0) {
      add("levels_flagged", fmt::format("{} of {} levels carry flags; see the table of levels.",
                                        flagged, results.levels->flags.size()));
    }
  }
  return block;
}

std::string not_examined(const ReportWarnings& warnings) {
  return fmt::format(
      "{}Not examined: whether the stuck stiffness k, the linear damping of the structure and the "
      "gains of the sensors are right, and whether the test repeats.",
      warnings.warnings.empty() ? "No warning and no flag. " : "");
}

}  // namespace

ReportSection summary_section(const ExperimentResults& results,
                              const std::optional<MethodComparison>& methods) {
  ReportSection section{.title = "Summary", .blocks = {}};
  if (results.joint) {
    section.blocks.emplace_back(ReportText{lead(results)});
    section.blocks.emplace_back(key_facts(results));
  } else {
    section.blocks.emplace_back(
        ReportMissing{"No joint.json in this folder: no joint was identified yet.", kIdentify});
  }
  const ReportWarnings warnings = all_warnings(results, methods);
  if (!warnings.warnings.empty()) section.blocks.emplace_back(warnings);
  if (results.joint) section.blocks.emplace_back(ReportText{not_examined(warnings)});
  if (results.joint) section.blocks.emplace_back(certainty(results));
  return section;
}

}  // namespace microslip
