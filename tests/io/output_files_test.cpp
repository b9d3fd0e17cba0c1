// SPDX-License-Identifier: MIT
#include "microslip/io/output/output_files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/table_stream.hpp"
#include "microslip/io/output/temporaries.hpp"

namespace microslip::output_files_test {
namespace {

namespace fs = std::filesystem;
using test::get;
using test::message_of;
using test::put;
using Names = std::vector<std::string>;

/// By which a table shows that it may be replaced.
const std::string kOwn = "# microslip 0.1.0: microslip identify\n";
const std::string kLevelsText = kOwn + "amplitude [m],dissipation [J]\n1,2\n";
const std::string kOtherLevels = kOwn + "amplitude [m],dissipation [J],source\n3,4,x\n";
const std::string kDensityText = kOwn + "slip_force [N],density [1/N]\n0,1\n";
const std::string kJointText = "{\"schema\": \"microslip.joint/1\"}";

std::string fault(const std::string& path, const std::string& content) {
  return message_of<FileError>([&] { return write_file(path, content), 0; });
}

TEST(OutputFiles, WritesAFile) {
  const test::TemporaryFolder folder;
  write_file(folder.file("levels.csv"), kLevelsText);
  EXPECT_EQ(get(folder.file("levels.csv")), kLevelsText);
  EXPECT_EQ(folder.names(), Names{"levels.csv"});
}

// An editor may have put blanks and carriage returns above the heading.
TEST(OutputFiles, KnowsAFileWithBlankLinesOfDosAboveItsHeading) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("levels.csv");
  put(path, "\t \r\n\r\n# note\r\n" + kOwn + "amplitude [m],dissipation [J]\r\n1,2\r\n");
  write_file(path, kLevelsText);
  EXPECT_EQ(get(path), kLevelsText);
}

// What a killed process left goes with the next file that is written there; what a living one works
// on stays.
TEST(OutputFiles, RemovesWhatAKilledProcessLeft) {
  const test::TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFiles files;
    files.add(folder.file("levels.csv"), kLevelsText);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(folder.names().size(), 1U) << "its temporary file";
  OutputFiles living;
  living.add(folder.file("first.csv"), kLevelsText);
  EXPECT_EQ(folder.names().size(), 1U) << "that of this process";
  living.commit();
  EXPECT_EQ(folder.names(), Names{"first.csv"});
}

// A march keeps its rows in a file of their own until it ends.
TEST(OutputFiles, RemovesTheRowsOfAKilledTable) {
  const test::TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    TableStream table(folder.file("march.csv"), "", "time [s]\n");
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(folder.names().size(), 2U) << "its temporary file and the rows";
  write_file(folder.file("levels.csv"), kLevelsText);
  EXPECT_EQ(folder.names(), Names{"levels.csv"});
}

TEST(OutputFiles, GivesTheUsualPermissions) {
  const test::TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_file(folder.file("levels.csv"), kLevelsText);
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat(folder.file("levels.csv").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(OutputFiles, ReplacesAFileOfItsKind) {
  const test::TemporaryFolder folder;
  put(folder.file("levels.csv"), kLevelsText);
  ASSERT_EQ(::chmod(folder.file("levels.csv").c_str(), 0604), 0);
  write_file(folder.file("levels.csv"), kOtherLevels);
  EXPECT_EQ(get(folder.file("levels.csv")), kOtherLevels);
  struct stat status {};
  ASSERT_EQ(::stat(folder.file("levels.csv").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0604U) << "permissions stay";
}

TEST(OutputFiles, ReplacesNoFileOfOthers) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("levels.csv");
  const std::string by_hand = "# of the microslip rig\namplitude [m],dissipation [J]\n1,2\n";
  put(path, by_hand);
  EXPECT_EQ(fault(path, kLevelsText),
            path +
                ": exists and was not written by microslip; it would be replaced. Move it away or "
                "choose another name.");
  EXPECT_THROW(check_output(path, kLevelsKind), FileError);
  EXPECT_THROW(check_output(path), FileError);
  EXPECT_NO_THROW(check_output(path, kLevelsKind, Replacing::kAny));
  EXPECT_NO_THROW(write_file(path, by_hand)) << "the very same";
  OutputFiles asked;
  put(asked.stage(path, Replacing::kAny), kOtherLevels);
  asked.commit();
  EXPECT_EQ(get(path), kOtherLevels);
}

TEST(OutputFiles, ReplacesNotEvenItsOwnByAnotherContent) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("levels.csv");
  put(path, kLevelsText);
  OutputFiles same;
  put(same.stage(path, Replacing::kSame), kLevelsText);
  EXPECT_NO_THROW(same.commit());
  OutputFiles other;
  put(other.stage(path, Replacing::kSame), kOtherLevels);
  EXPECT_EQ(message_of<FileError>([&] { return other.commit(), 0; }),
            path +
                ": exists and has another content; it would be replaced. Choose another name, or "
                "add `replace`.");
  EXPECT_EQ(get(path), kLevelsText);
}

TEST(OutputFiles, ReplacesAnEmptyFile) {
  const test::TemporaryFolder folder;
  put(folder.file("f"), "");
  write_file(folder.file("f"), kJointText);
  EXPECT_EQ(get(folder.file("f")), kJointText);
}

TEST(OutputFiles, WritesBehindALink) {
  const test::TemporaryFolder folder;
  put(folder.file("real"), kLevelsText);
  fs::create_symlink("real", folder.file("link"));
  write_file(folder.file("link"), kOtherLevels);
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_EQ(get(folder.file("real")), kOtherLevels);
}

TEST(OutputFilesFault, AnotherKind) {
  const test::TemporaryFolder folder;
  put(folder.file("levels.csv"), kLevelsText);
  EXPECT_EQ(
      fault(folder.file("levels.csv"), kJointText),
      folder.file("levels.csv") +
          ": exists and contains a table of levels; it would be replaced by microslip.joint/1. "
          "Remove it or choose another name.");
  EXPECT_EQ(get(folder.file("levels.csv")), kLevelsText);
  EXPECT_EQ(folder.names(), Names{"levels.csv"}) << "no temporary is left";
  put(folder.file("notes"), "My notes.\n1 2 3\n");
  EXPECT_NE(fault(folder.file("notes"), kJointText), "no error");
  put(folder.file("noise"), std::string("\0\1\2", 3));
  EXPECT_NE(fault(folder.file("noise"), std::string("\0\1\2", 3)).find("contains something else"),
            std::string::npos);
}

TEST(OutputFilesFault, Folder) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.file("d"));
  EXPECT_EQ(fault(folder.file("d"), kLevelsText),
            folder.file("d") + ": is a folder and cannot be replaced. Name a file in it.");
  EXPECT_NE(fault("", kLevelsText).find("is not a file name"), std::string::npos);
}

