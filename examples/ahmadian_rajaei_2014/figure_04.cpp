// SPDX-License-Identifier: MIT
// Fig. 4: frequency responses at constant response amplitude. At constant response the structure is
// equivalent to a linear one; its peak falls with the amplitude, its damping rises and falls again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "curves.hpp"
#include "figures.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::HarmonicBalance;
using microslip::Joint;
using microslip::ResponseCurve;
using microslip::SteadyVibration;
using std::numbers::pi;

// A mass on a spring, a damper and Segalman's joint: numbers of our own.
constexpr double kMass = 1.0;       // kg
constexpr double kSpring = 0.75;    // N/m
constexpr double kDamper = 0.005;   // N s/m
constexpr double kJoint = 0.25;     // N/m
constexpr double kMacroslip = 0.2;  // N

Joint joint() { return Joint::four_parameter(kMacroslip, kJoint, -0.5, 0.0); }

microslip::JointedStructure structure() {
  const double omega = std::sqrt(kSpring / kMass);
  microslip::ModalModel linear({{omega, kDamper / (kMass * omega)}},
                               {{"mass", {1.0 / std::sqrt(kMass)}}});
  return microslip::JointedStructure(std::move(linear),
                                     {{"joint", joint(), {1.0 / std::sqrt(kMass)}}}, {{"mass"}});
}

double receptance(const SteadyVibration& at) { return at.response / at.force_amplitude; }

/// ω where the receptance passes 1/√2 of its peak, between the two points beside it; 1/|H|² is a
/// parabola in ω² of an equivalent linear structure, close to straight in ω between them.
double half_power(const SteadyVibration& a, const SteadyVibration& b, double peak) {
  const auto ordinate = [&](const SteadyVibration& at) {
    return std::pow(peak / receptance(at), 2) - 2.0;
  };
  const double share = ordinate(a) / (ordinate(a) - ordinate(b));
  return a.angular_frequency + share * (b.angular_frequency - a.angular_frequency);
}

struct PeakOf {
  double omega = 0.0;       // rad/s
  double receptance = 0.0;  // m/N
  double damping = 0.0;     // damping ratio by the half-power width, 1
};

PeakOf peak_of(const ResponseCurve& curve) {
  const SteadyVibration& top = *std::ranges::max_element(curve.peaks, {}, receptance);
  PeakOf peak{.omega = top.angular_frequency, .receptance = receptance(top), .damping = 0.0};
  const double half = peak.receptance / std::numbers::sqrt2;
  std::vector<double> edges;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const SteadyVibration& a = curve.points[i - 1];
    const SteadyVibration& b = curve.points[i];
    if ((receptance(a) < half) != (receptance(b) < half)) {
      edges.push_back(half_power(a, b, peak.receptance));
    }
  }
  peak.damping = (edges.back() - edges.front()) / (2.0 * peak.omega);
  return peak;
}

/// ζ of the equivalent linear structure at resonance, (πcωX² + D)/(2πkX²), k the secant stiffness
/// of spring and joint.
double equivalent_damping(double amplitude) {
  const double stiffness = kSpring + microslip::secant_stiffness(joint(), amplitude);
  const double omega = std::sqrt(stiffness / kMass);
  const double loss =
      pi * kDamper * omega * amplitude * amplitude + microslip::dissipation(joint(), amplitude);
  return loss / (2.0 * pi * stiffness * amplitude * amplitude);
}

struct Sweep {
  std::vector<double> amplitude;  // m
  std::vector<PeakOf> peaks;
  std::vector<ResponseCurve> curves;
};

Sweep sweep(const Grid& grid) {
  const HarmonicBalance balance(
      structure(), {"mass"},
      {.harmonics = 3, .samples = 512, .least_points = grid.pick(500, 120), .accuracy = 0.0});
  Sweep made;
  made.amplitude = grid.reduced ? std::vector{0.05, 0.4, 2.0, 3.2, 8.0, 20.0}
                                : std::vector{0.05, 0.15, 0.4, 1.0, 2.0, 3.2, 8.0, 20.0};
  for (const double amplitude : made.amplitude) {
    made.curves.push_back(balance.constant_response(amplitude, 0.8, 1.05));
    const microslip::Summary& summary = made.curves.back().summary;
    if (!summary.converged()) throw microslip::Error(summary.full());
    made.peaks.push_back(peak_of(made.curves.back()));
  }
  return made;
}

std::vector<double> in_hertz(const std::vector<PeakOf>& peaks) {
  std::vector<double> values;
  for (const PeakOf& peak : peaks) values.push_back(peak.omega / (2.0 * pi));
  return values;
}

std::vector<double> damping_of(const std::vector<PeakOf>& peaks) {
  std::vector<double> values;
  for (const PeakOf& peak : peaks) values.push_back(peak.damping);
  return values;
}

