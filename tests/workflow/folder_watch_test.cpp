// SPDX-License-Identifier: MIT
#include "microslip/workflow/measure/folder_watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::folder_watch_test {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kStill{1000};

/// A folder that is looked at by a clock of the test's.
class Looked {
 public:
  Looked() : watch_(folder_.file("."), kStill, [](const std::string&) { return true; }) {}

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
  }
  void remove(const std::string& name) const { std::filesystem::remove(folder_.file(name)); }
  FolderChange after(int ms) {
    now_ += milliseconds(ms);
    return watch_.look(now_);
  }

 private:
  test::TemporaryFolder folder_;
  FolderWatch watch_;
  FolderWatch::Clock::time_point now_{};
};

TEST(FolderWatch, TakesAFileWhenItStandsStill) {
  Looked folder;
  EXPECT_FALSE(folder.after(0).any());
  folder.put("a.csv", "1");
  EXPECT_TRUE(folder.after(10).waiting);
  folder.put("a.csv", "1,2");  // still written
  EXPECT_FALSE(folder.after(990).any());
  EXPECT_FALSE(folder.after(500).any());
  const FolderChange whole = folder.after(600);
  EXPECT_EQ(whole.changed.size(), 1U);
  EXPECT_FALSE(whole.waiting);
  EXPECT_FALSE(folder.after(5000).any()) << "once";
  EXPECT_EQ(folder.after(10).whole.size(), 1U);
  folder.put("a.csv", "1,2,3");
  const FolderChange again = folder.after(10);
  EXPECT_TRUE(again.whole.empty());
  EXPECT_TRUE(again.waiting);
  EXPECT_EQ(folder.after(1000).changed.size(), 1U);
  folder.remove("a.csv");
  EXPECT_TRUE(folder.after(10).gone);
  EXPECT_FALSE(folder.after(10).any());
}

TEST(FolderWatch, LeavesTemporaryAndEmptyFilesAlone) {
  Looked folder;
  for (const std::string name : {".a.csv", "a.csv~", "a.csv.part", "a.tmp", "~$a.csv", "#a#"}) {
    EXPECT_TRUE(FolderWatch::is_temporary(name)) << name;
    folder.put(name, "1");
  }
  folder.put("empty.csv", "");
  EXPECT_FALSE(FolderWatch::is_temporary("a.csv"));
  EXPECT_FALSE(folder.after(0).waiting);
  EXPECT_FALSE(folder.after(5000).any());
}

TEST(FolderWatch, SaysThatThereIsNoFolder) {
  FolderWatch watch("/nowhere", kStill, [](const std::string&) { return true; });
  EXPECT_THROW((void)watch.look(), FileError);
}

}  // namespace
}  // namespace microslip::folder_watch_test
