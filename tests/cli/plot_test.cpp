// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/models.hpp"
#include "cli/run_program.hpp"
#include "cli/samples.hpp"

namespace microslip::cli_test::plot_test {
namespace {

const std::string kLevels =
    "amplitude [m],dissipation [J],dissipation_std [J],secant_stiffness [N/m],"
    "frequency [Hz],resonance_frequency [Hz],response_amplitude [m/s^2],"
    "input_energy [J],linear_dissipation [J]\n"
    "2e-5,2e-6,1e-7,1.6e5,55.8,55.7,2,5e-6,3e-6\n"
    "4e-5,2e-5,1e-7,1.5e5,55.6,55.5,4,3e-5,1e-5\n"
    "1e-4,3e-4,1e-6,1.4e5,55.4,55.3,10,4e-4,1e-4\n";

const std::string kVerification =
    "source,channel,status,frequency [Hz],response_amplitude [m/s^2],NRMSE [1],noise_share [1],"
    "amplitude_ratio [1],phase_error [rad]\n"
    "one,force,converged,50,2,0.02,0.01,1,0\n"
    "one,acc1,converged,50,2,0.03,0.01,1,0\n";

const std::string kHistories =
    "source,time [s],force_recorded [N],force_predicted [N],acc1_recorded [m/s^2],"
    "acc1_predicted [m/s^2]\n"
    "one,0,1,1.1,2,2.1\none,0.01,0,0.1,-2,-2.1\none,0.02,-1,-1.1,2,2.1\n";

const std::string kForceControl =
    "level [1],response_amplitude [m/s^2],frequency [Hz],control_iterations [1],force_before [N],"
    "force_after [N],before_2 [1],before_3 [1],after_2 [1],after_3 [1]\n"
    "1,2,55,1,0.1,0.1,1e-4,0.02,1e-5,1e-4\n2,4,55,1,0.2,0.2,2e-4,0.05,1e-5,2e-4\n";

const std::string kRecord =
    "time [s],force [N],acc1 [m/s^2],acc2 [m/s^2]\n0,0,1,2\n0.1,1,2,3\n0.2,0,-1,-2\n0.3,1,0,1\n";

/// A folder of a test and one of each file that a figure is made from.
Sandbox sandbox() {
  return Sandbox(
      {{"levels.csv", kLevels},
       {"joint.json", kJointText},
       {"density.csv",
        "slip_force [N],density [1/N],lower [1/N],upper [1/N]\n"
        "0,0.02,0.01,0.03\n40,0.01,0.01,0.02\n"},
       {"frf.csv",
        "frequency [Hz],force [N],displacement [m],phase [rad]\n"
        "10,1,1e-4,0.1\n11,1,5e-4,1.5\n12,1,1e-4,3\n"},
       {"backbone.csv",
        "displacement [m],force [N],frequency [Hz],damping_ratio [1]\n"
        "1e-5,0.1,50,0.01\n1e-3,5,45,0.03\n"},
       {"srs.csv",
        "frequency [Hz],maximax [m/s^2],positive [m/s^2],negative [m/s^2],"
        "relative_displacement [m]\n10,5,5,2,1e-3\n100,40,30,40,1e-4\n1000,9,9,8,1e-7\n"},
       {"march.csv",
        "time [s],force [N],displacement [m],velocity [m/s],acceleration [m/s^2],"
        "bolt displacement [m],bolt force [N]\n"
        "0,1,0,0,0,0,0\n0.1,0,1e-5,0,0,1e-5,1\n"},
       {"record.csv", kRecord},
       {"loop.csv", "displacement [m],force [N]\n0,0\n1e-4,5\n-1e-4,-5\n"},
       {"curve.csv",
        "amplitude [m],force [N],dissipation [J],secant_stiffness [N/m],"
        "loss_factor [1]\n1e-5,1,1e-6,1e5,0.01\n1e-4,8,1e-4,8e4,0.1\n"},
       {"verification.csv", kVerification},
       {"histories.csv", kHistories},
       {"comparison.csv",
        "source,kind,part,quantity,unit,axis,at,measured,measured_std,predicted,lower,upper,"
        "verdict\n"
        "a.csv,sweep,curve,displacement,m,frequency [Hz],10,1e-4,,1.1e-4,0.9e-4,1.2e-4,inside\n"
        "a.csv,sweep,curve,displacement,m,frequency [Hz],11,3e-4,,2e-4,1.5e-4,2.5e-4,outside\n"
        "a.csv,sweep,curve,phase_lag,rad,frequency [Hz],10,1,,1.1,0.9,1.2,inside\n"
        "a.csv,sweep,curve,phase_lag,rad,frequency [Hz],11,2,,2.1,1.9,2.2,inside\n"},
       {"force_control.csv", kForceControl}});
}

/// What a picture shows: its texts, in the order of the file.
std::string svg_of(const Sandbox& box, const Arguments& arguments) {
  Arguments call{"plot"};
  call.insert(call.end(), arguments.begin(), arguments.end());
  call.insert(call.end(), {"--out", "-"});
  const std::string svg = expect_done(box, call).out;
  EXPECT_TRUE(svg.starts_with("<?xml")) << typed(call);
  return svg;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part;
}

std::string label(const std::string& text) { return "<text>" + text + "</text>"; }

/// At a tick.
std::string number(const std::string& text) { return ">" + text + "</tspan>"; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// Marks of the data and of the legend; gnuplot's circle is its shape 5.
std::size_t circles(const std::string& svg) {
  return count(svg, "<use xlink:href='#gpPt5' transform='translate");
}

TEST(plot, EnergiesOfLevels) {
  const Sandbox box = sandbox();
  const std::string svg = svg_of(box, {"levels.csv", "--figure", "energies"});
  expect_parts(
      svg, {label("joint amplitude A [µm]"), label("energy per cycle [µJ]"), label("input energy"),
            label("linear loss"), label("joint, D"), "mm\" height"});
  EXPECT_EQ(circles(svg), 4U) << "three levels and the legend";
}

TEST(plot, EnergiesOfAmplitudeAndDissipationAlone) {
  const Sandbox box({{"levels.csv", "amplitude [um],dissipation [J]\n20,2e-6\n40,2e-5\n"}});
  const std::string svg = svg_of(box, {"levels.csv", "--figure", "energies"});
  EXPECT_EQ(circles(svg), 3U);
  EXPECT_EQ(svg.find("input energy"), std::string::npos);
}

TEST(plot, EveryFigureOfItsFile) {
  const Sandbox box = sandbox();
  const std::vector<std::pair<Arguments, std::vector<std::string>>> cases = {
      {{"joint.json", "--figure", "density"},
       {label("density φ [1/N]"), label("slip force f* [N]")}},
      {{"density.csv", "--figure", "density"}, {label("95 % band"), label("density φ [1/N]")}},
      {{"joint.json", "--figure", "loops"}, {label("joint force [N]"), label("A = 282.4 µm")}},
      {{"loop.csv", "--figure", "loops"}, {label("joint force [N]")}},
      {{"levels.csv", "--figure", "resonance"},
       {label("frequency [Hz]"), label("exciter acceleration [m/s²]"), label("drive")}},
      {{"levels.csv", "--figure", "stiffness"}, {label("secant stiffness k_eq [kN/m]")}},
      {{"joint.json", "--figure", "stiffness"}, {label("secant stiffness k_eq [kN/m]")}},
      {{"levels.csv", "--figure", "damping"}, {label("loss factor η [1]")}},
      {{"force_control.csv", "--figure", "force-control"},
       {label("harmonic over the first [%]"), label("before control"), label("(b)")}},
      {{"verification.csv", "--figure", "verification"},
       {label("(a) force"), label("(b) acc1"), label("rms error over rms [%]")}},
      {{"histories.csv", "--figure", "verification"},
       {label("(a) one"), label("force [N]"), label("acc1 [m/s²]"), label("predicted")}},
      {{"frf.csv", "--figure", "response"},
       {label("displacement amplitude"), label("phase lag [°]"), number("90")}},
      {{"backbone.csv", "--figure", "backbone"},
       {label("resonance frequency [Hz]"), label("damping ratio ζ [%]")}},
      {{"comparison.csv", "--figure", "comparison"},
       {label("(a) a.csv"), label("displacement [µm]"), label("phase lag [°]"),
        label("band of draws"), label("measured, outside")}},
      {{"srs.csv", "--figure", "spectrum"},
       {label("natural frequency [Hz]"), label("largest acceleration [m/s²]"), label("maximax")}},
      {{"march.csv", "--figure", "history"},
       {label("joint force [N]"), label("velocity [m/s]"), label("time [s]")}},
      {{"record.csv", "--figure", "history"}, {label("acceleration [m/s²]"), label("acc2")}},
      {{"curve.csv", "--figure", "dissipation"},
       {label("dissipation per cycle D [µJ]"), label("loss factor η [1]")}},
      {{"joint.json", "--figure", "dissipation"}, {label("(c)"), label("loss factor η [1]")}},
  };
  for (const auto& [call, parts] : cases) {
    SCOPED_TRACE(typed(call));
    expect_parts(svg_of(box, call), parts);
  }
}

TEST(plot, AFolderAsTheReportTakesIt) {
  const Sandbox box;
  const std::string rig = MICROSLIP_EXAMPLES "/reference_rig/";
  std::filesystem::create_directory(box.file("test"));
  box.put("test/levels.csv", kLevels);
  box.put("test/verification.csv", kVerification);
  box.put("test/verification_histories.csv", kHistories);
  for (const std::string name : {"rig.toml", "joint.json"}) {
    std::filesystem::copy_file(rig + name, box.file("test/" + name));
  }
  std::filesystem::copy_file(rig + "joint.json", box.file("test/truth_joint.json"));
  expect_parts(svg_of(box, {"test", "--figure", "constant-response"}),
               {label("acceleration over force [m/s²/N]"), label("2 m/s²"), label("10 m/s²")});
  expect_parts(svg_of(box, {"test", "--figure", "verification"}),
               {label("(a) 2 m/s², 50.00 Hz"), label("NRMSE 2.0 %, noise 1.0 %")});
  expect_parts(svg_of(box, {"test", "--figure", "density"}), {label("truth")});
  EXPECT_EQ(circles(svg_of(box, {"test", "--figure", "stiffness"})), 4U);
}

TEST(plot, AnotherJointBesideIt) {
  const Sandbox box = sandbox();
  box.put("fit.json", kJointText);
  for (const std::string figure : {"energies", "stiffness", "damping"}) {
    expect_parts(svg_of(box, {"levels.csv", "--figure", figure, "--other", "fit.json"}),
                 {label("fit")});
  }
  expect_parts(svg_of(box, {"--other", "fit.json", "joint.json", "--figure", "density"}),
               {label("fit")});
}

TEST(plot, ByStandardInput) {
  const Sandbox box;
  const Outcome run =
      expect_done(box, {"plot", "-", "--figure", "energies", "--out", "-"}, {.in = kLevels});
  EXPECT_EQ(circles(run.out), 4U);
  expect_refused(box, {"plot", "-", "--figure", "history"}, {"IN = standard input", "by its file"},
                 {.in = kRecord});
}

TEST(plot, NamesAndFormats) {
  const Sandbox box = sandbox();
  const Arguments call{"plot", "levels.csv", "--figure", "energies"};
  const auto with = [&](const Arguments& more) {
    Arguments all = call;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Outcome run = expect_done(box, call);
  EXPECT_TRUE(run.out.starts_with("energies.svg: energies, 90 mm wide, ")) << run.out;
  EXPECT_TRUE(box.get("energies.svg").starts_with("<?xml"));
  EXPECT_EQ(expect_done(box, with({"--format", "pdf", "--quiet"})).out, "");
  EXPECT_TRUE(box.get("energies.pdf").starts_with("%PDF-"));
  expect_done(box, with({"--out", "fig8.png"}));
  EXPECT_TRUE(box.get("fig8.png").starts_with("\x89PNG"));
  expect_done(box, with({"--format", "png", "--out", "fig9"}));  // without an ending
  EXPECT_TRUE(box.get("fig9").starts_with("\x89PNG"));
  expect_done(box, with({"--out", "fig8.png"}));  // replaces one of its kind
  EXPECT_TRUE(expect_done(box, with({"--format", "pdf", "--out", "-"})).out.starts_with("%PDF-"));
}

TEST(plot, RefusesFormatsThatContradict) {
  const Sandbox box = sandbox();
  const Arguments call{"plot", "levels.csv", "--figure", "energies"};
  const auto refuse = [&](const Arguments& more, const std::vector<std::string>& parts) {
    Arguments all = call;
    all.insert(all.end(), more.begin(), more.end());
    expect_refused(box, all, parts);
  };
  refuse({"--format", "pdf", "--out", "f.svg"}, {"--format = 'pdf'", "ending of --out, 'f.svg'"});
  refuse({"--out", "f.jpg"}, {"--out = 'f.jpg'", ".svg, .png or .pdf"});
  refuse({"--format", "jpg"}, {"--format", "jpg"});
  refuse({"--format", "png", "--out", "f.jpg"}, {"--out = 'f.jpg'", ".svg, .png or .pdf"});
  refuse({"--width-mm", "20"}, {"--width-mm", "from 50 to 400"});
  refuse({"--width-mm", "90mm"}, {"'90mm' must be a number of mm without a unit"});
  refuse({"--log", "--linear"}, {"--linear", "--log"});
  box.put("mine.svg", "notes");
  refuse({"--out", "mine.svg"}, {"mine.svg"});
  refuse({"--out", "nowhere/f.svg"}, {"nowhere"});
}

TEST(plot, SaysWhichFiguresThereAre) {
  const Sandbox box = sandbox();
  expect_refused(
      box, {"plot", "levels.csv"},
      {"--figure is not given; must name one of several figures. levels.csv has energies, "
       "resonance, stiffness, damping.\n"});
  expect_refused(box, {"plot", "levels.csv", "--figure", "loops"},
                 {"--figure = 'loops'", "needs joint.json or a CSV of loop", "has energies"});
  expect_refused(box, {"plot", "frf.csv", "--figure", "energies"},
                 {"needs levels.csv", "frf.csv has response.\n"});
  expect_refused(box, {"plot", "levels.csv", "--figure", "energy"}, {"--figure", "energies"});
}

TEST(plot, DrawsTheOnlyFigureThereIs) {
  const Sandbox box = sandbox();
  EXPECT_EQ(svg_of(box, {"frf.csv"}), svg_of(box, {"frf.csv", "--figure", "response"}));
  EXPECT_TRUE(expect_done(box, {"plot", "loop.csv"}).out.starts_with("loops.svg: loops, "));
}

TEST(plot, AFolderWithADensityAlone) {
  const Sandbox box = sandbox();
  std::filesystem::create_directory(box.file("test"));
  std::filesystem::copy_file(box.file("density.csv"), box.file("test/density.csv"));
  EXPECT_EQ(svg_of(box, {"test"}), svg_of(box, {"density.csv"}));
}

// A raw ]]> is no XML.
TEST(plot, NamesOfChannelsLeaveThePictureWellFormed) {
  const Sandbox box({{"end.csv", "time [s],a]]>b [N],c [N]\n0,1,2\n1,2,3\n"}});
  const std::string svg = svg_of(box, {"end.csv"});
  EXPECT_EQ(svg.find("]]>"), std::string::npos);
  expect_parts(svg, {"]]&gt;b"});
}

TEST(plot, AFolderOfFoldersNamesThem) {
  const Sandbox box;
  std::filesystem::create_directories(box.file("demo/none"));
  expect_refused(box, {"plot", "demo"},
                 {"input = 'demo'; has no data for any figure.",
                  "Name a folder with levels.csv, joint.json or calibration.csv"});
  for (const std::string name : {"b", "a"}) {
    std::filesystem::create_directory(box.file("demo/" + name));
    box.put("demo/" + name + "/levels.csv", kLevels);
  }
  expect_refused(box, {"plot", "demo"}, {"folders in it with results: demo/a, demo/b.\n"});
  expect_refused(box, {"plot", "demo", "--figure", "energies"}, {"demo/a, demo/b.\n"});
}

TEST(plot, OneLevelHasCurvesAndTicks) {
  const Sandbox box;
  std::filesystem::create_directory(box.file("test"));
  box.put("test/joint.json", kJointText);
  box.put("test/levels.csv",
          "amplitude [m],dissipation [J],secant_stiffness [N/m]\n1e-4,3e-4,1.4e5\n");
  const std::string svg = svg_of(box, {"test", "--figure", "energies"});
  expect_parts(svg, {label("joint"), number("100")});
  // The curve spans the factor 2 about the level, most of an axis of half a decade.
  EXPECT_GT(count(svg, " L"), 100U) << svg;
  const std::string alone = svg_of(box, {"test/levels.csv", "--figure", "energies"});
  expect_parts(alone, {number("100")});
}

TEST(plot, AJointOfAtomsShowsWhatSlips) {
  const Sandbox box(
      {{"joint.json", kJointText},
       {"atoms.json", R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e5, "density": )"
                      R"([{"type": "atoms", "slip_force_N": [5, 10], "weight": [0.25, 0.5]}]})"}});
  expect_parts(svg_of(box, {"atoms.json", "--figure", "density", "--other", "joint.json"}),
               {label("share of k that slips up to f* [1]")});
  expect_parts(svg_of(box, {"joint.json", "--figure", "density", "--other", "atoms.json"}),
               {label("density φ [1/N]"), "atoms without its atoms, 75.0 % of k"});
}

TEST(plot, ARecordOfManyChannelsShowsTheFirst) {
  std::string head = "time [s]";
  std::string row;
  for (int i = 1; i <= 30; ++i) {
    head += ",a" + std::to_string(i) + " [m/s^2]";
    row += "," + std::to_string(i);
  }
  const Sandbox box({{"many.csv", head + ",force [N]\n0" + row + ",1\n1" + row + ",2\n"}});
  const Outcome run = expect_done(box, {"plot", "many.csv"});
  EXPECT_NE(run.out.find("22 further channels are not drawn"), std::string::npos) << run.out;
  const std::string svg = box.get("history.svg");
  expect_parts(svg, {label("a8"), label("force [N]")});
  EXPECT_EQ(svg.find(label("a9")), std::string::npos);
}

TEST(plot, SaysWhichValueCannotBeDrawn) {
  const Sandbox box({{"huge.csv", "amplitude [m],dissipation [J]\n1e110,1\n"},
                     {"verification.csv",
                      "source,channel,status,frequency [Hz],response_amplitude [m/s^2],NRMSE [1],"
                      "noise_share [1],amplitude_ratio [1],phase_error [rad]\n"
                      "one,force,converged,50,2,0,0,1,0\n"}});
  expect_refused(box, {"plot", "huge.csv", "--figure", "energies"},
                 {"huge.csv: joint amplitude A", "at most 1e100"});
  box.put("huge_record.csv", "time [s],force [N]\n0,1e110\n1,0\n");
  expect_refused(box, {"plot", "huge_record.csv"}, {"huge_record.csv: value", "at most 1e100"});
  box.put("spring.json",
          R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e5, "density": []})");
  expect_refused(box, {"plot", "spring.json", "--figure", "loops"},
                 {"spring.json: joint = no slider"});
  expect_parts(svg_of(box, {"verification.csv"}), {label("rms error over rms [%]")});
}

TEST(plot, RefusesOptionsThatDoNotFit) {
  const Sandbox box = sandbox();
  expect_refused(box, {"plot", "record.csv", "--figure", "history", "--log"},
                 {"--log", "history", "no amplitude axis"});
  // What another file of the same figure could take.
  box.put("fit.json", kJointText);
  for (const std::string file : {"loop.csv", "curve.csv"}) {
    expect_refused(box, {"plot", file, "--other", "fit.json"},
                   {"--other", "draws no other joints"});
  }
  expect_refused(box, {"plot", "histories.csv", "--log"}, {"--log", "no amplitude axis"});
  expect_refused(box, {"plot", "frf.csv", "--figure", "response", "--other", "joint.json"},
                 {"--other = 'joint.json'", "draws no other joints"});
  expect_refused(box, {"plot", "levels.csv", "--figure", "energies", "--time", "0:1"},
                 {"--time = '0:1'", "cuts a history or a record, and energies is none"});
  expect_refused(box, {"plot", "record.csv", "--figure", "history", "--time", "5:6"},
                 {"--time", "spans 0 to 0.3 s"});
  // It has no --rate of its own.
  box.put("untimed.csv", "force [N],acc [g]\n1,2\n3,4\n5,6\n");
  expect_refused(box, {"plot", "untimed.csv", "--figure", "history"},
                 {"give the rate by --rate of convert or in a comment line"});
}

TEST(plot, RefusesWhatCannotBeRead) {
  const Sandbox box({{"broken.csv", "amplitude [m],dissipation [J]\n-1,2\n"},
                     {"notes.txt", "nothing to draw"},
                     {"rig.toml", "schema = \"microslip.rig/1\"\n"}});
  expect_refused(box, {"plot", "nowhere.csv", "--figure", "energies"}, {"nowhere.csv"});
  expect_refused(box, {"plot", "broken.csv", "--figure", "energies"}, {"broken.csv:2:1"});
  expect_refused(box, {"plot", "notes.txt", "--figure", "energies"}, {"notes.txt"});
  expect_refused(box, {"plot", "rig.toml", "--figure", "energies"}, {"rig.toml"});
}

TEST(plot, AWindowOfAHistory) {
  const Sandbox box = sandbox();
  const std::string svg = svg_of(box, {"record.csv", "--figure", "history", "--time", "100ms:0.2"});
  expect_parts(svg, {number("0.14")});
  EXPECT_EQ(svg.find(number("0.3")), std::string::npos);
}

TEST(plot, LogarithmicLinearAndGrey) {
  const Sandbox box = sandbox();
  const std::string energies = svg_of(box, {"levels.csv", "--figure", "energies", "--linear"});
  expect_parts(energies, {number("100"), number("0")});
  const std::string grey = svg_of(box, {"joint.json", "--figure", "loops", "--grey"});
  EXPECT_EQ(grey.find("rgb(  0, 114, 178)"), std::string::npos) << "blue";
  EXPECT_GE(count(grey, "stroke-dasharray"), 3U);
}

// Names come from outside; in the picture they are texts and nothing else.
TEST(plot, HostileNamesAreInert) {
  const std::string name = "'\"; system('touch hacked') `touch hacked` @x <b>&";
  const Sandbox box = sandbox();
  box.put("record.csv",
          "time [s],\"`touch hacked`; set output 'x' $(ls) <b>& [m]\",b [m]\n0,0,1\n1,1,2\n");
  const std::string svg = svg_of(box, {"record.csv", "--figure", "history"});
  EXPECT_FALSE(box.has("hacked"));
  EXPECT_FALSE(box.has("x"));
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  box.put(name + ".json", kJointText);
  const std::string others =
      svg_of(box, {"joint.json", "--figure", "density", "--other", name + ".json"});
  EXPECT_FALSE(box.has("hacked"));
  expect_parts(others, {"touch hacked", "&lt;b>"});
}

/// The programs that a child finds.
class Path {
 public:
  explicit Path(const std::string& folders) : old_(std::getenv("PATH")) {
    setenv("PATH", folders.c_str(), 1);
  }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;
  ~Path() { setenv("PATH", old_.c_str(), 1); }

 private:
  std::string old_;
};

TEST(plot, WithoutGnuplotSaysSo) {
  const Sandbox box = sandbox();
  const auto before = box.content();
  const Path none(box.path());
  const Outcome run = box.run({"plot", "levels.csv", "--figure", "energies"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "microslip: gnuplot not found; install gnuplot-nox\n");
  EXPECT_TRUE(box.content() == before);
}

/// A gnuplot that never ends.
TEST(plot, InterruptedLeavesNothing) {
  const Sandbox box = sandbox();
  box.put("gnuplot", "#!/bin/sh\n: > started\nexec sleep 10\n");
  std::filesystem::permissions(box.file("gnuplot"), std::filesystem::perms::owner_all);
  const auto before = box.content();
  const Path slow(box.path() + ":/usr/bin:/bin");
  Running program({"plot", "levels.csv", "--figure", "energies"}, box.path(), {});
  while (!box.has("started") && !program.has_ended()) usleep(5000);
  ASSERT_FALSE(program.has_ended());
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().signal, SIGTERM);
  auto after = box.content();
  std::erase_if(after, [](const auto& file) { return file.first.ends_with("/started"); });
  EXPECT_TRUE(after == before);
}

}  // namespace
}  // namespace microslip::cli_test::plot_test
