// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/model_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// Draws of records have a k each; those of another joint lie elsewhere.
void check_stiffness(const JointSamples& samples, double stiffness, const std::string& path,
                     const std::string& name) {
  constexpr double kApart = 0.1;
  const auto [least, most] = std::ranges::minmax(samples.stiffness);
  if (stiffness >= (1.0 - kApart) * least && stiffness <= (1.0 + kApart) * most) return;
  throw InputError(
      fmt::format("samples of {}", name), in_quotes(input_name(path)),
      fmt::format("must be draws of the same joint: their stiffness is {:.6g} to {:.6g} N/m, that "
                  "of the joint {:.6g} N/m",
                  least, most, stiffness),
      "Name the file that was written beside its joint.json.");
}

/// Whether one calibration drew them all.
bool are_of_one_calibration(const std::vector<std::optional<JointSamples>>& samples) {
  const JointSamples* first = nullptr;
  for (const auto& one : samples) {
    if (!one) continue;
    if (first == nullptr) first = &*one;
    if (!one->provenance || !first->provenance || one->size() != first->size()) return false;
    if (one->method != first->method || one->seed != first->seed) return false;
    if (one->method != "posterior of modal levels") return false;
    if (one->provenance->inputs != first->provenance->inputs) return false;
  }
  return true;
}

std::string share_text(const DrawsTaken& taken) {
  return fmt::format("{} of {}", taken.failed(), taken.options.count);
}

}  // namespace

void DrawOptions::check() const {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw InputError("confidence", confidence, "must be above 0 and below 1",
                     "0.95 leaves 2.5 % of the draws on each side.");
  }
  const std::size_t least = fewest(confidence);
  if (count >= least && count <= kMostDraws) return;
  throw InputError("draws", static_cast<double>(count),
                   fmt::format("must be from {}, so that one lies beyond each quantile, to {}",
                               least, kMostDraws),
                   "1000 give the edges of a 95 % band to about 5 % of its width.");
}

std::size_t DrawOptions::fewest(double confidence) {
  // 2/(1 − 0.95) is 40 but for rounding.
  return static_cast<std::size_t>(std::ceil(2.0 / (1.0 - confidence) - 1e-6));
}

void DrawOptions::check_size(std::size_t values, const std::string& remedy) const {
  if (values == 0) return;
  check_memory("`draws`", static_cast<double>(count), static_cast<double>(sizeof(double) * values),
               remedy);
}

JointDraws joint_draws_of(JointSamples samples, bool damping_said) {
  const auto kept = std::make_shared<const JointSamples>(std::move(samples));
  return {kept->size(), [kept, damping_said](std::size_t i) {
            DrawnJoint drawn{kept->joint(i)};
            if (!damping_said && !kept->linear_damping.empty()) {
              drawn.linear_damping = kept->linear_damping[i];
            }
            return drawn;
          }};
}

JointSamples samples_for(const std::string& path, double stiffness, const std::string& name) {
  JointSamples samples = read_joint_samples(path);
  check_stiffness(samples, stiffness, path, name);
  return samples;
}

StructureDraws draws_of(const JointedStructure& structure, const StructureSpread& spread,
                        std::vector<std::optional<JointSamples>> samples,
                        const std::vector<bool>& damping_said, const DrawOptions& options,
                        const std::string& name) {
  options.check();
  const bool together =
      options.correlation == Correlation::kTogether ||
      (options.correlation == Correlation::kAuto && are_of_one_calibration(samples));
  std::vector<JointDraws> joints;
  for (std::size_t j = 0; j < samples.size(); ++j) {
    const bool said = j < damping_said.size() && damping_said[j];
    joints.push_back(samples[j] ? joint_draws_of(*std::move(samples[j]), said) : JointDraws{});
  }
  StructureDraws draws(structure, spread, std::move(joints),
                       together ? JointPairing::kTogether : JointPairing::kIndependent,
                       options.seed);
  if (draws.any()) return draws;
  throw InputError(
      fmt::format("{}: uncertainty", name), "none",
      "must include a parameter that the draws can vary",
      "Name the draws of a joint with samples, or give frequency_std, loss_factor_std, "
      "normal_load_std or gain_std.");
}

StructureDraws draws_of(const ModelFile& model, const std::string& file,
                        const DrawOptions& options) {
  options.check();
  std::vector<std::optional<JointSamples>> samples(model.joint_samples.size());
  for (std::size_t j = 0; j < samples.size(); ++j) {
    if (model.joint_samples[j].empty()) continue;
    const StructuralJoint& joint = model.structure.joints()[j];
    samples[j] = samples_for(model.joint_samples[j], joint.joint.stiffness(),
                             fmt::format("'{}'", joint.name));
  }
  return draws_of(model.structure, model.spread, std::move(samples), model.damping_said, options,
                  input_name(file));
}

std::size_t DrawsTaken::failed() const {
  std::size_t sum = 0;
  for (const Failure& failure : failures) sum += failure.count;
  return sum;
}

bool DrawsTaken::too_many_failed() const {
  return static_cast<double>(failed()) > kMostFailed * static_cast<double>(options.count);
}

