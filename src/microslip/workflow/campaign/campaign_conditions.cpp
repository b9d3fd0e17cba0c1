// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_conditions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/campaign/campaign_statistics.hpp"
#include "microslip/workflow/campaign/condition_words.hpp"

namespace microslip {
namespace {

using Residuals = std::vector<double>;

/// The residuals of the tests of a group, a list a test.
using TestsOfGroup = std::map<std::size_t, Residuals>;

/// Of so many values.
double sigma_of_mean(const PooledScatter& scatter, std::size_t count) {
  return std::sqrt(scatter.variance() / static_cast<double>(count));
}

Residuals all_of(const TestsOfGroup& group) {
  Residuals all;
  for (const auto& [test, values] : group) std::ranges::copy(values, std::back_inserter(all));
  return all;
}

Residuals means_of(const TestsOfGroup& group) {
  Residuals means;
  for (const auto& [test, values] : group) means.push_back(mean_of(values));
  return means;
}

/// σ of what gains of their own make of the means of some tests.
/// @param exponents  of the levels of each.
double gain_of_mean(const CampaignFile& campaign, const TestsOfGroup& exponents) {
  return std::hypot(campaign.dissipation_gain_std,
                    campaign.amplitude_gain_std * mean_of(all_of(exponents))) /
         std::sqrt(static_cast<double>(exponents.size()));
}

/// Mean and σ of each group, see condition_effects().
/// @param gains  σ by those of the tests of each; empty where they do not matter.
std::vector<ConditionMean> means_with_sigma(const std::vector<TestsOfGroup>& groups,
                                            const Residuals& gains = {}) {
  PooledScatter of_levels;
  PooledScatter of_tests;
  for (const TestsOfGroup& group : groups) {
    of_levels.add(all_of(group));
    of_tests.add(means_of(group));
  }
  std::vector<ConditionMean> means;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Residuals levels = all_of(groups[i]);
    const double known =
        std::hypot(sigma_of_mean(of_levels, levels.size()), gains.empty() ? 0.0 : gains[i]);
    // std::fmax takes the one that is known.
    means.push_back({mean_of(levels), std::fmax(known, sigma_of_mean(of_tests, groups[i].size()))});
  }
  return means;
}

/// The levels whose test says the condition, by its value; groups are those of the effect.
std::vector<TestsOfGroup> by_value(const CampaignFile& campaign, const CampaignLevels& levels,
                                   const ConditionEffect& effect, const Residuals& residuals) {
  std::vector<TestsOfGroup> groups(effect.groups.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const CampaignCondition* one = campaign.tests[levels.test[i]].condition(effect.name);
    if (one == nullptr || !std::isfinite(residuals[i])) continue;
    const auto at = std::ranges::find(effect.groups, one->value, &ConditionGroup::value);
    groups[static_cast<std::size_t>(at - effect.groups.begin())][levels.test[i]].push_back(
        residuals[i]);
  }
  return groups;
}

/// Its groups, with what is counted.
ConditionEffect groups_of(const CampaignFile& campaign, const CampaignLevels& levels,
                          const std::string& name) {
  ConditionEffect effect{.name = name};
  std::set<std::size_t> tests;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const CampaignCondition* one = campaign.tests[levels.test[i]].condition(name);
    if (one == nullptr) continue;
    const double a = levels.levels.amplitude[i];
    auto group = std::ranges::find(effect.groups, one->value, &ConditionGroup::value);
    if (group == effect.groups.end()) {
      effect.groups.push_back(
          {.value = one->value, .number = one->number, .least = a, .largest = a});
      group = std::prev(effect.groups.end());
    }
    ++group->levels;
    if (tests.insert(levels.test[i]).second) ++group->tests;
    group->least = std::min(group->least, a);
    group->largest = std::max(group->largest, a);
  }
  std::ranges::sort(effect.groups, {}, [](const ConditionGroup& group) {
    return std::tuple(!group.number.has_value(), group.number.value_or(0.0), group.value);
  });
  return effect;
}

/// Whether some session has two values of it.
bool varies_within_sessions(const CampaignFile& campaign, const std::string& name) {
  std::map<std::string, std::set<std::string>> values;
  for (const CampaignTest& test : campaign.tests) {
    const CampaignCondition* one = test.condition(name);
    if (test.identifies() && one != nullptr) values[test.session].insert(one->value);
  }
  return std::ranges::any_of(values, [](const auto& one) { return one.second.size() > 1; });
}

