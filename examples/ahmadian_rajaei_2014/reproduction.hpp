// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/gnuplot.hpp"

/// @file
/// The reproduction of a figure of [AR14]: data, a picture, and numbers beside those of the paper.

namespace ahmadian_rajaei {

/// How finely everything is computed.
struct Grid {
  bool reduced = false;  ///< for the tests: fewer levels and coarser curves

  /// One of two numbers.
  template <typename T>
  [[nodiscard]] T pick(T full, T fewer) const {
    return reduced ? fewer : full;
  }
};

/// A result, its bounds, and the paper's words on it.
struct Finding {
  std::string quantity;  ///< with its unit: "resonance at the highest level [Hz]"
  std::string reported;  ///< what the paper reports or what follows from its equations
  double value = 0.0;
  double from = 0.0;  ///< agrees where from ≤ value ≤ to
  double to = 0.0;

  [[nodiscard]] bool agrees() const { return from <= value && value <= to; }
};

using Picture = std::variant<microslip::Figure, microslip::FigureGrid>;

/// A reproduced figure of the paper.
struct Reproduction {
  std::string name;   ///< of its files: "fig_02"
  std::string title;  ///< what it shows; a comment in its tables
  Picture picture;
  microslip::PictureSize size = {};
  /// Tables of data: the rest of the name of each file, and its contents.
  std::vector<std::pair<std::string, microslip::CsvWriter>> tables = {};
  std::vector<Finding> findings = {};
};

/// Everything as a table in Markdown: figure, quantity, the paper, here, agrees.
[[nodiscard]] std::string summary_text(std::span<const Reproduction> figures);

/// The table for programs: figure, quantity, value, from, to, agrees, reported.
[[nodiscard]] microslip::CsvWriter summary_table(std::span<const Reproduction> figures);

/// Writes data, pictures (svg, png), summary.md and summary.csv, all or nothing.
/// @param folder  is made where it is missing. @throws microslip::Error  where that fails.
void write_all(const std::string& folder, std::span<const Reproduction> figures);

}  // namespace ahmadian_rajaei
