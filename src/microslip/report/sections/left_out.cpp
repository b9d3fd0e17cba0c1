// SPDX-License-Identifier: MIT
#include "microslip/report/sections/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr double kContradictByChance = 0.05;

/// Number of contradicting parts, and of all that were judged.
struct Contradictions {
  std::vector<PartLeftOut> parts;  ///< that contradict
  std::size_t judged = 0;          ///< with those that do not
  std::string noun;                ///< what each is
};

Contradictions contradictions_in(const CampaignFound& found) {
  Contradictions all;
  const std::vector<PartLeftOut> parts = parts_left_out(found);
  for (const PartLeftOut& part : parts) {
    if (!part.judged || part.compared == 0) continue;
    ++all.judged;
    if (part.contradicts) all.parts.push_back(part);
  }
  all.noun = parts.empty() ? "" : parts.front().part;
  return all;
}

std::string count_text(const Contradictions& all) {
  return fmt::format("{} of {} {}s", all.parts.size(), all.judged, all.noun);
}

/// "s2m2, D +20 %; s2m1, D -3 %; and 4 more".
std::string list_text(const std::vector<PartLeftOut>& parts) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> texts;
  for (const PartLeftOut& part : parts) {
    texts.push_back(
        fmt::format("{}, D {:+.2g} %", part.name, 100.0 * std::expm1(part.mean_deviation)));
  }
  return first_texts(texts, kMost, "; ");
}

}  // namespace

std::vector<PartLeftOut> parts_left_out(const CampaignFound& found) {
  std::vector<PartLeftOut> parts;
  for (const LeftOutEntry& entry : found.left_out) {
    if (parts.empty() || parts.back().name != entry.left_out) {
      parts.push_back({.name = entry.left_out,
                       .part = entry.part,
                       .mean_deviation = entry.mean_deviation,
                       .chance = entry.chance,
                       .judged = entry.judged,
                       .contradicts = entry.contradicts});
    }
    const bool inside = entry.verdict == "inside";
    ++parts.back().levels;
    parts.back().inside += inside ? 1 : 0;
    parts.back().compared += inside || entry.verdict == "outside" ? 1 : 0;
  }
  return parts;
}

std::string count_that_contradict(const CampaignFound& found) {
  const Contradictions all = contradictions_in(found);
  return all.judged == 0 ? "" : count_text(all);
}

void put_contradictions(const ExperimentResults& results, ReportVerdict& verdict) {
  if (!results.campaign) return;
  const Contradictions all = contradictions_in(*results.campaign);
  if (all.parts.empty()) return;
  const double by_chance = kContradictByChance * static_cast<double>(all.judged);
  const bool more = static_cast<double>(all.parts.size()) > by_chance;
  verdict.doubtful = verdict.doubtful || more || all.noun != "level";
  verdict.text =
      fmt::format("{} contradict{} the others, {:.2g} would by chance: {}. {}", count_text(all),
                  all.parts.size() == 1 ? "s" : "", by_chance, list_text(all.parts), verdict.text);
}

std::string unknown_repeatability(const ExperimentResults& results) {
  const bool known = results.campaign && !results.campaign->repeatability.empty();
  return known ? "" : ", and whether the test repeats";
}

}  // namespace microslip
