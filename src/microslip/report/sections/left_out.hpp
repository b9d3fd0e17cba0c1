// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/report/document/report_document.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

/// @file
/// Results of a campaign for tests, modes or levels that were left out in turn. Internal to report.

namespace microslip {

/// Levels that were left out at once.
struct PartLeftOut {
  std::string name = {};        ///< of the test, the mode or the level
  std::string part = {};        ///< which of these it is
  std::size_t levels = 0;       ///< of it
  std::size_t compared = 0;     ///< those that the others predict
  std::size_t inside = 0;       ///< those in their band
  double mean_deviation = 0.0;  ///< ln of the mean of measured over predicted, 1
  double chance = 0.0;       ///< p-value: share of draws with as few values in the band or fewer, 1
  bool judged = true;        ///< whether the others know the joints one by one
  bool contradicts = false;  ///< the others
};

/// The parts that were left out, in the order of the file.
[[nodiscard]] std::vector<PartLeftOut> parts_left_out(const CampaignFound& found);

/// "1 of 4 tests": how many contradict the others, of those that are judged. Empty where none is.
[[nodiscard]] std::string count_that_contradict(const CampaignFound& found);

/// Begins a verdict with those that contradict the others, where some do, and makes it doubtful;
/// of levels, which are many, where they are more than one in twenty.
void put_contradictions(const ExperimentResults& results, ReportVerdict& verdict);

/// ", and whether the test repeats" where the repeatability of the test is unknown, or nothing
/// where a campaign gives it.
[[nodiscard]] std::string unknown_repeatability(const ExperimentResults& results);

}  // namespace microslip
