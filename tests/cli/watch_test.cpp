// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/bytes/sha256.hpp"

/// A test that is running: records come one by one, some of them broken, and it is stopped.

namespace microslip::cli_test::watch_test {
namespace {

namespace fs = std::filesystem;

const std::string kRig = MICROSLIP_EXAMPLES "/reference_rig/";

std::string level_name(int level) {
  return "level_" + std::string(level < 10 ? "0" : "") + std::to_string(level) + ".csv";
}

void add_record(const Sandbox& box, int level) {
  fs::copy_file(kRig + "recordings/" + level_name(level), box.file(level_name(level)));
}

/// Nothing is said of time: it is waited for until it is so, or the program has ended.
bool comes(const Running& program, const std::function<bool()>& so) {
  for (int i = 0; i < 3000 && !program.has_ended(); ++i) {
    if (so()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return so();
}

long rows_of(const Sandbox& box, const std::string& name) {
  if (!box.has(name)) return 0;
  const std::string text = box.get(name);
  long rows = -1;  // the header
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) rows += text[at] != '#';
  return rows;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Whether so many levels are evaluated to the end: the plan, the last that is written, names the
/// levels that it rests on.
bool evaluated(const Sandbox& box, long levels) {
  if (rows_of(box, "levels.csv") != levels || !box.has("next_levels.csv")) return false;
  return says(box.get("next_levels.csv"), sha256(box.get("levels.csv")));
}

const Arguments kWatch{"watch", ".", "--interval", "0.1", "--no-report"};

TEST(watch, EvaluatesRecordsOfARigAsTheyCome) {
  const Sandbox box;
  fs::copy_file(kRig + "rig.toml", box.file("rig.toml"));
  for (int i = 1; i <= 8; ++i) add_record(box, i);
  Running program(kWatch, box.path(), {});
  ASSERT_TRUE(comes(program, [&] { return evaluated(box, 8); }));
  // Half a record is named and left out, and taken when it is whole.
  const std::string whole = test::get(kRig + "recordings/" + level_name(10));
  box.put(level_name(10), "time [s],force [N],acc1 [m/s^2]\n0,1,2\n0.1,not yet");
  add_record(box, 11);
  ASSERT_TRUE(comes(program, [&] { return evaluated(box, 9); }));
  box.put(level_name(10), whole);
  ASSERT_TRUE(comes(program, [&] { return evaluated(box, 10); }));
  box.put(".level_12.csv.tmp", whole);  // somebody is copying it
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  program.send(SIGINT);
  const Outcome ended = program.wait();
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(says(ended.out, "level_08.csv: A = ")) << ended.out;
  EXPECT_TRUE(says(ended.out, "level_10.csv: A = ")) << ended.out;
  EXPECT_TRUE(says(ended.out, "next: ")) << ended.out;
  EXPECT_TRUE(says(ended.err, "level_10.csv")) << ended.err;
  EXPECT_TRUE(says(ended.err, "Left out until it changes")) << ended.err;
  for (const std::string name : {"levels.csv", "joint.json", "density.csv", "next_levels.csv"}) {
    EXPECT_TRUE(box.has(name)) << name;
  }
  EXPECT_EQ(box.content().size(), 1U + 10U + 1U + 4U) << "nothing half-written is left";
}

TEST(watch, TakesTablesOfLevelsAndRecordsOfForce) {
  const Sandbox box{{"levels.csv", sample_levels_text()}};
  const Outcome once =
      box.run(with(kWatch, {"--once", "--stiffness", "1.7e5", "--target", "area"}));
  EXPECT_EQ(once.status, 0) << once.err;
  EXPECT_TRUE(says(once.out, "levels.csv: 20 levels")) << once.out;
  EXPECT_TRUE(says(once.out, "the width of the area")) << once.out;
  EXPECT_EQ(box.get("levels.csv"), sample_levels_text()) << "an input stays as it is";
  const Sandbox other{{"record.csv", record_text(sample_record())}};
  const Outcome record = other.run(with(kWatch, {"--once"}));
  EXPECT_EQ(record.status, 0) << record.err;
  EXPECT_TRUE(says(record.out, "record.csv: 1 record of force and displacement")) << record.out;
  EXPECT_TRUE(says(record.out, "joint: k = ")) << record.out;
  EXPECT_TRUE(other.has("joint.json"));
}

// A plan holds for the joint that it was made with: with a second table there is none, and the old
// one does not stay.
TEST(watch, LeavesNoPlanOfAnEarlierJoint) {
  const Sandbox box{{"levels.csv", sample_levels_text()}};
  const Arguments call = with(kWatch, {"--once", "--stiffness", "1.7e5"});
  EXPECT_EQ(box.run(call).status, 0);
  EXPECT_TRUE(box.has("next_levels.csv"));
  box.put("more_levels.csv", sample_levels_text());
  const Outcome two = box.run(call);
  EXPECT_EQ(two.status, 0) << two.err;
  EXPECT_TRUE(says(two.out, "next: next_levels.csv was for the previous joint")) << two.out;
  EXPECT_FALSE(box.has("next_levels.csv"));
  EXPECT_TRUE(box.has("joint.json"));
}

// What comes back from a reader need not end in a full stop.
TEST(watch, SaysFaultsInSentences) {
  const Sandbox box{{"record.csv", record_text(sample_record())}, {"broken.mat", "garbage"}};
  const Outcome once = box.run(with(kWatch, {"--once"}));
  EXPECT_TRUE(says(once.err, ". Left out until it changes.")) << once.err;
}

TEST(watch, CountsALinkToARecordOnce) {
  const Sandbox box{{"record.csv", record_text(sample_record())}};
  fs::create_symlink("record.csv", box.file("same.csv"));
  const Outcome once = box.run(with(kWatch, {"--once"}));
  EXPECT_TRUE(says(once.err, "same.csv: the same file as record.csv. Left out until it changes."))
      << once.err;
  EXPECT_TRUE(says(once.out, "record.csv: 1 record")) << once.out;
  EXPECT_FALSE(says(once.out, "same.csv: ")) << once.out;
}

// It has no --allow-truncated: a record that is short is most often being written.
TEST(watch, AdvisesWhatCanBeDoneWithACutRecord) {
  const Sandbox box{{"cut.csv", record_text(sample_record()) + "9,1"}};
  const Outcome once = box.run(with(kWatch, {"--once"}));
  EXPECT_TRUE(says(once.err, "`microslip convert cut.csv whole_cut.csv --allow-truncated`"))
      << once.err;
  EXPECT_EQ(box.run({"convert", "cut.csv", "whole_cut.csv", "--allow-truncated"}).status, 0);
  EXPECT_TRUE(says(box.run(with(kWatch, {"--once"})).out, "whole_cut.csv: 1 record"));
}

TEST(watch, SaysThatNothingIsThere) {
  const Sandbox box{};
  const Outcome once = box.run(with(kWatch, {"--once"}));
  EXPECT_EQ(once.status, 0) << once.err;
  EXPECT_EQ(once.out, ".: no record yet\n");
  EXPECT_EQ(box.run(with(kWatch, {"--once", "--quiet"})).out, "");
}

TEST(watch, WritesAReport) {
  const Sandbox box{{"levels.csv", sample_levels_text()}};
  const Arguments call{"watch", ".", "--interval", "0.1", "--once", "--stiffness", "1.7e5"};
  EXPECT_EQ(box.run(call).status, 0);
  EXPECT_TRUE(says(box.get("watch.html"), "microslip watch"));
  EXPECT_EQ(box.run(call).status, 0) << "it replaces what it wrote";
}

TEST(watch, FailsWhereNothingCanBeWritten) {
  const Sandbox box{{"levels.csv", sample_levels_text()}};
  const Arguments call{"watch", ".", "--interval", "0.1", "--once", "--stiffness", "1.7e5"};
  const Outcome nothing = box.run(with(call, {"--no-report"}), {.file_size = 1000});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_TRUE(says(nothing.err, "joint.json: cannot be written")) << nothing.err;
  EXPECT_FALSE(box.has("joint.json"));
  // Its report alone has more than 100 kB.
  const Outcome no_report = box.run(call, {.file_size = 100'000});
  EXPECT_EQ(no_report.status, 1);
  EXPECT_TRUE(says(no_report.err, "watch.html is not written")) << no_report.err;
  EXPECT_TRUE(box.has("joint.json"));
}

TEST(watch, ReplacesNothingOfOthers) {
  for (const std::string name : {"joint.json", "watch.html", "density.csv", "next_levels.csv"}) {
    const Sandbox box{{"record.csv", record_text(sample_record())}, {name, kJointText}};
    expect_refused(box, with(kWatch, {"--once"}), {name, "there already", "Move it away"});
  }
  const Sandbox rig{{"rig.toml", test::get(kRig + "rig.toml")},
                    {"levels.csv", sample_levels_text()}};
  expect_refused(rig, with(kWatch, {"--once"}), {"levels.csv", "there already"});
  const Sandbox odd{{"record.csv", record_text(sample_record())}};
  ASSERT_EQ(::mkfifo(odd.file("joint.json").c_str(), 0600), 0);
  const Outcome pipe = odd.run(with(kWatch, {"--once"}));
  EXPECT_EQ(pipe.status, 2) << pipe.err;
  EXPECT_TRUE(says(pipe.err, "joint.json") && says(pipe.err, "there already")) << pipe.err;
}

TEST(watch, SaysWhatIsAtFault) {
  const Sandbox box{{"levels.csv", sample_levels_text()}};
  const Outcome unknown = box.run(with(kWatch, {"--once"}));
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(says(unknown.err, "--stiffness") && says(unknown.err, "missing")) << unknown.err;
  EXPECT_FALSE(box.has("joint.json"));
  expect_refused(box, {"watch", "nowhere"}, {"nowhere", "is not a folder"});
  expect_refused(box, {"watch", ".", "--interval", "0"}, {"--interval"});
  const Sandbox empty;
  EXPECT_EQ(empty.run(with(kWatch, {"--once"})).status, 0);
  const Sandbox broken{{"record.csv", "time [s],force [N]\n0,x\n"}};
  const Outcome ended = broken.run(with(kWatch, {"--once"}));
  EXPECT_EQ(ended.status, 0);
  EXPECT_TRUE(says(ended.err, "record.csv")) << ended.err;
}

TEST(watch, EndsWhereItIsStopped) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Sandbox box;
    Running program(kWatch, box.path(), {});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_FALSE(program.has_ended());
    program.send(signal);
    EXPECT_EQ(program.wait().status, 0);
  }
}

}  // namespace
}  // namespace microslip::cli_test::watch_test
