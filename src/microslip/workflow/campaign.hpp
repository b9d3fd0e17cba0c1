// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/io/campaign_file.hpp"
#include "microslip/workflow/calibration.hpp"
#include "microslip/workflow/campaign_conditions.hpp"
#include "microslip/workflow/campaign_leave_out.hpp"
#include "microslip/workflow/campaign_levels.hpp"
#include "microslip/workflow/campaign_sessions.hpp"
#include "microslip/workflow/tests_verification.hpp"

/// @file
/// Several tests of one structure: its joints from some of them, predictions of the others, and
/// which of the data contradict which.

namespace microslip {

/// What is asked for.
struct CampaignRun {
  std::string campaign;                        ///< path of campaign.toml
  std::string out;                             ///< folder of the results
  std::string command;                         ///< that the files are made by
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< told of all draws; may cancel
};

/// What the joints give at the levels that they were identified from, beside frequency and D. Empty
/// where levels have none of it, NaN where one has not.
struct FoundAtLevels {
  std::vector<double> secant_stiffness = {};        ///< of the joint, N/m
  std::vector<double> measured_damping_ratio = {};  ///< structure included, 1
  std::vector<double> damping_ratio = {};           ///< as found, 1
  /// What D of levels of modes scatters by, relative, where they have no standard deviations; else
  /// 0.
  double loss_scatter = 0.0;
  /// Where they have them, what they scatter by over these, 1; else 0.
  double deviation_scatter = 0.0;
  std::string summary = {};  ///< of the identification, without warnings
  bool converged = true;     ///< the identification
};

/// What came of it.
struct DoneCampaign {
  CampaignFile plan;             ///< as read
  CampaignLevels levels = {};    ///< of the tests that the joints were identified from
  FoundAtLevels found = {};      ///< by the joints
  SessionEffects sessions = {};  ///< what sessions differ by
  std::vector<ConditionEffect> conditions = {};  ///< what tests of different conditions do
  std::vector<LeftOut> left_out = {};            ///< empty where that was not asked for
  VerifiedTests verified = {};                   ///< sweeps and modes of the predicted tests
  std::vector<std::size_t> test_of = {};         ///< number in the plan of each of these, from 0
  std::vector<Warning> warnings = {};            ///< of all of it but the verified tests
  std::vector<ResultFile> files = {};            ///< to be written

  /// Whether all was found.
  [[nodiscard]] bool converged() const;
};

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

/// Reduces the tests to identify from, identifies the joint from all their levels, or the joints of
/// a model from all levels of its modes as calibrate_model(), holds them against each session,
/// predicts the other tests, and composes the files.
///
/// Of a model, levels of modes that are predicted and have no standard deviation of D or of ζ are
/// taken to scatter as D of the levels to identify from does; where these scatter more than their
/// standard deviations say, those of predicted levels count so much more. The comparison says so.
///
/// A predicted test of a session with levels has the model of that session, whose frequency is off
/// by its offset δ; σ of the frequency is frequency_std of the plan or, where that is not said,
/// what the frequencies of the levels scatter by about those of the model, together with σ_δ. Of a
/// session without levels no offset is known: that of the others, rms, counts in σ in its place. Of
/// a model see modal_offsets(): vibrations that the session and the first one tell are off as
/// measured where the joints have the mean of their secant stiffnesses at the levels of the
/// session; by what that changes over the levels, rms, σ_δ is more.
/// @throws FileError, FormatError, InputError  as planned_files(), the readers, identify().
/// @throws Cancelled                           as the progress says.
[[nodiscard]] DoneCampaign run_campaign(const CampaignRun& run);

/// The summary.
[[nodiscard]] std::string describe_campaign(const DoneCampaign& done);

}  // namespace microslip