/// Slope of means over numbers, weights 1/σ².
ConditionMean slope_of(const std::vector<ConditionGroup>& groups,
                       ConditionMean ConditionGroup::*of) {
  double weights = 0.0;
  double x = 0.0;
  double m = 0.0;
  for (const ConditionGroup& group : groups) {
    if (!group.number) return {};
    const double weight = std::pow((group.*of).sigma, -2);
    weights += weight;
    x += weight * *group.number;
    m += weight * (group.*of).mean;
  }
  double xx = 0.0;
  double xm = 0.0;
  for (const ConditionGroup& group : groups) {
    const double weight = std::pow((group.*of).sigma, -2);
    const double apart = *group.number - x / weights;
    xx += weight * apart * apart;
    xm += weight * apart * ((group.*of).mean - m / weights);
  }
  if (!(xx > 0.0 && std::isfinite(xx))) return {};
  return {xm / xx, 1.0 / std::sqrt(xx)};
}

void put_means(const std::vector<ConditionMean>& means, ConditionMean ConditionGroup::*of,
               ConditionEffect& effect) {
  for (std::size_t i = 0; i < means.size(); ++i) effect.groups[i].*of = means[i];
}

Residuals offset_residuals(const CampaignFile& campaign, const CampaignLevels& levels,
                           const SessionEffects& effects) {
  const std::vector<double> offsets = offsets_of_levels(effects, campaign, levels);
  Residuals residuals;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    residuals.push_back(std::log(levels.levels.frequency[i] / effects.frequency[i]) - offsets[i]);
  }
  return residuals;
}

/// The modes that every group has levels of with these residuals.
std::set<std::size_t> modes_in_common(const CampaignFile& campaign, const CampaignLevels& levels,
                                      const ConditionEffect& effect, const Residuals& residuals) {
  std::map<std::size_t, std::set<std::string>> values;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const CampaignCondition* one = campaign.tests[levels.test[i]].condition(effect.name);
    if (one != nullptr && std::isfinite(residuals[i])) {
      values[levels.mode_of(i)].insert(one->value);
    }
  }
  std::set<std::size_t> modes;
  for (const auto& [mode, own] : values) {
    if (own.size() == effect.groups.size()) modes.insert(mode);
  }
  return modes;
}

/// Residuals of the levels of one mode; NaN of others.
Residuals of_mode(const CampaignLevels& levels, std::size_t mode, Residuals residuals) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels.mode_of(i) != mode) residuals[i] = std::numeric_limits<double>::quiet_NaN();
  }
  return residuals;
}

/// Residuals of modes in common, each less the mean over the groups of their means; NaN of others.
Residuals centred_by_mode(const CampaignFile& campaign, const CampaignLevels& levels,
                          const ConditionEffect& effect, const Residuals& residuals) {
  Residuals centred(levels.size(), std::numeric_limits<double>::quiet_NaN());
  for (const std::size_t mode : modes_in_common(campaign, levels, effect, residuals)) {
    const Residuals own = of_mode(levels, mode, residuals);
    Residuals means;
    for (const TestsOfGroup& group : by_value(campaign, levels, effect, own)) {
      means.push_back(mean_of(all_of(group)));
    }
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels.mode_of(i) == mode) centred[i] = own[i] - mean_of(means);
    }
  }
  return centred;
}

/// Whether frequencies tell no more than how they change.
bool modes_may_be_off(const CampaignFile& campaign) {
  return campaign.of_model() && campaign.frequency != FrequencyOfLevels::kAbsolute;
}

// ---- Texts. ----

std::string percent_of(const ConditionMean& mean) {
  if (!std::isfinite(mean.sigma)) return fmt::format("{:+.2g} %", 100.0 * mean.mean);
  return fmt::format("{:+.2g} ± {:.2g} %", 100.0 * mean.mean, 100.0 * mean.sigma);
}

/// Difference between two groups.
struct GroupDifference {
  const ConditionGroup* of = nullptr;
  const ConditionGroup* against = nullptr;
  ConditionMean by = {};

  [[nodiscard]] double significance() const { return std::abs(by.mean) / by.sigma; }
  [[nodiscard]] bool significant() const {
    return significance() > kSignificant && std::abs(by.mean) > kLeastDifference;
  }
};

/// The pair that differs most against its σ; nothing where no mean is known.
std::optional<GroupDifference> largest_difference(const ConditionEffect& effect,
                                                  ConditionMean ConditionGroup::*of) {
  std::optional<GroupDifference> most;
  for (const ConditionGroup& against : effect.groups) {
    for (const ConditionGroup& group : effect.groups) {
      if (&group <= &against || !std::isfinite((group.*of).mean)) continue;
      const GroupDifference one{&group,
                                &against,
                                {(group.*of).mean - (against.*of).mean,
                                 std::hypot((group.*of).sigma, (against.*of).sigma)}};
      if (!most || one.significance() > most->significance()) most = one;
    }
  }
  return most;
}

std::string difference_text(std::string_view quantity, const GroupDifference& one) {
  return fmt::format("{} at {} differs by {} from that at {}{}", quantity, printable(one.of->value),
                     percent_of(one.by), printable(one.against->value),
                     one.significant() ? ", more than three standard deviations" : "");
}

