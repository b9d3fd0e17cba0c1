// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/workflow/campaign/campaign_opening.hpp"
#include "microslip/workflow/campaign/campaign_result.hpp"
#include "microslip/workflow/campaign/campaign_run.hpp"
#include "microslip/workflow/identify/calibration.hpp"

/// @file
/// Several tests of one structure: its joints from some of them, predictions of the others, and
/// which of the data contradict which.

namespace microslip {

/// The paths and kinds of the files that will be written, before anything is computed:
/// NAME_levels.csv of each test that is reduced, levels.csv, joint.json, model.toml, campaign.csv,
/// sessions.csv; with draws joint_samples.h5; of a model modal_levels.csv in place of levels.csv,
/// and in place of the joint what calibrate_model() writes; with predicted tests comparison.csv,
/// and model_SESSION.toml of each other session of theirs where offsets are fitted; conditions.csv
/// where tests to identify from say some; leave_one_out.csv where it is asked for.
/// @throws FileError, FormatError, InputError  as parse_campaign(); where the folder is that of an
///                                             input, or a test or the structure is no file of its
///                                             kind.
[[nodiscard]] std::vector<ResultFile> planned_files(const CampaignRun& run);
/// As above, of a campaign that was opened before.
[[nodiscard]] std::vector<ResultFile> planned_files(const CampaignRun& run,
                                                    const OpenedCampaign& opened);

/// Reduces the tests to identify from, identifies the joint from all their levels, or the joints of
/// a model from all levels of its modes as calibrate_model(), holds them against each session,
/// predicts the other tests, and composes the files.
///
/// Of a model, levels of modes that are predicted and have no standard deviation of D or of ζ are
/// assumed to scatter as D of the levels to identify from does; where these scatter more than their
/// standard deviations, those of predicted levels count so much more. The comparison states it.
///
/// A predicted test of a session with levels has the model of that session, whose frequency is off
/// by its offset δ; σ of the frequency is frequency_std of the plan or, where that is not given,
/// the scatter of the frequencies of the levels about those of the model, together with σ_δ. Of a
/// session without levels no offset is known: that of the others, rms, counts in σ in its place.
/// Of a model see modal_offsets(): vibrations that the session and the first one determine have the
/// measured offset where the joints have the mean of their secant stiffnesses at the levels of the
/// session; by what that changes over the levels, rms, σ_δ is more.
/// @throws FileError, FormatError, InputError  as planned_files(), the readers, identify().
/// @throws Cancelled                           as the progress says.
[[nodiscard]] DoneCampaign run_campaign(const CampaignRun& run);
/// As above, of a campaign that was opened before.
[[nodiscard]] DoneCampaign run_campaign(const CampaignRun& run, const OpenedCampaign& opened);

/// The summary.
[[nodiscard]] std::string describe_campaign(const DoneCampaign& done);

}  // namespace microslip
