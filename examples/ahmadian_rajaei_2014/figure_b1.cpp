// SPDX-License-Identifier: MIT
// Fig. B1: under a normal load that varies, (4) gives a density that is negative. [AR14 App. B]
#include <algorithm>
#include <cmath>

#include "curves.hpp"
#include "figures.hpp"
#include "microslip/joint/jenkins_network.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::JenkinsNetwork;
using microslip::NetworkMemory;
using microslip::NormalLoadLaw;

// φ = 0.2 on [0, 5] N, k = 1 N/m, as 200 elements; x = 10 sin 2πt, p = 1 + 0.9 sin² 2πt.
constexpr int kElements = 200;
constexpr double kAmplitude = 10.0;     // m
constexpr double kStiffness = 1.0;      // N/m
constexpr double kDensity = 0.2;        // 1/N
constexpr double kLargest = 5.0;        // N
constexpr std::size_t kIntervals = 40;  // of the return branch, for second differences

JenkinsNetwork network() {
  std::vector<microslip::JenkinsElement> elements;
  for (int i = 1; i <= kElements; ++i) {
    elements.push_back({kStiffness / kElements, kLargest * i / (kElements * kElements)});
  }
  return JenkinsNetwork(elements);
}

double varying_load(double x) { return 1.0 + 0.9 * std::pow(x / kAmplitude, 2); }
double constant_load(double /*x*/) { return 1.0; }

/// The steady loop from x = A down and up again in equal steps, its first point again at the end.
Loop loop_under(double (*load)(double), NormalLoadLaw law, std::size_t steps_a_branch) {
  const JenkinsNetwork elements = network();
  NetworkMemory memory(elements, law);
  std::vector<double> x = equal_steps(kAmplitude, -kAmplitude, steps_a_branch + 1);
  x.insert(x.end(), x.rbegin() + 1, x.rend());
  for (const double at : equal_steps(0.0, kAmplitude, steps_a_branch)) memory.advance(at, load(at));
  Loop loop{x, std::vector<double>(x.size())};
  for (int cycle = 0; cycle < 2; ++cycle) {  // the second is steady
    for (std::size_t i = 0; i < x.size(); ++i) loop.force[i] = memory.advance(x[i], load(x[i]));
  }
  return loop;
}

struct BranchDensity {
  std::vector<double> slip_force;  // N
  std::vector<double> density;     // 1/N
};

/// φ from (4) on the return branch from A, as if the load were constant: by (3) the branch is
/// F(y) = (f(A) − f(A − 2y))/2, and φ(ky) = −F″(y)/k², by second differences.
BranchDensity density_of(const Loop& loop, std::size_t steps_a_branch) {
  const std::size_t stride = steps_a_branch / kIntervals;
  const double h = kAmplitude / static_cast<double>(kIntervals);
  const auto virgin = [&](std::size_t i) { return 0.5 * (loop.force[0] - loop.force[i * stride]); };
  BranchDensity found;
  for (std::size_t j = 1; j < kIntervals; ++j) {
    found.slip_force.push_back(kStiffness * h * static_cast<double>(j));
    found.density.push_back(-(virgin(j + 1) - 2.0 * virgin(j) + virgin(j - 1)) /
                            (h * h * kStiffness * kStiffness));
  }
  return found;
}

struct Case {
  const char* name;
  double (*load)(double);
  NormalLoadLaw law;
  microslip::Stroke stroke;
};

const Case kCases[] = {
    {"constant load",
     constant_load,
     NormalLoadLaw::kIncremental,
     {.colour = microslip::kBlack, .style = microslip::LineStyle::kDashed, .width = 1.4}},
    {"varying load, incremental law",
     varying_load,
     NormalLoadLaw::kIncremental,
     {.colour = microslip::kBlue}},
    {"varying load, total law",
     varying_load,
     NormalLoadLaw::kTotal,
     {.colour = microslip::kVermillion, .style = microslip::LineStyle::kDashed}},
};

microslip::Figure loops_figure() {
  microslip::Figure figure;
  figure.title = "Loops under p = 1 + 0.9 sin² 2πt";
  figure.x = {.label = "displacement x", .unit = "m"};
  figure.y = {.label = "force f", .unit = "N"};
  return figure;
}

microslip::Figure densities_figure() {
  microslip::Figure figure;
  figure.title = "Density from the return branch, p neglected";
  figure.x = {.label = "slip force f*", .unit = "N"};
  figure.y = {.label = "density φ", .unit = "1/N"};
  // From right to left: with AVX-512, GCC 12.2 writes constants {a, a, 0, 0} as {a, a, a, a}.
  figure.layers.emplace_back(microslip::LineLayer{{kAmplitude, kLargest, kLargest, 0.0},
                                                  {0.0, 0.0, kDensity, kDensity},
                                                  "true density",
                                                  {.colour = microslip::kGrey, .width = 3.0}});
  return figure;
}

}  // namespace

Reproduction figure_b1(const Grid& grid) {
  const auto steps = grid.pick<std::size_t>(4000, 1000);
  microslip::Figure loops = loops_figure();
  microslip::Figure densities = densities_figure();
  CurveTable loop_table({{"displacement", microslip::kLength}, {"force", microslip::kForce}});
  CurveTable density_table({{"slip_force", microslip::kForce}, {"density", microslip::kPerForce}});
  std::vector<double> lowest;
  std::vector<double> last;
  for (const Case& one : kCases) {
    const Loop loop = loop_under(one.load, one.law, steps);
    const BranchDensity found = density_of(loop, steps);
    loop_table.add(one.name, {loop.displacement, loop.force});
    density_table.add(one.name, {found.slip_force, found.density});
    loops.layers.emplace_back(
        microslip::LineLayer{loop.displacement, loop.force, one.name, one.stroke});
    densities.layers.emplace_back(
        microslip::LineLayer{found.slip_force, found.density, one.name, one.stroke});
    lowest.push_back(std::ranges::min(found.density));
    last.push_back(found.density.back());
  }

  Reproduction made{.name = "fig_B1",
                    .title = "Varying normal load, and the density when it is neglected",
                    .picture = microslip::FigureGrid{
                        "A normal load that varies: negative density", 2, {loops, densities}}};
  made.size = {.width = 1100, .height = 480};
  made.tables.emplace_back("", loop_table.table());
  made.tables.emplace_back("_density", density_table.table());
  // Differences of forces of 2.5 N, exact to 1e-14 N, over h² = 1/16 m².
  made.findings.push_back({"least density at constant load [1/N]",
                           "the constant load of (4): not negative", lowest[0], -1e-11, kDensity});
  made.findings.push_back(
      {"least density, incremental law [1/N]", "negative", lowest[1], -1.0, -0.09});
  made.findings.push_back({"least density, total law [1/N]", "negative", lowest[2], -1.0, -0.09});
  // Once all slips f = −2.5125 p(x), whose second derivative gives −2·2.5125·0.018.
  made.findings.push_back({"density at 9.75 N, all slipping, incremental law [1/N]",
                           "−0.09045, by f = −p Σf_i", last[1], -0.0904501, -0.0904499});
  return made;
}

}  // namespace ahmadian_rajaei
