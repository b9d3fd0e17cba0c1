// SPDX-License-Identifier: MIT
// ahmadian_rajaei_2014 [--out DIR] [--reduced]: makes the figures of [AR14] again.
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "experiment.hpp"
#include "figures.hpp"
#include "reproduction.hpp"

namespace {

using namespace ahmadian_rajaei;

constexpr const char* kUsage =
    "usage: ahmadian_rajaei_2014 [--out DIR] [--reduced]\n"
    "  --out DIR   folder for data, pictures and summary; default: ahmadian_rajaei_2014\n"
    "  --reduced   fewer levels and coarser curves, as in the tests\n";

std::vector<Reproduction> all_figures(const Grid& grid) {
  const std::string examples = MICROSLIP_EXAMPLES;
  const Experiment experiment = run_experiment(grid, examples);
  return {figure_02(grid, experiment.truth),
          figure_03(grid),
          figure_04(grid),
          figure_06(experiment),
          figure_07(experiment),
          figure_08(experiment),
          figure_09(grid, experiment),
          figure_10(grid, experiment),
          figure_11(grid, experiment),
          figure_b1(grid)};
}

}  // namespace

int main(int count, char** arguments) {
  std::string out = "ahmadian_rajaei_2014";
  Grid grid;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--reduced") {
      grid.reduced = true;
    } else if (argument == "--out" && i + 1 < count) {
      out = arguments[++i];
    } else {
      std::fputs(kUsage, argument == "--help" ? stdout : stderr);
      return argument == "--help" ? 0 : 2;
    }
  }
  try {
    const std::vector<Reproduction> figures = all_figures(grid);
    write_all(out, figures);
    std::printf("%s\nData, pictures (svg, png) and this table are in %s\n",
                summary_text(figures).c_str(), out.c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ahmadian_rajaei_2014: %s\n", error.what());
    return 1;
  }
}
