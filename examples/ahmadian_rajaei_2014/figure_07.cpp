// SPDX-License-Identifier: MIT
// Fig. 7: the force at the exciter before and after the control of its harmonics: drawn as it is,
// in numbers as it is recorded.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <utility>

#include "curves.hpp"
#include "figures.hpp"
#include "microslip/report/figures/rig_figures.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::VirtualLevel;

constexpr std::size_t kHarmonics = 10;
constexpr double kAsked = 0.01;  // |F_n|/|F_1| [AR14]
constexpr std::uint64_t kSeed = 2;

/// The force in a record.
struct RecordedForce {
  std::vector<double> time;      // two cycles, from a peak of the acceleration at the exciter, s
  std::vector<double> force;     // N
  std::vector<double> harmonic;  // |F_n|/|F_1|, n = 1 …, 1
};

RecordedForce recorded_force(const Experiment& experiment, const microslip::DrivenVibration& driven,
                             std::uint64_t record) {
  const microslip::Rig& rig = experiment.reducer.rig();
  const microslip::Recording recording =
      microslip::virtual_record(rig, experiment.state, driven, kSeed, record);
  const std::span<const double> signals[] = {
      recording.signal(rig.excitation.channel, microslip::kForce),
      recording.signal(rig.accelerometers.front().channel, microslip::kAcceleration)};
  const microslip::FourierFit fit =
      microslip::fit_fourier(recording.axis, signals, experiment.reducer.options().fit);
  const microslip::FourierSeries& force = fit.series[0];
  RecordedForce found;
  for (std::size_t n = 1; n <= kHarmonics; ++n) {
    found.harmonic.push_back(std::abs(force.c(n)) / std::abs(force.c(1)));
  }
  const double phase = std::arg(fit.series[1].c(1));
  const double peak = (phase > 0.0 ? 2.0 * std::numbers::pi - phase : -phase) / fit.omega;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double time = recording.axis.at(i) - peak;
    if (time < 0.0 || time > 2.0 * force.period()) continue;
    found.time.push_back(time);
    found.force.push_back(signals[0][i]);
  }
  return found;
}

/// The largest |F_n|/|F_1|, n from 2, of all levels.
double largest_distortion(const Experiment& experiment) {
  double largest = 0.0;
  for (const VirtualLevel& level : experiment.test.levels) {
    largest = std::max(largest, microslip::force_distortion(level.controlled, kHarmonics));
  }
  return largest;
}

}  // namespace

Reproduction figure_07(const Experiment& experiment) {
  const VirtualLevel& highest = experiment.test.levels.back();
  const RecordedForce before = recorded_force(experiment, highest.uncontrolled, 0);
  const RecordedForce after = recorded_force(experiment, highest.controlled, 1);
  microslip::FigureGrid picture =
      microslip::force_control_figure(experiment.test.levels, kHarmonics, {.response_unit = "g"});
  picture.title = "Control of the force";
  Reproduction made{.name = "fig_07",
                    .title = "Force before and after the control of its harmonics",
                    .picture = std::move(picture)};
  made.size = {.width = 1500, .height = 480};
  CurveTable histories({{"time", microslip::kTime}, {"force", microslip::kForce}});
  histories.add("before control", {before.time, before.force});
  histories.add("after", {after.time, after.force});
  made.tables.emplace_back("", histories.table());
  microslip::CsvWriter harmonics;
  harmonics.add_numbers("harmonic", microslip::kDimensionless,
                        equal_steps(1.0, kHarmonics, kHarmonics));
  harmonics.add_numbers("before_over_first", microslip::kDimensionless, before.harmonic);
  harmonics.add_numbers("after_over_first", microslip::kDimensionless, after.harmonic);
  made.tables.emplace_back("_harmonics", harmonics);

  const auto largest = [](const RecordedForce& recorded) {
    return *std::max_element(recorded.harmonic.begin() + 1, recorded.harmonic.end());
  };
  // The shaker of the virtual test is our own; that its force needs control is all that is asked.
  made.findings.push_back(
      {"largest harmonic of the force over the first, highest level, before "
       "control [1]",
       "the shaker feeds harmonics into the force (no number)", largest(before), kAsked, 1.0});
  made.findings.push_back({"largest harmonic after control, highest level [1]",
                           "controlled to 0.01", largest(after), 0.0, kAsked});
  made.findings.push_back({"largest harmonic after control, all levels [1]", "controlled to 0.01",
                           largest_distortion(experiment), 0.0, kAsked});
  return made;
}

}  // namespace ahmadian_rajaei