TEST(OutputFilesFault, SpecialFile) {
  EXPECT_EQ(
      fault("/dev/null", kLevelsText),
      "/dev/null: is not a regular file and cannot be replaced. Write to - and redirect standard "
      "output.");
}

TEST(OutputFilesFault, NoFolder) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(fault(folder.file("no/levels.csv"), kLevelsText),
            folder.file("no/levels.csv") + ": cannot be written: there is no folder '" +
                folder.file("no") + "'. Create it first.");
  put(folder.file("f"), "");
  EXPECT_EQ(fault(folder.file("f/levels.csv"), kLevelsText),
            folder.file("f/levels.csv") + ": cannot be written: '" + folder.file("f") +
                "' is not a folder. Choose another name.");
}

TEST(OutputFilesFault, Unwritable) {
  // The kernel's own tree: root too may create nothing here.
  EXPECT_EQ(fault("/proc/levels.csv", kLevelsText).find("/proc/levels.csv: cannot be written: "),
            0U)
      << fault("/proc/levels.csv", kLevelsText);
}

TEST(OutputFilesFault, NotPermitted) {
  const test::TemporaryFolder folder;
  put(folder.file("levels.csv"), kLevelsText);
  ASSERT_EQ(::chmod(folder.file("levels.csv").c_str(), 0444), 0);
  ASSERT_EQ(::chmod(folder.file("").c_str(), 0555), 0);
  {
    const test::Unprivileged unprivileged;
    EXPECT_EQ(fault(folder.file("new.csv"), kOtherLevels),
              folder.file("new.csv") +
                  ": cannot be written: Permission denied. Choose a folder that you may write to.");
  }
  ASSERT_EQ(::chmod(folder.file("").c_str(), 0777), 0);
  const test::Unprivileged unprivileged;
  EXPECT_EQ(fault(folder.file("levels.csv"), kOtherLevels),
            folder.file("levels.csv") +
                ": is not writable. Choose another name or change its permissions.");
}

TEST(OutputFilesFault, DeviceFull) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  const int before = ::dup(STDOUT_FILENO);
  std::fflush(stdout);
  ::dup2(::fileno(full), STDOUT_FILENO);
  const test::TemporaryFolder folder;
  const std::string message = message_of<FileError>([&] {
    OutputFiles files;
    files.add(folder.file("levels.csv"), kLevelsText);
    files.add("-", kDensityText);
    files.commit();
    return 0;
  });
  ::dup2(before, STDOUT_FILENO);
  ::close(before);
  std::fclose(full);
  EXPECT_EQ(message,
            "standard output: cannot be written: No space left on device. Free some space, or "
            "choose another folder.");
  EXPECT_EQ(folder.names(), Names{}) << "all or none";
}

