// SPDX-License-Identifier: MIT
#include "microslip/report/page/html_report.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/report/page/html_text.hpp"

namespace microslip::html_report_test {
namespace {

const std::string kHostile = "</title></script><script>harm()</script>";

ReportDocument sample() {
  const ReportFigure figure{
      .figure = {.title = "Loss " + kHostile,
                 .x = {.label = "A", .unit = "µm"},
                 .y = {.label = "D", .unit = "mJ"},
                 .layers = {LineLayer{.x = {1.0}, .y = {1.0}, .legend = kHostile}}}};
  const ReportTable table{.title = "Levels",
                          .columns = {{"source"}, {"f", "Hz", 5}, {"n", "1", 0}},
                          .rows = {{kHostile, 55.7, 3.0}, {"b", 0.000123456, 12.0}},
                          .marked = {1}};
  return {.title = kHostile,
          .sections = {{"One", {figure, table}},
                       {"Two", {ReportMissing{"Nothing.", "microslip x <y>"}}}}};
}

/// The file, with a stand-in for the pictures.
std::string sample_html() {
  return html_report(sample(), {.picture = [](const Figure&, int, int) { return "<svg/>"; }});
}

/// The contents of the elements of a name that have no attributes.
std::vector<std::string> contents_of(std::string_view html, const std::string& name) {
  const std::string start = "<" + name + ">";
  const std::string end = "</" + name + ">";
  std::vector<std::string> found;
  std::size_t at = html.find(start);
  while (at != std::string_view::npos) {
    const std::size_t close = html.find(end, at);
    found.emplace_back(html.substr(at + start.size(), close - at - start.size()));
    at = html.find(start, close);
  }
  return found;
}

std::string policy_of(const std::string& html) {
  const std::string start = "Content-Security-Policy\" content=\"";
  const std::size_t at = html.find(start) + start.size();
  return html.substr(at, html.find('"', at) - at);
}

TEST(HtmlReport, ThePolicyHasTheHashOfEachScriptAndStyle) {
  const std::string html = sample_html();
  const std::string policy = policy_of(html);
  EXPECT_TRUE(policy.starts_with("default-src 'none'; script-src 'sha256-"));
  std::vector<std::string> scripts = contents_of(html, "script");
  const std::vector<std::string> styles = contents_of(html, "style");
  // Libraries wait as texts, and run by these hashes too.
  for (const std::string id : {"plotly", "uplot"}) {
    const std::string start = "<script type=\"text/plain\" id=\"" + id + "\">";
    const std::size_t from = html.find(start) + start.size();
    scripts.push_back(html.substr(from, html.find("</script>", from) - from));
    EXPECT_GT(scripts.back().size(), 10000) << id;
  }
  ASSERT_EQ(scripts.size(), 3);
  ASSERT_EQ(styles.size(), 2);
  for (const auto& list : {scripts, styles}) {
    for (const std::string& content : list) {
      const std::string hash = "'sha256-" + base64(bytes_of_hex(sha256(content))) + "'";
      EXPECT_NE(policy.find(hash), std::string::npos) << content.substr(0, 80);
    }
  }
  EXPECT_EQ(policy.find("unsafe-inline"), std::string::npos);
  EXPECT_EQ(policy.find("unsafe-eval"), std::string::npos);
  EXPECT_EQ(policy.find("http"), std::string::npos);
}

TEST(HtmlReport, TextsAreInert) {
  const std::string html = sample_html();
  EXPECT_EQ(html.find("harm()</script>"), std::string::npos);
  EXPECT_NE(html.find("<title>&lt;/title&gt;&lt;/script&gt;"), std::string::npos);
  EXPECT_NE(html.find("<code>microslip x &lt;y&gt;</code>"), std::string::npos);
}

TEST(HtmlReport, HasAHeadForACustomer) {
  ReportDocument document = sample();
  document.particulars = {{"Object", "Plate <12>"}, {"Customer", "Böse & Co"}};
  document.logo = "<svg/>";
  document.logo_type = "image/svg+xml";
  const std::string html = html_report(document, {.picture = {}});
  EXPECT_NE(html.find("<img class=\"logo\" alt=\"Logo\" src=\"data:image/svg+xml;base64," +
                      base64("<svg/>") + "\">"),
            std::string::npos);
  EXPECT_NE(html.find("<dt>Object</dt><dd>Plate &lt;12&gt;</dd>"), std::string::npos);
  EXPECT_NE(html.find("<dt>Customer</dt><dd>Böse &amp; Co</dd>"), std::string::npos);
}

TEST(HtmlReport, TablesHaveRoundedAndFullNumbers) {
  const std::string html = sample_html();
  EXPECT_NE(html.find("data-value=\"55.7\">55.700</td>"), std::string::npos);
  EXPECT_NE(html.find("data-value=\"0.000123456\">0.00012346</td>"), std::string::npos);
  EXPECT_NE(html.find("data-value=\"12\">12</td>"), std::string::npos);
  EXPECT_NE(html.find("<tr class=\"marked\"><td>b</td>"), std::string::npos);
}

TEST(HtmlReport, PicturesAreImagesWithAlternatives) {
  const std::string html = sample_html();
  EXPECT_NE(html.find("src=\"" + svg_address("<svg/>") + "\""), std::string::npos);
  EXPECT_NE(html.find("alt=\"Loss &lt;/title&gt;"), std::string::npos);
  const std::string without = html_report(sample(), {.picture = {}});
  EXPECT_EQ(without.find("<img"), std::string::npos);
  EXPECT_NE(without.find("no-picture"), std::string::npos);
}

TEST(HtmlReport, AFigureThatCannotBeDrawnHasNoPicture) {
  const std::string html = html_report(sample(), {.picture = [](const Figure&, int, int) {
                                         throw InputError("layers.size()", "0", "must be 1");
                                         return std::string();
                                       }});
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_NE(html.find("class=\"figure wide no-picture\""), std::string::npos);
}

/// Figures with a picture of some bytes each.
ReportDocument figures(std::size_t count) {
  const ReportFigure figure{
      .figure = {.title = "Loss",
                 .x = {.label = "A", .unit = "µm"},
                 .y = {.label = "D", .unit = "mJ"},
                 .layers = {LineLayer{.x = {1.0}, .y = {1.0}, .legend = "a"}}}};
  return {.title = "Many", .sections = {{"One", std::vector<ReportBlock>(count, figure)}}};
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(HtmlReport, PicturesEndWhereTheFileWouldExceedItsSize) {
  const auto large = [](const Figure&, int, int) { return std::string(500'000, 'x'); };
  const std::string html = html_report(figures(20), {.picture = large});
  EXPECT_LE(html.size(), 4'000'000);
  EXPECT_EQ(count_of(html, "<img"), 4);  // of 0.5 MB each, beside the 1.6 MB of the libraries
  EXPECT_EQ(count_of(html, "<noscript>"), 16);
}

// Two stand side by side; one that is left has the width of the page.
TEST(HtmlReport, AFigureThatIsLeftIsWide) {
  const auto widths = [](const ReportDocument& document) {
    std::vector<int> found;
    (void)html_report(document, {.picture = [&](const Figure&, int width, int) {
                        found.push_back(width);
                        return "<svg/>";
                      }});
    return found;
  };
  ReportDocument document = figures(4);
  EXPECT_EQ(widths(document), (std::vector{480, 480, 480, 480}));
  std::vector<ReportBlock>& blocks = document.sections[0].blocks;
  std::get<ReportFigure>(blocks[1]).wide = true;
  EXPECT_EQ(widths(document), (std::vector{980, 980, 480, 480}));
  blocks.insert(blocks.begin() + 3, ReportText{"between"});
  EXPECT_EQ(widths(document), (std::vector{980, 980, 980, 980}));
}

TEST(HtmlReport, IsKnownAsAReport) {
  EXPECT_EQ(file_kind(sample_html().substr(0, kKindHeadSize)), kReportKind);
}

TEST(HtmlReport, SameBytesEachTime) { EXPECT_EQ(sample_html(), sample_html()); }

TEST(HtmlReport, LicencesAreInIt) {
  const std::string html = sample_html();
  EXPECT_NE(html.find("Copyright (c) 2016-2024 Plotly Technologies Inc."), std::string::npos);
  EXPECT_NE(html.find("Leon Sorokin"), std::string::npos);
}

}  // namespace
}  // namespace microslip::html_report_test
