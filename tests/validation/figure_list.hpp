// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace microslip::validation {

/// One line of docs/validation.md: a figure, its test or benchmark, and its bounds.
struct FigureLine {
  std::string what;
  /// `folder.Suite.Test`, or `bench.name` of a benchmark; with a * at the end, all names that begin
  /// with the text before it.
  std::string by;
  /// The figure that it records, `name [unit]`, of several the sum. None: whether the tests pass.
  std::string figure;
  std::string over;    ///< a benchmark: the figure is divided by that of this one
  std::string unit;    ///< of what is shown and of the bounds; by default that of the figure
  double scale = 1.0;  ///< from the unit of the figure to that
  int digits = 2;      ///< shown
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::string reference;  ///< what it is measured against
  bool external = false;  ///< needs data that are not in the repository
  int summary = 0;        ///< its place among the lines of README.md, from 1; 0: it is not there

  /// That tests pass is all.
  [[nodiscard]] bool counts_tests() const { return figure.empty(); }
};

/// A table of the page.
struct FigureTopic {
  std::string name;
  std::vector<FigureLine> lines;
};

/// Reads the list, figures.toml. @throws std::runtime_error  names the line that is at fault.
std::vector<FigureTopic> read_figure_list(const std::string& path);

}  // namespace microslip::validation
