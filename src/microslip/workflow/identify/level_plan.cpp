// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/level_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/identify/inversion/further_levels.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/identify/methods/diagnostics.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/workflow/identify/planned_peak.hpp"
#include "microslip/workflow/reduce/level_table.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr double kWidths = 3.92;         // of a band of 95 %, over the standard deviation
constexpr double kHardlyHelps = 0.01;    // share of the width
constexpr std::size_t kGridPoints = 64;  // of each spacing
/// Every so many draws goes through a structure: neighbours are alike.
constexpr std::size_t kPeakStride = 4;

std::size_t stride_of(PlanTarget target) { return target == PlanTarget::kPeak ? kPeakStride : 1; }

/// Amplitudes in equal steps and in equal ratios, of four digits: who wants steady vibration cannot
/// set more.
std::vector<double> amplitudes_between(double from, double to) {
  std::vector<double> grid;
  const double last = static_cast<double>(kGridPoints - 1);
  for (std::size_t i = 0; i < kGridPoints; ++i) {
    const double share = static_cast<double>(i) / last;
    grid.push_back(from + share * (to - from));
    grid.push_back(from * std::pow(to / from, share));
  }
  for (double& a : grid) {
    // A quotient of whole numbers is the double next to what is written: 7.197e-06.
    const double units = std::pow(10.0, 3.0 - std::floor(std::log10(a)));
    a = std::clamp(std::round(a * units) / units, from, to);
  }
  std::ranges::sort(grid);
  const auto alike = [](double a, double b) { return b - a < 1e-9 * b; };
  grid.erase(std::unique(grid.begin(), grid.end(), alike), grid.end());
  return grid;
}

/// Of a draw: density, joint with its curves, and what it makes of the levels, some.
constexpr double kBytesOfKnot = 500.0;

void check_interval(std::string_view name, std::pair<double, double> range) {
  if (range.first >= 0.0 && range.second > range.first && std::isfinite(range.second)) return;
  throw InputError(name, fmt::format("{:g} to {:g}", range.first, range.second),
                   "must rise from 0 or more");
}

void check_planning(const LevelPlanning& options) {
  if (options.count < 1 || options.count > kMostDesigned) {
    throw InputError("count", static_cast<double>(options.count),
                     fmt::format("must be from 1 to {}", kMostDesigned));
  }
  constexpr std::size_t kFewestDraws = 100;
  if (options.draws < kFewestDraws || options.draws > LevelPlanning::kMostDraws) {
    throw InputError("draws", static_cast<double>(options.draws),
                     fmt::format("must be from {} to {}", kFewestDraws, LevelPlanning::kMostDraws),
                     "1000 give expected widths to about 3 %.");
  }
  if (options.range) check_interval("range", *options.range);
  if (!options.amplitude) return;
  check_interval("amplitude", *options.amplitude);
  if (options.amplitude->first > 0.0) return;
  throw InputError("FROM of `amplitude`", options.amplitude->first, "must be above 0 m");
}

void check_enough(const LevelEvidence& evidence) {
  if (evidence.size() >= kFewestToPlan) return;
  throw InputError(
      "number of different amplitudes", static_cast<double>(evidence.size()),
      fmt::format("must be {} or more: a plan rests on the density found so far", kFewestToPlan),
      fmt::format("Start with {} or more levels in equal steps from the smallest to the largest "
                  "amplitude of the test.",
                  kFewestToPlan));
}

/// Far beyond the levels nothing is known that a plan could rest on.
void check_reach(std::string_view name, double reach, double highest,
                 const LevelPlanning& options) {
  constexpr double kFarthest = 3.0;
  if (reach <= kFarthest * highest) return;
  const bool forces = name == "`range`";
  throw InputError(fmt::format("TO of {}", name), forces ? options.stiffness * reach : reach,
                   fmt::format("must be {:.4g} {} or less, {:g} times the range of the levels",
                               kFarthest * highest * (forces ? options.stiffness : 1.0),
                               forces ? "N" : "m", kFarthest),
                   "Measure a level in between, and plan again.");
}

/// A posterior, and the levels that it is of.
struct Known {
  LevelEvidence evidence;
  InversionResult result;
};

