// SPDX-License-Identifier: MIT
// Fig. 3: a power-law density does not make the dissipation a power of the force. [AR14 (5) (6)]
#include <algorithm>
#include <cmath>
#include <limits>

#include "curves.hpp"
#include "figures.hpp"
#include "microslip/joint/dissipation.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::Joint;

constexpr double kStiffness = 1000.0;  // N/m
constexpr double kLargest = 25.0;      // N

/// φ = 0.1 f*^−½ on 0 … 25 N: area 1, f_y = 25/3 N.
Joint power_law() {
  return Joint(kStiffness,
               microslip::SlipDensity({microslip::PowerLawPart{
                   .coefficient = 0.1, .exponent = -0.5, .from = 0.0, .to = kLargest}}));
}

struct Curve {
  std::vector<double> amplitude;  // m
  std::vector<double> force;      // N
  std::vector<double> loss;       // J
  std::vector<double> slope;      // 1
};

/// d ln D/d ln f = (A D′/D)/(A F′/F) at f = F(A).
Curve curve_of(const Joint& joint, const std::vector<double>& amplitudes) {
  Curve curve{.amplitude = amplitudes, .force = {}, .loss = {}, .slope = {}};
  for (const double a : amplitudes) {
    curve.force.push_back(joint.virgin_force(a));
    curve.loss.push_back(microslip::dissipation(joint, a));
    curve.slope.push_back(microslip::dissipation_slope(joint, a) / curve.loss.back() *
                          curve.force.back() / joint.tangent_stiffness(a));
  }
  return curve;
}

/// In closed form, with s = √(kA): 2.5(1 − (2/15)s)/(1 − s/5).
double exact_slope(double amplitude) {
  const double s = std::sqrt(kStiffness * amplitude);
  return 2.5 * (1.0 - 2.0 / 15.0 * s) / (1.0 - s / 5.0);
}

double largest_error(const Curve& curve) {
  double largest = 0.0;
  for (std::size_t i = 0; i < curve.slope.size(); ++i) {
    largest = std::max(largest, std::abs(curve.slope[i] / exact_slope(curve.amplitude[i]) - 1.0));
  }
  return largest;
}

double slope_at(const Joint& joint, double amplitude) {
  return curve_of(joint, {amplitude}).slope.front();
}

/// The force over f_y where the slope passes 3, the largest that (5) with χ ≤ 0 allows; by
/// bisection.
double share_at_slope_three(const Joint& joint) {
  double below = 0.0;
  double above = joint.macroslip_displacement();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (slope_at(joint, middle) < 3.0 ? below : above) = middle;
  }
  return joint.virgin_force(below) / joint.macroslip_force();
}

microslip::FigureGrid picture_of(const Joint& joint, const Curve& curve) {
  microslip::Figure loss;
  loss.title = "Dissipation";
  loss.x = {.label = "force amplitude f", .unit = "N", .log = true};
  loss.y = {.label = "dissipation per cycle D", .unit = "J", .log = true};
  std::vector<double> power(curve.force.size());
  std::ranges::transform(curve.force, power.begin(), [&](double f) {
    return curve.loss.front() * std::pow(f / curve.force.front(), 2.5);
  });
  loss.layers.emplace_back(microslip::LineLayer{
      curve.force,
      power,
      "ν f^2.5 of small forces, (5)",
      {.colour = microslip::kVermillion, .style = microslip::LineStyle::kDashed}});
  loss.layers.emplace_back(
      microslip::LineLayer{curve.force, curve.loss, "D of φ = 0.1 f*^−0.5, (7)"});

  microslip::Figure slope;
  slope.title = "Slope of log D over log f";
  slope.x = {.label = "force amplitude over macro-slip force f/f_y", .unit = "1", .log = true};
  slope.y = {.label = "slope", .unit = "1", .range = microslip::AxisRange{2.0, 6.0}};
  const std::vector<double> share = scaled(curve.force, joint.macroslip_force());
  slope.layers.emplace_back(microslip::LineLayer{
      {share.front(), share.back()},
      {2.5, 2.5},
      "3 + χ = 2.5, (5)",
      {.colour = microslip::kVermillion, .style = microslip::LineStyle::kDashed}});
  slope.layers.emplace_back(
      microslip::LineLayer{{share.front(), share.back()},
                           {3.0, 3.0},
                           "3, the largest of (5)",
                           {.colour = microslip::kGrey, .style = microslip::LineStyle::kDotted}});
  slope.layers.emplace_back(microslip::LineLayer{share, curve.slope, "slope of D"});
  return {"A power-law density does not dissipate by a power of the force", 2, {loss, slope}};
}

}  // namespace

Reproduction figure_03(const Grid& grid) {
  const Joint joint = power_law();
  const double macroslip = joint.macroslip_displacement();
  const Curve curve =
      curve_of(joint, equal_ratios(1e-8, 0.9999 * macroslip, grid.pick<std::size_t>(400, 60)));

  Reproduction made{.name = "fig_03",
                    .title = "Slope of log D over log f for φ = 0.1 f*^−0.5",
                    .picture = picture_of(joint, curve)};
  made.size = {.width = 1100, .height = 460};
  microslip::CsvWriter table;
  table.add_numbers("amplitude", microslip::kLength, curve.amplitude);
  table.add_numbers("force", microslip::kForce, curve.force);
  table.add_numbers("dissipation", microslip::kEnergy, curve.loss);
  table.add_numbers("slope", microslip::kDimensionless, curve.slope);
  made.tables.emplace_back("", table);

  // At the lowest amplitude s = 3.2e-3, so that the slope is 2.5(1 + s/15).
  made.findings.push_back({"slope at the smallest force [1]", "3 + χ = 2.5, for small forces only",
                           curve.slope.front(), 2.5, 2.501});
  // s = 1.875: F = 2.63671875 N.
  made.findings.push_back({"f/f_y at which the slope passes 3, the largest of (5) with χ ≤ 0 [1]",
                           "0.3164 by the closed form; (5) does not hold beyond",
                           share_at_slope_three(joint), 0.316406, 0.316407});
  made.findings.push_back({"slope at 0.9999 of the macro-slip amplitude [1]",
                           "grows without bound towards macro-slip", curve.slope.back(), 100.0,
                           std::numeric_limits<double>::max()});
  // D, D′, F and F′ are closed forms; towards macro-slip 1 − s/5 amplifies the rounding.
  made.findings.push_back(
      {"slope against 2.5(1 − (2/15)s)/(1 − s/5), s = √(kA), largest relative difference [1]",
       "closed form", largest_error(curve), 0.0, 1e-9});
  return made;
}

}  // namespace ahmadian_rajaei
