// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/workflow/campaign/campaign_effects.hpp"
#include "microslip/workflow/compare/comparison.hpp"

/// @file
/// Results of comparisons of tests with a model, and of campaigns, from their tables.

namespace microslip {

/// comparison.csv.
struct ComparisonFound {
  std::vector<ComparedTest> tests = {};  ///< without their loops, and what became of draws
  /// How columns were taken, and draws: test, or key of the comment where it is of no test; text.
  std::vector<std::pair<std::string, std::string>> notes = {};
  std::vector<Warning> warnings = {};     ///< each names its test
  std::optional<double> confidence = {};  ///< P of the bands; nothing without draws
  /// Whether it was made with the joint.json, or the model.toml, that lies beside it.
  bool of_this_model = true;
};

/// A row of campaign.csv. NaN where there is no value.
struct CampaignEntry {
  std::string test = {};                                        ///< its name in the campaign
  std::string use = {};                                         ///< "identify", "predict" or "both"
  std::string session = {};                                     ///< of the test
  std::string conditions = {};                                  ///< "torque 12, shaker A"
  std::string part = {};                                        ///< "level", "peak" or "curve"
  std::string source = {};                                      ///< the record, sweep or mode
  double mode = std::numeric_limits<double>::quiet_NaN();       ///< from 1; of a level of a model
  double amplitude = std::numeric_limits<double>::quiet_NaN();  ///< m
  double frequency = std::numeric_limits<double>::quiet_NaN();  ///< Hz
  double frequency_predicted = std::numeric_limits<double>::quiet_NaN();    ///< Hz
  double dissipation = std::numeric_limits<double>::quiet_NaN();            ///< J
  double dissipation_predicted = std::numeric_limits<double>::quiet_NaN();  ///< J
  std::size_t inside = 0;   ///< values of the row in their band
  std::size_t outside = 0;  ///< values out of it
};

/// A row of leave_one_out.csv. NaN where there is no value.
struct LeftOutEntry {
  std::string left_out = {};    ///< the name of what was
  std::string part = {};        ///< what that is: "test", "level" or "mode"
  std::string test = {};        ///< of the level
  double amplitude = 0.0;       ///< m
  double measured = 0.0;        ///< J
  double predicted = 0.0;       ///< J
  double lower = 0.0;           ///< J
  double upper = 0.0;           ///< J
  std::string verdict = {};     ///< "inside", "outside", "beyond"
  double mean_deviation = 0.0;  ///< of all that was left out together, 1
  double chance = 0.0;          ///< p-value, 1
  bool contradicts = false;     ///< as above
  bool judged = true;           ///< the others determine each joint separately
};

/// A condition of conditions.csv.
struct ConditionFound {
  ConditionEffect effect = {};  ///< with its trends
  std::string trend = {};       ///< in words, as trend_text(); empty without one
};

/// Results of a campaign.
struct CampaignFound {
  std::string title = {};                       ///< may be empty
  std::vector<CampaignEntry> entries = {};      ///< of campaign.csv
  std::vector<SessionEffect> sessions = {};     ///< of sessions.csv
  std::string repeatability = {};               ///< in words; may be empty
  std::vector<ConditionFound> conditions = {};  ///< of conditions.csv
  std::vector<LeftOutEntry> left_out = {};      ///< of leave_one_out.csv
  std::vector<Warning> warnings = {};           ///< of campaign.csv
  /// Whether it is of a model: levels are those of modes, their amplitudes those of its response
  /// point, and D that of all joints.
  bool of_model = false;
};

/// How many values a comparison has, over all of its curves.
struct InsideCount {
  std::size_t compared = 0;  ///< measured and predicted
  std::size_t banded = 0;    ///< those with a band
  std::size_t inside = 0;    ///< those in it
};

/// Counts them.
[[nodiscard]] InsideCount count_inside(const std::vector<ComparedTest>& tests);

/// Verdict of a comparison on the model, in one or two sentences: how many values of how many tests
/// lie in their bands against how many are expected, by how much they differ without bands, and the
/// warnings that speak against it, by their codes.
[[nodiscard]] std::string comparison_verdict(const ComparisonFound& found);

/// Whether a warning of a comparison speaks against model, joint or one of its tests.
[[nodiscard]] bool speaks_against(const ComparisonFound& found, const Warning& warning);

}  // namespace microslip
