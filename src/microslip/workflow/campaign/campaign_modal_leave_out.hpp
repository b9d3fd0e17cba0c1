// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/observe/modal_levels.hpp"
#include "microslip/workflow/campaign/campaign_leave_out.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"
#include "microslip/workflow/identify/calibration.hpp"

/// @file
/// Leave-one-out of levels of modes. Internal to workflow.

namespace microslip {

/// Inputs of leave_one_mode_out().
struct ModalLeaveOut {
  const CampaignFile& plan;             ///< specifies tests, modes or levels
  const ModelCalibration& calibration;  ///< of all, with its draws
  const CalibratedModel& done;          ///< found from all
  const CampaignLevels& levels;         ///< of the tests, with D as measured
  const ModalLevels& modal;             ///< the same, as they were calibrated from
  Progress progress = {};               ///< reports the calibrations; may cancel
};

/// Leaves out one part after the other, identifies the joints from the rest, and predicts D of all
/// joints at the displacements of the part, as compare_modal_levels(): one entry per mode of the
/// part. Bands are those of measured values: the draws of the joints, for a test those of the
/// spread of the model, too, and noise of each level, CalibratedLevel::loss_noise as the others
/// scatter. A level is beyond the others where a joint moves more there, as found from all, than in
/// any of them, by more than 1 %. Warnings of the others are kept. Levels whose D of all joints is
/// not known are left out and not compared.
/// Where calibrate() refuses the others, too few levels for instance, the part left out has that as
/// its failure.
/// @throws Cancelled   as the progress says.
[[nodiscard]] std::vector<LeftOut> leave_one_mode_out(const ModalLeaveOut& what);

}  // namespace microslip
