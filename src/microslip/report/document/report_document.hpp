// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/report/drawing/figure.hpp"

/// @file
/// The contents of a report, apart from how it looks (html_report). Texts are UTF-8 and shown as
/// they are, without markup: names out of files can do no harm. Values are drawn as they are given:
/// a caller who wants µm on an axis scales the data and names µm as its unit.

namespace microslip {

/// One of several contents of a figure: that of a level, for instance.
struct FigureChoice {
  std::string name;                ///< its name in the menu
  std::vector<Layer> layers = {};  ///< what is drawn then
};

/// Kind of chart on the screen.
enum class ChartKind {
  kPlot,
  kTimeHistory,  ///< lines over time, many points; those of a section share their cursor
};

/// A figure on a page. With choices the reader picks one, and the figure itself has no layers;
/// figures of a section with the same `choose` change together, where they have a choice of that
/// name. Values along y that are not finite are gaps.
struct ReportFigure {
  Figure figure = {};                      ///< its axes have labels and units
  ChartKind chart = ChartKind::kPlot;      ///< how it is drawn on the screen
  std::string choose = {};                 ///< what is chosen: "Level"
  std::vector<FigureChoice> choices = {};  ///< none, or what the reader chooses from
  std::size_t chosen = 0;                  ///< at first; the one in the printed picture
  bool wide = false;                       ///< over the width of the page
};

/// The content that is drawn at first.
[[nodiscard]] const std::vector<Layer>& chosen_layers(const ReportFigure& figure);

/// A column of a table.
struct ReportColumn {
  std::string name;       ///< its head
  std::string unit = {};  ///< empty for a column of text
  int digits = 4;         ///< of its numbers; 0 for whole numbers
  bool code = false;      ///< its texts are for machines: hash sums, commands
};

/// A number, or a text.
using ReportCell = std::variant<double, std::string>;

/// A table with a head.
struct ReportTable {
  std::string title;                       ///< above the table
  std::string caption = {};                ///< what it shows, a sentence or two
  std::vector<ReportColumn> columns = {};  ///< one at least
  std::vector<std::vector<ReportCell>> rows =
      {};                                ///< each as long as `columns`; a NaN is an empty cell
  std::vector<std::size_t> marked = {};  ///< rows to be looked at, rising
  bool beside = false;                   ///< stands beside the figure before it where there is room
};

/// Names with values, in two columns.
struct ReportFacts {
  std::string title = {};                                       ///< above them; may be empty
  std::vector<std::pair<std::string, std::string>> facts = {};  ///< names and values
  bool prominent = false;   ///< large figures, for the few that matter most
  bool one_column = false;  ///< for long values
  bool beside = false;      ///< stands beside the figure before it where there is room
};

/// A paragraph.
struct ReportText {
  std::string text;  ///< of the paragraph
};

/// Warnings. Never hidden.
struct ReportWarnings {
  std::vector<Warning> warnings = {};  ///< in the order shown
  bool beside = false;                 ///< stands beside the figure before it where there is room
};

/// The verdict at the top of a report: whether its result is reliable, and its warnings.
struct ReportVerdict {
  std::string text;                ///< a sentence or two
  bool doubtful = false;           ///< whether the text is a warning
  std::vector<std::string> codes;  ///< of the warnings of the section, which have the details
};

/// Missing contents, and the command that makes them.
struct ReportMissing {
  std::string text;          ///< what is missing
  std::string command = {};  ///< that makes it; may be empty
};

/// A piece of a section.
using ReportBlock = std::variant<ReportText, ReportFacts, ReportVerdict, ReportWarnings,
                                 ReportMissing, ReportTable, ReportFigure>;

/// A part of the report under a heading.
struct ReportSection {
  std::string title;                     ///< its heading
  std::vector<ReportBlock> blocks = {};  ///< in the order shown
};

/// A whole report.
struct ReportDocument {
  std::string title;          ///< its main heading, and that of the window
  std::string subtitle = {};  ///< below it; may be empty
  /// Below that: headings and texts, "Customer", "…".
  std::vector<std::pair<std::string, std::string>> particulars = {};
  std::string logo = {};                     ///< bytes of a picture beside the heading; empty: none
  std::string logo_type = {};                ///< its type in an address, `image/png` for instance
  std::vector<ReportSection> sections = {};  ///< one at least
};

/// Checks what the comments above demand, that there is a section, and that each figure has an axis
/// label with a unit and something to draw.
/// @throws InputError  naming the section, the block and the layer, counted from 0, and the value.
void check_report(const ReportDocument& document);

}  // namespace microslip
