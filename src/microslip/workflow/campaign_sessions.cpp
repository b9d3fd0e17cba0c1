// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign_sessions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Σ(v − v̄)².
double squares_of(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

/// Values of the levels of each session, in the order of the effects.
std::vector<std::vector<double>> by_session(const SessionEffects& effects,
                                            const CampaignFile& campaign,
                                            const CampaignLevels& levels,
                                            const std::vector<double>& values) {
  std::vector<std::vector<double>> sorted(effects.sessions.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const SessionEffect* session = effects.find(campaign.tests[levels.test[i]].session);
    sorted[static_cast<std::size_t>(session - effects.sessions.data())].push_back(values[i]);
  }
  return sorted;
}

void count_levels(const CampaignFile& campaign, const CampaignLevels& levels,
                  SessionEffects& effects) {
  for (const std::string& name : campaign.sessions()) {
    SessionEffect session;
    session.name = name;
    for (std::size_t t = 0; t < campaign.tests.size(); ++t) {
      if (campaign.tests[t].session != name) continue;
      const auto count = static_cast<std::size_t>(std::ranges::count(levels.test, t));
      session.levels += count;
      if (count > 0) ++session.tests;
    }
    if (session.levels > 0) effects.sessions.push_back(session);
  }
}

void add_repeatability(const CampaignFile& campaign, const CampaignLevels& levels,
                       const std::vector<double>& residuals, SessionEffects& effects) {
  std::map<std::string, std::map<std::size_t, std::vector<double>>> tests;  // of each session
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    tests[campaign.tests[levels.test[i]].session][levels.test[i]].push_back(residuals[i]);
  }
  double within = 0.0;
  std::size_t freedom = 0;
  for (const auto& [session, of_session] : tests) {
    std::vector<double> means;
    for (const auto& [test, values] : of_session) means.push_back(mean_of(values));
    within += squares_of(means);
    freedom += means.size() - 1;
  }
  if (freedom > 0) effects.within_sessions = std::sqrt(within / static_cast<double>(freedom));
  std::vector<double> between;
  for (const SessionEffect& session : effects.sessions) {
    between.push_back(session.dissipation_offset);
  }
  if (between.size() < 2) return;
  effects.between_sessions =
      std::sqrt(squares_of(between) / static_cast<double>(between.size() - 1));
}

void add_losses(const CampaignFile& campaign, const CampaignLevels& levels, const Joint& joint,
                double linear_damping, SessionEffects& effects) {
  for (const double a : levels.levels.amplitude) {
    const double linear = linear_damping * a * a;
    const double loss = dissipation(joint, a) + linear;
    const double growth = dissipation_slope(joint, a) * a + 2.0 * linear;
    effects.dissipation.push_back(loss);
    effects.exponent.push_back(loss > 0.0 ? growth / loss : 0.0);
  }
  const std::vector<double> residuals = loss_residuals(levels, effects);
  const auto sorted = by_session(effects, campaign, levels, residuals);
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    const auto count = static_cast<double>(sorted[s].size());
    effects.sessions[s].dissipation_offset = mean_of(sorted[s]);
    effects.sessions[s].dissipation_scatter = std::sqrt(squares_of(sorted[s]) / count);
  }
  add_repeatability(campaign, levels, residuals, effects);
}

/// y of each level; f̂ goes to `effects`.
std::vector<double> frequency_residuals(const CampaignLevels& levels, const StickState& state,
                                        const Joint& joint, SessionEffects& effects) {
  std::vector<double> residuals;
  const double spring =
      state.stiffness > 0.0 ? state.stiffness : joint.stiffness();  // in the modes
  for (std::size_t i = 0; i < levels.levels.frequency.size(); ++i) {
    const double softened = spring - secant_stiffness(joint, levels.levels.amplitude[i]);
    effects.frequency.push_back(natural_frequency(state, softened));
    residuals.push_back(std::log(levels.levels.frequency[i] / effects.frequency.back()));
  }
  return residuals;
}

bool of_first_mode(const std::vector<double>& residuals) {
  constexpr double kFarthest = 0.1;
  return std::ranges::all_of(residuals, [](double y) { return std::abs(y) <= kFarthest; });
}

[[noreturn]] void throw_no_offsets(std::string_view rule) {
  throw InputError("identification.session_offsets", "true", rule,
                   "Leave it out, or check structure and levels.");
}

