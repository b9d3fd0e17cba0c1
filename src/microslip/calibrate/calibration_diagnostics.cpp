// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/median.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/calibrate/calibration.hpp"
#include "microslip/calibrate/known_together.hpp"

namespace microslip {
namespace {

/// A joint is not seen where the variance reduction of its density is below this everywhere.
constexpr double kLeastReduction = 0.5;
/// A loss less than so many of its standard deviations above 0 at all levels may as well be none:
/// the estimate of a zero loss is 2 of them, as it cannot be negative.
constexpr double kLeastLossRatio = 3.0;
/// A band of this half width, over the loss, is wide; it counts where the joint has this share of
/// the loss of all.
constexpr double kWideBand = 0.1;
constexpr double kShareThatCounts = 0.1;
/// Offsets of the frequencies beyond this are more than a model and a test usually differ by.
constexpr double kLargeOffset = 0.01;
/// An offset over its standard deviation that is not noise.
constexpr double kLargeOffsetRatio = 3.0;
/// Scatter of losses: relative, and over the given deviations.
constexpr double kLargeScatter = 0.15;
constexpr double kLargeScatterRatio = 2.0;
/// Losses without deviations scatter by this at least, relative.
constexpr double kLeastScatter = 1e-3;
/// Median of |N(0, 1)|.
constexpr double kMedianOfNormal = 0.6745;
/// Share of all calibrations in which a level is falsely called an outlier.
constexpr double kByChance = 1e-3;
/// Scatter of frequencies, relative: the softening of joints is known better than that.
constexpr double kLargeFrequencyScatter = 5e-4;
/// A sensor and the structure may differ by this share of the amplitude, or, where the sensor has
/// standard deviations, by so many of these, rms.
constexpr double kSensorShare = 0.1;
constexpr double kSensorRatio = 3.0;

/// Names of the levels.
class LevelNames {
 public:
  explicit LevelNames(const std::vector<std::string>& names) : names_(names) {}

  /// "level 3", or its name.
  [[nodiscard]] std::string of(std::size_t level) const {
    return names_.empty() ? fmt::format("level {}", level + 1) : names_[level];
  }
  /// "3", or its name.
  [[nodiscard]] std::string in_list(std::size_t level) const {
    return names_.empty() ? fmt::format("{}", level + 1) : names_[level];
  }

