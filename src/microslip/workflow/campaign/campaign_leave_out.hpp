// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/observe/common_errors.hpp"
#include "microslip/workflow/campaign/campaign_levels.hpp"
#include "microslip/workflow/compare/comparison.hpp"

/// @file
/// Leave-one-out: which of the tests of a campaign, or of their levels, contradict the others.

namespace microslip {

/// In place of a verdict where the others do not determine each joint separately.
inline constexpr std::string_view kNotJudged = "not_judged";

/// A part that was left out, and its prediction from the others.
struct LeftOut {
  std::string name = {};                 ///< of the test, or of test and level
  std::vector<std::size_t> levels = {};  ///< their numbers among those of the campaign, from 0
  std::vector<double> measured = {};     ///< D of each, J
  /// D of each at its amplitude, by the joint identified from the others. `measured` in it is NaN
  /// where the amplitude is beyond those of the others, which give no prediction there.
  ComparedCurve curve = {};
  DrawsTaken taken = {};  ///< outcome of the draws
  bool converged = true;  ///< the identification without it
  /// Reason why the others give no result, for a model; then no level is compared. Empty where they
  /// do.
  std::string failure = {};
  std::vector<Warning> warnings = {};  ///< of a model, of the identification without it
  /// Reason why it is not assessed: the others do not determine each joint separately, so that
  /// their bands are unreliable. Empty where it is assessed.
  std::string not_judged = {};

  /// ln of the mean of D/D̂, weighted by (D̂/σ)², over the levels that are compared, 1; NaN where
  /// there is none.
  [[nodiscard]] double mean_deviation() const;
  /// Whether it is assessed, and the p-value of the number of levels in the band is at most 1 −
  /// P.
  [[nodiscard]] bool contradicts() const;
  /// Measured less predicted of value i over the distance of the edge of the band on that side, 1:
  /// beyond 1 and −1 it is outside. NaN where it is not compared.
  [[nodiscard]] double deviation(std::size_t i) const;
};

/// How the others are identified.
struct LeaveOutOptions {
  double stiffness = 0.0;                      ///< k, N/m
  IdentificationOptions identification = {};   ///< with bands, whose draws predict
  CommonErrors errors = {};                    ///< of the levels
  Execution execution = Execution::threads();  ///< of the draws
  Progress progress = {};                      ///< reports the identifications; may cancel
};

/// Before all work: that a density can be identified without each of them.
/// @param campaign  says whether tests or levels. @param levels  of its tests.
/// @throws InputError  where fewer than kFewestLevels different amplitudes are left of as many or
///                     more.
void check_leave_out(const CampaignFile& campaign, const CampaignLevels& levels);

/// Leaves out one after the other, identifies the joint from what is left, and predicts D at the
/// amplitudes that were left out. Bands are those of what would be read: the draws of the joint and
/// of its linear damping; noise of each level, its standard deviation with what that of the
/// amplitude makes of D, times what the others scatter by where that is more, or what they scatter
/// by where none is given; and for a test that is left out gains of its own of the standard
/// deviations that all have; those of a level are those of the others, of which it is one.
/// @param campaign  says whether tests or levels.
/// @param levels    of its tests.
/// @param options   of the identifications.
/// @throws InputError  as identify(), naming what was left out.
/// @throws Cancelled   as the progress says.
[[nodiscard]] std::vector<LeftOut> leave_one_out(const CampaignFile& campaign,
                                                 const CampaignLevels& levels,
                                                 const LeaveOutOptions& options);

}  // namespace microslip
