// SPDX-License-Identifier: MIT
#include "microslip/io/output/output_folders.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::output_folders_test {
namespace {

namespace fs = std::filesystem;

TEST(OutputFolders, KeepThoseThatGotAFile) {
  const test::TemporaryFolder folder;
  {
    OutputFolders folders;
    folders.make(folder.file("a/used"));
    folders.make(folder.file("a/empty/empty"));
    folders.make(folder.file("a/used"));  // there by now
    test::put(folder.file("a/used/file"), "x");
  }
  EXPECT_TRUE(fs::exists(folder.file("a/used/file")));
  EXPECT_FALSE(fs::exists(folder.file("a/empty")));
}

TEST(OutputFolders, LeaveAloneWhatWasThere) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.file("there"));
  { OutputFolders().make(folder.file("there")); }
  EXPECT_TRUE(fs::exists(folder.file("there")));
}

TEST(OutputFolders, VanishWithTheirTemporaryFiles) {
  const test::TemporaryFolder folder;
  OutputFolders folders;
  folders.make(folder.file("a/b"));
  const Temporary file(folder.file("a/b/t"));
  test::put(file.path(), "x");
  remove_temporaries();  // as on an interrupt
  EXPECT_FALSE(fs::exists(folder.file("a")));
}

TEST(OutputFolders, RefuseTheNameOfAFile) {
  const test::TemporaryFolder folder;
  test::put(folder.file("file"), "x");
  OutputFolders folders;
  EXPECT_THROW(folders.make(folder.file("file")), FileError);
  EXPECT_THROW(folders.make(folder.file("file/below")), FileError);
}

}  // namespace
}  // namespace microslip::output_folders_test