std::string values_text(const ConditionEffect& effect) {
  std::vector<std::string> values;
  for (const ConditionGroup& group : effect.groups) values.push_back(printable(group.value));
  return fmt::format("{}", fmt::join(values, ", "));
}

std::string pooled_text(const ConditionEffect& effect) {
  return fmt::format("tests at {} are identified together: {}",
                     condition_text(effect.name, values_text(effect)),
                     condition_verdict(effect).text);
}

}  // namespace

bool amplitudes_overlap(const std::vector<ConditionGroup>& groups) {
  for (const ConditionGroup& a : groups) {
    for (const ConditionGroup& b : groups) {
      if (a.largest < b.least) return false;
    }
  }
  return true;
}

ConditionVerdict condition_verdict(const ConditionEffect& effect) {
  ConditionVerdict verdict;
  if (!effect.pooled()) return verdict;
  const auto tell = [&](std::string_view quantity, ConditionMean ConditionGroup::*of) {
    const auto most = largest_difference(effect, of);
    if (!most) return;
    verdict.text += (verdict.text.empty() ? "" : "; ") + difference_text(quantity, *most);
    verdict.differ = verdict.differ || (effect.common_modes && most->significant());
  };
  tell("D", &ConditionGroup::dissipation);
  tell("the frequency", &ConditionGroup::frequency);
  verdict.text += verdict.differ ? ". They differ: identify them separately." : ".";
  if (!effect.common_modes) {
    verdict.text +=
        " They have no mode in common: the effects of the condition and of the mode cannot be "
        "distinguished.";
  }
  if (!effect.overlap) {
    verdict.text +=
        " Their amplitudes do not overlap: the effects of the condition and of the amplitude "
        "cannot be distinguished.";
  }
  return verdict;
}

std::vector<ConditionEffect> condition_effects(const CampaignFile& campaign,
                                               const CampaignLevels& levels,
                                               const SessionEffects& effects) {
  std::vector<ConditionEffect> all;
  for (const std::string& name : campaign.conditions()) {
    ConditionEffect effect = groups_of(campaign, levels, name);
    if (effect.groups.empty()) continue;
    effect.overlap = amplitudes_overlap(effect.groups);
    Residuals gains;
    if (!effects.exponent.empty()) {
      for (const TestsOfGroup& group : by_value(campaign, levels, effect, effects.exponent)) {
        gains.push_back(gain_of_mean(campaign, group));
      }
    }
    put_means(means_with_sigma(by_value(campaign, levels, effect, loss_residuals(levels, effects)),
                               gains),
              &ConditionGroup::dissipation, effect);
    const bool determined = !campaign.session_offsets || varies_within_sessions(campaign, name);
    effect.common_modes = !modes_in_common(campaign, levels, effect, effects.dissipation).empty();
    if (determined && !effects.frequency.empty()) {
      Residuals residuals = offset_residuals(campaign, levels, effects);
      if (modes_may_be_off(campaign)) {
        residuals = centred_by_mode(campaign, levels, effect, residuals);
      }
      put_means(means_with_sigma(by_value(campaign, levels, effect, residuals)),
                &ConditionGroup::frequency, effect);
    }
    effect.dissipation_trend = slope_of(effect.groups, &ConditionGroup::dissipation);
    effect.frequency_trend = slope_of(effect.groups, &ConditionGroup::frequency);
    all.push_back(std::move(effect));
  }
  return all;
}

std::vector<Warning> condition_warnings(const CampaignFile& campaign,
                                        const std::vector<ConditionEffect>& effects) {
  std::vector<Warning> warnings;
  for (const ConditionEffect& effect : effects) {
    if (effect.pooled()) warnings.push_back({"conditions_pooled", pooled_text(effect)});
    for (const CampaignTest& test : campaign.tests) {
      const CampaignCondition* one = test.condition(effect.name);
      if (!test.predicted() || one == nullptr) continue;
      if (std::ranges::find(effect.groups, one->value, &ConditionGroup::value) !=
          effect.groups.end()) {
        continue;
      }
      warnings.push_back(
          {"condition_not_identified",
           fmt::format("{} is predicted at {}, but the {} identified at {}: the effect of the "
                       "difference is unknown.",
                       test.name, condition_text(effect.name, one->value),
                       campaign.of_model() ? "joints were" : "joint was", values_text(effect))});
    }
  }
  return warnings;
}

std::string trend_text(const ConditionEffect& effect) {
  std::string text;
  const auto add = [&](std::string_view quantity, const ConditionMean& trend) {
    if (!std::isfinite(trend.mean)) return;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", quantity, percent_of(trend));
  };
  add("D", effect.dissipation_trend);
  add("frequency", effect.frequency_trend);
  return text.empty() ? text : fmt::format("{} per {}", text, condition_step(effect.name));
}

}  // namespace microslip
