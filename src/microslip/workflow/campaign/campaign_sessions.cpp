// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign_sessions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/campaign/campaign_statistics.hpp"

namespace microslip {
namespace {

/// Values of the levels of each session and mode that are known, in the order of the effects.
std::vector<std::vector<double>> by_session(const SessionEffects& effects,
                                            const CampaignFile& campaign,
                                            const CampaignLevels& levels,
                                            const std::vector<double>& values) {
  std::vector<std::vector<double>> sorted(effects.sessions.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const SessionEffect* session =
        effects.find(campaign.tests[levels.test[i]].session, levels.mode_of(i));
    sorted[static_cast<std::size_t>(session - effects.sessions.data())].push_back(values[i]);
  }
  return sorted;
}

/// The number of the first session that has levels of the mode of session s.
std::size_t first_of(const SessionEffects& effects, std::size_t s) {
  const auto first =
      std::ranges::find(effects.sessions, effects.sessions[s].mode, &SessionEffect::mode);
  return static_cast<std::size_t>(first - effects.sessions.begin());
}

void count_levels(const CampaignFile& campaign, const CampaignLevels& levels,
                  SessionEffects& effects) {
  for (const std::string& name : campaign.sessions()) {
    std::map<std::size_t, std::map<std::size_t, std::size_t>> counts;  // of each mode and test
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (campaign.tests[levels.test[i]].session == name) {
        ++counts[levels.mode_of(i)][levels.test[i]];
      }
    }
    for (const auto& [mode, tests] : counts) {
      SessionEffect session{.name = name, .mode = mode, .tests = tests.size()};
      for (const auto& [test, count] : tests) session.levels += count;
      effects.sessions.push_back(session);
    }
  }
}

void add_repeatability(const CampaignFile& campaign, const CampaignLevels& levels,
                       const std::vector<double>& residuals, SessionEffects& effects) {
  using OfTests = std::map<std::size_t, std::vector<double>>;
  std::map<std::pair<std::string, std::size_t>, OfTests> cells;  // of each session and mode
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!std::isfinite(residuals[i])) continue;
    cells[{campaign.tests[levels.test[i]].session, levels.mode_of(i)}][levels.test[i]].push_back(
        residuals[i]);
  }
  PooledScatter within;
  for (const auto& [cell, tests] : cells) {
    std::vector<double> means;
    for (const auto& [test, values] : tests) means.push_back(mean_of(values));
    within.add(means);
  }
  if (within.known()) effects.within_sessions = std::sqrt(within.variance());
  std::map<std::size_t, std::vector<double>> of_modes;
  for (const SessionEffect& session : effects.sessions) {
    if (!std::isfinite(session.dissipation_offset)) continue;
    of_modes[session.mode].push_back(session.dissipation_offset);
  }
  PooledScatter between;
  for (const auto& [mode, offsets] : of_modes) between.add(offsets);
  if (between.known()) effects.between_sessions = std::sqrt(between.variance());
}

void add_losses(const CampaignFile& campaign, const CampaignLevels& levels,
                SessionEffects& effects) {
  const std::vector<double> residuals = loss_residuals(levels, effects);
  const auto sorted = by_session(effects, campaign, levels, residuals);
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    const auto count = static_cast<double>(sorted[s].size());
    effects.sessions[s].dissipation_offset = mean_of(sorted[s]);
    effects.sessions[s].dissipation_scatter = std::sqrt(squares_of(sorted[s]) / count);
  }
  add_repeatability(campaign, levels, residuals, effects);
}

/// y of each level.
std::vector<double> frequency_residuals(const CampaignLevels& levels,
                                        const SessionEffects& effects) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < effects.frequency.size(); ++i) {
    residuals.push_back(std::log(levels.levels.frequency[i] / effects.frequency[i]));
  }
  return residuals;
}

