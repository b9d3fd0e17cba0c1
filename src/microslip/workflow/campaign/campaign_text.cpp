// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/campaign/campaign.hpp"
#include "microslip/workflow/campaign/campaign_tables.hpp"
#include "microslip/workflow/text/summary_text.hpp"

/// @file
/// Summary of a campaign.

namespace microslip {
namespace {

std::string describe_sessions(const SessionEffects& effects, bool of_model) {
  std::string text;
  for (const SessionEffect& session : effects.sessions) {
    std::string facts = fmt::format(
        "{} of {}, D {:+.2g} % from the joint{}", counted(session.levels, "level"),
        counted(session.tests, "test"), 100.0 * session.dissipation_offset, of_model ? "s" : "");
    if (session.frequency_offset_std > 0.0) {
      facts += fmt::format(", frequency offset {:+.3f} ± {:.2g} %",
                           100.0 * session.frequency_offset, 100.0 * session.frequency_offset_std);
    } else if (session.frequency_difference != 0.0 && std::isfinite(session.frequency_difference)) {
      facts += fmt::format(", frequency offset {:+.3f} %, not corrected",
                           100.0 * session.frequency_difference);
    }
    text += line(of_model ? fmt::format("session {}, mode {}", session.name, session.mode)
                          : "session " + session.name,
                 facts);
  }
  if (effects.frequency_std > 0.0) {
    text += line("frequencies", fmt::format("rms deviation from the model {:.2g} %",
                                            100.0 * effects.frequency_std));
  }
  const std::string repeats = repeatability_text(effects);
  return repeats.empty() ? text : text + line("repeatability", "of D: " + repeats);
}

/// Departures, before the density, which is of no use then.
std::string describe_departures(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) {
    if (warning.code == kTestNotOfThisKind) text += line("NOT A MASING JOINT", warning.text);
  }
  return text;
}

std::string describe_conditions(const std::vector<ConditionEffect>& conditions) {
  std::string text;
  for (const ConditionEffect& condition : conditions) {
    const std::string trend = trend_text(condition);
    if (!trend.empty()) text += line("trend", trend);
  }
  return text;
}

std::string describe_left_out(const std::vector<LeftOut>& parts) {
  std::string text;
  std::size_t compared = 0;
  std::size_t named = 0;
  for (const LeftOut& part : parts) {
    const std::string facts =
        !part.failure.empty() ? "not compared: no solution without it"
        : part.curve.compared() == 0
            ? "beyond the others, which give no prediction there"
            : fmt::format("D {:+.2g} % from the prediction of the others, {} of {} inside{}",
                          100.0 * std::expm1(part.mean_deviation()), part.curve.inside(),
                          part.curve.compared(),
                          part.contradicts()         ? ": CONTRADICTS THEM"
                          : !part.not_judged.empty() ? ": not assessed"
                                                     : "");
    text += line(&part == parts.data() ? "left out" : "", part.name + ": " + facts);
    compared += part.not_judged.empty() && part.curve.compared() > 0 ? 1 : 0;
    named += part.contradicts() ? 1 : 0;
  }
  if (parts.empty()) return text;
  if (compared == 0) return text + line("", "none of them is assessed");
  const double chance = 1.0 - parts.front().taken.options.confidence;
  return text + line("", fmt::format("{} of {} contradict the others, {:.2g} expected by chance",
                                     named, compared, chance * static_cast<double>(compared)));
}

}  // namespace

std::string describe_campaign(const DoneCampaign& done) {
  std::string text = done.plan.title.empty() ? "" : printable(done.plan.title) + "\n";
  text += describe_departures(done.levels.warnings) + done.found.summary +
          describe_sessions(done.sessions, done.plan.of_model()) +
          describe_conditions(done.conditions) + describe_left_out(done.left_out);
  VerifiedTests verified = done.verified;
  verified.warnings = done.warnings;
  return text +
         (verified.tests.empty() ? describe_warnings(done.warnings) : describe_tests(verified));
}

}  // namespace microslip