DrawsTaken take_draws(const DrawOptions& options,
                      const std::function<std::string(std::size_t i)>& work,
                      const Execution& execution, const Progress& progress) {
  std::vector<std::string> reasons(options.count);
  const auto one = [&](std::size_t i) {
    try {
      reasons[i] = work(i);
    } catch (const InputError& error) {
      reasons[i] = error.what();
    }
  };
  execution.for_each(options.count, one, progress);
  DrawsTaken taken{options, {}};
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (reasons[i].empty()) continue;
    const auto same = std::ranges::find(taken.failures, reasons[i], &DrawsTaken::Failure::reason);
    if (same == taken.failures.end()) {
      taken.failures.push_back({reasons[i], 1, i});
    } else {
      ++same->count;
    }
  }
  std::ranges::stable_sort(taken.failures, std::ranges::greater(), &DrawsTaken::Failure::count);
  return taken;
}

Band band_of(const std::vector<std::vector<double>>& lower,
             const std::vector<std::vector<double>>& upper, double confidence) {
  std::size_t rows = 0;
  for (const auto& values : lower) rows = std::max(rows, values.size());
  if (rows == 0) {
    throw InputError("draws", "none that converged", "must be 1 or more for a band");
  }
  Band band;
  std::vector<double> low;
  std::vector<double> high;
  for (std::size_t row = 0; row < rows; ++row) {
    low.clear();
    high.clear();
    for (std::size_t i = 0; i < lower.size(); ++i) {
      if (lower[i].empty()) continue;
      low.push_back(lower[i][row]);
      high.push_back(upper[i][row]);
    }
    band.lower.push_back(quantile_pair(low, confidence).first);
    band.upper.push_back(quantile_pair(high, confidence).second);
  }
  return band;
}

Band band_of(const std::vector<std::vector<double>>& values, double confidence) {
  return band_of(values, values, confidence);
}

std::string draws_comment(const DrawsTaken& taken, const std::string& what) {
  const DrawOptions& options = taken.options;
  std::string text =
      comment_entry(kDrawsKey, "",
                    fmt::format("{} of seed {}, {} % between lower and upper; uncertain: {}",
                                options.count, options.seed, 100.0 * options.confidence, what));
  if (taken.failed() == 0) return text;
  text += '\n' + comment_entry(
                     kDrawsFailedKey, "",
                     fmt::format("{}{}, left out", taken.too_many_failed() ? "NOT CONVERGED: " : "",
                                 share_text(taken)));
  constexpr std::size_t kMostReasons = 10;
  for (std::size_t i = 0; i < std::min(taken.failures.size(), kMostReasons); ++i) {
    const DrawsTaken::Failure& failure = taken.failures[i];
    text += '\n' + comment_entry(kFailureKey, "",
                                 fmt::format("{} {}, first number {}: {}", failure.count,
                                             failure.count == 1 ? "draw" : "draws", failure.example,
                                             failure.reason));
  }
  return text;
}

std::string uncertain_text(const ModelFile& model) {
  std::string text;
  const auto add = [&](const std::string& what) {
    text += fmt::format("{}{}", text.empty() ? "" : "; ", what);
  };
  const auto given = [](const std::vector<double>& values) {
    return std::ranges::any_of(values, [](double value) { return value > 0.0; });
  };
  for (std::size_t j = 0; j < model.structure.joints().size(); ++j) {
    const std::string& name = model.structure.joints()[j].name;
    const bool drawn = j < model.joint_samples.size() && !model.joint_samples[j].empty();
    if (drawn) add(fmt::format("samples of '{}'", name));
    const bool loaded = j < model.spread.normal_load.size() && model.spread.normal_load[j] > 0.0;
    if (loaded) add(fmt::format("normal_load_std of '{}'", name));
  }
  if (given(model.spread.frequency)) add("frequency_std");
  if (given(model.spread.loss_factor)) add("loss_factor_std");
  if (given(model.spread.force_gain)) add("gain_std of the excitation");
  if (model.spread.response_gain > 0.0) add("gain_std of the response");
  return text;
}

std::string describe_draws(const DrawsTaken& taken, const std::string& what) {
  std::string text =
      line("draws", fmt::format("{} of seed {}, {} % between lower and upper", taken.options.count,
                                taken.options.seed, 100.0 * taken.options.confidence));
  text += line("uncertain", what);
  constexpr std::size_t kMostReasons = 3;
  for (std::size_t i = 0; i < std::min(taken.failures.size(), kMostReasons); ++i) {
    const DrawsTaken::Failure& failure = taken.failures[i];
    text += line("failed", fmt::format("{}, first number {}: {}", failure.count, failure.example,
                                       failure.reason));
  }
  return text;
}

std::vector<Warning> draw_warnings(const DrawsTaken& taken) {
  std::vector<Warning> warnings;
  if (taken.failed() > 0) {
    warnings.push_back(
        {"draws_failed",
         fmt::format("{} draws failed and are in no quantile{}. The comments give the reasons.",
                     share_text(taken),
                     taken.too_many_failed()
                         ? fmt::format(", more than {:g} %: the band is that of the others, which "
                                       "may not be representative",
                                       100.0 * DrawsTaken::kMostFailed)
                         : "")});
  }
  return warnings;
}

}  // namespace microslip