/// f̂ of the first mode of a structure at each level, Hz.
std::vector<double> frequencies_of_first_mode(const CampaignLevels& levels, const StickState& state,
                                              const Joint& joint) {
  std::vector<double> frequencies;
  const double spring =
      state.stiffness > 0.0 ? state.stiffness : joint.stiffness();  // in the modes
  for (std::size_t i = 0; i < levels.levels.frequency.size(); ++i) {
    const double softened = spring - secant_stiffness(joint, levels.levels.amplitude[i]);
    frequencies.push_back(natural_frequency(state, softened));
  }
  return frequencies;
}

/// The numbers of levels with y, of each session and mode.
std::map<std::pair<std::string, std::size_t>, std::vector<std::size_t>> levels_of_sessions(
    const CampaignFile& campaign, const CampaignLevels& levels,
    const std::vector<double>& residuals) {
  std::map<std::pair<std::string, std::size_t>, std::vector<std::size_t>> numbers;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!std::isfinite(residuals[i])) continue;
    numbers[{campaign.tests[levels.test[i]].session, levels.mode_of(i)}].push_back(i);
  }
  return numbers;
}

/// y of a test, and of the others.
struct TwoSets {
  std::vector<double> own;
  std::vector<double> others;
};

/// Of levels where their amplitudes overlap.
/// @param numbers  of the levels, those of the test among them.
TwoSets overlapping(const CampaignLevels& levels, const std::vector<double>& residuals,
                    const std::vector<std::size_t>& numbers, std::size_t test) {
  const auto range = [&](bool own) {
    std::pair range{HUGE_VAL, -HUGE_VAL};
    for (const std::size_t i : numbers) {
      if ((levels.test[i] == test) != own) continue;
      range.first = std::min(range.first, levels.levels.amplitude[i]);
      range.second = std::max(range.second, levels.levels.amplitude[i]);
    }
    return range;
  };
  const auto own = range(true);
  const auto others = range(false);
  TwoSets sets;
  for (const std::size_t i : numbers) {
    const double a = levels.levels.amplitude[i];
    if (a < std::max(own.first, others.first) || a > std::min(own.second, others.second)) continue;
    (levels.test[i] == test ? sets.own : sets.others).push_back(residuals[i]);
  }
  return sets;
}

bool of_first_mode(const std::vector<double>& residuals) {
  constexpr double kFarthest = 0.1;
  return std::ranges::all_of(residuals, [](double y) { return std::abs(y) <= kFarthest; });
}

[[noreturn]] void throw_no_offsets(std::string_view rule) {
  throw InputError("identification.session_offsets", "true", rule,
                   "Leave it out, or check structure and levels.");
}

/// Means of y against that of the first session of each mode.
void add_differences(const std::vector<std::vector<double>>& sorted, SessionEffects& effects) {
  PooledScatter scatter;
  for (const std::vector<double>& values : sorted) scatter.add(values);
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    SessionEffect& session = effects.sessions[s];
    const std::vector<double>& first = sorted[first_of(effects, s)];
    session.frequency_scatter =
        std::sqrt(squares_of(sorted[s]) / static_cast<double>(sorted[s].size()));
    session.frequency_difference = mean_of(sorted[s]) - mean_of(first);
    if (s == first_of(effects, s)) {
      session.frequency_difference_std = sorted[s].empty() ? session.frequency_difference : 0.0;
    } else if (scatter.known()) {
      session.frequency_difference_std =
          std::sqrt(scatter.variance() * (1.0 / static_cast<double>(sorted[s].size()) +
                                          1.0 / static_cast<double>(first.size())));
    }
  }
}

void take_offsets(SessionEffects& effects) {
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t s = 0; s < effects.sessions.size(); ++s) {
    SessionEffect& session = effects.sessions[s];
    if (!std::isfinite(session.frequency_difference)) continue;  // without frequencies
    if (!std::isfinite(session.frequency_difference_std)) {
      throw_no_offsets(
          "needs a session with two levels: with one each, the scatter cannot be determined");
    }
    session.frequency_offset = session.frequency_difference;
    session.frequency_offset_std = session.frequency_difference_std;
    squares += session.frequency_offset * session.frequency_offset;
    count += s == first_of(effects, s) ? 0 : 1;
  }
  if (count == 0) throw_no_offsets("needs frequencies of a mode in two sessions");
  effects.between_frequencies = std::sqrt(squares / static_cast<double>(count));
}

