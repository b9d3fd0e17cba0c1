// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/observe/levels.hpp"
#include "microslip/workflow/campaign/campaign_run.hpp"
#include "microslip/workflow/identify/calibration.hpp"

/// @file
/// The levels of the tests of a campaign.

namespace microslip {

/// Levels of several tests, test after test. Each vector but `tables` and `warnings` has one entry
/// a level.
struct CampaignLevels {
  /// Quantities of the single tests; frequencies as measured. Of a model the amplitude is that of
  /// the response point, and D that of all joints; NaN where something was not measured.
  Levels levels = {};
  std::vector<std::size_t> mode = {};    ///< from 1; of a model, else empty: the first
  std::vector<std::size_t> test = {};    ///< number of its test in the campaign, from 0
  std::vector<std::string> source = {};  ///< of its record or sweep; "level 3" if not given
  std::vector<std::string> flags = {};   ///< between blanks
  std::vector<double> reversals = {};    ///< in a cycle, 1

  std::vector<ResultFile> tables = {};  ///< NAME_levels.csv of each test that was reduced
  std::vector<Warning> warnings = {};   ///< of the readers and of what is not used
  bool converged = true;                ///< of ring-downs, to the end or to the noise

  /// The number of levels.
  [[nodiscard]] std::size_t size() const { return test.size(); }
  /// The mode of level i, from 1.
  [[nodiscard]] std::size_t mode_of(std::size_t i) const { return mode.empty() ? 1 : mode[i]; }
};

/// "level 3" of number 2: a level of a table that does not name its record.
[[nodiscard]] std::string numbered_level(std::size_t number);

/// Where the levels of a test that is reduced go.
[[nodiscard]] std::string levels_path(const std::string& out, const CampaignTest& test);

/// Reads levels.csv, or reduces what is none by its kind.
/// @param campaign  whose tests. @param out  folder of the tables. @param command  of their
///     comment.
/// @param progress  reports the records; may cancel.
/// @throws FileError, FormatError, InputError, Cancelled  as reduce_campaign_test(),
///     level_table_of().
[[nodiscard]] CampaignLevels campaign_levels(const OpenedCampaign& campaign, const std::string& out,
                                             const std::string& command, const Progress& progress);

/// Those of some numbers, from 0.
[[nodiscard]] Levels some_levels(const Levels& levels, std::span<const std::size_t> which);

/// "Friday: level 3" of each level, by its number in the table of its test.
[[nodiscard]] std::vector<std::string> names_of_levels(const CampaignFile& campaign,
                                                       const CampaignLevels& levels);

/// Those of some, by their numbers from 0.
[[nodiscard]] std::vector<std::string> names_of_levels(const CampaignFile& campaign,
                                                       const CampaignLevels& levels,
                                                       std::span<const std::size_t> which);

/// The text of levels.csv: `amplitude [m], dissipation [J]`, frequency [Hz] less the offset of the
/// session, `measured_frequency [Hz]` as it was, and `test, session, source, reversals, flags`.
/// @param levels    as read. @param campaign  of them.
/// @param offset    relative, of the frequency of each level, as a logarithm, 1.
/// @param comment   above it.
[[nodiscard]] std::string pooled_levels_text(const CampaignLevels& levels,
                                             const CampaignFile& campaign,
                                             const std::vector<double>& offset,
                                             const std::string& comment);

}  // namespace microslip