 private:
  const std::vector<std::string>& names_;
};

void warn_of_missing(const CalibrationResult& result, const LevelNames& names,
                     std::vector<Warning>& warnings) {
  std::string list;
  std::size_t missing = 0;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (result.levels[i].found) continue;
    if (++missing <= 5) list += (list.empty() ? "" : ", ") + names.in_list(i);
  }
  if (missing == 0) return;
  warnings.push_back(
      {"levels_not_found",
       fmt::format(
           "the structure has no resonance at the displacement of {} level{} ({}{}): it does not "
           "reach their displacement, or its modes differ from those measured. They were left out.",
           missing, missing == 1 ? "" : "s", list, missing > 5 ? ", …" : "")});
}

void warn_of_pairs(const CalibrationResult& result, std::vector<Warning>& warnings) {
  for (const JointPair& pair : result.pairs) {
    if (!pair.known_only_together) continue;
    warnings.push_back(
        {"known_only_together",
         fmt::format("{} and {} are known only together: the sum of their losses to {}, each to {} "
                     "at best (one standard deviation; correlation {:.2f}). Measure a mode that "
                     "exercises one of them more than the other, or its displacement.",
                     result.joints[pair.first].name, result.joints[pair.second].name,
                     percent_text(pair.spread_together), percent_text(pair.spread_alone),
                     pair.correlation)});
  }
}

void warn_of_groups(const CalibrationResult& result, std::vector<Warning>& warnings) {
  if (result.known_in_sum.size() < 2) return;
  std::string names;
  for (const std::size_t joint : result.known_in_sum) {
    names += (names.empty() ? "" : ", ") + result.joints[joint].name;
  }
  warnings.push_back(
      {"known_only_together",
       fmt::format(
           "{} are known only together: the loss of all joints is known far better than that of "
           "each of them. Measure modes that exercise them differently, or their displacements.",
           names)});
}

void warn_of_unseen(const CalibrationResult& result, std::vector<Warning>& warnings) {
  for (std::size_t j = 0; j < result.joints.size(); ++j) {
    const CalibratedJoint& joint = result.joints[j];
    const double most = std::ranges::max(joint.variance_reduction);
    if (known_only_together(result, j)) continue;  // has a warning of its own
    if (joint.loss_significance < kLeastLossRatio) {
      warnings.push_back(
          {"joint_not_seen",
           fmt::format("the loss of {} is not distinguishable from 0: it is {:.2g} times its "
                       "standard deviation at best, over all levels. Only the upper end of its "
                       "density's band is informative. Measure a mode that exercises it.",
                       joint.name, joint.loss_significance)});
    } else if (most < kLeastReduction) {
      warnings.push_back({"joint_not_seen",
                          fmt::format("the levels hardly determine {}: variance reduction of its "
                                      "density is {} at best. Measure a mode that exercises it.",
                                      joint.name, percent_text(most))});
    }
  }
}

/// Half the width of a band, over the loss.
double half_width(const Estimate& loss) { return 0.5 * (loss.upper - loss.lower) / loss.value; }

/// A loss in a wide band may be as far off as that, where the joint takes part in the loss of all.
void warn_of_wide_bands(const CalibrationResult& result, const LevelNames& names,
                        std::vector<Warning>& warnings) {
  for (std::size_t j = 0; j < result.joints.size(); ++j) {
    const CalibratedJoint& joint = result.joints[j];
    if (known_only_together(result, j)) continue;  // has a warning of its own
    std::size_t wide = 0;
    std::size_t counted = 0;
    std::size_t where = 0;
    double most = kWideBand;
    for (std::size_t i = 0; i < result.levels.size(); ++i) {
      const CalibratedLevel& level = result.levels[i];
      const Estimate& loss = level.joints[joint.index].dissipation;
      if (!level.found || !(loss.value > kShareThatCounts * level.dissipation)) continue;
      ++counted;
      const double half = half_width(loss);
      if (!(half > kWideBand)) continue;
      ++wide;
      if (half <= most) continue;
      most = half;
      where = i;
    }
    if (wide == 0) continue;
    warnings.push_back(
        {"loss_uncertain",
         fmt::format("the loss of {} is known to ± {} or worse at {} of the {} levels where it has "
                     "a tenth of the loss of all: ± {} at {}. Measure more levels, a mode that "
                     "exercises it more than the others, or its displacement.",
                     joint.name, percent_text(kWideBand), wide, counted, percent_text(most),
                     names.of(where))});
  }
}

void warn_of_offsets(const CalibrationResult& result, std::vector<Warning>& warnings) {
  for (std::size_t m = 0; m < result.frequency_offset.size(); ++m) {
    const double offset = result.frequency_offset[m];
    if (std::isnan(offset) || std::abs(offset) < kLargeOffset) continue;
    warnings.push_back(
        {"frequency_offset",
         fmt::format("mode {} was measured {:+.2f} % off the frequency of the model: displacements "
                     "of the joints depend on its shapes. Correct the model, the stiffness of the "
                     "joints, or how much of it is in the modes (spring_in_modes).",
                     m + 1, 100.0 * offset)});
  }
}

/// Modes that a wrong modulus puts off are off alike. Where they are not, by more than they are
/// known to, mass or stiffness is wrong in places, and shapes are, which no offset corrects.
void warn_of_unlike_offsets(const CalibrationResult& result, std::vector<Warning>& warnings) {
  if (result.modes.springs.empty()) return;  // as given
  std::vector<std::size_t> measured;
  double mean = 0.0;
  for (std::size_t m = 0; m < result.frequency_offset.size(); ++m) {
    if (std::isnan(result.frequency_offset[m])) continue;
    measured.push_back(m);
    mean += result.modes.offset[m];
  }
  mean /= static_cast<double>(measured.size());
  std::string list;
  bool differ = false;
  for (const std::size_t m : measured) {
    const double least =
        std::max(kLargeFrequencyScatter, kLargeOffsetRatio * result.modes.deviation[m]);
    differ = differ || std::abs(result.modes.offset[m] - mean) > least;
    list += fmt::format("{}mode {} {:+.2g} %", list.empty() ? "" : ", ", m + 1,
                        100.0 * result.modes.offset[m]);
  }
  if (!differ) return;
  warnings.push_back(
      {"offsets_differ",
       fmt::format("the modes without joints are off the model by different shares ({}): so are "
                   "its shapes then, by amounts that the bands do not contain. Correct the model.",
                   list)});
}

/// "level 3 has 10 times the fitted loss".
std::string worst_level(const CalibrationResult& result, const LevelNames& names) {
  double worst = 0.0;
  std::size_t where = 0;
  double ratio = 1.0;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const CalibratedLevel& level = result.levels[i];
    const double over = level.measured_dissipation / level.dissipation;
    if (!level.found || !(over > 0.0) || !(std::abs(std::log(over)) > worst)) continue;
    worst = std::abs(std::log(over));
    where = i;
    ratio = over;
  }
  return fmt::format("{} has {:.3g} times the fitted loss", names.of(where), ratio);
}

