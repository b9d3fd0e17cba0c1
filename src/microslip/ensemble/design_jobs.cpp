// SPDX-License-Identifier: MIT
#include "microslip/ensemble/design_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/ensemble/input_hashes.hpp"
#include "microslip/identify/inversion/bands.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/identify/methods/density_comparison.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

constexpr std::size_t kPoints = 50;  // points of the curves in the results
/// Levels and draws of a test have streams of their own.
constexpr std::uint64_t kStreamsOfDraws = std::uint64_t{1} << 40U;

double amplitude_of(const DesignPlan& plan, std::size_t i, std::size_t count) {
  const double share = static_cast<double>(i) / static_cast<double>(count - 1);
  return plan.equal_ratios ? plan.lowest * std::pow(plan.highest / plan.lowest, share)
                           : plan.lowest + share * (plan.highest - plan.lowest);
}

double relative_rms(const std::vector<double>& found, const std::vector<double>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sum += std::pow(found[i] / truth[i] - 1.0, 2);
  }
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

/// Share of the knots from 5 to 95 % of the range at which the band contains the truth, and its
/// mean width over the mean density of the truth there.
std::pair<double, double> judge_band(const InversionResult& result, const DensityBands& bands,
                                     const SlipDensity& truth) {
  const double reach = result.slip_force.back();
  double inside = 0.0;
  double count = 0.0;
  double width = 0.0;
  double density = 0.0;
  for (std::size_t j = 0; j < result.slip_force.size(); ++j) {
    const double f = result.slip_force[j];
    if (f < 0.05 * reach || f > 0.95 * reach) continue;
    const double there = truth.density(f);
    count += 1.0;
    inside += bands.lower[j] <= there && there <= bands.upper[j] ? 1.0 : 0.0;
    width += bands.upper[j] - bands.lower[j];
    density += there;
  }
  return {inside / count, density > 0.0 ? width / density : std::nan("")};
}

}  // namespace

DesignJobs::DesignJobs(DesignPlan design, const EnsemblePlan& plan)
    : plan_(std::move(design)), seed_(plan.seed), confidence_(plan.confidence) {
  if (plan_.rig.empty()) {
    take_joint(plan.file);
  } else {
    take_rig(plan.file);
  }
  found_.emplace(stiffness_, plan_.lowest, plan_.highest, kPoints,
                 plan_.identification.linear_damping);
  if (rig_) {
    add_rig_designs();
  } else {
    add_designs();
  }
  notes_.push_back(fmt::format(
      "errors are relative: density_error as ‖φ − φ_true‖/‖φ_true‖ from 5 to 95 % of kA_max, "
      "dissipation_error as rms over the amplitudes"));
  if (linear_damping_ > 0.0) {
    notes_.push_back(fmt::format(
        "the tests have the linear damping of the joint file, {:g} J/m^2{}", linear_damping_,
        plan_.identification.linear_damping
            ? ""
            : "; no identification includes it: set linear_damping = true"));
  }
}

void DesignJobs::take_joint(const std::string& plan) {
  const JointFile file = read_joint(plan_.joint);
  truth_ = file.joint;
  stiffness_ = truth_->stiffness();
  linear_damping_ = identified_damping(file).value_or(0.0);
  inputs_ = hashes_of({plan_.joint});
  if (dissipation(*truth_, plan_.lowest) > 0.0) return;
  throw InputError(fmt::format("{}: design.amplitude_m[0]", plan), plan_.lowest,
                   "must be an amplitude at which the joint dissipates");
}

void DesignJobs::take_rig(const std::string& plan) {
  rig_.emplace(plan_, plan);
  truth_ = rig_->truth().joint;
  stiffness_ = rig_->stiffness();
  linear_damping_ = identified_damping(rig_->truth()).value_or(0.0);
  plan_.lowest = rig_->lowest();
  plan_.highest = rig_->highest();
  plan_.equal_ratios = rig_->equal_ratios();
  inputs_ = hashes_of(rig_->files());
  warnings_ = rig_->warnings();
  notes_.push_back("tests: records of the rig under a sinusoidal force, reduced to levels");
  for (std::size_t s = 0; s < plan_.sensors.size(); ++s) {
    notes_.push_back(fmt::format("sensors {}: {}", s + 1, fmt::join(plan_.sensors[s], ", ")));
  }
}

void DesignJobs::add_rig_designs() {
  for (std::size_t tests = 0; tests < plan_.levels.size(); ++tests) {
    for (const double noise : plan_.sensor_noise) {
      for (std::size_t s = 0; s < std::max<std::size_t>(1, plan_.sensors.size()); ++s) {
        add_group(
            {.levels = plan_.levels[tests], .tests = tests, .sensor_noise = noise, .sensors = s});
      }
    }
  }
}

