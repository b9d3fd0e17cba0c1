// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/report/drawing/child_process.hpp"
#include "microslip/report/drawing/gnuplot_panel.hpp"
#include "microslip/report/drawing/panel_layout.hpp"
#include "microslip/report/drawing/picture_mark.hpp"
#include "microslip/report/drawing/placed.hpp"

namespace microslip {
namespace {

constexpr double kCssPixelsPerInch = 96.0;
constexpr double kPointsPerInch = 72.0;
constexpr double kMillimetresPerInch = 25.4;
constexpr double kGridEdge = 14.0;  // between the edge of the picture and its title, px

void check_length(std::string_view name, int length) {
  if (length < 100 || length > 10000) {
    throw InputError(name, length, "must be 100 to 10000 px");
  }
}

void check_number(std::string_view name, double value, double from, double to) {
  if (!(value >= from && value <= to)) {
    throw InputError(name, value, fmt::format("must be {} to {}", from, to));
  }
}

/// Sizes of fonts are px everywhere else, but cairo takes points, 3/4 of a px, and its unit of
/// lines in a PDF is half a point.
std::string terminal(PictureFormat format, PictureSize size, const PictureStyle& style) {
  const std::string look =
      fmt::format("font '{},{}' rounded background '#ffffff'", kFontName, kLabelFont.size);
  switch (format) {
    case PictureFormat::kSvg:
      return fmt::format("svg size {},{} {}", size.width, size.height, look);
    case PictureFormat::kPng: {
      const double scale = style.png_scale;
      return fmt::format(
          "pngcairo size {},{} {} fontscale {} linewidth {} pointscale {} dashlength 1.7",
          std::lround(scale * size.width), std::lround(scale * size.height), look, 0.75 * scale,
          scale, 1.2 * scale);
    }
    case PictureFormat::kPdf:
      break;
  }
  const double points = kPointsPerInch / style.pixels_per_inch;  // of a px
  return fmt::format(
      "pdfcairo size {}in,{}in {} fontscale {} linewidth {} pointscale {} dashlength 1.7",
      size.width / style.pixels_per_inch, size.height / style.pixels_per_inch, look, 0.75 * points,
      2.0 * points, 1.8 * points);
}

std::string header(PictureFormat format, PictureSize size, const PictureStyle& style) {
  check_length("width", size.width);
  check_length("height", size.height);
  check_number("pixels_per_inch", style.pixels_per_inch, 24.0, 600.0);
  check_number("png_scale", style.png_scale, 0.5, 20.0);
  return fmt::format(
      "set encoding utf8\n"
      "set terminal {}\n",
      terminal(format, size, style));
}

PanelSpace space_of(PictureSize size, const PictureStyle& style) {
  const auto width = static_cast<double>(size.width);
  const auto height = static_cast<double>(size.height);
  return {.box = {.left = 0.0, .bottom = 0.0, .right = width, .top = height},
          .picture_width = width,
          .picture_height = height,
          .number = 0,
          .framed = style.framed,
          .grey = style.grey};
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

/// Gives the panels of a column the same margins at the sides and those of a row the same ones
/// below and above, so that their axes line up.
void line_up(const FigureGrid& grid, std::vector<PanelSpace>& spaces) {
  std::vector<Margins> own;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    own.push_back(margins_of(panel_layout(grid.panels[i], spaces[i].box), spaces[i].box));
  }
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    Margins& least = spaces[i].least;
    for (std::size_t j = 0; j < spaces.size(); ++j) {
      if (j % grid.columns == i % grid.columns) {
        least.left = std::max(least.left, own[j].left);
        least.right = std::max(least.right, own[j].right);
      }
      if (j / grid.columns == i / grid.columns) {
        least.bottom = std::max(least.bottom, own[j].bottom);
        least.top = std::max(least.top, own[j].top);
      }
    }
  }
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

/// The title that a screen reader reads and a browser shows at the mouse pointer becomes that of
/// the figure.
void set_svg_title(std::string& picture, std::string_view title) {
  replace_all(picture, "<title>Gnuplot</title>", fmt::format("<title>{}</title>", xml_text(title)));
}

/// gnuplot leaves the > of texts as it is, and ]]> is no XML there.
void escape_svg_texts(std::string& picture) { replace_all(picture, "]]>", "]]&gt;"); }

/// gnuplot writes its name of a bold font, which is none of CSS, and no font for where this is
/// missing.
void set_svg_fonts(std::string& picture) {
  constexpr std::string_view kFamily = "font-family=\"DejaVu Sans, Verdana, sans-serif\"";
  replace_all(picture, "font-family=\"DejaVu Sans:Bold\"",
              fmt::format("{} font-weight=\"bold\"", kFamily));
  replace_all(picture, "font-family=\"DejaVu Sans\"", kFamily);
}

/// The size on paper, where px of a browser would give another one.
void set_svg_size(std::string& picture, PictureSize size, double pixels_per_inch) {
  if (pixels_per_inch == kCssPixelsPerInch) return;
  const double unit = kMillimetresPerInch / pixels_per_inch;
  const std::string nominal = fmt::format("width=\"{}\" height=\"{}\"", size.width, size.height);
  const std::size_t at = picture.find(nominal);
  if (at == std::string::npos) return;
  picture.replace(
      at, nominal.size(),
      fmt::format("width=\"{:.4g}mm\" height=\"{:.4g}mm\"", unit * size.width, unit * size.height));
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

/// The name of the picture: its title or, without one, its axes.
std::string title_of(const Figure& figure) {
  if (!figure.title.empty() || figure.y.label.empty()) return figure.title;
  return fmt::format("{} over {}", axis_text(figure.y), axis_text(figure.x));
}

std::string title_of(const FigureGrid& grid) {
  if (!grid.title.empty()) return grid.title;
  std::string name;
  for (Figure panel : grid.panels) {
    panel.title.clear();  // "(a)" is no title
    name += (name.empty() ? "" : "; ") + title_of(panel);
  }
  return name;
}

template <class FigureOrGrid>
std::string draw_any(const FigureOrGrid& figure, PictureFormat format, PictureSize size,
                     const PictureStyle& style) {
  std::string picture = run_gnuplot(gnuplot_script(figure, format, size, style));
  if (format == PictureFormat::kSvg) {
    set_svg_size(picture, size, style.pixels_per_inch);
    set_svg_fonts(picture);
    escape_svg_texts(picture);
    set_svg_title(picture, title_of(figure));
    mark_svg(picture);
  }
  if (format == PictureFormat::kPng) mark_png(picture);
  if (format == PictureFormat::kPdf) {
    set_pdf_date(picture);
    mark_pdf(picture);
  }
  return picture;
}

}  // namespace

std::string gnuplot_script(const Figure& figure, PictureFormat format, PictureSize size,
                           const PictureStyle& style) {
  check_figure(figure);
  std::string script = header(format, size, style);
  append_panel(script, figure, space_of(size, style));
  return script;
}

std::string gnuplot_script(const FigureGrid& grid, PictureFormat format, PictureSize size,
                           const PictureStyle& style) {
  check_figure(grid);
  std::string script = header(format, size, style) + "set multiplot\n";
  const PanelSpace picture = space_of(size, style);
  const std::vector<PlacedText> title = grid_title(grid, picture);
  std::vector<PanelSpace> spaces;
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    spaces.push_back(panel_space(grid, picture, title.size(), i));
  }
  line_up(grid, spaces);
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    for (const PlacedText& text : title) {
      if (i == 0) script += gnuplot_label(text, kGridTitleFont, "#202020", picture);
    }
    append_panel(script, grid.panels[i], spaces[i]);
    script += "reset\n";
  }
  return script + "unset multiplot\n";
}

std::string draw(const Figure& figure, PictureFormat format, PictureSize size,
                 const PictureStyle& style) {
  return draw_any(figure, format, size, style);
}

std::string draw(const FigureGrid& grid, PictureFormat format, PictureSize size,
                 const PictureStyle& style) {
  return draw_any(grid, format, size, style);
}

std::string run_gnuplot(std::string_view script) {
  // With the default settings, not those in the home of whoever runs this.
  const std::optional<ChildResult> result = run_child({"gnuplot", "--default-settings"}, script);
  if (!result) throw Error("gnuplot not found; install gnuplot-nox");
  if (result->status == 0 && !result->output.empty()) return result->output;
  const std::string why = reason(result->errors);
  throw Error(fmt::format("gnuplot failed with status {}: {}", result->status,
                          why.empty() ? "without a message" : why));
}

}  // namespace microslip
