// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/test_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"

namespace microslip::test_file_test {
namespace {

using test::message_of;

const std::string kLevels = "amplitude [m],dissipation [J]\n1e-5,1e-6\n";
const std::string kSweep =
    "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n80,1,2,-1\n81,1,3,-2\n";

class TestFileTest : public ::testing::Test {
 protected:
  TestFile opened(const std::string& content) {
    test::put(path_, content);
    return open_test(path_);
  }

  const test::TemporaryFolder folder_;
  const std::string path_ = folder_.file("x.csv");
};

TEST_F(TestFileTest, IsRecognisedByItsContent) {
  EXPECT_EQ(opened(kLevels).content, TestContent::kLevels);
  EXPECT_EQ(opened("mode [1],displacement [m],dissipation [J]\n1,1,1\n").content,
            TestContent::kModalLevels);
  EXPECT_EQ(opened(kSweep).content, TestContent::kSteppedSine);
  EXPECT_EQ(opened("time [s],force [N]\n0,1\n").content, TestContent::kRecording);
  EXPECT_EQ(opened("").content, TestContent::kRecording) << "which its reader refuses";
  const TestFile joint = opened(R"({"schema": "microslip.joint/1"})");
  EXPECT_EQ(joint.content, TestContent::kOther);
  EXPECT_EQ(joint.kind, "microslip.joint/1");
}

TEST_F(TestFileTest, HasTheTextOfATableAndTheHashOfAll) {
  const std::string long_levels = kLevels + std::string(200'000, '\n') + "2e-5,2e-6\n";
  const TestFile levels = opened(long_levels);
  EXPECT_EQ(levels.text, long_levels);
  EXPECT_EQ(text_of(levels), long_levels);
  EXPECT_EQ(levels.sha256, sha256(long_levels));
  const std::string long_record = "time [s],force [N]\n" + std::string(200'000, '1') + ",1\n";
  const TestFile record = opened(long_record);
  EXPECT_LT(record.text.size(), long_record.size()) << "its first bytes alone";
  EXPECT_EQ(record.sha256, sha256(long_record));
  EXPECT_EQ(record.format, RecordingFormat::kCsv);
  EXPECT_EQ(read_stepped_sines(opened(kSweep)).at(0).frequency, (std::vector<double>{80.0, 81.0}));
}

// Which variable of a MATLAB file is meant need not be said where only one can be.
TEST_F(TestFileTest, FindsTheOnlySweepOfAMatlabFile) {
  const std::string data = std::string(MICROSLIP_TEST_DATA) + "/mat/";
  const TestFile alone = open_test(data + "sweep.mat");
  ASSERT_EQ(alone.content, TestContent::kSteppedSine);
  EXPECT_EQ(read_stepped_sines(alone).at(0).frequency, (std::vector<double>{80.0, 81.0}));
  EXPECT_EQ(alone.sha256, open_test(data + "sweep.mat:Sweep").sha256);
  EXPECT_EQ(open_test(data + "two_sweeps.mat").content, TestContent::kRecording);
  EXPECT_EQ(open_test(data + "plain5.mat").content, TestContent::kRecording);
}

TEST_F(TestFileTest, HasTheFormatOfARecording) {
  const TestFile hdf5 = opened(std::string(512, ' ') + std::string("\x89HDF\r\n\x1A\n\0\0", 10));
  EXPECT_EQ(hdf5.format, RecordingFormat::kHdf5) << "behind a user block";
  const std::string mat = std::string(MICROSLIP_TEST_DATA) + "/mat/plain5.mat";
  EXPECT_EQ(open_test(mat).format, RecordingFormat::kMat);
  const TestFile zip = opened(std::string("PK\x03\x04", 4) + std::string(100, 'x'));
  EXPECT_FALSE(zip.format);
  EXPECT_EQ(zip.sha256, "") << "nobody reads it";
}

TEST_F(TestFileTest, TakesNothingOfAPipeOrADevice) {
  const std::string pipe = folder_.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero")}) {
    const TestFile file = open_test(path);  // would wait for a writer, or for ever
    EXPECT_TRUE(file.once) << path;
    EXPECT_EQ(file.content, TestContent::kRecording);
    EXPECT_EQ(file.sha256, "");
  }
}

TEST_F(TestFileTest, LeavesStandardInputWhereItWas) {
  test::put(path_, kSweep);
  const int before = ::dup(STDIN_FILENO);
  const int file = ::open(path_.c_str(), O_RDONLY);
  ::dup2(file, STDIN_FILENO);
  const TestFile opened = open_test("-");
  EXPECT_TRUE(opened.once);
  EXPECT_EQ(opened.content, TestContent::kSteppedSine);
  EXPECT_EQ(read_stepped_sines(opened).at(0).force.size(), 2U);
  ::dup2(before, STDIN_FILENO);
  ::close(before);
  ::close(file);
}

TEST_F(TestFileTest, NamesWhatCannotBeOpened) {
  EXPECT_EQ(message_of<FileError>([] { return open_test("no/such.csv").path; }),
            message_of<FileError>([] { return read_file("no/such.csv"); }));
  EXPECT_EQ(message_of<FileError>([&] { return open_test(folder_.file("")).path; }),
            message_of<FileError>([&] { return read_file(folder_.file("")); }));
}

}  // namespace
}  // namespace microslip::test_file_test
