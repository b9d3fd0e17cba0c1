// SPDX-License-Identifier: MIT

// Files of instruments and other programs (pyuff's data folder). The values were read off the files
// by eye.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "io/uff_support.hpp"
#include "microslip/io/uff/uff55.hpp"

namespace microslip::uff_samples_test {
namespace {

class UffSamples : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MICROSLIP_DATA_DIR");
    if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
    folder_ = std::string(folder) + "/uff/";
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_ + name; }

 private:
  std::string folder_;
};

TEST_F(UffSamples, BinaryDoubles) {
  const Recordings read = read_recordings_uff(file("binary8byte.uff"));
  EXPECT_TRUE(read.warnings.empty());
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.source, "binary8byte.uff");
  EXPECT_EQ(recording.axis, (Axis{.dimension = kTime, .start = 0.0, .step = 0.01, .values = {}}));
  const Channel& acc = recording.channel("sine 5 Hz 1");
  EXPECT_EQ(acc.dimension, kAcceleration);
  ASSERT_EQ(acc.values.size(), 250U);
  // A sine of 5 Hz and 1 g, stored with the digits of single precision; the last bytes of the file
  // are 20 f9 c6 d3 3f.
  for (std::size_t i = 0; i < acc.values.size(); ++i) {
    EXPECT_NEAR(acc.values[i] / 9.80665, std::sin(2.0 * M_PI * 5.0 * 0.01 * static_cast<double>(i)),
                0.02)
        << i;
  }
  EXPECT_EQ(acc.values[0], 0.0);
  EXPECT_NEAR(acc.values[249] / 9.80665, 0.309020, 1e-6);
}

TEST_F(UffSamples, FrequencyResponseWithLatin1Label) {
  const Recordings read = read_recordings_uff(file("non_ascii_header.uff"));
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.axis,
            (Axis{.dimension = kFrequency, .start = 0.0, .step = 0.195313, .values = {}}));
  const Channel& frf = recording.channel("ref6_23_Mar");
  EXPECT_EQ(frf.dimension, kAcceleration / kForce) << "(1/N)*(m/s²)";
  EXPECT_EQ(frf.values, (std::vector<double>{4.07994e-01, -5.99924e-02, 2.58750e-02, -2.99003e-01,
                                             -1.80250e+00, 3.75037e+00}));
  EXPECT_EQ(frf.imaginary, (std::vector<double>{0.0, -5.53260e-02, -2.30085e-04, 3.17213e-01,
                                                1.55302e+00, 2.93363e+00}));
}

TEST_F(UffSamples, PaddedRecordsWithExponentsOfThreeDigits) {
  const Recordings read = read_recordings_uff(file("time-history-not-all-columns-filled.uff"));
  EXPECT_TRUE(read.warnings.empty());
  const Recording& recording = read.recordings.at(0);
  EXPECT_EQ(recording.axis,
            (Axis{.dimension = kTime, .start = 0.0, .step = 1.0 / 20000.0, .values = {}}));
  const Channel& acc = recording.channel("1x : m/s²");
  EXPECT_EQ(acc.dimension, kAcceleration);
  ASSERT_EQ(acc.values.size(), 13U);
  EXPECT_EQ(acc.values.front(), -3.81956);
  EXPECT_EQ(acc.values[6], -3.90210);
  EXPECT_EQ(acc.values.back(), -5.84096);
}

TEST_F(UffSamples, AHeaderThatClaimsMoreThanThereIs) {
  const std::string path = file("dataset_milestone_in_header.uff");
  const std::string message =
      test::message_of<FormatError>([&] { return read_recordings_uff(path); });
  EXPECT_NE(message.find("expected 2508876 values (2508876 points) in dataset 1, found 42"),
            std::string::npos)
      << message;
  const Recordings read = read_recordings_uff(path, {.allow_truncated = true});
  EXPECT_EQ(test::codes(read), std::vector<std::string>{"uff_truncated"});
  const Recording& recording = read.recordings.at(0);
  EXPECT_EQ(recording.axis.start, 1.11858e-05);
  EXPECT_EQ(recording.axis.step, 1.0 / 51200.0);
  const Channel& microphone = recording.channels.at(0);
  EXPECT_EQ(microphone.name,
            "M.REDON   [.../20EH0456 2017-12-06 Creteil Wet50C 14mm TorqueJLR 36V BIPO1/1 :1]");
  EXPECT_EQ(microphone.dimension, kPressure);
  ASSERT_EQ(microphone.values.size(), 42U);
  EXPECT_EQ(microphone.values.front(), -6.73633e-03);
  EXPECT_EQ(microphone.values[24], 7.21978e-03);
  EXPECT_EQ(microphone.values.back(), 5.39653e-03);
}

TEST_F(UffSamples, ModeShapes) {
  const UffModeShapes read = read_mode_shapes_uff(file("uff55_translation.uff"));
  EXPECT_TRUE(read.warnings.empty());
  ASSERT_EQ(read.shapes.size(), 3U);
  EXPECT_EQ(read.shapes[0].frequency, 10.0);
  EXPECT_EQ(read.shapes[1].frequency, 12.0);
  EXPECT_EQ(read.shapes[2].frequency, 13.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const UffModeShape& shape = read.shapes[i];
    EXPECT_EQ(shape.analysis, UffAnalysis::kNormalMode);
    EXPECT_EQ(shape.number, static_cast<std::int64_t>(i) + 1);
    EXPECT_EQ(shape.specific_type, 8);
    EXPECT_EQ(shape.modal_mass, 0.0);
    EXPECT_EQ(shape.nodes, (std::vector<std::int64_t>{1, 2, 3, 4}));
    EXPECT_EQ(shape.values.size(), 12U);
    EXPECT_TRUE(shape.imaginary.empty());
  }
  EXPECT_EQ(read.shapes[0].at(0, 0), -1.46518);
  EXPECT_EQ(read.shapes[1].at(3, 2), 1.98289);
  EXPECT_EQ(read.shapes[2].at(2, 1), 1.48845);
}

}  // namespace
}  // namespace microslip::uff_samples_test