void add_frequencies(const CampaignFile& campaign, const CampaignLevels& levels,
                     SessionEffects& effects) {
  const std::vector<double> residuals = frequency_residuals(levels, effects);
  const auto sorted = by_session(effects, campaign, levels, residuals);
  add_differences(sorted, effects);
  if (campaign.session_offsets) take_offsets(effects);
  std::map<std::size_t, std::vector<double>> left;  // of each mode
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    const SessionEffect& session = effects.sessions[s];
    if (campaign.session_offsets && !effects.determined_offset(session.name, session.mode))
      continue;
    for (const double y : sorted[s]) left[session.mode].push_back(y - session.frequency_offset);
  }
  std::vector<double> all;
  for (const auto& [mode, values] : left) {
    std::ranges::copy(values, std::back_inserter(all));
    if (!values.empty()) effects.frequency_std_of_modes[mode] = rms_of(values);
  }
  if (!all.empty()) effects.frequency_std = rms_of(all);
}

/// Marks sessions whose amplitudes do not overlap those of the first.
void add_ranges(const CampaignFile& campaign, const CampaignLevels& levels,
                SessionEffects& effects) {
  const auto amplitude = by_session(effects, campaign, levels, levels.levels.amplitude);
  for (std::size_t s = 0; s < amplitude.size(); ++s) {
    const auto [least, most] = std::ranges::minmax(amplitude[first_of(effects, s)]);
    const auto [low, high] = std::ranges::minmax(amplitude[s]);
    effects.sessions[s].apart = low > most || high < least;
  }
  std::vector<double> logarithms;
  for (const double f : effects.frequency) logarithms.push_back(std::log(f));
  const auto frequency = by_session(effects, campaign, levels, logarithms);
  for (std::size_t s = 0; s < frequency.size(); ++s) {
    const std::vector<double>& first = frequency[first_of(effects, s)];
    if (frequency[s].empty() || first.empty()) continue;
    effects.sessions[s].softening = mean_of(frequency[s]) - mean_of(first);
  }
}

}  // namespace

std::vector<double> loss_residuals(const CampaignLevels& levels, const SessionEffects& effects) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (i < effects.damping_over_found.size() && std::isfinite(effects.damping_over_found[i])) {
      residuals.push_back(std::log(effects.damping_over_found[i]));
      continue;
    }
    const double measured = levels.levels.dissipation[i];
    const double found = effects.dissipation[i];
    const bool nothing = measured <= 0.0 || found <= 0.0;
    residuals.push_back(nothing ? 0.0 : std::log(measured / found));
  }
  return residuals;
}

const SessionEffect* SessionEffects::find(const std::string& name, std::size_t mode) const {
  const auto found = std::ranges::find_if(sessions, [&](const SessionEffect& session) {
    return session.name == name && session.mode == mode;
  });
  return found == sessions.end() ? nullptr : &*found;
}

bool SessionEffects::has(const std::string& name) const {
  return std::ranges::find(sessions, name, &SessionEffect::name) != sessions.end();
}

std::optional<std::pair<double, double>> SessionEffects::determined_offset(const std::string& name,
                                                                           std::size_t mode) const {
  const SessionEffect* own = find(name, mode);
  if (own == nullptr || find(sessions.front().name, mode) == nullptr) return std::nullopt;
  if (!std::isfinite(own->frequency_difference)) return std::nullopt;
  return std::pair{own->frequency_offset, own->frequency_offset_std};
}

double SessionEffects::frequency_std_of(std::size_t mode) const {
  const auto own = frequency_std_of_modes.find(mode);
  return own == frequency_std_of_modes.end() ? frequency_std : own->second;
}

