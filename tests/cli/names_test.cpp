// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/bytes/unicode.hpp"
#include "support/replaced.hpp"

/// Names of files that a terminal would obey, a spreadsheet compute, or a table not hold.

namespace microslip::cli_test::names_test {
namespace {

bool says(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

const std::string kRecording = "time [s],force [N]\n0,1\n0.1,2\n0.2,1\n";

// ESC, DEL, CSI as one character, a right-to-left override, an isolate, an Arabic mark, a byte that
// is no UTF-8.
TEST(Names, ThatATerminalObeysAreWrittenOut) {
  for (const std::string_view bad :
       {"\x1B[31m", "\x7F", "\xC2\x9B", "\xE2\x80\xAE", "\xE2\x81\xA6", "\xD8\x9C", "\xFC"}) {
    const std::string name = "a" + std::string(bad) + "b.csv";
    const Sandbox box{{name, kRecording}, {"d" + name, sample_decay_text()}};
    std::vector<Arguments> calls{
        {"convert", name, "--list"},
        {"convert", name, "out" + name},
        {"identify", name, "--stiffness", "1e5", "--out", "j.json"},
        {"identify", "none" + name, "--stiffness", "1e5", "--out", "j.json"}};
    const bool in_table = bad == "\xE2\x80\xAE" || bad == "\xFC";
    if (in_table) {
      calls.push_back({"ringdown", "d" + name, "--modal-mass", "1", "--out", "decays.csv"});
    }
    for (const Arguments& call : calls) {
      const Outcome run = box.run(call);
      EXPECT_FALSE(says(run.out, bad) || says(run.err, bad)) << typed(call) << run.out << run.err;
    }
    if (!in_table) continue;
    ASSERT_TRUE(box.has("decays.csv"));
    const std::string table = box.get("decays.csv");
    EXPECT_FALSE(says(table, bad)) << table;
    EXPECT_EQ(valid_utf8(table), table.size());
  }
}

TEST(Names, ThatAreNoFormulaInATable) {
  const Sandbox box;
  const std::string rig = MICROSLIP_EXAMPLES "/reference_rig/";
  box.put("rig.toml", test::get(rig + "rig.toml"));
  for (const std::string name : {"=1+1.csv", "+1.csv", "-2.csv", "@SUM(A1).csv", "'=2.csv"}) {
    box.put(name, test::get(rig + "recordings/level_05.csv"));
    const std::string file = name.starts_with('-') ? "./" + name : name;
    ASSERT_EQ(box.run({"reduce", "rig.toml", file, "--out", "r.csv", "--quiet"}).status, 0) << name;
    const std::string table = box.get("r.csv");
    EXPECT_FALSE(says(table, "\n" + name) || says(table, "," + name)) << table;
  }
  // Channels of recordings come back as they were.
  const std::string channels = "time [s],=1+1 [N],+Z [m],-X [1],@a [1]\n0,1,1,1,1\n1,2,2,2,2\n";
  const Sandbox other{{"in.csv", channels}};
  ASSERT_EQ(other.run({"convert", "in.csv", "out.csv"}).status, 0);
  EXPECT_TRUE(other.get("out.csv").starts_with("time [s],'=1+1 [N],'+Z [m],'-X [1],'@a [1]\n"))
      << other.get("out.csv");
  ASSERT_EQ(other.run({"convert", "out.csv", "again.csv"}).status, 0);
  EXPECT_EQ(other.get("again.csv"), other.get("out.csv"));
  EXPECT_TRUE(says(other.run({"convert", "out.csv", "--list"}).out, "\n  =1+1: force, N"));
}

TEST(Names, OfCopiesAreNamed) {
  const Sandbox box{{"a.csv", sample_levels_text()},
                    {"b.csv", sample_levels_text()},
                    {"one.csv", record_text(sample_record())},
                    {"two.csv", record_text(sample_record())}};
  const std::string warning = "b.csv has the same content as a.csv";
  box.put("c.csv", "# another\n" + sample_levels_text());
  const Arguments identify{"identify", "a.csv", "b.csv", "c.csv", "--stiffness", "1.7e5"};
  const Outcome levels = box.run(with(identify, {"--out", "j.json"}));
  EXPECT_TRUE(says(levels.out, "same content")) << levels.out << levels.err;
  EXPECT_TRUE(says(box.get("j.json"), warning));
  ASSERT_EQ(
      box.run(with(identify, {"--assemblies", "files", "--samples", "100", "--out", "t"})).status,
      0);
  EXPECT_TRUE(says(box.get("t/assemblies.csv"), "# warning: same_content: " + warning));
  EXPECT_EQ(box.run({"levels", "one.csv", "two.csv", "--out", "l.csv"}).status, 0);
  EXPECT_TRUE(says(box.get("l.csv"), "two.csv has the same content as one.csv"));
  box.put("rig.toml", test::get(MICROSLIP_EXAMPLES "/reference_rig/rig.toml"));
  for (const char* name : {"l1.csv", "l2.csv"}) {
    box.put(name, test::get(MICROSLIP_EXAMPLES "/reference_rig/recordings/level_05.csv"));
  }
  EXPECT_EQ(box.run({"reduce", "rig.toml", "l1.csv", "l2.csv", "--out", "r.csv"}).status, 0);
  EXPECT_TRUE(says(box.get("r.csv"), "l2.csv has the same content as l1.csv"));
}

}  // namespace
}  // namespace microslip::cli_test::names_test
