// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/observe/modal_levels.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"

/// @file
/// The levels of modes of the tests of a campaign. Internal to workflow.

namespace microslip {

/// Levels of modes, test after test, twice.
struct CampaignModalLevels {
  /// As calibrate() takes them; with sessions where the campaign fits offsets of these.
  ModalLevels modal = {};
  /// For tables and statistics; D is NaN until measured_losses().
  CampaignLevels levels = {};
};

/// Reads modal_levels.csv, or reduces what is none by its kind.
/// @param campaign  of a model. @param out  folder of the tables.
/// @param command   of their comment. @param progress  reports the records; may cancel.
/// @throws FileError, FormatError, InputError, Cancelled  as reduce_modal_test(),
///     parse_modal_levels().
[[nodiscard]] CampaignModalLevels campaign_modal_levels(const OpenedCampaign& campaign,
                                                        const std::string& out,
                                                        const std::string& command,
                                                        const Progress& progress);

/// D of all joints at each level as it was measured, J: of damping ratios less the loss of the
/// structure. NaN where the loss of single joints alone was, or the level was not found.
[[nodiscard]] std::vector<double> measured_losses(const CalibrationResult& found);

/// The text of modal_levels.csv of all tests: frequency [Hz] less the offset of mode and session,
/// `measured_frequency [Hz]` as it was, and `test, session, source`.
/// @param offset   relative, of the frequency of each level, as a logarithm, 1.
/// @param comment  above it.
[[nodiscard]] std::string pooled_modal_levels_text(const CampaignModalLevels& all,
                                                   const CampaignFile& campaign,
                                                   const std::vector<double>& offset,
                                                   const std::string& comment);

}  // namespace microslip
