// SPDX-License-Identifier: MIT
#include "microslip/report/page/html_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "microslip/report/drawing/gnuplot.hpp"
#include "microslip/report/page/html_text.hpp"
#include "microslip/report/page/report_data.hpp"
#include "microslip/report/page/report_page.hpp"
#include "microslip/report/page/web_assets.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostBytes = 3'900'000;  // limit of mail attachments

std::string source_hash(std::string_view hexadecimal) {
  return fmt::format(" 'sha256-{}'", base64(bytes_of_hex(hexadecimal)));
}

/// Nothing is loaded, no script runs but these three, no style but these applies.
std::string security_policy() {
  // plotly.js makes an empty style element and fills it rule by rule, which the policy does not
  // concern.
  constexpr std::string_view kEmpty =
      "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
  std::string policy = "default-src 'none'; script-src";
  for (const WebAsset* script : {&kPlotlyScript, &kUplotScript, &kReportScript}) {
    policy += source_hash(script->sha256);
  }
  policy += "; style-src";
  for (const WebAsset* style : {&kUplotStyle, &kReportStyle}) policy += source_hash(style->sha256);
  policy += source_hash(kEmpty);
  // The one style attribute of plotly.js: font-size:70%, of the exponents at the ticks.
  constexpr std::string_view kExponent =
      "4be97e733d705eab3607415c8eaa93ecdbe3c069a10f552326cc178e54a48f4b";
  policy += "; style-src-attr 'unsafe-hashes'" + source_hash(kExponent);
  return policy + "; img-src data: blob:; base-uri 'none'; form-action 'none'";
}

/// A script that waits as a text until a script of the page runs it.
std::string library(std::string_view id, const WebAsset& script) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, script.text);
}

std::string element(std::string_view name, const WebAsset& asset) {
  return fmt::format("<{0}>{1}</{0}>\n", name, asset.text);
}

std::string head(const ReportDocument& document) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n",
                      security_policy());
  html += "<meta name=\"referrer\" content=\"no-referrer\">\n";
  html += "<meta name=\"generator\" content=\"microslip report\">\n";
  html += fmt::format("<title>{}</title>\n", html_text(document.title));
  return html + element("style", kUplotStyle) + element("style", kReportStyle) + "</head>\n";
}

std::string particulars(const ReportDocument& document) {
  std::string html = "<dl class=\"particulars\">\n";
  for (const auto& [heading, text] : document.particulars) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(heading), html_text(text));
  }
  return html + "</dl>\n";
}

std::string header(const ReportDocument& document) {
  std::string html = "<header>\n";
  if (!document.logo.empty()) {
    html += fmt::format("<img class=\"logo\" alt=\"Logo\" src=\"data:{};base64,{}\">\n",
                        html_text(document.logo_type), base64(document.logo));
  }
  html += "<p class=\"kicker\">microslip report</p>\n";
  html += fmt::format("<h1>{}</h1>\n", html_text(document.title));
  if (!document.subtitle.empty()) {
    html += fmt::format("<p class=\"subtitle\">{}</p>\n", html_text(document.subtitle));
  }
  if (!document.particulars.empty()) html += particulars(document);
  return html + "</header>\n";
}

std::string footer() {
  std::string html =
      "<footer>\n<details><summary>Licences of the software in this file</summary>\n";
  html += fmt::format("<p>{}</p>\n", html_text(kWebLibraries));
  for (const WebAsset* licence : {&kPlotlyLicence, &kUplotLicence}) {
    // Line by line, as line breaks are no text of one line.
    html += "<pre>";
    std::string_view rest = licence->text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1);
      html += html_text(rest.substr(0, rest[end] == '\n' ? end : end + 1)) + "\n";
      rest.remove_prefix(end + 1);
    }
    html += "</pre>\n";
  }
  return html + "</details>\n</footer>\n";
}

}  // namespace

std::string html_report(const ReportDocument& document, const HtmlReportOptions& options) {
  check_report(document);
  std::string before = head(document);
  before += "<body>\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n";
  before += header(document);
  before += page_navigation(document);
  before += "<main id=\"content\" tabindex=\"-1\">\n";
  std::string after = "</main>\n" + footer();
  after += "<script type=\"application/json\" id=\"report-data\">" + report_data(document) +
           "</script>\n";
  after += library("plotly", kPlotlyScript) + library("uplot", kUplotScript);
  after += element("script", kReportScript) + "</body>\n</html>\n";
  const std::size_t bytes = before.size() + after.size();
  return before + page_sections(document, options, kMostBytes - std::min(kMostBytes, bytes)) +
         after;
}

}  // namespace microslip