void warn_of_scatter(const CalibrationResult& result, const LevelNames& names,
                     std::vector<Warning>& warnings) {
  const double scatter = result.loss_scatter;
  if (result.loss_std_given && scatter > kLargeScatterRatio) {
    warnings.push_back(
        {"scatter_large",
         fmt::format("losses scatter {:.3g} times as much as their standard deviations state ({}): "
                     "these are too small, or the model is wrong.",
                     scatter, worst_level(result, names))});
  } else if (!result.loss_std_given && scatter > kLargeScatter) {
    warnings.push_back(
        {"scatter_large", fmt::format("losses scatter by {} about the fit: {}.",
                                      percent_text(scatter), worst_level(result, names))});
  }
}

/// What residuals of losses scatter by, 1: their median, which one or two of many do not move,
/// corrected for the degrees of freedom of the densities. NaN where these are too many.
double typical_residual(const CalibrationResult& result) {
  std::vector<double> sizes;
  for (const CalibratedLevel& level : result.levels) {
    if (level.found && std::isfinite(level.residual)) sizes.push_back(std::abs(level.residual));
  }
  const auto count = static_cast<double>(sizes.size());
  if (count <= 2.0 * result.edf) return std::numeric_limits<double>::quiet_NaN();
  const double scatter =
      median(std::move(sizes)) / kMedianOfNormal * std::sqrt(count / (count - result.edf));
  const double least = result.loss_std_given ? 1.0 : kLeastScatter;
  return std::max(scatter, least / result.loss_scatter);
}

void warn_of_outliers(const CalibrationResult& result, const LevelNames& names,
                      std::vector<Warning>& warnings) {
  const double typical = typical_residual(result);
  for (const std::size_t i : result.outliers) {
    const CalibratedLevel& level = result.levels[i];
    warnings.push_back(
        {"level_outlier",
         fmt::format("{} has {:.3g} times the fitted loss, {:.3g} times as far off as the levels "
                     "scatter. It was weighted in full: correct it, or leave it out.",
                     names.of(i), level.measured_dissipation / level.dissipation,
                     std::abs(level.residual) / typical)});
  }
}

void warn_of_frequencies(const CalibrationResult& result, std::vector<Warning>& warnings) {
  const double scatter = result.frequency_scatter;
  const double most = result.frequency_std_given ? kLargeScatterRatio : kLargeFrequencyScatter;
  if (!(scatter > most)) return;
  warnings.push_back(
      {"frequency_unexplained",
       fmt::format("frequencies deviate from those of the identified joints by {}: a gain of the "
                   "displacements, the model, or a changed load. The result then rests on the "
                   "losses alone.",
                   result.frequency_std_given
                       ? fmt::format("{:.3g} times their standard deviations", scatter)
                       : percent_text(scatter))});
}

bool some_positive(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value > 0.0; });
}

