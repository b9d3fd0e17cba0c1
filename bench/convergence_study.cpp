// SPDX-License-Identifier: MIT
//
// The tables and the picture of docs/validation.md on the harmonic balance: how fast it converges
// in the harmonics and in the samples, and how near it comes to reference values.
//
//     convergence_study PICTURE.svg > convergence.md
//
// Each table stands between marks as in docs/validation.md. scripts/update_validation puts them
// there.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/report/drawing/gnuplot.hpp"
#include "support/reference_csv.hpp"
#include "support/structures.hpp"

namespace microslip::bench {
namespace {

constexpr std::size_t kFixedHarmonics = 9;
constexpr std::size_t kFixedSamples = 4096;
constexpr double kNotThere = -1.0;

/// A structure at phase resonance with a given response.
struct Case {
  std::string name;
  JointedStructure structure;
  ResponsePoint response;
  double level;
  std::size_t exact_harmonics;
  std::vector<std::string> quantities;
};

std::vector<Case> cases() {
  const std::vector<std::string> odd{"frequency", "force", "D", "harmonic 3"};
  const std::vector<std::string> all{"frequency", "force", "D", "harmonic 2", "harmonic 3"};
  return {{"Iwan mass", testing::one_mass(testing::iwan_joint()), {"mass"}, 2.06, 151, odd},
          {"Jenkins mass", testing::one_mass(testing::jenkins_joint()), {"mass"}, 1.224, 151, odd},
          {"Friction rig at 4 g",
           testing::friction_rig(),
           {"force", ResponseKind::kAcceleration},
           39.24,
           63,
           all}};
}

/// The quantities of a case with H harmonics and N samples.
std::vector<double> quantities(const Case& study, std::size_t harmonics, std::size_t samples) {
  const HarmonicBalance balance(study.structure, study.response,
                                {.harmonics = harmonics, .samples = samples});
  const VibrationResult result = balance.solve(kPhaseResonance, {Quantity::kResponse, study.level});
  if (!result.summary.converged()) throw std::runtime_error(result.summary.full());
  const SteadyVibration& v = result.vibration;
  const auto response = v.acceleration(study.structure.linear(), study.response.point);
  std::vector<double> values{v.angular_frequency, v.force_amplitude, v.joints[0].dissipation};
  for (std::size_t n = study.quantities.size() == 5 ? 2 : 3; n <= 3; ++n) {
    values.push_back(n <= harmonics ? std::abs(response[n]) : kNotThere);
  }
  return values;
}

/// Errors over H or N: [quantity][row].
struct Study {
  std::vector<double> steps;
  std::vector<std::vector<double>> errors;
};

Study over(const Case& study, const std::vector<std::size_t>& steps, bool harmonics) {
  const std::vector<double> exact = harmonics
                                        ? quantities(study, study.exact_harmonics, kFixedSamples)
                                        : quantities(study, kFixedHarmonics, 1U << 16U);
  Study result{{}, std::vector<std::vector<double>>(exact.size())};
  for (const std::size_t step : steps) {
    const std::vector<double> values = harmonics ? quantities(study, step, kFixedSamples)
                                                 : quantities(study, kFixedHarmonics, step);
    result.steps.push_back(static_cast<double>(step));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const bool there = values[i] != kNotThere;
      result.errors[i].push_back(there ? std::abs(values[i] / exact[i] - 1.0) : kNotThere);
    }
  }
  return result;
}

/// −d ln error/d ln step by least squares from H = 5 on, rounding left out.
double order(const std::vector<double>& steps, const std::vector<double>& errors) {
  constexpr double kRounding = 1e-12;
  double n = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] < 4.9 || errors[i] < kRounding) continue;
    const double x = std::log(steps[i]);
    const double y = std::log(errors[i]);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return -(n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// A table with the marks of docs/validation.md around it.
class Block {
 public:
  explicit Block(const std::string& name) { fmt::print("<!-- validation: {} -->\n", name); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  ~Block() { fmt::print("<!-- end validation -->\n"); }
};

void print_study(const Case& study, const Study& result, const char* symbol) {
  const Block block(fmt::format("{} over {}", study.name, symbol));
  std::string head = fmt::format("| {} |", symbol);
  std::string rule = "|---|";
  for (const std::string& quantity : study.quantities) {
    head += fmt::format(" {} |", quantity);
    rule += "---|";
  }
  fmt::print("{}\n{}\n", head, rule);
  for (std::size_t row = 0; row < result.steps.size(); ++row) {
    fmt::print("| {} |", result.steps[row]);
    for (const auto& errors : result.errors) {
      fmt::print(" {} |", errors[row] == kNotThere ? "–" : fmt::format("{:.1e}", errors[row]));
    }
    fmt::print("\n");
  }
  fmt::print("| order |");
  for (const auto& errors : result.errors) fmt::print(" {:.1f} |", order(result.steps, errors));
  fmt::print("\n");
}

Figure figure(const Case& study, const Study& result, bool harmonics) {
  Figure figure;
  figure.title = study.name;
  figure.x = {.label = harmonics ? "harmonics H" : "samples of a cycle N", .log = true};
  figure.x.range = harmonics ? AxisRange{0.9, 35.0} : AxisRange{25.0, 5200.0};
  figure.y = {.label = "relative error", .log = true, .range = AxisRange{1e-13, 1.0}};
  const std::vector<std::string> known{"frequency", "D", "harmonic 3", "harmonic 2"};
  for (std::size_t i = 0; i < result.errors.size(); ++i) {
    const std::string& name = study.quantities[i];
    if (name == "force") continue;  // lies on D
    const auto colour = static_cast<int>(std::ranges::find(known, name) - known.begin());
    LineLayer line{.x = {}, .y = {}, .legend = "", .stroke = {.colour = colour}};
    for (std::size_t row = 0; row < result.steps.size(); ++row) {
      if (result.errors[i][row] <= 0.0) continue;
      line.x.push_back(result.steps[row]);
      line.y.push_back(result.errors[i][row]);
    }
    PointLayer points{.x = line.x, .y = line.y, .legend = name, .colour = colour, .size = 0.8};
    figure.layers.emplace_back(std::move(line));
    figure.layers.emplace_back(std::move(points));
  }
  figure.legend = Legend::kBelow;
  return figure;
}

void row(const std::string& what, double reference, double ours) {
  fmt::print("| {} | {:.7g} | {:.7g} | {:.1e} |\n", what, reference, ours,
             std::abs(ours / reference - 1.0));
}

void print_peaks() {
  const Block block("peaks of one mass");
  fmt::print("| peak of one mass | reference | microslip | deviation |\n|---|---|---|---|\n");
  const auto table = testing::reference_table("sdof_peak.csv");
  const auto peak = [](const Joint& joint, double force, std::size_t harmonics) {
    const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                  {.harmonics = harmonics, .samples = kFixedSamples});
    return balance.frequency_response(force, 0.8, 1.1).peaks.at(0);
  };
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double force = table["force [N]"][i];
    const bool iwan = i < 2;
    const SteadyVibration v =
        peak(iwan ? testing::iwan_joint() : testing::jenkins_joint(), force, 1);
    const std::string name = fmt::format("{}, {} N, H = 1: ", iwan ? "Iwan" : "Jenkins", force);
    row(name + "displacement, m", table["peak_displacement [m]"][i], v.response);
    row(name + "rad/s", table["angular_frequency [rad/s]"][i], v.angular_frequency);
  }
  const SteadyVibration v = peak(testing::jenkins_joint(), 0.1, 3);
  row("Jenkins, 0.1 N, H = 3: displacement, m", 1.2274, v.response);
  row("Jenkins, 0.1 N, H = 3: rad/s", 0.96057, v.angular_frequency);
}