TEST(OutputFilesFault, LinkToNothing) {
  const test::TemporaryFolder folder;
  fs::create_symlink("nothing", folder.file("link"));
  EXPECT_EQ(fault(folder.file("link"), kLevelsText),
            folder.file("link") + ": is a broken link. Remove it or choose another name.");
}

TEST(OutputFiles, WritesSeveralTogether) {
  const test::TemporaryFolder folder;
  put(folder.file("density.csv"), kDensityText);
  OutputFiles files;
  files.add(folder.file("joint.json"), kJointText);
  files.add(folder.file("density.csv"), kDensityText + "1,0\n");
  EXPECT_EQ(get(folder.file("density.csv")), kDensityText) << "nothing before commit()";
  files.commit();
  EXPECT_EQ(get(folder.file("joint.json")), kJointText);
  EXPECT_EQ(get(folder.file("density.csv")), kDensityText + "1,0\n");
  EXPECT_EQ(folder.names(), (Names{"density.csv", "joint.json"}));
}

TEST(OutputFiles, LeavesNothingWithoutCommit) {
  const test::TemporaryFolder folder;
  try {
    OutputFiles files;
    files.add(folder.file("joint.json"), kJointText);
    EXPECT_EQ(folder.names().size(), 1U);
    throw std::runtime_error("in between");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(OutputFiles, WritesNoneWhereOneIsRefused) {
  const test::TemporaryFolder folder;
  put(folder.file("density.csv"), kLevelsText);
  EXPECT_NE(message_of<FileError>([&] {
              OutputFiles files;
              files.add(folder.file("joint.json"), kJointText);
              files.add(folder.file("density.csv"), kDensityText);
              files.commit();
              return 0;
            }),
            "no error");
  EXPECT_EQ(folder.names(), Names{"density.csv"});
  EXPECT_EQ(get(folder.file("density.csv")), kLevelsText);
}

TEST(OutputFiles, TakesBackWhatIsPlacedWhereALaterOneFails) {
  const test::TemporaryFolder folder;
  put(folder.file("levels.csv"), kLevelsText);
  EXPECT_NE(message_of<FileError>([&] {
              OutputFiles files;
              files.add(folder.file("levels.csv"), kOtherLevels);
              files.add(folder.file("joint.json"), kJointText);
              fs::remove(files.stage(folder.file("third.mat")));
              files.commit();
              return 0;
            }),
            "no error");
  EXPECT_EQ(folder.names(), Names{"levels.csv"});
  EXPECT_EQ(get(folder.file("levels.csv")), kLevelsText);
}

TEST(OutputFiles, StagesForOtherWriters) {
  const test::TemporaryFolder folder;
  OutputFiles files;
  put(files.stage(folder.file("picture.png")), "\x89PNG\r\n\x1A\n...");
  files.commit();
  EXPECT_EQ(get(folder.file("picture.png")), "\x89PNG\r\n\x1A\n...");
  OutputFiles again;
  put(again.stage(folder.file("picture.png")), kJointText);
  EXPECT_NE(message_of<FileError>([&] { return again.commit(), 0; }).find("contains a PNG picture"),
            std::string::npos);
}

TEST(OutputFilesFault, OnePathTwice) {
  const test::TemporaryFolder folder;
  OutputFiles files;
  files.add(folder.file("a"), kJointText);
  EXPECT_EQ(message_of<FileError>([&] { return files.add(folder.file("./a"), kLevelsText), 0; }),
            folder.file("./a") + ": would be written twice. Choose different names.");
  files.add("-", kJointText);
  EXPECT_EQ(message_of<FileError>([&] { return files.add("-", kLevelsText), 0; }),
            "standard output: would be written twice. Name a file for one of them.");
}

TEST(OutputFiles, LeavesNothingWhenAllTemporariesAreRemoved) {
  const test::TemporaryFolder folder;
  OutputFiles files;
  files.add(folder.file("joint.json"), kJointText);
  remove_temporaries();
  EXPECT_EQ(folder.names(), Names{});
  EXPECT_NE(message_of<FileError>([&] { return files.commit(), 0; }), "no error");
}

TEST(OutputFiles, ChecksBeforehand) {
  const test::TemporaryFolder folder;
  put(folder.file("levels.csv"), kLevelsText);
  EXPECT_NO_THROW(check_output("-", kLevelsKind));
  EXPECT_NO_THROW(check_output(folder.file("levels.csv"), kLevelsKind));
  EXPECT_NO_THROW(check_output(folder.file("levels.csv")));
  EXPECT_THROW(check_output(folder.file("levels.csv"), kJointKind), FileError);
  EXPECT_THROW(check_output(folder.file("no/levels.csv")), FileError);
}

}  // namespace
}  // namespace microslip::output_files_test