void DesignJobs::add_designs() {
  const std::vector<double> secant =
      plan_.secant_noise.empty() ? std::vector<double>{0.0} : plan_.secant_noise;
  for (const std::size_t levels : plan_.levels) {
    for (const double noise : plan_.noise) {
      for (const double amplitude : plan_.amplitude_noise) {
        for (const double k : secant) add_group({levels, noise, amplitude, k});
      }
    }
  }
}

std::string DesignJobs::name_of(const Design& design) const {
  if (rig_) {
    std::string name =
        fmt::format("{} levels - noise of the sensors x {:g}", design.levels, design.sensor_noise);
    if (!plan_.sensors.empty()) name += fmt::format(" - sensors {}", design.sensors + 1);
    return name;
  }
  std::string name = fmt::format("{} levels - noise {:g}", design.levels, design.noise);
  if (design.amplitude_noise > 0.0) name += fmt::format(" - of A {:g}", design.amplitude_noise);
  if (design.secant_noise > 0.0) name += fmt::format(" - of k_eq {:g}", design.secant_noise);
  return name;
}

void DesignJobs::add_group(const Design& design) {
  const std::string name = name_of(design);
  const auto same = std::ranges::find(groups_, name, &EnsembleGroup::name);
  if (same != groups_.end()) return;  // a number that is given twice
  EnsembleGroup group{name,
                      plan_.count,
                      {{"density_error", kDimensionless},
                       {"area_error", kDimensionless},
                       {"dissipation_error", kDimensionless}}};
  if (plan_.draws > 0) {
    group.outputs.push_back({"band_coverage", kDimensionless});
    group.outputs.push_back({"band_width", kDimensionless});
  }
  std::ranges::copy(found_->outputs(), std::back_inserter(group.outputs));
  groups_.push_back(std::move(group));
  designs_.push_back(design);
}

Levels DesignJobs::tested(const Design& design, std::uint64_t index) const {
  RandomStream random(seed_, index);
  if (rig_) {
    // Records have streams of their own: each test has a seed of 53 bits for them.
    constexpr double kSeeds = 9007199254740992.0;
    const auto seed = static_cast<std::uint64_t>(kSeeds * random.uniform());
    return rig_->levels(design.tests, design.sensor_noise, design.sensors, seed);
  }
  Levels levels;
  for (std::size_t i = 0; i < design.levels; ++i) {
    const double a = amplitude_of(plan_, i, design.levels);
    const double of_dissipation = random.normal();
    const double of_amplitude = random.normal();
    const double of_secant = random.normal();
    const double loss = dissipation(*truth_, a) + linear_damping_ * a * a;
    levels.amplitude.push_back(a * std::max(1e-3, 1.0 + design.amplitude_noise * of_amplitude));
    levels.dissipation.push_back(std::max(0.0, loss * (1.0 + design.noise * of_dissipation)));
    if (design.secant_noise == 0.0) continue;
    const double std = design.secant_noise * truth_->stiffness();
    levels.secant_stiffness.push_back(secant_stiffness(*truth_, a) + std * of_secant);
    levels.secant_stiffness_std.push_back(std);
  }
  return levels;
}

std::vector<double> DesignJobs::judged(const InversionResult& result, std::uint64_t index) const {
  const double k = stiffness_;
  const double reach = k * plan_.highest;
  std::vector<double> found;
  std::vector<double> truth;
  const Joint joint = joint_of(result, k);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double a = amplitude_of(plan_, i, kPoints);
    found.push_back(dissipation(joint, a) + result.linear_damping.value_or(0.0) * a * a);
    truth.push_back(dissipation(*truth_, a) + linear_damping_ * a * a);
  }
  std::vector<double> values{
      density_error(result.slip_force, result.density, reach, truth_->density()),
      result.area - truth_->density().moments(reach).zeroth, relative_rms(found, truth)};
  if (plan_.draws == 0) return values;
  const DensityBands bands = density_bands(result, {.samples = plan_.draws,
                                                    .confidence = confidence_,
                                                    .seed = seed_ + kStreamsOfDraws * (index + 1),
                                                    .execution = Execution::serial()});
  const auto [coverage, width] = judge_band(result, bands, truth_->density());
  values.push_back(coverage);
  values.push_back(width);
  return values;
}

JobResult DesignJobs::run(std::size_t group, std::uint64_t index) const {
  try {
    const InversionResult result = invert(LevelEvidence(tested(designs_[group], index)), stiffness_,
                                          inversion_options(plan_.identification));
    if (!result.summary.converged()) return {{}, result.summary.reason};
    JobResult done{judged(result, index), {}};
    std::ranges::copy(found_->of(result), std::back_inserter(done.values));
    return done;
  } catch (const InputError& error) {
    return {{}, error.what()};
  }
}

}  // namespace microslip
