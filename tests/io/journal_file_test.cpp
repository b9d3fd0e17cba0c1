// SPDX-License-Identifier: MIT
#include "microslip/documents/study/journal_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <barrier>
#include <csignal>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/io/output/write_error.hpp"

namespace microslip::journal_file_test {
namespace {

/// Blocks 0, 1, … of different sizes, one of them empty.
std::string content_of(std::size_t block) {
  return std::string(block * 37 % 101, static_cast<char>('a' + block % 26));
}

constexpr std::size_t kBlocks = 6;

std::string written(const std::string& path) {
  {
    JournalWriter journal(path, "of a test\n");
    for (std::size_t i = 0; i < kBlocks; ++i) journal.append(i, content_of(i));
  }
  return test::get(path);
}

/// Those that are there are as they were written.
void expect_whole(const JournalReader& journal) {
  EXPECT_EQ(journal.heading(), "of a test\n");
  for (const JournalBlock& block : journal.blocks()) {
    EXPECT_EQ(journal.content(block), content_of(block.number));
  }
}

TEST(Journal, KeepsWhatIsAppended) {
  const test::TemporaryFolder folder;
  (void)written(folder.file("j"));
  const JournalReader journal(folder.file("j"));
  ASSERT_EQ(journal.blocks().size(), kBlocks);
  expect_whole(journal);
}

// A stop may cut it at any byte: whole blocks stay, and the writer goes on behind them, so that the
// end is the same to the byte.
TEST(Journal, GoesOnFromAnyByte) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("j");
  const std::string whole = written(path);
  const std::size_t heading = JournalReader(path).blocks().front().offset - 32;
  for (std::size_t size = heading; size < whole.size(); ++size) {
    test::put(path, whole.substr(0, size));
    {
      JournalWriter journal(path, "of a test\n");
      const std::size_t done = JournalReader(path).blocks().size();
      expect_whole(JournalReader(path));
      for (std::size_t i = done; i < kBlocks; ++i) journal.append(i, content_of(i));
    }
    ASSERT_EQ(test::get(path), whole) << "cut at " << size;
  }
}

// A heading that is not whole is no journal: it is written under another name first, so that only
// damage makes it so.
TEST(Journal, RefusesADamagedHeading) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("j");
  const std::string whole = written(path);
  for (const std::size_t size : {std::size_t{5}, std::size_t{20}, std::size_t{25}}) {
    test::put(path, whole.substr(0, size));
    EXPECT_THROW(JournalReader{path}, FormatError) << size;
  }
  test::put(path, "something else\n");
  EXPECT_THROW((JournalWriter{path, "of a test\n"}), Error);
  EXPECT_EQ(test::get(path), "something else\n");
}

// A bit that turned: that block does not count, others do.
TEST(Journal, LeavesOutADamagedBlock) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("j");
  std::string text = written(path);
  const JournalBlock block = JournalReader(path).blocks().at(2);
  text[block.offset + 3] ^= 1;
  test::put(path, text);
  const JournalReader journal(path);
  ASSERT_EQ(journal.blocks().size(), kBlocks - 1);
  expect_whole(journal);
  for (const JournalBlock& one : journal.blocks()) EXPECT_NE(one.number, 2U);
}

// Damage anywhere never brings a block that was not written, and never throws.
TEST(Journal, SurvivesAnyDamage) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("j");
  const std::string whole = written(path);
  const std::size_t heading = JournalReader(path).blocks().front().offset - 32;
  RandomStream random(1, 0);
  for (int trial = 0; trial < 300; ++trial) {
    std::string text = whole;
    for (int k = 0; k < 3; ++k) {
      const auto at = heading + static_cast<std::size_t>(
                                    random.uniform() * static_cast<double>(text.size() - heading));
      text[at] = static_cast<char>(256.0 * random.uniform());
    }
    test::put(path, text);
    expect_whole(JournalReader(path));
  }
}

TEST(Journal, HasOneWriter) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("j");
  const JournalWriter first(path, "of a test\n");
  EXPECT_THROW((JournalWriter{path, "of a test\n"}), FileError);
}

// Of two that begin at once one gets it, and what it appends is in the file of that name.
TEST(Journal, HasOneWriterOfTwoThatBeginAtOnce) {
  const test::TemporaryFolder folder;
  for (int round = 0; round < 50; ++round) {
    const std::string path = folder.file("j" + std::to_string(round));
    std::barrier<> begin(2);
    std::barrier<> end(2);
    std::atomic<int> writers = 0;
    const auto write = [&] {
      begin.arrive_and_wait();
      std::unique_ptr<JournalWriter> journal;
      try {
        journal = std::make_unique<JournalWriter>(path, "of a test\n");
        journal->append(1, "content");
        ++writers;
      } catch (const FileError&) {
        // The other one has it.
      }
      end.arrive_and_wait();
    };
    std::thread other(write);
    write();
    other.join();
    EXPECT_EQ(writers, 1);
    EXPECT_EQ(JournalReader(path).blocks().size(), 1U);
  }
}

/// No file becomes larger than this while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    signal_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }

 private:
  rlimit before_{};
  void (*signal_)(int) = SIG_DFL;
};

// A full disk, played by a limit of the size of files: what was appended before stays, of the rest
// nothing.
TEST(Journal, KeepsItsBlocksOnAFullDisk) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("j");
  const std::string whole = written(path);
  {
    JournalWriter journal(path, "of a test\n");
    const FileSizeLimit limit(whole.size() + 40);
    EXPECT_THROW(journal.append(6, std::string(100, 'x')), WriteError);
    journal.append(7, "");
  }
  const JournalReader journal(path);
  EXPECT_EQ(journal.blocks().size(), kBlocks + 1);
  EXPECT_EQ(test::get(path).substr(0, whole.size()), whole);
}

TEST(Journal, IsFoundBesideItsResult) {
  const test::TemporaryFolder folder;
  for (const char* name : {"r.h5.journal", "r.h5.2-of-3.journal", "r.h5.x.journal", "r.h5",
                           "r.h5.1-of-.journal", "other.h5.journal", "r.h5journal"}) {
    test::put(folder.file(name), "x");
  }
  test::put(folder.file("r.h5.1-of-3.journal"), "");  // just made
  EXPECT_EQ(
      journals_beside(folder.file("r.h5")),
      (std::vector<std::string>{folder.file("r.h5.2-of-3.journal"), folder.file("r.h5.journal")}));
  EXPECT_EQ(journal_path("r.h5", "2-of-3"), "r.h5.2-of-3.journal");
}

}  // namespace
}  // namespace microslip::journal_file_test
