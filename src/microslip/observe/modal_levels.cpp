// SPDX-License-Identifier: MIT
#include "microslip/observe/modal_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/gather.hpp"

namespace microslip {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A vector of one entry per level, and the rule of its values.
template <typename Owner>
struct ModalColumn {
  std::string_view name;
  std::vector<double> Owner::*values;
  bool positive;
};

constexpr std::array kModalColumns{
    ModalColumn<ModalLevels>{"displacement", &ModalLevels::displacement, true},
    ModalColumn<ModalLevels>{"displacement_std", &ModalLevels::displacement_std, false},
    ModalColumn<ModalLevels>{"frequency", &ModalLevels::frequency, true},
    ModalColumn<ModalLevels>{"frequency_std", &ModalLevels::frequency_std, false},
    ModalColumn<ModalLevels>{"dissipation", &ModalLevels::dissipation, false},
    ModalColumn<ModalLevels>{"dissipation_std", &ModalLevels::dissipation_std, false},
    ModalColumn<ModalLevels>{"damping_ratio", &ModalLevels::damping_ratio, false},
    ModalColumn<ModalLevels>{"damping_ratio_std", &ModalLevels::damping_ratio_std, false}};

constexpr std::array kJointColumns{
    ModalColumn<JointLevels>{"amplitude", &JointLevels::amplitude, true},
    ModalColumn<JointLevels>{"amplitude_std", &JointLevels::amplitude_std, false},
    ModalColumn<JointLevels>{"dissipation", &JointLevels::dissipation, false},
    ModalColumn<JointLevels>{"dissipation_std", &JointLevels::dissipation_std, false}};

/// Makes room for levels of which only some have the column.
void append_column(const std::vector<double>& more, std::size_t more_levels, std::size_t before,
                   std::vector<double>& values) {
  if (more.empty() && values.empty()) return;
  values.resize(before, kUnknown);
  values.insert(values.end(), more.begin(), more.end());
  values.resize(before + more_levels, kUnknown);
}

void check_column(std::string_view name, const std::vector<double>& values, std::size_t levels,
                  bool positive) {
  if (!values.empty() && values.size() != levels) {
    throw InputError(name, fmt::format("{} values", values.size()),
                     fmt::format("must have {}, one per level, or none", levels));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    const bool fits = positive ? values[i] > 0.0 : values[i] >= 0.0;
    if (fits && std::isfinite(values[i])) continue;
    throw InputError(fmt::format("{} of level {}", name, i + 1), values[i],
                     positive ? "must be positive and finite" : "must be 0 or more and finite");
  }
}

bool tells_a_loss(const ModalLevels& levels, std::size_t i) {
  const auto known = [i](const std::vector<double>& values) {
    return !std::isnan(ModalLevels::value(values, i));
  };
  return known(levels.dissipation) || known(levels.damping_ratio) ||
         std::ranges::any_of(levels.joints,
                             [&](const JointLevels& joint) { return known(joint.dissipation); });
}

bool has_a_loss(const ModalLevels& levels, std::size_t i) {
  const auto positive = [i](const std::vector<double>& values) {
    return ModalLevels::value(values, i) > 0.0;
  };
  return positive(levels.dissipation) || positive(levels.damping_ratio) ||
         std::ranges::any_of(levels.joints,
                             [&](const JointLevels& joint) { return positive(joint.dissipation); });
}

}  // namespace

void append(const ModalLevels& more, ModalLevels& levels) {
  const std::size_t before = levels.size();
  for (const auto& column : kModalColumns) {
    append_column(more.*column.values, more.size(), before, levels.*column.values);
  }
  for (const JointLevels& joint : more.joints) {
    if (std::ranges::find(levels.joints, joint.name, &JointLevels::name) == levels.joints.end()) {
      levels.joints.push_back({.name = joint.name});
    }
  }
  for (JointLevels& joint : levels.joints) {
    const auto same = std::ranges::find(more.joints, joint.name, &JointLevels::name);
    const JointLevels added = same == more.joints.end() ? JointLevels{} : *same;
    for (const auto& column : kJointColumns) {
      append_column(added.*column.values, more.size(), before, joint.*column.values);
    }
  }
  if (!more.session.empty() || !levels.session.empty()) {
    levels.session.resize(before, 0);
    levels.session.insert(levels.session.end(), more.session.begin(), more.session.end());
    levels.session.resize(before + more.size(), 0);
  }
  levels.mode.insert(levels.mode.end(), more.mode.begin(), more.mode.end());
}

ModalLevels some_levels(const ModalLevels& levels, std::span<const std::size_t> which) {
  const auto some = [&](const auto& values) { return gather(values, which); };
  ModalLevels kept{.mode = some(levels.mode), .session = some(levels.session)};
  for (const auto& column : kModalColumns) kept.*column.values = some(levels.*column.values);
  for (const JointLevels& joint : levels.joints) {
    kept.joints.push_back({.name = joint.name});
    for (const auto& column : kJointColumns) {
      kept.joints.back().*column.values = some(joint.*column.values);
    }
  }
  return kept;
}

std::size_t distinct_levels(const ModalLevels& levels) {
  std::set<std::pair<std::size_t, double>> places;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    places.emplace(levels.mode[i], levels.displacement[i]);
  }
  return places.size();
}

void check_modal_levels(const ModalLevels& levels) {
  for (const auto& column : kModalColumns) {
    check_column(column.name, levels.*column.values, levels.size(), column.positive);
  }
  if (!levels.session.empty() && levels.session.size() != levels.size()) {
    throw InputError("session", fmt::format("{} values", levels.session.size()),
                     fmt::format("must have {}, one per level, or none", levels.size()));
  }
  for (const JointLevels& joint : levels.joints) {
    for (const auto& column : kJointColumns) {
      check_column(fmt::format("{}_{}", column.name, joint.name), joint.*column.values,
                   levels.size(), column.positive);
    }
  }
  bool any_loss = false;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (std::isnan(ModalLevels::value(levels.displacement, i))) {
      throw InputError(fmt::format("displacement of level {}", i + 1), InputState{"missing"},
                       "must be given");
    }
    if (!tells_a_loss(levels, i)) {
      throw InputError(fmt::format("loss of level {}", i + 1), InputState{"missing"},
                       "must be given as dissipation or as damping_ratio");
    }
    any_loss = any_loss || has_a_loss(levels, i);
  }
  if (levels.size() > 0 && !any_loss) {
    throw InputError("loss of all levels", 0.0, "must be above 0 at one of them");
  }
}

}  // namespace microslip