void print_rig() {
  const Block block("levels of the friction rig");
  fmt::print(
      "| friction rig, m/s² | f | force | A | D | harmonic 2 | harmonic 3 |\n"
      "|---|---|---|---|---|---|---|\n");
  const auto table = testing::reference_table("reference_rig_levels.csv");
  const HarmonicBalance balance(testing::friction_rig(), {"force", ResponseKind::kAcceleration},
                                {.harmonics = 9, .samples = 512});
  const auto& levels = table["response_amplitude [m/s^2]"];
  const ResponseCurve curve = balance.backbone(levels);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const SteadyVibration& v = curve.points.at(i);
    const auto acceleration = v.acceleration(balance.structure().linear(), "force");
    const auto deviation = [&](const char* column, double value) {
      return std::abs(value / table[column][i] - 1.0);
    };
    fmt::print("| {} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", levels[i],
               deviation("frequency [Hz]", v.frequency()),
               deviation("force_amplitude [N]", v.force_amplitude),
               deviation("amplitude [m]", v.joints[0].amplitude),
               deviation("dissipation [J]", v.joints[0].dissipation),
               deviation("acceleration_harmonic2 [m/s^2]", std::abs(acceleration[2])),
               deviation("acceleration_harmonic3 [m/s^2]", std::abs(acceleration[3])));
  }
}

void run(const std::string& picture) {
  print_peaks();
  print_rig();
  std::vector<std::size_t> harmonics;
  for (std::size_t h = 1; h <= 31; h += 2) harmonics.push_back(h);
  std::vector<std::size_t> samples;
  for (std::size_t n = 32; n <= 4096; n *= 2) samples.push_back(n);
  FigureGrid grid{.title = "Convergence of the harmonic balance", .columns = 3, .panels = {}};
  for (const bool over_harmonics : {true, false}) {
    for (const Case& study : cases()) {
      const Study result = over(study, over_harmonics ? harmonics : samples, over_harmonics);
      print_study(study, result, over_harmonics ? "H" : "N");
      grid.panels.push_back(figure(study, result, over_harmonics));
    }
  }
  std::ofstream(picture, std::ios::binary) << draw(
      grid, picture.ends_with(".png") ? PictureFormat::kPng : PictureFormat::kSvg, {1200, 800});
}

}  // namespace
}  // namespace microslip::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("convergence_study PICTURE.svg > tables.md\n", stderr);
    return 2;
  }
  microslip::bench::run(argv[1]);
  return 0;
}
