// SPDX-License-Identifier: MIT
#include "validation/page.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "validation/measurements.hpp"

namespace microslip::validation::page_test {
namespace {

const std::string kRoot = MICROSLIP_ROOT;

template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

// ---- The committed page. ----

// The figures as they are shown, back into the tables of the list: the same tables. So every line
// is there with the words and bounds of the list, in order, and keeps its bounds.
// scripts/update_validation makes them so.
TEST(ValidationPage, IsInStepWithItsList) {
  const std::vector<FigureTopic> topics =
      read_figure_list(kRoot + "/tests/validation/figures.toml");
  const Blocks page = blocks_of(read_text(kRoot + "/docs/validation.md"));
  const Blocks readme = blocks_of(read_text(kRoot + "/README.md"));
  ASSERT_GE(topics.size(), 5U);
  std::vector<Figures> figures;
  for (const FigureTopic& topic : topics) {
    SCOPED_TRACE(topic.name);
    ASSERT_TRUE(page.contains(topic.name));
    figures.push_back(figures_in(page.at(topic.name)));
    ASSERT_EQ(figures.back().size(), topic.lines.size());
    EXPECT_EQ(page.at(topic.name), table_of(topic.lines, figures.back()));
    for (std::size_t i = 0; i < topic.lines.size(); ++i) {
      const std::optional<double>& figure = figures.back()[i];
      EXPECT_TRUE(figure || topic.lines[i].external) << topic.lines[i].what;
      if (figure) {
        EXPECT_EQ(broken_bound(topic.lines[i], *figure).value_or(""), "");
      }
    }
  }
  ASSERT_TRUE(readme.contains("summary"));
  EXPECT_EQ(readme.at("summary"), tables_of(topics, figures).at("summary"));
}

// ---- Blocks. ----

TEST(ValidationBlocks, AreReplacedAndTheRestStays) {
  const std::string text = "a\n<!-- validation: one -->\nold\n<!-- end validation -->\n\nb\n";
  EXPECT_EQ(blocks_of(text), (Blocks{{"one", "old\n"}}));
  EXPECT_EQ(with_blocks(text, {{"one", "x\ny\n"}, {"two", ""}}),
            "a\n<!-- validation: one -->\nx\ny\n<!-- end validation -->\n\nb\n");
  EXPECT_EQ(with_blocks(text, blocks_of(text)), text);
}

TEST(ValidationBlocks, NeedTheirMarksAndTheirContent) {
  const std::string open = "<!-- validation: one -->\n";
  const std::string close = "<!-- end validation -->\n";
  EXPECT_EQ(message_of([&] { blocks_of(open); }), "block one does not end");
  EXPECT_EQ(message_of([&] { blocks_of(open + open); }), "block one does not end");
  EXPECT_EQ(message_of([&] { blocks_of(close); }), "a block ends that did not begin");
  EXPECT_EQ(message_of([&] { blocks_of(open + close + open + close); }), "block one stands twice");
  EXPECT_EQ(message_of([&] { with_blocks(open + close, {}); }), "nothing for block one");
}

// ---- Tables. ----

FigureLine line_of(std::optional<double> at_least, std::optional<double> at_most) {
  FigureLine line;
  line.what = "error";
  line.by = "joint.Suite.Test";
  line.figure = "error [N]";
  line.unit = "N";
  line.at_least = at_least;
  line.at_most = at_most;
  line.reference = "truth";
  return line;
}

TEST(ValidationTable, ShowsFiguresAndBounds) {
  FigureLine tests;
  tests.what = "files";
  tests.by = "io.Suite.*";
  tests.reference = "themselves";
  const std::vector<FigureLine> lines{
      line_of({}, 1e-10), line_of(0.9, 0.99), line_of(20, {}), line_of({}, {}), tests,
      line_of({}, 2e-3),  line_of({}, 2e3)};
  const Figures figures{4.949e-12, 0.9, 12345.0, std::nullopt, 7.0, -1e-300, 0.0};
  const std::string table = table_of(lines, figures);
  EXPECT_EQ(table,
            "| what | measured | bound | against | by |\n|---|---|---|---|---|\n"
            "| error | 4.9e-12 N | ≤ 1e-10 N | truth | `joint.Suite.Test` |\n"
            "| error | 0.9 N | 0.9 to 0.99 N | truth | `joint.Suite.Test` |\n"
            "| error | 1.2e4 N | ≥ 20 N | truth | `joint.Suite.Test` |\n"
            "| error | not measured, its data are not there | – | truth | `joint.Suite.Test` |\n"
            "| files | 7 pass | all pass | themselves | `io.Suite.*` |\n"
            "| error | -1e-300 N | ≤ 2e-3 N | truth | `joint.Suite.Test` |\n"
            "| error | 0 N | ≤ 2000 N | truth | `joint.Suite.Test` |\n");
  EXPECT_EQ(figures_in(table), (Figures{4.9e-12, 0.9, 1.2e4, std::nullopt, 7.0, -1e-300, 0.0}));
  EXPECT_EQ(table_of(lines, figures_in(table)), table);
}

// Lines are in the order of their places, and "the same" is resolved.
TEST(ValidationTable, SummaryIsInItsOrder) {
  FigureTopic topic{"a", std::vector<FigureLine>(3, line_of({}, 1.0))};
  topic.lines[0].summary = 2;
  topic.lines[1].reference = "the same; twice";
  topic.lines[1].summary = 1;
  EXPECT_EQ(tables_of({topic}, {{0.5, 0.25, 0.125}}).at("summary"),
            "| what | measured | bound | against |\n|---|---|---|---|\n"
            "| error | 0.25 N | ≤ 1 N | truth; twice |\n| error | 0.5 N | ≤ 1 N | truth |\n");
}

TEST(ValidationTable, MarksBrokenBounds) {
  EXPECT_FALSE(broken_bound(line_of({}, 1.0), 1.0));
  EXPECT_FALSE(broken_bound(line_of(1.0, {}), 1.0));
  EXPECT_EQ(broken_bound(line_of({}, 1.0), 1.25), "error: 1.2 N, bound ≤ 1 N (joint.Suite.Test)");
  EXPECT_TRUE(broken_bound(line_of(1.0, {}), 0.999));
  EXPECT_TRUE(broken_bound(line_of(0.9, 0.99), 0.995));
  EXPECT_TRUE(broken_bound(line_of({}, {}), std::numeric_limits<double>::quiet_NaN()));
}

// ---- The list. ----

std::string fault_of(const std::string& line) {
  const ::microslip::test::TemporaryFolder folder;
  const std::string path = folder.file("figures.toml");
  ::microslip::test::put(path, "[[topic]]\nname = 'a'\n[[topic.line]]\n" + line);
  return message_of([&] { (void)read_figure_list(path); });
}

TEST(ValidationList, TakesTheUnitOfTheFigure) {
  const ::microslip::test::TemporaryFolder folder;
  const std::string path = folder.file("figures.toml");
  ::microslip::test::put(path,
                         "[[topic]]\nname = 'a'\n"
                         "[[topic.line]]\nwhat = 'w'\nby = 'b'\nreference = 'r'\nfigure = 'f [N]'\n"
                         "[[topic.line]]\nwhat = 'w'\nby = 'b'\nreference = 'r'\nfigure = 'f [1]'\n"
                         "[[topic.line]]\nwhat = 'w'\nby = 'b'\nreference = 'r'\nfigure = 'f [s]'\n"
                         "unit = 'ms'\nscale = 1000\nat_most = 2\n");
  const std::vector<FigureLine> lines = read_figure_list(path).at(0).lines;
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].unit, "N");
  EXPECT_EQ(lines[1].unit, "");
  EXPECT_EQ(lines[2].unit, "ms");
  EXPECT_EQ(lines[2].scale, 1000.0);
  EXPECT_EQ(lines[2].at_most, 2.0);
}

