// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/identify/evidence/stiffness_evidence.hpp"
#include "microslip/identify/inversion/possible_joints.hpp"
#include "microslip/identify/methods/density_comparison.hpp"
#include "microslip/workflow/results/level_quantities.hpp"
#include "microslip/workflow/text/flag_meanings.hpp"

namespace microslip {
namespace {

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
    if (!methods || !methods->inversion.inversion()->scatter_is_relative) return std::nullopt;
    scatter = methods->inversion.inversion()->scatter;
  }
  if (!(misfit.rms > kLargest * scatter)) return std::nullopt;
  return Warning{
      "joint_misses_levels",
      fmt::format("D of the joint differs from that of the levels by {}, far beyond their scatter: "
                  "the joint {}.",
                  misfit_text(results),
                  joint.from_these_levels ? "does not fit, or was changed after identification"
                                          : "was not identified from these levels")};
}

/// The stiffness of the levels compared with the joint, as in its identification. The resonance
/// where it was measured, else the drive.
std::vector<Warning> judge_stiffness(const ExperimentResults& results,
                                     const std::optional<MethodComparison>& methods) {
  const MeasuredLevels& test = *results.levels;
  Levels levels = test.levels;
  if (!test.resonance_frequency.empty()) {
    levels.frequency = test.resonance_frequency;
  } else {
    levels.frequency = test.frequency;
  }
  if (levels.frequency_std.size() != levels.frequency.size()) levels.frequency_std.clear();
  const Joint& joint = results.joint->joint;
  const InversionResult* inversion =
      methods && results.joint->from_these_levels ? methods->inversion.inversion() : nullptr;
  SoftestJoint softest;
  if (inversion) {
    softest = [&](double from, double to) {
      return softest_joint(*inversion, joint.stiffness(), from, to);
    };
  }
  return diagnose(stiffness_evidence(levels, joint, softest), joint);
}

/// One for each code, with the number of records that carry it.
std::vector<Warning> flags_of_predictions(const std::vector<ChannelMisfit>& comparisons) {
  std::map<std::string, std::set<std::string>> records;
  std::set<std::string> all;
  for (const ChannelMisfit& one : comparisons) {
    all.insert(one.source);
    std::istringstream words(one.flags);
    for (std::string code; words >> code;) records[code].insert(one.source);
    if (!one.status.empty() && one.status != kConvergedStatus) {
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

/// With their texts, where the file has them.
std::vector<Warning> said_by_identification(const IdentifiedJoint& joint) {
  std::vector<Warning> said;
  for (std::size_t i = 0; i < joint.warnings.size(); ++i) {
    said.push_back({joint.warnings[i], i < joint.warning_texts.size()
                                           ? joint.warning_texts[i]
                                           : "From the identification:"});
  }
  return said;
}

}  // namespace

std::size_t used_count(const MeasuredLevels& test) {
  return test.levels.size() - static_cast<std::size_t>(std::ranges::count(test.left_out, true));
}

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

double beyond_noise(const ChannelMisfit& row) {
  return std::sqrt(std::max(row.nrmse * row.nrmse - row.noise_share * row.noise_share, 0.0));
}

std::string misfit_text(const ExperimentResults& results) {
  const Misfit misfit = misfit_of_levels(results);
  return misfit.in_deviations ? fmt::format("{:.3g} standard deviations of D, rms", misfit.rms)
                              : fmt::format("{} of D, rms", percent_text(misfit.rms));
}

std::optional<double> error_against_truth(const ExperimentResults& results) {
  if (!results.truth || !results.joint->covered_to) return std::nullopt;
  try {
    return density_error(results.joint->joint.density(), *results.joint->covered_to,
                         results.truth->density());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<Warning> warnings_of(const ExperimentResults& results,
                                 const std::optional<MethodComparison>& methods) {
  std::vector<Warning> all = results.warnings;
  const auto add = [&](const std::string& code, const std::string& text) {
    const auto same = [&](const Warning& known) { return known.code == code; };
    if (std::ranges::none_of(all, same)) all.push_back({code, text});
  };
  if (const auto misfit = foreign_misfit(results, methods)) add(misfit->code, misfit->text);
  if (results.joint && results.levels) {
    for (const Warning& warning : judge_stiffness(results, methods))
      add(warning.code, warning.text);
  }
  if (results.joint && results.levels && results.joint->method.empty()) {
    add("joint_of_unknown_origin",
        "joint.json does not state how it was identified: nothing shows that it belongs to the "
        "levels "
        "below.");
  }
  if (methods) {
    for (const Warning& warning : methods->warnings) add(warning.code, warning.text);
  }
  if (results.joint) {
    for (const Warning& warning : said_by_identification(*results.joint)) {
      if (results.joint->by_records) {
        all.push_back(warning);
      } else {
        add(warning.code, warning.text);
      }
    }
  }
  for (const auto& [code, text] : flags_of_predictions(results.comparisons)) add(code, text);
  if (results.comparison) {
    for (const Warning& warning : results.comparison->warnings) add(warning.code, warning.text);
  }
  if (results.campaign) {
    for (const Warning& warning : results.campaign->warnings) add(warning.code, warning.text);
  }
  if (results.levels) {
    const auto flagged = std::ranges::count_if(results.levels->flags,
                                               [](const std::string& f) { return !f.empty(); });
    if (flagged > 0) {
      add("levels_flagged", fmt::format("{} of {} levels carry flags; see the table of levels.",
                                        flagged, results.levels->flags.size()));
    }
  }
  return all;
}

}  // namespace microslip