/// Means of y against that of the first session.
void add_differences(const std::vector<std::vector<double>>& sorted, SessionEffects& effects) {
  double squares = 0.0;
  std::size_t count = 0;
  for (const std::vector<double>& values : sorted) {
    squares += squares_of(values);
    count += values.size();
  }
  const bool known = count > sorted.size();
  const double variance = squares / static_cast<double>(count - sorted.size());
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    SessionEffect& session = effects.sessions[s];
    session.frequency_scatter =
        std::sqrt(squares_of(sorted[s]) / static_cast<double>(sorted[s].size()));
    session.frequency_difference = mean_of(sorted[s]) - mean_of(sorted.front());
    if (s == 0) {
      session.frequency_difference_std = 0.0;
    } else if (known) {
      session.frequency_difference_std =
          std::sqrt(variance * (1.0 / static_cast<double>(sorted[s].size()) +
                                1.0 / static_cast<double>(sorted.front().size())));
    }
  }
}

void take_offsets(SessionEffects& effects) {
  double squares = 0.0;
  for (SessionEffect& session : effects.sessions) {
    if (!std::isfinite(session.frequency_difference_std)) {
      throw_no_offsets("needs a session with two levels: with one each, nothing tells the scatter");
    }
    session.frequency_offset = session.frequency_difference;
    session.frequency_offset_std = session.frequency_difference_std;
    squares += session.frequency_offset * session.frequency_offset;
  }
  effects.between_frequencies =
      std::sqrt(squares / static_cast<double>(effects.sessions.size() - 1));
}

void add_frequencies(const CampaignFile& campaign, const CampaignLevels& levels,
                     const StickState& state, const Joint& joint, SessionEffects& effects) {
  const std::vector<double> residuals = frequency_residuals(levels, state, joint, effects);
  const bool near = of_first_mode(residuals);
  if (residuals.empty() || !near) {
    if (campaign.session_offsets) {
      throw_no_offsets(near ? "needs a frequency of each level to identify from"
                            : "needs frequencies near that of the first mode of the structure");
    }
    effects.frequency.clear();
    return;
  }
  const auto sorted = by_session(effects, campaign, levels, residuals);
  add_differences(sorted, effects);
  if (campaign.session_offsets) take_offsets(effects);
  double squares = 0.0;
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    for (const double y : sorted[s]) {
      squares += std::pow(y - effects.sessions[s].frequency_offset, 2);
    }
  }
  effects.frequency_std = std::sqrt(squares / static_cast<double>(residuals.size()));
}

/// What is said of sessions whose amplitudes do not overlap those of the first.
void add_ranges(const CampaignFile& campaign, const CampaignLevels& levels,
                SessionEffects& effects) {
  const auto amplitude = by_session(effects, campaign, levels, levels.levels.amplitude);
  const auto [least, most] = std::ranges::minmax(amplitude.front());
  for (std::size_t s = 0; s < amplitude.size(); ++s) {
    const auto [low, high] = std::ranges::minmax(amplitude[s]);
    effects.sessions[s].apart = low > most || high < least;
  }
  if (effects.frequency.empty()) return;
  std::vector<double> logarithms;
  for (const double f : effects.frequency) logarithms.push_back(std::log(f));
  const auto frequency = by_session(effects, campaign, levels, logarithms);
  for (std::size_t s = 0; s < frequency.size(); ++s) {
    effects.sessions[s].softening = mean_of(frequency[s]) - mean_of(frequency.front());
  }
}

}  // namespace

std::vector<double> loss_residuals(const CampaignLevels& levels, const SessionEffects& effects) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double measured = levels.levels.dissipation[i];
    const double found = effects.dissipation[i];
    residuals.push_back(measured > 0.0 && found > 0.0 ? std::log(measured / found) : 0.0);
  }
  return residuals;
}

const SessionEffect* SessionEffects::find(const std::string& name) const {
  const auto found = std::ranges::find(sessions, name, &SessionEffect::name);
  return found == sessions.end() ? nullptr : &*found;
}

SessionEffects session_effects(const CampaignFile& campaign, const CampaignLevels& levels,
                               const StickState& state, const Joint& joint, double linear_damping) {
  SessionEffects effects;
  count_levels(campaign, levels, effects);
  add_losses(campaign, levels, joint, linear_damping, effects);
  add_frequencies(campaign, levels, state, joint, effects);
  add_ranges(campaign, levels, effects);
  return effects;
}

std::vector<double> offsets_of_levels(const SessionEffects& effects, const CampaignFile& campaign,
                                      const CampaignLevels& levels) {
  std::vector<double> offsets;
  for (const std::size_t test : levels.test) {
    offsets.push_back(effects.find(campaign.tests[test].session)->frequency_offset);
  }
  return offsets;
}

}  // namespace microslip
