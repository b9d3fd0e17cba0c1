// SPDX-License-Identifier: MIT
#include "microslip/report/sections/prediction_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/percent.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/report/document/shown_unit.hpp"
#include "microslip/workflow/results/verdict.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr const char* kReachTitle = "Valid range";
constexpr const char* kSmaller = "smaller motions";
constexpr const char* kLarger = "larger motions";
constexpr const char* kError = "error of predictions";
constexpr const char* kAgainstTests = "predictions against tests";

/// "2.13 to 300 µm", or "156 nm to 1.03 mm" where one unit suits one end alone.
std::string range_text(double from, double to, std::string_view si_unit) {
  constexpr double kLeast = 0.01;
  const ShownUnit unit = shown_unit(si_unit, to);
  if (from > 0.0 && from < kLeast * unit.size) {
    const ShownUnit small = shown_unit(si_unit, from);
    return fmt::format("{:.3g} {} to {:.3g} {}", from / small.size, small.text, to / unit.size,
                       unit.text);
  }
  return fmt::format("{:.3g} to {:.3g} {}", from / unit.size, to / unit.size, unit.text);
}

/// Range of the finite values.
std::string range_text(const std::vector<double>& values, std::string_view si_unit) {
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known),
                       [](double value) { return std::isfinite(value); });
  if (known.empty()) return "not measured";
  const auto [least, most] = std::ranges::minmax(known);
  return range_text(least, most, si_unit);
}

/// What is known of slip forces beyond those of the measured motions.
std::string beyond_text(const IdentifiedJoint& joint) {
  constexpr double kNothing = 5e-4;  // 0.0 %
  const double rest = 1.0 - joint.joint.density().moments(*joint.covered_to).zeroth;
  if (rest < kNothing) return "known: all of the stiffness has slipped";
  return fmt::format("not available: {} of k did not slip in the test", percent_text(rest));
}

/// The noise of a weak signal alone can be a quarter of it.
std::string error_of_records(const ExperimentResults& results) {
  const std::vector<ChannelMisfit>& comparisons = results.comparisons;
  if (!results.predictions_are_of_this_joint) {
    return "not available: the predictions are of another joint or rig";
  }
  const auto worst = std::ranges::max_element(comparisons, {}, beyond_noise);
  const auto noisiest = std::ranges::max_element(comparisons, {}, &ChannelMisfit::nrmse);
  std::vector<double> responses;
  for (const ChannelMisfit& one : comparisons) responses.push_back(one.response_amplitude);
  return fmt::format(
      "at most {} beyond the noise ({}, {}); NRMSE with the noise at most {}; records of {}",
      percent_text(beyond_noise(*worst)), worst->channel, file_name(worst->source),
      percent_text(noisiest->nrmse), range_text(responses, "m/s^2"));
}

/// Adds the errors at records of the rig, and of tests against a model.
/// @param unverified  where there is neither.
void add_errors(const ExperimentResults& results, const std::string& unverified,
                ReportFacts& facts) {
  if (!results.comparisons.empty()) facts.facts.emplace_back(kError, error_of_records(results));
  if (results.comparison) {
    facts.facts.emplace_back(kAgainstTests, comparison_verdict(*results.comparison));
  }
  if (results.comparisons.empty() && !results.comparison) {
    facts.facts.emplace_back(kError, unverified);
  }
}

void add_measured(const MeasuredLevels& levels, ReportFacts& facts) {
  facts.facts.emplace_back("joint amplitude",
                           fmt::format("{}, {}", range_text(levels.levels.amplitude, "m"),
                                       counted(used_count(levels), "level")));
  if (!levels.response_amplitude.empty()) {
    facts.facts.emplace_back("response", range_text(levels.response_amplitude, "m/s^2"));
  }
  if (!levels.force_amplitude.empty()) {
    facts.facts.emplace_back("force of the exciter", range_text(levels.force_amplitude, "N"));
  }
}

}  // namespace

