// SPDX-License-Identifier: MIT
#include "microslip/report/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/report/child_process.hpp"
#include "microslip/report/gnuplot_panel.hpp"
#include "microslip/report/placed.hpp"

namespace microslip {
namespace {

constexpr double kPixelsPerInch = 96.0;
constexpr double kGridEdge = 14.0;  // between the edge of the picture and its title, px

void check_length(std::string_view name, int length) {
  if (length < 100 || length > 10000) {
    throw InputError(name, length, "must be 100 to 10000 px");
  }
}

/// Sizes of fonts are px everywhere else, but cairo takes points, and its unit of lines in a PDF is
/// half a point.
std::string terminal(PictureFormat format, PictureSize size) {
  const std::string look =
      fmt::format("font '{},{}' rounded background '#ffffff'", kFontName, kLabelFont.size);
  switch (format) {
    case PictureFormat::kSvg:
      return fmt::format("svg size {},{} {}", size.width, size.height, look);
    case PictureFormat::kPng:
      return fmt::format(
          "pngcairo size {},{} {} fontscale 1.5 linewidth 2 pointscale 2.4 dashlength 1.7",
          2 * size.width, 2 * size.height, look);
    case PictureFormat::kPdf:
      break;
  }
  return fmt::format(
      "pdfcairo size {}in,{}in {} fontscale 0.5625 linewidth 1.5 pointscale 1.35 dashlength 1.7",
      size.width / kPixelsPerInch, size.height / kPixelsPerInch, look);
}

std::string header(PictureFormat format, PictureSize size) {
  check_length("width", size.width);
  check_length("height", size.height);
  return fmt::format(
      "set encoding utf8\n"
      "set terminal {}\n",
      terminal(format, size));
}

PanelSpace space_of(PictureSize size) {
  const auto width = static_cast<double>(size.width);
  const auto height = static_cast<double>(size.height);
  return {.box = {.left = 0.0, .bottom = 0.0, .right = width, .top = height},
          .picture_width = width,
          .picture_height = height,
          .number = 0};
}

std::vector<PlacedText> grid_title(const FigureGrid& grid, const PanelSpace& picture) {
  std::vector<PlacedText> title;
  double y = picture.box.top - kGridEdge - 0.5 * line_height(kGridTitleFont);
  for (std::string& line :
       wrapped(grid.title, picture.box.width() - 2.0 * kGridEdge, kGridTitleFont)) {
    title.push_back({.text = std::move(line), .x = kGridEdge, .y = y});
    y -= line_height(kGridTitleFont);
  }
  return title;
}

/// The space of panel i, below the lines of the title.
PanelSpace panel_space(const FigureGrid& grid, const PanelSpace& picture, std::size_t title_lines,
                       std::size_t i) {
  const std::size_t rows = (grid.panels.size() + grid.columns - 1) / grid.columns;
  const double title = static_cast<double>(title_lines) * line_height(kGridTitleFont);
  const double top = picture.box.top - (title > 0.0 ? kGridEdge + title : 0.0);
  const double width = picture.box.width() / static_cast<double>(grid.columns);
  const double height = top / static_cast<double>(rows);
  PanelSpace space = picture;
  space.number = i;
  space.box.left = width * static_cast<double>(i % grid.columns);
  space.box.right = space.box.left + width;
  const std::size_t row = i / grid.columns;
  space.box.top = top - height * static_cast<double>(row);
  space.box.bottom = space.box.top - height;
  return space;
}

/// The line that says what is wrong; before it gnuplot may warn of other things and repeats the
/// command.
std::string reason(std::string_view errors) {
  std::string first;
  while (!errors.empty()) {
    const std::string_view line = errors.substr(0, errors.find('\n'));
    errors.remove_prefix(std::min(line.size() + 1, errors.size()));
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos) continue;
    std::string text = shown_text(line.substr(start, line.find_last_not_of(" \t") + 1 - start));
    if (text.find("warning:") != std::string::npos) continue;
    if (text.rfind("line ", 0) == 0) return text;
    if (first.empty()) first = text;
  }
  return first;
}

void replace_all(std::string& text, std::string_view old, std::string_view replacement) {
  for (std::size_t at = text.find(old); at != std::string::npos;
       at = text.find(old, at + replacement.size())) {
    text.replace(at, old.size(), replacement);
  }
}

std::string xml_text(std::string_view text) {
  std::string escaped = shown_text(text);
  replace_all(escaped, "&", "&amp;");
  replace_all(escaped, "<", "&lt;");
  replace_all(escaped, ">", "&gt;");
  return escaped;
}

/// What a screen reader says and a browser shows at the mouse pointer becomes the title of the
/// figure.
void set_svg_title(std::string& picture, std::string_view title) {
  replace_all(picture, "<title>Gnuplot</title>", fmt::format("<title>{}</title>", xml_text(title)));
}

/// gnuplot writes its name of a bold font, which is none of CSS, and no font for where this is
/// missing.
void set_svg_fonts(std::string& picture) {
  constexpr std::string_view kFamily = "font-family=\"DejaVu Sans, Verdana, sans-serif\"";
  replace_all(picture, "font-family=\"DejaVu Sans:Bold\"",
              fmt::format("{} font-weight=\"bold\"", kFamily));
  replace_all(picture, "font-family=\"DejaVu Sans\"", kFamily);
}

/// The same figure gives the same file on another day. The date keeps its length, because a PDF
/// file counts its bytes.
void set_pdf_date(std::string& picture) {
  constexpr std::string_view kKey = "/CreationDate (D:";
  constexpr std::string_view kDate = "20000101000000";
  const std::size_t at = picture.find(kKey);
  if (at == std::string::npos || at + kKey.size() + kDate.size() > picture.size()) return;
  picture.replace(at + kKey.size(), kDate.size(), kDate);
}

template <class FigureOrGrid>
std::string draw_any(const FigureOrGrid& figure, PictureFormat format, PictureSize size) {
  std::string picture = run_gnuplot(gnuplot_script(figure, format, size));
  if (format == PictureFormat::kSvg) set_svg_fonts(picture);
  if (format == PictureFormat::kSvg) set_svg_title(picture, figure.title);
  if (format == PictureFormat::kPdf) set_pdf_date(picture);
  return picture;
}

}  // namespace

