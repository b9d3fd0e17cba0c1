// SPDX-License-Identifier: MIT
#include "microslip/report/page/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/report/document/static_picture.hpp"
#include "microslip/report/page/html_text.hpp"

namespace microslip {
namespace {

/// A code in words: "scatter large".
std::string in_words(std::string code) {
  std::ranges::replace(code, '_', ' ');
  return html_text(code);
}

constexpr int kPictureHeight = 340;  // px: letters of 7 pt where two stand side by side on A4
constexpr int kPictureWidth = 480;
constexpr int kWidePictureWidth = 980;
constexpr std::string_view kNoPicture =
    "<noscript>A script draws this figure; this browser runs none.</noscript>";

/// Titles that begin alike get different ids.
std::string section_id(std::size_t index, const ReportSection& section) {
  return fmt::format("section-{}-{}", index, html_id(section.title));
}

/// The number with trailing zeros, so that a column shows the measured digits: 55.70.
std::string rounded(double number, int digits) {
  if (number == 0.0) return "0";
  std::string text = fmt::format("{:.{}e}", number, digits - 1);
  const int exponent = std::stoi(text.substr(text.find('e') + 1));
  if (exponent < -4 || exponent > 6) return text;
  return fmt::format("{:.{}f}", number, std::max(digits - 1 - exponent, 0));
}

/// Whether the block stands among figures.
bool is_beside(const ReportBlock& block) {
  return std::visit(
      [](const auto& content) {
        if constexpr (requires { content.beside; }) return content.beside;
        return false;
      },
      block);
}

/// The figures over the width of the page: two that follow each other stand side by side, as a
/// figure and the blocks beside it do, and a single one has the width for itself.
std::set<const ReportFigure*> wide_figures(const ReportSection& section) {
  std::set<const ReportFigure*> wide;
  const ReportFigure* alone = nullptr;
  const auto widen = [&] {
    if (alone) wide.insert(alone);
    alone = nullptr;
  };
  for (const ReportBlock& block : section.blocks) {
    const auto* figure = std::get_if<ReportFigure>(&block);
    if (alone && is_beside(block)) {
      alone = nullptr;
    } else if (!figure || figure->wide) {
      widen();
      if (figure) wide.insert(figure);
    } else {
      alone = alone ? nullptr : figure;
    }
  }
  widen();
  return wide;
}

/// Writes the blocks of a report one after the other.
class Page {
 public:
  /// @param room  for pictures, in bytes.
  Page(const HtmlReportOptions& options, std::size_t room) : options_(options), room_(room) {}

  void add(const ReportSection& section, std::size_t index) {
    const std::string id = section_id(index, section);
    warnings_id_ = id + "-warnings";
    wide_ = wide_figures(section);
    html_ += fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n", id);
    html_ += fmt::format("<h2 id=\"{}-title\">{}</h2>\n", id, html_text(section.title));
    for (const ReportBlock& block : section.blocks) {
      const bool is_figure = std::holds_alternative<ReportFigure>(block);
      const bool beside = in_figures_ && is_beside(block);
      group_beside(beside);
      group_figures(is_figure || beside);
      std::visit([this](const auto& content) { write(content); }, block);
    }
    group_beside(false);
    group_figures(false);
    html_ += "</section>\n";
  }

  [[nodiscard]] const std::string& html() const { return html_; }

 private:
  /// Figures that follow each other stand side by side where there is room.
  void group_figures(bool is_figure) {
    if (is_figure == in_figures_) return;
    html_ += is_figure ? "<div class=\"figures\">\n" : "</div>\n";
    in_figures_ = is_figure;
  }

  /// Writes the blocks beside a figure, one below the other.
  void group_beside(bool is_beside) {
    if (is_beside == in_beside_) return;
    html_ += is_beside ? "<div class=\"beside\">\n" : "</div>\n";
    in_beside_ = is_beside;
  }

  void write(const ReportText& block) {
    html_ += fmt::format("<p class=\"text\">{}</p>\n", html_text(block.text));
  }

  void write(const ReportMissing& block) {
    html_ += fmt::format("<p class=\"missing\">{}", html_text(block.text));
    if (!block.command.empty()) {
      html_ += fmt::format(" <code>{}</code>", html_text(block.command));
    }
    html_ += "</p>\n";
  }

  void write(const ReportFacts& block) {
    if (!block.title.empty()) html_ += fmt::format("<h3>{}</h3>\n", html_text(block.title));
    html_ += fmt::format("<dl class=\"facts{}{}\">\n", block.prominent ? " prominent" : "",
                         block.one_column ? " one-column" : "");
    for (const auto& [name, value] : block.facts) {
      html_ +=
          fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(name), html_text(value));
    }
    html_ += "</dl>\n";
  }

  void write(const ReportVerdict& block) {
    html_ += fmt::format("<div class=\"verdict{}\">\n<p>{}</p>\n",
                         block.doubtful ? " doubtful" : "", html_text(block.text));
    if (!block.codes.empty()) {
      html_ += fmt::format("<p class=\"codes\"><a href=\"#{}\">{} warning{}</a>:", warnings_id_,
                           block.codes.size(), block.codes.size() == 1 ? "" : "s");
      for (const std::string& code : block.codes) {
        html_ += fmt::format("{} {}", code == block.codes.front() ? "" : ";", in_words(code));
      }
      html_ += "</p>\n";
    }
    html_ += "</div>\n";
  }