/// Draws must reach to all amplitudes and slip forces that are asked for.
Known known_up_to(double amplitude, LevelEvidence evidence, double stiffness) {
  constexpr double kBeyond = 1.0 + 1e-9;
  InversionResult result = invert(evidence, stiffness);
  if (amplitude <= kBeyond * evidence.levels().amplitude.back()) {
    return {std::move(evidence), std::move(result)};
  }
  LevelEvidence reaching = reaching_to(evidence, result, stiffness, amplitude);
  InversionResult beyond = invert(reaching, stiffness);
  return {std::move(reaching), std::move(beyond)};
}

std::vector<DensitySample> planning_draws(const InversionResult& result,
                                          const LevelPlanning& options) {
  check_memory("`draws`", static_cast<double>(options.draws),
               kBytesOfKnot * static_cast<double>(result.slip_force.size()), "Take fewer.");
  DensityPosterior posterior = result.posterior;
  posterior.goals = {};  // extremes are ends of bands: they say nothing of a variance
  posterior.rises.clear();
  const std::vector<DensitySample> all =
      posterior.samples(options.seed, options.draws, Execution::threads(), options.progress);
  std::vector<DensitySample> taken;
  for (std::size_t i = 0; i < all.size(); i += stride_of(options.target)) taken.push_back(all[i]);
  return taken;
}

DesignTarget target_of(std::vector<Joint>& joints, const LevelPlanning& options, LevelPlan& plan,
                       const Joint& found) {
  switch (options.target) {
    case PlanTarget::kArea:
      return area_target(joints, plan.range);
    case PlanTarget::kPeak: {
      PeakDraws peak = peak_draws(options, found, joints);
      plan.peak_frequency = peak.frequency;
      plan.peak_height = peak.height;
      joints = std::move(peak.joints);
      std::ranges::move(peak.warnings, std::back_inserter(plan.warnings));
      return {{1, std::move(peak.heights)}, {1.0}};
    }
    case PlanTarget::kDensity:
      break;
  }
  return density_target(joints, plan.range);
}

void to_widths(LevelDesign& design) {
  for (double* value : {&design.now, &design.after, &design.one_more}) *value *= kWidths;
  for (DesignedLevel& level : design.levels) {
    level.before *= kWidths;
    level.after *= kWidths;
    level.endless *= kWidths;
  }
}

void plan_by(const LevelEvidence& evidence, const LevelPlanning& options, LevelPlan& plan) {
  check_enough(evidence);
  const std::vector<double>& measured = evidence.levels().amplitude;
  const auto [from, to] = options.amplitude.value_or(std::pair{measured.front(), measured.back()});
  check_reach("`amplitude`", to, measured.back(), options);
  plan.amplitude = amplitudes_between(from, to);
  plan.range = options.range.value_or(std::pair{options.stiffness * from, options.stiffness * to});
  check_reach("`range`", plan.range.second / options.stiffness, measured.back(), options);
  const Known known =
      known_up_to(std::max(to, plan.range.second / options.stiffness), evidence, options.stiffness);
  plan.warnings = diagnose(known.result, known.evidence, options.stiffness, {});
  std::vector<Joint> joints =
      drawn_joints(known.result, planning_draws(known.result, options), options.stiffness);
  const DesignTarget target =
      target_of(joints, options, plan, joint_of(known.result, options.stiffness));
  plan.draws = joints.size();
  plan.design = design_levels(further_levels(known.evidence, known.result, joints, plan.amplitude),
                              target, options.count);
  to_widths(plan.design);
}

std::string_view unit_of_width(PlanTarget target) {
  if (target == PlanTarget::kArea) return "1";
  return target == PlanTarget::kPeak ? "m" : "1/N";
}

std::string width_text(double width, PlanTarget target) {
  return target == PlanTarget::kArea ? fmt::format("{:.4g}", width)
                                     : fmt::format("{:.4g} {}", width, unit_of_width(target));
}

std::string target_text(const LevelPlan& plan, const LevelPlanning& options) {
  if (options.target == PlanTarget::kPeak) {
    return fmt::format("height of the peak of {} at {:.6g} Hz, {:.5g} m", options.peak.model,
                       plan.peak_frequency, plan.peak_height);
  }
  return fmt::format(
      "{} from {:.4g} to {:.4g} N",
      options.target == PlanTarget::kArea ? "slipping fraction of k" : "density, mean band width",
      plan.range.first, plan.range.second);
}