TEST(ValidationList, NamesWhatIsWrong) {
  const std::string line = "what = 'w'\nby = 'b'\nreference = 'r'\n";
  EXPECT_EQ(fault_of(line), "no error");
  EXPECT_EQ(fault_of("what = 'w'\nreference = 'r'\n"), "figures.toml:3: by must be a text");
  EXPECT_EQ(fault_of(line + "at_mots = 1\n"), "figures.toml:3: unknown key at_mots");
  EXPECT_EQ(fault_of(line + "figure = 'f [1]'\nat_most = '1'\n"),
            "figures.toml:3: at_most must be a number");
  EXPECT_EQ(fault_of(line + "at_most = 1\n"), "figures.toml:3: a bound needs a figure");
  EXPECT_EQ(fault_of("what = 'a | b'\n"), "figures.toml:3: what must have no | or line end");
}

// ---- Measurements. ----

constexpr const char* kTests = R"({"testsuites": [{"name": "Suite", "testsuite": [
  {"name": "Test", "result": "COMPLETED", "line": 7, "error [N]": "0.25", "list": "{ 1, 2 }"},
  {"name": "Other", "result": "COMPLETED", "error [N]": "4"},
  {"name": "Broken", "result": "COMPLETED", "failures": [{"failure": "x"}], "error [N]": "1"},
  {"name": "Skipped", "result": "SKIPPED"}]}]})";