ReportFacts reach_of_levels(const ExperimentResults& results) {
  const IdentifiedJoint& joint = *results.joint;
  ReportFacts facts{.title = kReachTitle, .facts = {}, .beside = true};
  if (results.levels && joint.from_these_levels) {
    add_measured(*results.levels, facts);
  } else if (joint.covered_from && joint.covered_to) {
    const double k = joint.joint.stiffness();
    facts.facts.emplace_back("joint amplitude",
                             range_text(*joint.covered_from / k, *joint.covered_to / k, "m"));
  } else {
    facts.facts.emplace_back("joint amplitude", "not given in its file");
  }
  if (joint.covered_from && joint.covered_to) {
    facts.facts.emplace_back(
        kSmaller,
        "extrapolated: the levels determine two moments of the density there, not its shape");
    facts.facts.emplace_back(kLarger, beyond_text(joint));
  }
  add_errors(results, "not verified: compared with no record (microslip verify)", facts);
  return facts;
}

ReportFacts reach_of_records(const ExperimentResults& results) {
  const IdentifiedJoint& joint = *results.joint;
  ReportFacts facts{.title = kReachTitle, .facts = {}, .beside = true};
  if (joint.covered_from && joint.covered_to) {
    const double k = joint.joint.stiffness();
    facts.facts.emplace_back("half range of the motion",
                             range_text(*joint.covered_from / k, *joint.covered_to / k, "m"));
    facts.facts.emplace_back(
        kSmaller, "extrapolated: slip is below noise, the density is continued smoothly");
    facts.facts.emplace_back(kLarger, beyond_text(joint));
  }
  const auto worst =
      std::ranges::max_element(joint.by_records->records, {}, &RecordFound::unexplained);
  facts.facts.emplace_back(
      kError,
      fmt::format("at most {} of the force of its own records{}", percent_text(worst->unexplained),
                  results.comparison ? ""
                                     : "; not verified on a record that was "
                                       "not used"));
  if (results.comparison) {
    facts.facts.emplace_back(kAgainstTests, comparison_verdict(*results.comparison));
  }
  return facts;
}

ReportFacts reach_of_calibration(const ExperimentResults& results) {
  const CalibrationSummary& found = *results.calibration;
  ReportFacts facts{.title = kReachTitle, .facts = {}, .beside = true};
  std::map<std::size_t, std::vector<double>> of_mode;
  if (results.modal_levels) {
    for (std::size_t i = 0; i < results.modal_levels->mode.size(); ++i) {
      of_mode[results.modal_levels->mode[i]].push_back(results.modal_levels->displacement[i]);
    }
  }
  for (const auto& [mode, displacement] : of_mode) {
    facts.facts.emplace_back(fmt::format("displacement, mode {}", mode),
                             fmt::format("{}, {}", range_text(displacement, "m"),
                                         counted(displacement.size(), "level")));
  }
  for (const JointSummary& joint : found.joints) {
    facts.facts.emplace_back(
        fmt::format("amplitude of {}", joint.name),
        range_text(joint.covered_from / joint.stiffness, joint.covered_to / joint.stiffness, "m"));
  }
  facts.facts.emplace_back(kLarger, "not available: the levels do not show what slips there");
  facts.facts.emplace_back(
      kError, fmt::format("losses of its own levels scatter by {}{}",
                          found.scatter_is_relative ? percent_text(found.scatter)
                                                    : fmt::format("{:.2f} σ", found.scatter),
                          results.comparison ? ""
                                             : "; not verified on a level or a mode that was not "
                                               "used"));
  if (results.comparison) {
    facts.facts.emplace_back(kAgainstTests, comparison_verdict(*results.comparison));
  }
  return facts;
}

ReportFacts reach_of_comparison(const ComparisonFound& found) {
  ReportFacts facts{.title = kReachTitle, .facts = {}, .beside = true};
  facts.facts.emplace_back(kAgainstTests, comparison_verdict(found));
  return facts;
}

}  // namespace microslip