std::pair<double, double> SessionEffects::offset_of(const std::string& name,
                                                    std::size_t mode) const {
  const auto own = determined_offset(name, mode);
  return own ? *own : offset_of_others(name);
}

std::pair<double, double> SessionEffects::offset_of_others(const std::string& name) const {
  std::vector<double> offsets;
  for (const SessionEffect& session : sessions) {
    if (session.name != name) continue;
    const auto own = determined_offset(name, session.mode);
    if (own) offsets.push_back(own->first);
  }
  if (offsets.empty()) return {0.0, between_frequencies};
  constexpr std::size_t kFewest = 3;  // two hardly tell a scatter
  const double mean = mean_of(offsets);
  const auto n = static_cast<double>(offsets.size());
  if (offsets.size() < kFewest) return {mean, std::sqrt(mean * mean + squares_of(offsets) / n)};
  return {mean, std::sqrt(squares_of(offsets) / (n - 1.0) * (1.0 + 1.0 / n))};
}

std::vector<TestDifference> differing_tests(const CampaignFile& campaign,
                                            const CampaignLevels& levels,
                                            const SessionEffects& effects) {
  std::vector<TestDifference> all;
  if (effects.frequency.empty()) return all;
  const std::vector<double> residuals = frequency_residuals(levels, effects);
  for (const auto& [key, numbers] : levels_of_sessions(campaign, levels, residuals)) {
    std::set<std::size_t> tests;
    for (const std::size_t i : numbers) tests.insert(levels.test[i]);
    for (const std::size_t test : tests) {
      const TwoSets sets = overlapping(levels, residuals, numbers, test);
      if (sets.own.size() < 2 || sets.others.size() < 2) continue;
      const auto n = static_cast<double>(sets.own.size());
      const auto m = static_cast<double>(sets.others.size());
      PooledScatter scatter;
      scatter.add(sets.own);
      scatter.add(sets.others);
      const TestDifference one{.test = test,
                               .mode = key.second,
                               .difference = mean_of(sets.own) - mean_of(sets.others),
                               .sigma = std::sqrt(scatter.variance() * (1.0 / n + 1.0 / m))};
      const double least = std::max(kSignificant * one.sigma, kLeastDifference);
      if (std::abs(one.difference) > least) all.push_back(one);
    }
  }
  return all;
}

SessionEffects session_effects(const CampaignFile& campaign, const CampaignLevels& levels,
                               SessionEffects found) {
  count_levels(campaign, levels, found);
  add_losses(campaign, levels, found);
  if (!found.frequency.empty()) add_frequencies(campaign, levels, found);
  add_ranges(campaign, levels, found);
  return found;
}

SessionEffects session_effects(const CampaignFile& campaign, const CampaignLevels& levels,
                               const StickState& state, const Joint& joint, double linear_damping) {
  SessionEffects found{.frequency = frequencies_of_first_mode(levels, state, joint)};
  for (const double a : levels.levels.amplitude) {
    const double linear = linear_damping * a * a;
    const double loss = dissipation(joint, a) + linear;
    const double growth = dissipation_slope(joint, a) * a + 2.0 * linear;
    found.dissipation.push_back(loss);
    found.exponent.push_back(loss > 0.0 ? growth / loss : 0.0);
  }
  const bool near = of_first_mode(frequency_residuals(levels, found));
  if (campaign.session_offsets && (found.frequency.empty() || !near)) {
    throw_no_offsets(near ? "needs a frequency of each level to identify from"
                          : "needs frequencies near that of the first mode of the structure");
  }
  if (!near) found.frequency.clear();
  return session_effects(campaign, levels, std::move(found));
}

std::vector<double> offsets_of_levels(const SessionEffects& effects, const CampaignFile& campaign,
                                      const CampaignLevels& levels) {
  std::vector<double> offsets;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    offsets.push_back(
        effects.find(campaign.tests[levels.test[i]].session, levels.mode_of(i))->frequency_offset);
  }
  return offsets;
}

}  // namespace microslip