microslip::FigureGrid picture_of(const Sweep& sweep) {
  microslip::Figure responses;
  responses.title = "Receptance at constant displacement X";
  responses.x = {.label = "frequency", .unit = "Hz"};
  responses.y = {.label = "receptance X/F", .unit = "m/N", .log = true};
  for (std::size_t i = 0; i < sweep.curves.size(); ++i) {
    microslip::LineLayer line;
    for (const SteadyVibration& point : sweep.curves[i].points) {
      line.x.push_back(point.frequency());
      line.y.push_back(receptance(point));
    }
    line.legend = fmt::format("X = {:g} m", sweep.amplitude[i]);
    line.stroke = {.colour = static_cast<int>(i), .width = 1.5};
    responses.layers.emplace_back(line);
  }
  microslip::Figure damping;
  damping.title = "Their half-power damping";
  damping.x = {.label = "displacement amplitude X", .unit = "m", .log = true};
  damping.y = {.label = "damping ratio ζ", .unit = "%"};
  const std::vector<double> fine =
      equal_ratios(sweep.amplitude.front(), sweep.amplitude.back(), 200);
  std::vector<double> expected(fine.size());
  std::ranges::transform(fine, expected.begin(), equivalent_damping);
  damping.layers.emplace_back(microslip::LineLayer{fine,
                                                   scaled(expected, 0.01),
                                                   "(πcωX² + D)/(2π kX²), k the secant stiffness",
                                                   {.colour = microslip::kBlack}});
  damping.layers.emplace_back(microslip::PointLayer{.x = sweep.amplitude,
                                                    .y = scaled(damping_of(sweep.peaks), 0.01),
                                                    .legend = "half-power width"});
  return {"One degree of freedom with an Iwan joint at constant response", 2, {responses, damping}};
}

microslip::CsvWriter curves_table(const Sweep& sweep) {
  CurveTable table({{"frequency", microslip::kFrequency},
                    {"displacement", microslip::kLength},
                    {"force", microslip::kForce}});
  for (std::size_t i = 0; i < sweep.curves.size(); ++i) {
    std::vector<std::vector<double>> columns(3);
    for (const SteadyVibration& point : sweep.curves[i].points) {
      columns[0].push_back(point.frequency());
      columns[1].push_back(point.response);
      columns[2].push_back(point.force_amplitude);
    }
    table.add(fmt::format("X = {:g} m", sweep.amplitude[i]), columns);
  }
  return table.table();
}

microslip::CsvWriter peaks_table(const Sweep& sweep) {
  microslip::CsvWriter table;
  table.add_numbers("displacement", microslip::kLength, sweep.amplitude);
  table.add_numbers("frequency", microslip::kFrequency, in_hertz(sweep.peaks));
  table.add_numbers("damping_ratio", microslip::kDimensionless, damping_of(sweep.peaks));
  return table;
}

/// The largest change of the peak frequency from one amplitude to the next, Hz.
double largest_rise(const std::vector<double>& frequency) {
  double largest = -1.0;
  for (std::size_t i = 1; i < frequency.size(); ++i) {
    largest = std::max(largest, frequency[i] - frequency[i - 1]);
  }
  return largest;
}

}  // namespace

Reproduction figure_04(const Grid& grid) {
  const Sweep swept = sweep(grid);
  const std::vector<double> frequency = in_hertz(swept.peaks);
  const std::vector<double> damping = damping_of(swept.peaks);
  Reproduction made{.name = "fig_04",
                    .title = "Frequency responses at constant response amplitude",
                    .picture = picture_of(swept)};
  made.size = {.width = 1100, .height = 520};
  made.tables.emplace_back("", curves_table(swept));
  made.tables.emplace_back("_peaks", peaks_table(swept));

  double error = 0.0;
  for (std::size_t i = 0; i < damping.size(); ++i) {
    error = std::max(error, std::abs(damping[i] / equivalent_damping(swept.amplitude[i]) - 1.0));
  }
  made.findings.push_back(
      {"largest change of the peak frequency from one amplitude to the next [Hz]",
       "the peak frequency falls", largest_rise(frequency), -1.0, 0.0});
  const double highest = std::ranges::max(damping);
  made.findings.push_back({"largest damping over that at the smallest amplitude [1]",
                           "the damping rises", highest / damping.front(), 2.0, 100.0});
  made.findings.push_back({"damping at the largest amplitude over the largest damping [1]",
                           "and then falls towards macro-slip", damping.back() / highest, 0.0,
                           0.5});
  // The half-power width of a damping ζ is 2ζ to the order ζ², here 1e-3, and the curve has points
  // at finite distances.
  made.findings.push_back(
      {"half-power damping against that of D and k_eq, largest relative difference [1]",
       "equivalent to a linear structure at each response", error, 0.0, grid.pick(0.01, 0.03)});
  return made;
}

}  // namespace ahmadian_rajaei