double fall_of(double before, double after) { return before > 0.0 ? 1.0 - after / before : 0.0; }

/// Amplitudes whose further repeats would hardly lower the width.
std::string exhausted_text(const LevelPlan& plan) {
  std::string list;
  for (const DesignedLevel& level : plan.design.levels) {
    if (fall_of(level.after, level.endless) >= kHardlyHelps) continue;
    list += (list.empty() ? "" : ", ") + length_text(plan.amplitude[level.candidate]);
  }
  if (list.empty()) {
    return "repeats still help at each amplitude: repeated without end, they lower the width by "
           "another 1 % or more";
  }
  return fmt::format(
      "further repeats no longer help at {}: any number of them lowers the width by less than 1 %",
      list);
}

std::string one_more_text(const LevelPlan& plan, PlanTarget target) {
  const double gain = fall_of(plan.design.after, plan.design.one_more);
  return fmt::format("{}; one more level lowers it by {:.2g} %{}",
                     width_text(plan.design.after, target), 100.0 * gain,
                     gain < kHardlyHelps ? ", which hardly helps" : "");
}

}  // namespace

LevelPlan plan_levels(const LevelPlanning& options) {
  check_planning(options);
  LevelTable table = read_level_table(options.levels, {.assemblies = AssemblyColumn::kRefused});
  LevelPlan plan;
  plan.input = std::move(table.input);
  plan.used = table.used.levels.size();
  const LevelEvidence evidence(table.used.levels);
  try {
    plan_by(evidence, options, plan);
  } catch (const InputError& error) {
    if (evidence.size() >= kFewestToPlan) throw;
    throw error.renamed(fmt::format("{}: {}", table.used.file, error.name()));
  }
  std::ranges::move(table.warnings, std::back_inserter(plan.warnings));
  return plan;
}

std::string plan_text(const LevelPlan& plan, const LevelPlanning& options,
                      std::string_view command) {
  CsvWriter table;
  table.add_comment(provenance_of(command, {plan.input}));
  table.add_comment(
      fmt::format("target: {}; 95 % band, {} draws", target_text(plan, options), plan.draws));
  table.add_comment("errors common to all levels are not in the widths: no level reduces them");
  table.add_comment(fmt::format("width now: {}", width_text(plan.design.now, options.target)));
  table.add_comment(fmt::format("width after all: {}", one_more_text(plan, options.target)));
  table.add_comment(exhausted_text(plan));
  add_warnings(plan.warnings, table);
  const Dimension dimension = options.target == PlanTarget::kArea   ? kDimensionless
                              : options.target == PlanTarget::kPeak ? kLength
                                                                    : kPerForce;
  const auto add = [&](std::string_view name, const Dimension& of, auto value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < plan.design.levels.size(); ++i) {
      values.push_back(value(i, plan.design.levels[i]));
    }
    table.add_numbers(name, of, values);
  };
  add("rank", kDimensionless, [](std::size_t i, auto&) { return static_cast<double>(i + 1); });
  add("amplitude", kLength,
      [&](std::size_t, auto& level) { return plan.amplitude[level.candidate]; });
  add("repeats", kDimensionless,
      [](std::size_t, auto& level) { return static_cast<double>(level.repeats); });
  add("width_before", dimension, [](std::size_t, auto& level) { return level.before; });
  add("width_after", dimension, [](std::size_t, auto& level) { return level.after; });
  add("width_endless", dimension, [](std::size_t, auto& level) { return level.endless; });
  return table.str();
}

std::string describe_plan(const LevelPlan& plan, const LevelPlanning& options) {
  std::string text =
      line("levels", fmt::format("{}, {} draws", counted(plan.used, "level"), plan.draws)) +
      line("target", target_text(plan, options)) +
      line("width now", width_text(plan.design.now, options.target));
  std::size_t rank = 0;
  for (const DesignedLevel& level : plan.design.levels) {
    text += line(fmt::format("next {}", ++rank),
                 fmt::format("{}{}: then {}", length_text(plan.amplitude[level.candidate]),
                             level.repeats > 1 ? fmt::format(", {} times", level.repeats) : "",
                             width_text(level.after, options.target)));
  }
  return text + line("width after all", one_more_text(plan, options.target)) +
         wrapped("  ", exhausted_text(plan), 2);
}

}  // namespace microslip
