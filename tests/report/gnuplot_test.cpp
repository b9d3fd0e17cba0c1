// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/gnuplot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/report/drawing/child_process.hpp"
#include "report/support.hpp"

namespace microslip::gnuplot_test {
namespace {

using test::contains;
using test::density_figure;
using test::input_fault;

std::string svg_script(const Figure& figure) { return gnuplot_script(figure, PictureFormat::kSvg); }

std::string error_of(std::string_view script) {
  try {
    (void)run_gnuplot(script);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Sets a variable of the environment while it lives.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    const char* old = std::getenv(name);
    if (old != nullptr) old_ = old;
    had_ = old != nullptr;
    setenv(name, value, 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() {
    if (had_) {
      setenv(name_.c_str(), old_.c_str(), 1);
    } else {
      unsetenv(name_.c_str());
    }
  }

 private:
  std::string name_;
  std::string old_;
  bool had_ = false;
};

/// Nests tags and quotes rightly; knows no more of XML than gnuplot writes.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag.empty() || tag.find('<') != std::string::npos) return false;
    if (tag[0] == '?' || tag[0] == '!' || tag.back() == '/') continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \t\r\n"));
    if (name[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    value = (value << 8U) | static_cast<unsigned char>(bytes.at(i));
  }
  return value;
}

TEST(GnuplotScript, HoldsTheDataInOrder) {
  const std::string script = svg_script(density_figure());
  EXPECT_TRUE(contains(script, "$data_0_0 << EOD\n0 0.05 0.15\n10 0.02 0.06\n20 0 0.02\nEOD\n"));
  EXPECT_TRUE(contains(script, "$data_0_1 << EOD\n0 0.1\n10 0.04\n20 0.01\nEOD\n"));
  EXPECT_TRUE(contains(script, "\nplot $data_0_0 using 1:2:3 with filledcurves"));
  EXPECT_TRUE(contains(script, "$data_0_1 using 1:2 with lines linecolor rgb '#000000'"));
  EXPECT_TRUE(contains(script, "$data_0_2 using 1:2:5:6 with yerrorbars"));
}

// Two layers share 0.76 of a step of 1: from −0.38 to 0 and from 0 to 0.38 beside each number. The
// lower end of a bar is 0 or, on a logarithmic axis, the end of that; a bar of 0 has no place
// there.
TEST(GnuplotScript, BarsOfLayersStandSideBySide) {
  Figure figure{
      .y = {.range = AxisRange{0.1, 10.0}},
      .layers = {BarLayer{.x = {2.0, 3.0}, .y = {5.0, 0.0}, .legend = "before"},
                 BarLayer{.x = {2.0, 3.0}, .y = {1.0, 2.0}, .legend = "hidden", .shown = false},
                 BarLayer{.x = {2.0, 3.0}, .y = {1.0, 0.5}, .legend = "after"}}};
  const std::string linear = svg_script(figure);
  EXPECT_TRUE(contains(linear, "EOD\n2 5 1.62 2 0 5\n3 0 2.62 3 0 0\nEOD\n")) << linear;
  EXPECT_TRUE(contains(linear, "EOD\n2 1 2 2.38 0 1\n3 0.5 3 3.38 0 0.5\nEOD\n")) << linear;
  EXPECT_TRUE(contains(linear, "with boxxyerror"));
  EXPECT_FALSE(contains(linear, "hidden"));
  figure.y.log = true;
  EXPECT_TRUE(contains(svg_script(figure), "EOD\n2 5 1.62 2 0.1 5\nEOD\n"));
}

TEST(GnuplotScript, NamesTerminalAndTexts) {
  const std::string script = svg_script(density_figure());
  EXPECT_EQ(
      script.rfind("set encoding utf8\nset terminal svg size 800,500 font 'DejaVu Sans,14'", 0),
      0U);
  EXPECT_TRUE(contains(script, "set label \"Distribution density φ(f*)\" at screen "));
  EXPECT_TRUE(contains(script, "set label \"slip force f* [N]\" at screen "));
  EXPECT_TRUE(contains(script, "set label \"largest force\" at screen "));
  EXPECT_TRUE(contains(gnuplot_script(density_figure(), PictureFormat::kPng, {400, 300}),
                       "set terminal pngcairo size 800,600 "));
  EXPECT_TRUE(contains(gnuplot_script(density_figure(), PictureFormat::kPdf, {480, 384}),
                       "set terminal pdfcairo size 5in,4in "));
}

TEST(GnuplotScript, NumbersReadBackAsTheSameDoubles) {
  const Figure figure{.layers = {LineLayer{.x = {0.1, 1.0 / 3.0}, .y = {1e-17, 123456789.125}}}};
  EXPECT_TRUE(contains(svg_script(figure), "0.1 1e-17\n0.3333333333333333 123456789.125\n"));
}

TEST(GnuplotScript, DoesNotDependOnTheLocale) {
  const std::string script = svg_script(density_figure());
  // Whichever of these is installed writes 0,5; without any the test shows little.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", ""}) {
    std::setlocale(LC_ALL, name);
    EXPECT_EQ(svg_script(density_figure()), script);
  }
  std::setlocale(LC_ALL, "C");
}

TEST(GnuplotScript, LogarithmicAxes) {
  Figure figure = density_figure();
  figure.y.log = true;
  figure.layers = {LineLayer{.x = {1.0, 2.0, 3.0, 4.0}, .y = {1e-6, 0.0, 1e-3, 1.0}},
                   BandLayer{.x = {1.0, 2.0}, .lower = {-1.0, 1e-3}, .upper = {1.0, 1.0}}};
  figure.y.range = AxisRange{.from = 1e-7, .to = 10.0};
  const std::string script = svg_script(figure);
  EXPECT_TRUE(contains(script, "set yrange [1e-07:10]\nset logscale y 10\n"));
  EXPECT_TRUE(contains(script, "set label '10^{−6}' at screen "));
  EXPECT_TRUE(contains(script, "1 1e-06\n\n3 0.001\n4 1\n"));  // a gap
  EXPECT_TRUE(contains(script, "1 1e-07 1\n2 0.001 1\n"));     // down to the end of the axis
  EXPECT_FALSE(contains(script, "set logscale x"));
}

TEST(GnuplotScript, AClosedLoop) {
  const Figure figure{.layers = {LoopLayer{.x = {0.0, 1.0, 0.0}, .y = {0.0, 1.0, 2.0}}}};
  EXPECT_TRUE(contains(svg_script(figure), "EOD\n0 0\n1 1\n0 2\n0 0\nEOD\n"));
}

TEST(GnuplotScript, QuotesTexts) {
  Figure figure = density_figure();
  figure.title = "it's \"; set output `x`";
  figure.subtitle = "two\nlines \\1 @a";
  const std::string script = svg_script(figure);
  EXPECT_TRUE(
      contains(script, "set label \"it\\0047s \\0042; set output \\0140x\\0140\" at screen "));
  EXPECT_TRUE(contains(script, "set label \"two lines \\01341 \\0100a\" at screen "));
}

TEST(GnuplotScript, GridsHaveOneTitleAndNumberedPanels) {
  const FigureGrid grid{.title = "Loops", .panels = {density_figure(), density_figure()}};
  const std::string script = gnuplot_script(grid, PictureFormat::kSvg, {1000, 500});
  EXPECT_TRUE(contains(script, "set multiplot\nset label \"Loops\" at screen "));
  EXPECT_TRUE(contains(script, "$data_1_2 << EOD"));
  EXPECT_TRUE(contains(script, "reset\nunset multiplot\n"));
}

TEST(GnuplotScript, FramedPicturesHaveNoGrid) {
  const std::string script =
      gnuplot_script(density_figure(), PictureFormat::kSvg, {}, {.framed = true});
  EXPECT_TRUE(contains(script, "set border 15 "));
  EXPECT_FALSE(contains(script, "set grid"));
  EXPECT_TRUE(contains(svg_script(density_figure()), "set grid"));
}

TEST(GnuplotScript, InGreyEachColourHasAShade) {
  const std::string script =
      gnuplot_script(density_figure(), PictureFormat::kSvg, {}, {.grey = true});
  EXPECT_TRUE(contains(script, "fillcolor rgb '#202020'"));
  EXPECT_FALSE(contains(script, "#0072b2"));
  EXPECT_FALSE(contains(script, "#d55e00"));
}

TEST(GnuplotScript, OpenMarksAreOutlines) {
  Figure figure{.layers = {PointLayer{.x = {1.0}, .y = {1.0}}}};
  EXPECT_TRUE(contains(svg_script(figure), "pointtype 7 "));
  std::get<PointLayer>(figure.layers[0]).open = true;
  EXPECT_TRUE(contains(svg_script(figure), "pointtype 6 "));
}

TEST(GnuplotScript, AxesOfAColumnOfPanelsLineUp) {
  FigureGrid grid{.columns = 1, .panels = {density_figure(), density_figure()}};
  for (double& upper : std::get<BandLayer>(grid.panels[1].layers[0]).upper) upper *= 12345.0;
  const std::string script = gnuplot_script(grid, PictureFormat::kSvg, {600, 800});
  const std::size_t first = script.find("set lmargin at screen ");
  const std::size_t second = script.find("set lmargin at screen ", first + 1);
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(script.substr(first, 30), script.substr(second, 30));
}

TEST(GnuplotScriptFault, Styles) {
  const auto fault = [](const PictureStyle& style) {
    return input_fault(
        [&] { return gnuplot_script(density_figure(), PictureFormat::kPdf, {}, style); });
  };
  EXPECT_EQ(fault({.pixels_per_inch = 0.0}), "pixels_per_inch = 0; must be 24 to 600");
  EXPECT_EQ(fault({.png_scale = 21.0}), "png_scale = 21; must be 0.5 to 20");
}

TEST(GnuplotScriptFault, SizesAndFigures) {
  EXPECT_EQ(input_fault([] {
              return gnuplot_script(density_figure(), PictureFormat::kSvg, {99, 500});
            }),
            "width = 99; must be 100 to 10000 px");
  EXPECT_EQ(input_fault([] { return svg_script({}); }),
            "layers.size() = 0; a figure needs a line, a loop, points, a band or bars");
}

TEST(Draw, Svg) {
  const std::string picture = draw(density_figure(), PictureFormat::kSvg);
  EXPECT_EQ(picture.rfind("<?xml", 0), 0U);
  EXPECT_TRUE(is_well_formed(picture));
  EXPECT_TRUE(contains(picture, "<title>Distribution density φ(f*)</title>"));
  EXPECT_TRUE(contains(picture, "<text>Distribution density φ(f*)</text>"));
  EXPECT_TRUE(contains(picture, "<text>density φ [1/N]</text>"));
  EXPECT_TRUE(
      contains(picture, "font-family=\"DejaVu Sans, Verdana, sans-serif\" font-weight=\"bold\""));
  EXPECT_TRUE(contains(picture, "width=\"800\" height=\"500\""));
}

TEST(Draw, SizesOnPaper) {
  const PictureStyle style{.pixels_per_inch = 120.0, .png_scale = 5.0};
  const PictureSize size{480, 360};
  EXPECT_TRUE(contains(draw(density_figure(), PictureFormat::kSvg, size, style),
                       "width=\"101.6mm\" height=\"76.2mm\""));
  EXPECT_TRUE(contains(draw(density_figure(), PictureFormat::kPdf, size, style),
                       "/MediaBox [ 0 0 288 216 ]"));
  EXPECT_EQ(big_endian(draw(density_figure(), PictureFormat::kPng, size, style), 16), 2400U);
}

TEST(Draw, PngIsTwiceAsLarge) {
  const std::string picture = draw(density_figure(), PictureFormat::kPng, {400, 300});
  ASSERT_EQ(picture.substr(0, 8), "\x89PNG\r\n\x1A\n");
  EXPECT_EQ(big_endian(picture, 16), 800U);
  EXPECT_EQ(big_endian(picture, 20), 600U);
}

TEST(Draw, Pdf) {
  const std::string picture = draw(density_figure(), PictureFormat::kPdf);
  EXPECT_EQ(picture.rfind("%PDF-", 0), 0U);
  EXPECT_TRUE(contains(picture, "/MediaBox [ 0 0 600 375 ]"));  // 96 px are 72 points
  EXPECT_TRUE(contains(picture, "/CreationDate (D:20000101000000"));
}

TEST(Draw, GivesTheSameBytesAgain) {
  for (const auto format : {PictureFormat::kSvg, PictureFormat::kPng, PictureFormat::kPdf}) {
    const std::string first = draw(density_figure(), format);
    const Environment locale("LC_ALL", "C");
    const Environment terminal("GNUTERM", "dumb");
    EXPECT_TRUE(draw(density_figure(), format) == first);
  }
}

TEST(Draw, AGrid) {
  const FigureGrid grid{.title = "Four of them",
                        .panels = {density_figure(), density_figure(), density_figure()}};
  const std::string picture = draw(grid, PictureFormat::kSvg, {1000, 800});
  EXPECT_TRUE(is_well_formed(picture));
  EXPECT_TRUE(contains(picture, "<text>Four of them</text>"));
}

TEST(Draw, ManyPoints) {
  LineLayer line;
  for (int i = 0; i < 100000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i % 100);
  }
  EXPECT_TRUE(is_well_formed(draw(Figure{.layers = {line}}, PictureFormat::kSvg)));
}

TEST(Draw, ExtremeNumbers) {
  for (const bool log : {false, true}) {
    const Figure figure{.x = {.log = log},
                        .y = {.log = log},
                        .layers = {PointLayer{.x = {1e-100, 1e100}, .y = {1e100, 1e-100}}}};
    EXPECT_TRUE(is_well_formed(draw(figure, PictureFormat::kSvg)));
  }
  Figure outside = density_figure();
  outside.x.range = AxisRange{.from = 100.0, .to = 200.0};
  EXPECT_TRUE(is_well_formed(draw(outside, PictureFormat::kSvg)));
}

// Each text must come out as it went in: nothing runs, nothing is marked up.
TEST(Draw, HostileTexts) {
  // Where the locale knows no UTF-8, gnuplot warns of that on standard error.
  const Environment locale("LC_ALL", "C.UTF-8");
  const std::vector<std::string> texts = {"'.system('echo injected >&2').'",
                                          "`echo injected >&2`",
                                          "\"`echo injected >&2`\"",
                                          "\\' ; print 'injected'",
                                          "'\nprint 'injected'",
                                          "' ; print 'injected",
                                          "\" ; print \"injected",
                                          "{",
                                          "}",
                                          "@injected",
                                          "a_b^c {/Bold=40 d} &{e} ~f{g}",
                                          "# no comment",
                                          "%d %s",
                                          "\\",
                                          "''",
                                          "$data_0_0",
                                          "</text><script>injected</script>",
                                          "\\U+221E \\n \\123",
                                          "EOD",
                                          "]]> &amp; \"quoted\""};
  for (const std::string& text : texts) {
    Figure figure{.title = text, .subtitle = text, .x = {.label = text}, .y = {.label = text}};
    figure.layers = {LineLayer{.x = {0.0, 1.0}, .y = {0.0, 1.0}, .legend = text},
                     MarkerLayer{.x = 0.5, .label = text}};
    const std::string script = svg_script(figure);
    const auto child = run_child({"gnuplot", "--default-settings"}, script);
    ASSERT_TRUE(child.has_value());
    EXPECT_EQ(child->errors, "") << text;
    const std::string picture = draw(figure, PictureFormat::kSvg);
    EXPECT_TRUE(is_well_formed(picture)) << text;
    EXPECT_FALSE(contains(picture, "<script")) << text;
    std::string shown = text;
    std::replace(shown.begin(), shown.end(), '\n', ' ');
    for (std::size_t at = 0; (at = shown.find('&', at)) != std::string::npos; at += 5) {
      shown.replace(at, 1, "&amp;");
    }
    for (std::size_t at = 0; (at = shown.find('<', at)) != std::string::npos; at += 4) {
      shown.replace(at, 1, "&lt;");
    }
    if (const std::size_t at = shown.find("]]>"); at != std::string::npos) {
      shown.replace(at, 3, "]]&gt;");
    }
    std::size_t count = 0;
    for (std::size_t at = 0;
         (at = picture.find("<text>" + shown + "</text>", at)) != std::string::npos; ++at) {
      ++count;
    }
    EXPECT_EQ(count, 6U) << text;  // title, subtitle, two axes, legend, marker
  }
}

TEST(Draw, BrokenUtf8IsReplaced) {
  Figure figure = density_figure();
  figure.title = "a\xFF\xC3(b\x01";
  const std::string picture = draw(figure, PictureFormat::kSvg);
  EXPECT_TRUE(contains(picture, "<text>a\uFFFD\uFFFD(b</text>"));
  EXPECT_FALSE(draw(figure, PictureFormat::kPng).empty());
}

TEST(RunGnuplotFault, SaysWhatIsWrong) {
  const Environment locale("LC_ALL", "C");  // brings a warning, which is not what is wrong
  EXPECT_EQ(error_of("set encoding utf8\nset terminal svg\nset title foo(\nplot x\n"),
            "gnuplot failed with status 1: line 0: invalid expression");
  EXPECT_TRUE(contains(error_of("set terminal svg\nplot no_such_thing\n"), "gnuplot failed with"));
  EXPECT_EQ(error_of(""), "gnuplot failed with status 0: without a message");
}

TEST(RunGnuplotFault, NotInstalled) {
  const Environment path("PATH", "/no/such/folder");
  EXPECT_EQ(error_of("plot x\n"), "gnuplot not found; install gnuplot-nox");
}

}  // namespace
}  // namespace microslip::gnuplot_test
