// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/workflow/campaign/campaign_conditions.hpp"
#include "microslip/workflow/campaign/campaign_leave_out.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"
#include "microslip/workflow/campaign/campaign_sessions.hpp"
#include "microslip/workflow/compare/tests_verification.hpp"
#include "microslip/workflow/identify/calibration.hpp"

namespace microslip {

/// Results of the joints at the levels from which they were identified, other than frequency and D.
/// Empty where levels have none of it, NaN where one has not.
struct FoundAtLevels {
  std::vector<double> secant_stiffness = {};        ///< of the joint, N/m
  std::vector<double> measured_damping_ratio = {};  ///< structure included, 1
  std::vector<double> damping_ratio = {};           ///< as found, 1
  /// Relative scatter of D of levels of modes, where they have no standard deviations; else
  /// 0.
  double loss_scatter = 0.0;
  /// Where they have them, the scatter over these, 1; else 0.
  double deviation_scatter = 0.0;
  std::string summary = {};  ///< of the identification, without warnings
  bool converged = true;     ///< the identification
};

/// Result of run_campaign().
struct DoneCampaign {
  CampaignFile plan;             ///< as read
  CampaignLevels levels = {};    ///< of the tests that the joints were identified from
  FoundAtLevels found = {};      ///< by the joints
  SessionEffects sessions = {};  ///< differences of the sessions
  std::vector<ConditionEffect> conditions = {};  ///< effects of the conditions of tests
  std::vector<LeftOut> left_out = {};            ///< empty where not requested
  VerifiedTests verified = {};                   ///< sweeps and modes of the predicted tests
  std::vector<std::size_t> test_of = {};         ///< number in the plan of each of these, from 0
  std::vector<Warning> warnings = {};            ///< of all of it but the verified tests
  /// Levels of the warnings `level_outlier` of the identification, from 0, in their order.
  std::vector<std::size_t> outliers = {};
  std::vector<ResultFile> files = {};  ///< to be written

  /// Whether all was found.
  [[nodiscard]] bool converged() const;
};

}  // namespace microslip