  void write(const ReportWarnings& block) {
    if (block.warnings.empty()) return;
    html_ +=
        fmt::format("<ul id=\"{}\" class=\"warnings\" aria-label=\"Warnings\">\n", warnings_id_);
    for (const Warning& warning : block.warnings) {
      html_ += fmt::format("<li>{} <code>({})</code></li>\n", html_text(warning.text),
                           html_text(warning.code));
    }
    html_ += "</ul>\n";
  }

  void write(const ReportTable& table) {
    const std::string title = html_text(table.title);
    html_ += "<div class=\"table-block\">\n";
    html_ += fmt::format("<div class=\"head\"><h3>{}</h3></div>\n", title);
    html_ += fmt::format(
        "<div class=\"table\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n<table>\n<thead>",
        title);
    html_ += "<tr>";
    for (const ReportColumn& column : table.columns) write(column);
    html_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const bool marked = std::ranges::binary_search(table.marked, i);
      html_ += marked ? "<tr class=\"marked\">" : "<tr>";
      for (std::size_t j = 0; j < table.columns.size(); ++j) {
        write(table.rows[i][j], table.columns[j]);
      }
      html_ += "</tr>\n";
    }
    html_ += "</tbody>\n</table>\n</div>\n";
    if (!table.caption.empty()) {
      html_ += fmt::format("<p class=\"caption\">{}</p>\n", html_text(table.caption));
    }
    html_ += "</div>\n";
  }

  void write(const ReportColumn& column) {
    html_ += fmt::format("<th scope=\"col\"{}>{}", column.unit.empty() ? "" : " class=\"number\"",
                         html_text(column.name));
    if (!column.unit.empty()) {
      html_ += fmt::format(" <span class=\"unit\">[{}]</span>", html_text(column.unit));
    }
    html_ += "</th>";
  }

  void write(const ReportCell& cell, const ReportColumn& column) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
      const char* kind = column.code           ? " class=\"code\""
                         : column.unit.empty() ? ""
                                               : " class=\"number\"";
      html_ += fmt::format("<td{}>{}</td>", kind, html_text(*text));
    } else if (const double number = std::get<double>(cell); std::isfinite(number)) {
      html_ += fmt::format(
          "<td data-value=\"{:.9g}\">{}</td>", number,
          column.digits == 0 ? fmt::format("{:.0f}", number) : rounded(number, column.digits));
    } else {
      html_ += "<td data-value=\"\">–</td>";
    }
  }

  void write(const ReportFigure& figure) {
    const std::string alternative = html_text(picture_text(figure));
    const bool wide = wide_.contains(&figure);
    const std::string picture = picture_of(figure, wide, alternative);
    html_ +=
        fmt::format("<figure id=\"figure-{}\" class=\"figure{}{}\" data-figure=\"{}\">\n", figures_,
                    wide ? " wide" : "", picture.empty() ? " no-picture" : "", figures_);
    html_ += fmt::format("<div class=\"head\"><h3>{}</h3></div>\n", html_text(figure.figure.title));
    if (!figure.choices.empty()) {
      html_ += fmt::format("<p class=\"chosen\">{}: {}</p>\n", html_text(figure.choose),
                           html_text(figure.choices.at(figure.chosen).name));
    }
    html_ += fmt::format("<div class=\"canvas\">{}", picture.empty() ? kNoPicture : picture);
    html_ += fmt::format("<div class=\"chart\" role=\"img\" aria-label=\"{}\"></div></div>\n",
                         alternative);
    html_ +=
        fmt::format("<figcaption>{}</figcaption>\n</figure>\n", html_text(figure.figure.caption));
    ++figures_;
  }

  /// The picture as a separate image, isolated from the page. Empty where none is wanted,
  /// or nothing of the figure can be drawn: all below zero on a logarithmic axis, for instance; or
  /// where there is no room for it.
  [[nodiscard]] std::string picture_of(const ReportFigure& figure, bool wide,
                                       const std::string& alternative) {
    if (!options_.picture) return {};
    const int width = wide ? kWidePictureWidth : kPictureWidth;
    try {
      const std::string svg = options_.picture(static_picture(figure), width, kPictureHeight);
      const std::string picture = fmt::format(
          "<img class=\"picture\" loading=\"lazy\" decoding=\"async\" width=\"{}\" height=\"{}\" "
          "alt=\"{}\" src=\"{}\">",
          width, kPictureHeight, alternative, svg_address(svg));
      if (picture.size() > room_) return {};
      room_ -= picture.size();
      return picture;
    } catch (const InputError&) {
      return {};
    }
  }

  const HtmlReportOptions& options_;
  std::size_t room_;
  std::string html_;
  std::string warnings_id_;
  std::set<const ReportFigure*> wide_;
  bool in_figures_ = false;
  bool in_beside_ = false;
  std::size_t figures_ = 0;
};

}  // namespace

std::string page_navigation(const ReportDocument& document) {
  std::string html = "<nav aria-label=\"Sections\"><ul>\n";
  for (std::size_t i = 0; i < document.sections.size(); ++i) {
    const ReportSection& section = document.sections[i];
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section_id(i, section),
                        html_text(section.title));
  }
  return html + "</ul></nav>\n";
}

std::string page_sections(const ReportDocument& document, const HtmlReportOptions& options,
                          std::size_t most_bytes) {
  const auto sections = [&document](const HtmlReportOptions& drawn, std::size_t room) {
    Page page(drawn, room);
    for (std::size_t i = 0; i < document.sections.size(); ++i) page.add(document.sections[i], i);
    return page.html();
  };
  const std::string bare = sections({.picture = {}}, 0);
  if (!options.picture || bare.size() >= most_bytes) return bare;
  return sections(options, most_bytes - bare.size());
}

}  // namespace microslip
