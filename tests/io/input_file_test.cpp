// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/input_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>

#include "io/support.hpp"

namespace microslip::input_file_test {
namespace {

using test::message_of;
using test::put;

TEST(InputFile, ReadsAllBytes) {
  const test::TemporaryFolder folder;
  for (const std::size_t size : {0U, 1U, 65535U, 65536U, 65537U, 1000000U}) {
    std::string content(size, '\0');
    for (std::size_t i = 0; i < size; ++i) content[i] = static_cast<char>(i % 251);
    put(folder.file("f"), content);
    EXPECT_EQ(read_file(folder.file("f")), content);
    EXPECT_EQ(read_file_head(folder.file("f"), 100), content.substr(0, 100));
  }
}

TEST(InputFile, ReadsATextToItsFirstZero) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("f");
  for (const std::size_t size : {0U, 1U, 4095U, 4096U, 1048575U, 1048576U, 3000000U}) {
    const std::string text(size, 'x');
    put(path, text);
    EXPECT_EQ(read_text(path), text);
  }
  // A hole of 8 GiB, which no block after the first is read of.
  put(path, "a,b\n1,2\n");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 33U);
  EXPECT_EQ(message_of<FormatError>([&] { return read_text(path); }),
            path + ":3:1: expected text, found the byte 0x00. Is this a text table?");
  EXPECT_EQ(message_of<FileError>([&] { return read_text(path, 1000); }),
            path + ": is larger than 1000 bytes. Is it the right file?");
}

TEST(InputFile, ReadsAPipe) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const std::string content(300000, 'x');
  std::thread writer([&] { put(path, content); });
  EXPECT_EQ(read_file(path), content);
  writer.join();
}

TEST(InputFile, ReadsStandardInput) {
  const test::TemporaryFolder folder;
  put(folder.file("f"), "content");
  const int before = ::dup(STDIN_FILENO);
  const int file = ::open(folder.file("f").c_str(), O_RDONLY);
  ::dup2(file, STDIN_FILENO);
  EXPECT_EQ(read_file("-"), "content");
  ::dup2(before, STDIN_FILENO);
  ::close(before);
  ::close(file);
  EXPECT_EQ(input_name("-"), "standard input");
}

TEST(InputFileFault, Missing) {
  EXPECT_EQ(message_of<FileError>([] { return read_file("no/such.csv"); }),
            "no/such.csv: cannot be read: No such file or directory. Check the path.");
  EXPECT_EQ(message_of<FileError>([] { return read_file(""); }),
            ": cannot be read: No such file or directory. Check the path.");
  EXPECT_EQ(message_of<FileError>([] { return read_file(std::string("a\0b", 3)); }),
            "a: cannot be read: the path contains a zero byte");
}

TEST(InputFileFault, Folder) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(message_of<FileError>([&] { return read_file(folder.file("")); }),
            folder.file("") + ": is a folder. Name a file in it.");
}

TEST(InputFileFault, NotAFolder) {
  const test::TemporaryFolder folder;
  put(folder.file("f"), "");
  EXPECT_EQ(message_of<FileError>([&] { return read_file(folder.file("f/g")); }),
            folder.file("f/g") +
                ": cannot be read: Not a directory. A part of the path is a file, not a folder.");
}

TEST(InputFileFault, NotPermitted) {
  const test::TemporaryFolder folder;
  put(folder.file("f"), "x");
  std::filesystem::permissions(folder.file("f"), std::filesystem::perms::none);
  const test::Unprivileged unprivileged;
  EXPECT_EQ(message_of<FileError>([&] { return read_file(folder.file("f")); }),
            folder.file("f") + ": cannot be read: Permission denied. Get permission to read it.");
}

TEST(InputFileFault, TooLarge) {
  const test::TemporaryFolder folder;
  put(folder.file("f"), std::string(100, 'x'));
  EXPECT_EQ(read_file(folder.file("f"), 100).size(), 100U);
  EXPECT_EQ(message_of<FileError>([&] { return read_file(folder.file("f"), 99); }),
            folder.file("f") + ": is larger than 99 bytes. Is it the right file?");
  EXPECT_EQ(message_of<FileError>([] { return read_file("/dev/zero", 1000000); }),
            "/dev/zero: is larger than 1000000 bytes. Is it the right file?");
}

}  // namespace
}  // namespace microslip::input_file_test