void warn_of_std(const CalibrationResult& result, const ModalLevels& levels,
                 std::vector<Warning>& warnings) {
  const bool joint_std = std::ranges::any_of(
      levels.joints, [](const JointLevels& joint) { return some_positive(joint.dissipation_std); });
  const auto warn = [&](std::string_view what) {
    warnings.push_back(
        {"std_ignored", fmt::format("standard deviations of {} are not used: not every level has "
                                    "one above 0.",
                                    what)});
  };
  if (!result.loss_std_given && (some_positive(levels.dissipation_std) || joint_std ||
                                 some_positive(levels.damping_ratio_std))) {
    warn("the losses");
  }
  if (!result.frequency_std_given && some_positive(levels.frequency_std)) warn("the frequencies");
  if (result.loss_std_given) return;
  if (!some_positive(levels.displacement_std)) return;
  warnings.push_back({"std_ignored",
                      "standard deviations of displacements are not used for the losses: they are "
                      "used only with those of the losses, which not every level has above 0."});
}

/// How a sensor deviates from its joint.
struct SensorErrors {
  double worst = 0.0;     ///< largest, relative
  std::size_t where = 0;  ///< its level
  double rms = 0.0;       ///< over the standard deviations; NaN where a level has none
};

SensorErrors errors_of(const CalibrationResult& result, const JointLevels& sensor,
                       const CalibratedJoint& joint) {
  SensorErrors errors;
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const JointAtLevel& at = result.levels[i].joints[joint.index];
    if (!result.levels[i].found || std::isnan(at.measured_amplitude)) continue;
    const double error = at.measured_amplitude / at.amplitude - 1.0;
    const double deviation = ModalLevels::value(sensor.amplitude_std, i);
    squares += deviation > 0.0 ? std::pow(error * at.amplitude / deviation, 2)
                               : std::numeric_limits<double>::quiet_NaN();
    count += 1.0;
    if (!(std::abs(error) > std::abs(errors.worst))) continue;
    errors.worst = error;
    errors.where = i;
  }
  errors.rms = std::sqrt(squares / count);
  return errors;
}

void warn_of_sensors(const CalibrationResult& result, const ModalLevels& levels,
                     const LevelNames& names, std::vector<Warning>& warnings) {
  for (const CalibratedJoint& joint : result.joints) {
    const auto measured = std::ranges::find(levels.joints, joint.name, &JointLevels::name);
    if (measured == levels.joints.end()) continue;
    const auto [worst, where, rms] = errors_of(result, *measured, joint);
    const bool contradicts = std::isnan(rms) ? std::abs(worst) >= kSensorShare : rms > kSensorRatio;
    if (!contradicts) continue;
    warnings.push_back(
        {"sensor_contradicts",
         fmt::format("the sensor of {} shows {:.2g} % {} than the structure with the identified "
                     "joints, at {}: check its gain and the shape of the joint.{}",
                     joint.name, 100.0 * std::abs(worst), worst > 0.0 ? "more" : "less",
                     names.of(where),
                     std::isnan(rms) ? ""
                                     : " Without its standard deviations its displacements are "
                                       "taken in place of those of the structure.")});
  }
}

}  // namespace

std::vector<std::size_t> loss_outliers(const CalibrationResult& result) {
  const double typical = typical_residual(result);
  const auto is_judged = [](const CalibratedLevel& level) {
    return level.found && std::isfinite(level.residual);
  };
  const auto count = static_cast<double>(std::ranges::count_if(result.levels, is_judged));
  std::vector<std::size_t> outliers;
  if (std::isnan(typical)) return outliers;
  const double most = boost::math::quantile(boost::math::normal(), 1.0 - 0.5 * kByChance / count);
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const CalibratedLevel& level = result.levels[i];
    if (is_judged(level) && std::abs(level.residual) > most * typical) outliers.push_back(i);
  }
  return outliers;
}

std::vector<Warning> diagnose(const CalibrationResult& result, const ModalLevels& levels,
                              const std::vector<std::string>& names) {
  const LevelNames named(names);
  std::vector<Warning> warnings;
  warn_of_missing(result, named, warnings);
  warn_of_pairs(result, warnings);
  warn_of_groups(result, warnings);
  warn_of_unseen(result, warnings);
  warn_of_wide_bands(result, named, warnings);
  warn_of_offsets(result, warnings);
  warn_of_unlike_offsets(result, warnings);
  warn_of_frequencies(result, warnings);
  warn_of_scatter(result, named, warnings);
  warn_of_outliers(result, named, warnings);
  warn_of_std(result, levels, warnings);
  warn_of_sensors(result, levels, named, warnings);
  return warnings;
}

}  // namespace microslip