std::string gnuplot_script(const Figure& figure, PictureFormat format, PictureSize size) {
  check_figure(figure);
  std::string script = header(format, size);
  append_panel(script, figure, space_of(size));
  return script;
}

std::string gnuplot_script(const FigureGrid& grid, PictureFormat format, PictureSize size) {
  check_figure(grid);
  std::string script = header(format, size) + "set multiplot\n";
  const PanelSpace picture = space_of(size);
  const std::vector<PlacedText> title = grid_title(grid, picture);
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    for (const PlacedText& text : title) {
      if (i == 0) script += gnuplot_label(text, kGridTitleFont, "#202020", picture);
    }
    append_panel(script, grid.panels[i], panel_space(grid, picture, title.size(), i));
    script += "reset\n";
  }
  return script + "unset multiplot\n";
}

std::string draw(const Figure& figure, PictureFormat format, PictureSize size) {
  return draw_any(figure, format, size);
}

std::string draw(const FigureGrid& grid, PictureFormat format, PictureSize size) {
  return draw_any(grid, format, size);
}

std::string run_gnuplot(std::string_view script) {
  // With the default settings, not those in the home of whoever runs this.
  const std::optional<ChildResult> result = run_child({"gnuplot", "--default-settings"}, script);
  if (!result) throw Error("gnuplot not found; install gnuplot-nox");
  if (result->status == 0 && !result->output.empty()) return result->output;
  const std::string why = reason(result->errors);
  throw Error(fmt::format("gnuplot failed with status {}: {}", result->status,
                          why.empty() ? "it says nothing" : why));
}

}  // namespace microslip
