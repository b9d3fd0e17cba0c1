// SPDX-License-Identifier: MIT

// Writes a report to standard output that has everything a report can have, and names that would do
// harm if anything took them for markup or a program. Expectations of browser tests are in
// sample_test.mjs.

#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/report/page/html_report.hpp"

namespace {

using namespace microslip;

const std::string kHostile =
    "</script><script>window.harmed=1</script><img src=x onerror=\"window.harmed=2\">\xE2\x80\xA8";
const std::string kLink = "<a href=\"javascript:window.harmed=3\">acc1</a> <b>%{x}</b> &amp; $x^2$";
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPoints = 90;

std::vector<double> amplitudes() {
  std::vector<double> a;
  for (std::size_t i = 0; i < kPoints; ++i) a.push_back(2.0 + 3.3 * static_cast<double>(i));
  return a;
}

std::vector<double> mapped(const std::vector<double>& x, double (*f)(double)) {
  std::vector<double> y;
  for (const double value : x) y.push_back(f(value));
  return y;
}

ReportFigure points_and_lines() {
  const std::vector<double> a = amplitudes();
  const std::vector<double> d = mapped(a, [](double x) { return 1e-3 * std::pow(x, 2.4); });
  std::vector<double> broken = d;
  broken[40] = kNan;
  PointLayer measured{.x = a, .y = d, .legend = "measured", .colour = kBlack};
  measured.y_error = mapped(d, [](double v) { return 0.05 * v; });
  BandLayer band{.x = a, .legend = kLink};
  band.lower = mapped(d, [](double v) { return v > 10.0 ? 0.8 * v : 0.0; });
  band.upper = mapped(d, [](double v) { return 1.2 * v; });
  return {
      .figure = {.title = "Dissipation",
                 .caption = "Points with bars, a line with a gap, an area.",
                 .x = {.label = "amplitude A", .unit = "µm", .log = true, .log_switch = true},
                 .y = {.label = "energy per cycle", .unit = "mJ", .log = true, .log_switch = true},
                 .layers = {measured, LineLayer{a, broken, "identified"}, band,
                            MarkerLayer{.x = 10.0, .label = "kA of the lowest level"}}}};
}

ReportFigure loops() {
  ReportFigure figure{.figure = {.title = "Loops",
                                 .x = {.label = "displacement", .unit = "µm"},
                                 .y = {.label = "force", .unit = "N"}}};
  for (int i = 0; i < 3; ++i) {
    LoopLayer loop{.legend = "loop " + std::to_string(i) + (i == 0 ? kLink : ""),
                   .stroke = {.colour = i}};
    for (int j = 0; j < 100; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / 100.0;
      loop.x.push_back(300.0 * std::cos(angle));
      loop.y.push_back(40.0 * std::cos(angle + 0.1 * (i + 1)));
    }
    figure.figure.layers.emplace_back(std::move(loop));
  }
  return figure;
}

ReportFigure history(const std::string& title, const std::string& unit) {
  ReportFigure figure{.figure = {.title = title,
                                 .x = {.label = "time", .unit = "s"},
                                 .y = {.label = "signal", .unit = unit}},
                      .chart = ChartKind::kTimeHistory,
                      .choose = "Level",
                      .wide = true};
  for (int level = 1; level <= 3; ++level) {
    LineLayer one{.legend = kHostile, .stroke = {.colour = kBlue}};
    LineLayer other{.legend = kLink, .stroke = {.colour = kVermillion}};
    for (int i = 0; i < 300; ++i) {
      one.x.push_back(1e-4 * i);
      one.y.push_back(level * std::sin(0.0419 * i));
      other.y.push_back(level * std::sin(0.0419 * i + 0.3));
    }
    other.x = one.x;
    one.y[100] = kNan;  // a sample that was lost
    figure.choices.push_back({"level " + std::to_string(level) + kHostile, {one, other}});
  }
  return figure;
}

ReportFigure harmonics() {
  ReportFigure figure{
      .figure = {.title = "Harmonics of the force",
                 .x = {.label = "harmonic", .unit = "1"},
                 .y = {.label = "share", .unit = "%", .log = true, .log_switch = true}},
      .choose = "Level"};
  for (int level = 1; level <= 3; ++level) {
    BarLayer before{.legend = "before", .colour = kGrey};
    BarLayer after{.legend = "after", .colour = kBlue};
    for (int n = 2; n <= 10; ++n) {
      before.x.push_back(n);
      before.y.push_back(8.0 * level / n);
      after.y.push_back(0.5 / n);
    }
    after.x = before.x;
    // In another order than that of the histories.
    figure.choices.insert(figure.choices.begin(),
                          {"level " + std::to_string(level) + kHostile, {before, after}});
  }
  return figure;
}

ReportTable table() {
  ReportTable table{.title = "Levels",
                    .caption = "A caption.",
                    .columns = {{"source"}, {"A", "µm"}, {"flags"}},
                    .marked = {1}};
  table.rows = {
      {kHostile, 1.23456789, ""}, {"=HYPERLINK(\"x\")", kNan, kLink}, {"plain", -1234567.0, ""}};
  return table;
}

}  // namespace

int main() {
  ReportDocument document{.title = "Sample " + kHostile, .subtitle = kLink};
  document.sections.push_back(
      {"Summary " + kLink,
       {ReportFacts{.facts = {{"stiffness k", "170 kN/m"}, {"area", "0.8"}}, .prominent = true},
        ReportWarnings{
            {{"density_negative", "Without the limit it would be negative. " + kHostile}}},
        ReportText{"A text. " + kLink},
        ReportMissing{"No histories are here.", "microslip verify RIG.toml " + kHostile}}});
  document.sections.push_back({"Levels", {table()}});
  document.sections.push_back({"Energies", {points_and_lines(), loops()}});
  document.sections.push_back(
      {"Histories", {history("Force", "N"), history("Acceleration", "m/s^2"), harmonics()}});
  document.sections.push_back({"Provenance", {ReportFacts{.facts = {{"command", kHostile}}}}});
  std::cout << html_report(document);
}
