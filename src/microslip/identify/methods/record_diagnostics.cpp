// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/percent.hpp"
#include "microslip/identify/methods/diagnostics.hpp"

namespace microslip {
namespace {

/// A loss less than so many of its standard deviations above 0 may as well be none: the estimate of
/// a zero loss is 2 of them, as it cannot be negative.
constexpr double kLeastLossRatio = 3.0;

/// Description of a departure, and its remedy.
struct DepartureText {
  std::string_view what;
  std::string_view remedy;
};

DepartureText text_of(RecordDeparture departure) {
  switch (departure) {
    case RecordDeparture::kRate:
      return {"follows the velocity",
              "`viscous fit` identifies a viscous part beside the friction; a slower test has less "
              "of it."};
    case RecordDeparture::kAsymmetry:
      return {"differs between the two directions",
              "Look for a contact that opens, or an eccentric load; no symmetric joint has such "
              "loops."};
    case RecordDeparture::kDeadZone:
      return {
          "is missing about zero or stiffens where a contact closes: backlash, pinching or "
          "bearing",
          "Take up the play, or measure the displacement behind it."};
    case RecordDeparture::kDrift:
      return {"grows or falls over the record: wear, temperature or a changing load",
              "Identify its parts separately, or run the joint in first."};
    case RecordDeparture::kOffset:
      return {
          "has a drifting zero",
          "`drift fit` finds the drift with the joint; balance the force sensor, or take a shorter "
          "part of the record."};
    case RecordDeparture::kDisplacementDrift:
      return {"is as of a displacement whose zero drifts",
              "`drift fit` finds the drift beside the joint; take a shorter part of the record, or "
              "let the sensor warm up."};
    case RecordDeparture::kOther:
      return {"deviates from the joint of the other records",
              "Compare units, gains and channels of the files, or identify from each separately."};
    case RecordDeparture::kRange:
      break;
  }
  return {
      "has branches that do not follow one curve: unloading is not twice the first loading, or "
      "the shape changes with the amplitude",
      "Identify from motions of one amplitude separately."};
}

Warning contradiction(const std::string& name, std::string_view what, const LevelVerdict& verdict) {
  return {what == "D" ? "levels_contradict" : "secant_differs",
          fmt::format(
              "{}: its {} deviates from that of the joint of the other files by {}, where noise "
              "would give {}: another joint, load or gain. Identify from each separately.",
              name, what, percent_text(verdict.share), percent_text(verdict.noise))};
}

/// D of each draw at the largest displacement a: 4∫x*(a − x*)ψ dx*, by Simpson's rule, exact
/// for a straight ψ.
std::vector<double> losses_of_draws(const RecordInversionResult& result) {
  const std::vector<double>& x = result.slip_displacement;
  const double a = x.back();
  std::vector<double> losses;
  for (const StiffnessDraw& draw : result.draws) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const double middle = 0.5 * (x[i] + x[i + 1]);
      const double psi = 0.5 * (draw.density[i] + draw.density[i + 1]);
      sum += (x[i + 1] - x[i]) / 6.0 *
             (x[i] * (a - x[i]) * draw.density[i] + 4.0 * middle * (a - middle) * psi +
              x[i + 1] * (a - x[i + 1]) * draw.density[i + 1]);
    }
    losses.push_back(4.0 * sum);
  }
  return losses;
}

/// Forces of a spring contain no friction: the friction found is what cannot be ruled out.
void warn_of_no_slip(const RecordInversionResult& result, std::vector<Warning>& warnings) {
  const std::vector<double> losses = losses_of_draws(result);
  if (losses.size() < 2) return;
  const auto n = static_cast<double>(losses.size());
  const double mean = std::accumulate(losses.begin(), losses.end(), 0.0) / n;
  double square = 0.0;
  for (const double loss : losses) square += (loss - mean) * (loss - mean);
  const double deviation = std::sqrt(square / n);
  if (mean >= kLeastLossRatio * deviation && mean > 0.0) return;
  warnings.push_back(
      {"no_slip",
       fmt::format("the force is that of a spring: the loss is not distinguishable from 0, {:.3g} "
                   "J at the largest displacement with a standard deviation of {:.3g} J. Only the "
                   "upper end of the density's band is informative. Test at larger displacements.",
                   mean, deviation)});
}

}  // namespace

std::vector<Warning> diagnose(const RecordInversionResult& result, const JointEvidence& evidence) {
  std::vector<Warning> warnings;
  for (std::size_t r = 0; r < result.records.size(); ++r) {
    for (const RecordVerdict& verdict : result.records[r].verdicts) {
      if (!verdict.broken) continue;
      const DepartureText text = text_of(verdict.departure);
      const std::string which =
          result.records.size() > 1 ? evidence.name_of_record(r) + ": " : std::string();
      const std::string what =
          fmt::format("{} of the force {}, where noise would give {}", percent_text(verdict.share),
                      text.what, percent_text(verdict.noise));
      warnings.push_back(
          {std::string(to_string(verdict.departure)),
           verdict.alternative
               ? fmt::format("{}or, as the record shows no difference to the above: {}. {}", which,
                             what, text.remedy)
               : fmt::format("{}not a Masing joint under constant normal load: {}. {}", which, what,
                             text.remedy)});
    }
  }
  warn_of_no_slip(result, warnings);
  for (std::size_t t = 0; t < result.levels.size(); ++t) {
    const LevelFit& fit = result.levels[t];
    const std::string name = evidence.name_of_levels(t);
    if (fit.dissipation_verdict && fit.dissipation_verdict->broken) {
      warnings.push_back(contradiction(name, "D", *fit.dissipation_verdict));
    }
    if (fit.secant_verdict && fit.secant_verdict->broken) {
      warnings.push_back(contradiction(name, "k_eq", *fit.secant_verdict));
    }
  }
  return warnings;
}

}  // namespace microslip