constexpr const char* kBenchmarks = R"({"context": {"load_avg": [1.5, 1, 1]}, "benchmarks": [
  {"name": "a_mean", "run_name": "a", "aggregate_name": "mean", "real_time": 9.0, "cpu_time": 9.0,
   "time_unit": "ms"},
  {"name": "a_median", "run_name": "a", "aggregate_name": "median", "real_time": 4.0,
   "cpu_time": 2.0, "time_unit": "ms", "ns_per_sample": 8.0},
  {"name": "b/real_time_median", "run_name": "b/real_time", "aggregate_name": "median",
   "real_time": 4.0, "cpu_time": 2.0, "time_unit": "us", "ns_per_sample": 2.0}]})";

Measurements measured() {
  const ::microslip::test::TemporaryFolder folder;
  ::microslip::test::put(folder.file("test_joint.json"), kTests);
  ::microslip::test::put(folder.file("bench.json"), kBenchmarks);
  ::microslip::test::put(folder.file("browser.sample.json"), R"({"a": {"b": 3}, "c": "x"})");
  Measurements measurements;
  ::microslip::test::put(folder.file("ctest.json"),
                         R"({"docs.a": true, "docs.b": true, "docs.c": false})");
  for (const char* name : {"test_joint.json", "bench.json", "browser.sample.json", "ctest.json"}) {
    measurements.add_file(folder.file(name));
  }
  return measurements;
}

std::optional<double> figure(const std::string& by, const std::string& name, double scale = 1.0,
                             const std::string& over = "", bool external = false) {
  FigureLine line;
  line.by = by;
  line.figure = name;
  line.scale = scale;
  line.over = over;
  line.external = external;
  return measured().figure(line);
}

TEST(Measurements, AreTheFiguresOfTestsAndBenchmarks) {
  EXPECT_EQ(figure("joint.Suite.Test", "error [N]"), 0.25);
  EXPECT_EQ(figure("joint.Suite.Test", "error [N]", 1e3), 250.0);
  EXPECT_EQ(figure("joint.Suite.*", "error [N]"), 4.25) << "of those that passed";
  EXPECT_EQ(figure("joint.Suite.*", ""), 2.0);
  EXPECT_EQ(figure("bench.a", "time [s]"), 2.0 * 1e-3) << "the median of processor time";
  EXPECT_EQ(figure("bench.b/real_time", "time [s]"), 4.0 * 1e-6);
  EXPECT_EQ(figure("bench.a", "ns_per_sample", 1.0, "bench.b/real_time"), 4.0);
  EXPECT_EQ(figure("browser.sample", "a/b"), 3.0);
  EXPECT_EQ(figure("ctest.docs.b", ""), 1.0);
  EXPECT_EQ(figure("ctest.docs.*", ""), 2.0);
  EXPECT_EQ(measured().failed(), (std::vector<std::string>{"joint.Suite.Broken", "ctest.docs.c"}));
  EXPECT_EQ(measured().load(), 1.5);
}

TEST(Measurements, NameWhatIsMissing) {
  const auto message = [](const std::string& by, const std::string& name) {
    return message_of([&] { (void)figure(by, name); });
  };
  EXPECT_EQ(message("joint.Suite.None", "error [N]"),
            "joint.Suite.None was not run, so there is no 'error [N]'");
  for (const char* test : {"Broken", "Skipped"}) {
    EXPECT_EQ(
        message(std::string("joint.Suite.") + test, "error [N]"),
        std::string("joint.Suite.") + test + " failed, was skipped or does not record 'error [N]'");
  }
  EXPECT_NE(message("joint.Suite.Test", "other [N]").find("'other [N]'"), std::string::npos);
  EXPECT_FALSE(figure("joint.Suite.Skipped", "error [N]", 1.0, "", true));
}

}  // namespace
}  // namespace microslip::validation::page_test
