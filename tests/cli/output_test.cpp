// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

/// Where the results go: whole or not at all, and over nothing but their own kind.

namespace microslip::cli_test::output_test {
namespace {

namespace fs = std::filesystem;

Sandbox sandbox() {
  return Sandbox{{"levels.csv", sample_levels_text()}, {"joint.json", kJointText}};
}

Arguments identify_to(const std::string& joint, const std::string& density = {}) {
  Arguments all{"identify", "levels.csv", "--stiffness", "1.7e5", "--quiet", "--out", joint};
  if (!density.empty()) all.insert(all.end(), {"--density-csv", density});
  return all;
}

Arguments dissipation_to(const std::string& out) {
  return {"dissipation", "joint.json", "--amplitude", "1um:9um:3", "--out", out};
}

Arguments loop_to(const std::string& out) {
  return {"loop", "joint.json", "--amplitude", "9um", "--points", "3", "--out", out};
}

TEST(Output, WhereNothingCanBeWritten) {
  const Sandbox box = sandbox();
  fs::create_directory(box.file("folder"));
  for (const auto& call : {dissipation_to, loop_to}) {
    expect_refused(box, call("none/new.csv"), {"none/new.csv", "no folder 'none'", "Create"});
    expect_refused(box, call("folder"), {"folder", "is a folder", "Name a file in it"});
    expect_refused(box, call("."), {"is a folder"});
    expect_refused(box, call("joint.json/new.csv"), {"joint.json/new.csv", "is not a folder"});
    expect_refused(box, call("/dev/null"), {"/dev/null", "regular file", "Write to -"});
    expect_refused(box, call(""), {"''", "file name"});
    expect_refused(box, call(std::string(300, 'x')), {"File name too long", "shorter"});
  }
  expect_refused(box, identify_to("none/new.json"), {"none/new.json", "no folder 'none'"});
  expect_refused(box, identify_to("new.json", "none/d.csv"), {"none/d.csv", "no folder 'none'"});
  expect_refused(box, identify_to("new.json", "folder"), {"folder", "is a folder"});
}

TEST(Output, OverAFileOfAnotherKind) {
  const Sandbox box = sandbox();
  box.put("notes.txt", "do not lose me\n");
  box.put("rig.json", R"({"schema": "microslip.rig/1"})");
  expect_refused(box, dissipation_to("joint.json"), {"joint.json", "microslip.joint/1", "Remove"});
  expect_refused(box, dissipation_to("levels.csv"), {"levels.csv", "a table of levels"});
  expect_refused(box, loop_to("levels.csv"), {"levels.csv", "a table of levels"});
  expect_refused(box, identify_to("levels.csv"), {"levels.csv", "a table of levels"});
  expect_refused(box, identify_to("notes.txt"), {"notes.txt", "another name"});
  expect_refused(box, identify_to("rig.json"), {"rig.json", "microslip.rig/1"});
  expect_refused(box, identify_to("new.json", "levels.csv"), {"levels.csv", "a table of levels"});
  expect_refused(box, identify_to("new.json", "joint.json"), {"joint.json"});
}

TEST(Output, OverAFileOfItsKind) {
  const Sandbox box = sandbox();
  expect_done(box, identify_to("found.json", "density.csv"));
  const std::string joint = box.get("found.json");
  const std::string density = box.get("density.csv");
  expect_done(box, identify_to("found.json", "density.csv"));
  EXPECT_EQ(box.get("found.json"), joint);
  EXPECT_EQ(box.get("density.csv"), density);
  expect_done(box, dissipation_to("curve.csv"));
  expect_done(box, dissipation_to("curve.csv"));
  expect_done(box, loop_to("loop.csv"));
  expect_done(box, loop_to("loop.csv"));
  EXPECT_EQ(box.content().size(), 6U) << "no temporaries";
}

TEST(Output, OverAnEmptyFile) {
  const Sandbox box = sandbox();
  box.put("new.csv", "");
  expect_done(box, dissipation_to("new.csv"));
  EXPECT_GT(box.get("new.csv").size(), 100U);
}

TEST(Output, OfTwoFilesUnderOneName) {
  const Sandbox box = sandbox();
  fs::create_directory(box.file("sub"));
  expect_refused(box, identify_to("new", "new"), {"new", "written twice", "different names"});
  expect_refused(box, identify_to("new", "./new"), {"./new", "written twice"});
  expect_refused(box, identify_to("sub/../new", "new"), {"new", "written twice"});
  expect_refused(box, identify_to(box.file("new"), "new"), {"new", "written twice"});
  expect_refused(box, identify_to("-", "-"), {"standard output", "written twice"});
}

TEST(Output, ByAUserWithoutRights) {
  const Sandbox box = sandbox();  // writable for its owner alone
  fs::create_directory(box.file("closed"));
  box.put("old.csv", "");
  fs::permissions(box.file("old.csv"), fs::perms{0444});
  fs::permissions(box.file("closed"), fs::perms{0555});
  const Circumstances user{.unprivileged = true};
  if (box.run({"--version"}, user).status != 0) {
    GTEST_SKIP() << "other users may not run the program where it was built";
  }
  expect_refused(box, dissipation_to("closed/new.csv"),
                 {"closed/new.csv", "Permission denied", "Choose a folder"}, user);
  expect_refused(box, dissipation_to("old.csv"), {"old.csv"}, user);
  expect_refused(box, {"demo", "--out", "closed/demo"}, {"closed/demo", "Permission denied"}, user);
  fs::permissions(box.file("joint.json"), fs::perms::none);
  expect_refused(box, dissipation_to("-"),
                 {"joint.json", "Permission denied", "permission to read"}, user);
  fs::permissions(box.file("joint.json"), fs::perms::owner_all);
}

TEST(Output, OnAFullDevice) {
  const Sandbox box = sandbox();
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  if (full < 0) GTEST_SKIP() << "there is no /dev/full";
  const Circumstances how{.standard_output = full};
  expect_unwritten(box, dissipation_to("-"),
                   {"standard output", "No space left", "Free some space"}, how);
  expect_unwritten(box, identify_to("-", "density.csv"), {"standard output", "No space left"}, how);
  expect_unwritten(box, {"--help"}, {"standard output", "No space left"}, how);
  box.put("record.csv", sample_decay_text());
  expect_unwritten(box, {"convert", "record.csv", "--list"}, {"standard output"}, how);
  // The files are written, and only their summary is lost: that is neither a failure nor silent.
  const Arguments call{"identify", "levels.csv", "--stiffness", "1.7e5", "--out", "new.json"};
  for (const Circumstances& each : {how, Circumstances{.closed = {1}}}) {
    const Outcome run = box.run(call, each);
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("warning: the summary is lost: standard output"), std::string::npos)
        << run.err;
    EXPECT_TRUE(box.has("new.json"));
  }
  ::close(full);
}

TEST(Output, WithoutStandardFiles) {
  const Sandbox box = sandbox();
  EXPECT_EQ(box.run(dissipation_to("new.csv"), {.closed = {0, 1, 2}}).status, 0);
  EXPECT_TRUE(box.has("new.csv"));
  EXPECT_EQ(box.run(dissipation_to("none/new.csv"), {.closed = {0, 1, 2}}).status, 2);
  EXPECT_EQ(box.run(dissipation_to("-"), {.closed = {1}}).status, 1);
  EXPECT_EQ(box.run({"bogus"}, {.closed = {2}}).status, 2);
}

TEST(Output, LeavesALinkALink) {
  const Sandbox box = sandbox();
  fs::create_directory(box.file("results"));
  fs::create_symlink("results/curve.csv", box.file("link.csv"));
  expect_refused(box, dissipation_to("link.csv"), {"link.csv", "broken link"});
  box.put("results/curve.csv", "");
  expect_done(box, dissipation_to("link.csv"));
  EXPECT_TRUE(fs::is_symlink(box.file("link.csv")));
  EXPECT_GT(box.get("results/curve.csv").size(), 100U);
}

TEST(Output, TakesNamesOfAllSorts) {
  const Sandbox box = sandbox();
  for (const std::string name : {"with blank.csv", "Straße µ.csv", "quote'\".csv", "--x.csv",
                                 "line\nbreak.csv", "not utf-8 \xFF.csv"}) {
    const bool option_like = name.starts_with("--");
    expect_done(box, dissipation_to(option_like ? "./" + name : name));
    EXPECT_TRUE(box.has(name)) << name;
  }
  expect_done(box, identify_to("not utf-8 \xFF.json"));
  EXPECT_EQ(parse_joint(box.get("not utf-8 \xFF.json"), "f").joint.stiffness(), 1.7e5)
      << "the name is in the provenance";
}

}  // namespace
}  // namespace microslip::cli_test::output_test
