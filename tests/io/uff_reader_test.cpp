// SPDX-License-Identifier: MIT

// What files of real instruments and programs need from a reader.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/uff_support.hpp"

namespace microslip::uff_reader_test {
namespace {

using test::codes;
using test::Function58;
using test::kThree;
using test::read_channel;
using test::read_uff;
using test::three_points;
using test::uff_fault;
using test::units164;
using Numbers = std::vector<double>;
using Codes = std::vector<std::string>;

// ---- Binary values are taken by their number. ----

TEST(UffReader, BytesOfValuesMayLookLikeLinesAndMarkers) {
  Function58 f = three_points();
  const std::string payload = "\n    -1\n" + std::string("    -1 \n") + "\n\n\n\n\r\n\n\n";
  ASSERT_EQ(payload.size(), 24U);
  const Recordings read = read_uff(binary_dataset(f, payload, 24) + text_dataset(f, kThree));
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_TRUE(read.warnings.empty());
  ASSERT_EQ(read.recordings[0].channels.size(), 2U);
  EXPECT_EQ(test::doubles(read.recordings[0].channels[0].values), payload);
  EXPECT_EQ(read.recordings[0].channels[1].values, (Numbers{1, 2, 3}));
}

TEST(UffReader, AMarkerIsAWholeLine) {
  Function58 f = three_points();
  f.id = "a    -1 b";
  f.response_node = -1;  // its columns hold the bytes of the marker
  const Recordings read = read_uff(text_dataset(f, kThree));
  EXPECT_EQ(read.recordings[0].channels[0].name, "a    -1 b");
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 2, 3}));
}

TEST(UffReader, TrustsThePointsWhereTheAnnouncedBytesLie) {
  Function58 f = three_points();
  f.ordinate_type = 6;
  const std::string payload = test::doubles({1, 2, 3, 4, 5, 6});
  const Recordings read = read_uff(binary_dataset(f, payload, 3 * 8));
  EXPECT_EQ(codes(read), Codes{"uff_byte_count"});
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 3, 5}));
  EXPECT_EQ(read.recordings[0].channels[0].imaginary, (Numbers{2, 4, 6}));

  f.ordinate_type = 4;
  f.even = false;
  const Recordings uneven = read_uff(binary_dataset(f, test::doubles({1, 2, 3, 4, 7, 6}), 3 * 8));
  EXPECT_EQ(codes(uneven), Codes{"uff_byte_count"});
  EXPECT_EQ(uneven.recordings[0].axis.values, (Numbers{1, 3, 7}));
  EXPECT_EQ(uneven.recordings[0].channels[0].values, (Numbers{2, 4, 6}));
}

TEST(UffReader, RefusesBytesThatFitNothing) {
  const std::string fault =
      uff_fault(binary_dataset(three_points(), test::doubles({1, 2, 3, 4}), 17));
  EXPECT_EQ(fault,
            "t.uff:13: expected the line '    -1' after the 24 bytes of the 3 points of dataset 1, "
            "found other bytes, and 17 bytes announced. The header and the values of the "
            "dataset contradict each other.");
}

TEST(UffReader, TakesALineBreakBehindBinaryValues) {
  for (const char* line_break : {"\n", "\r\n", ""}) {
    const Recordings read =
        read_uff(binary_dataset(three_points(), test::doubles({1, 2, 3}), 24, 1, 2, line_break) +
                 binary_dataset(three_points(), test::doubles({4, 5, 6}), 24, 1, 2, line_break));
    EXPECT_TRUE(read.warnings.empty());
    ASSERT_EQ(read.recordings[0].channels.size(), 2U);
    EXPECT_EQ(read.recordings[0].channels[1].values, (Numbers{4, 5, 6}));
  }
}

// ---- Text in all its forms. ----

TEST(UffReader, LineEndingsMayBeMixedInOneFile) {
  std::string text = text_dataset(three_points(), kThree);
  int n = 0;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
    if (++n % 3 == 0) text.insert(at, "\r");
    if (n % 3 == 1) text.insert(at, std::string(5, ' '));
  }
  const Recordings read = read_uff(text + text_dataset(three_points(), kThree));
  EXPECT_TRUE(read.warnings.empty());
  ASSERT_EQ(read.recordings[0].channels.size(), 2U);
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 2, 3}));
}

TEST(UffReader, ReadsExponentsOfAllForms) {
  Function58 f = three_points();
  f.points = 6;
  f.ordinate_type = 2;
  EXPECT_EQ(read_channel(text_dataset(f,
                                      "  1.00000E+00 1.00000e+001  1.00000D+02"
                                      "  1.00000+003-1.00000E-105 1.000000E+05\n"))
                .values,
            (Numbers{1, 10, 100, 1000, -1e-105, 1e5}));
}

TEST(UffReader, SkipsZerosThatFillTheLastLine) {
  const Recordings read = read_uff(
      text_dataset(three_points(), kThree.substr(0, kThree.size() - 1) + "  0.000000000000E+00\n"));
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 2, 3}));
}

TEST(UffReader, SaysWhichValuesItLeavesOut) {
  EXPECT_EQ(codes(read_uff(text_dataset(three_points(), kThree + kThree))),
            Codes{"uff_extra_lines"});
  EXPECT_EQ(codes(read_uff(text_dataset(
                three_points(), kThree.substr(0, kThree.size() - 1) + "  4.000000000000E+00\n"))),
            Codes{"uff_extra_values"});
}

TEST(UffReader, UnknownDatasetsAreSkipped) {
  const std::string other =
      test::marker() + "  2411\nanything\n         1    -1\n" + test::marker();
  const Recordings read = read_uff(other + text_dataset(three_points(), kThree) + other);
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 2, 3}));
  EXPECT_EQ(uff_fault(other),
            "t.uff: expected a function of at least two points (dataset 58 or 58b), found 1 "
            "dataset 2411");
}

// The format allows text between datasets.
TEST(UffReader, PassesOverRemarksBetweenDatasets) {
  const std::string one = text_dataset(three_points(), kThree);
  const Recordings read = read_uff(one + "Workpiece 3\n\nwritten by a mesher\n" + one + "end\n");
  EXPECT_EQ(read.recordings[0].channels.size(), 2U);
}

TEST(UffReader, DecodesLatin1) {
  Function58 f = three_points();
  f.id = "Kan\xE4le";
  f.ordinate_type_code = 1;
  f.ordinate_unit = "m/s\xB2";
  const Channel channel = read_channel(text_dataset(f, kThree));
  EXPECT_EQ(channel.name, "Kanäle");
  EXPECT_EQ(channel.dimension, kAcceleration);
}

// ---- Recordings, names, attributes. ----

TEST(UffReader, FunctionsOverOneAxisAreARecording) {
  Function58 force = three_points();
  Function58 acc = three_points();
  acc.id = "acc";
  Function58 slow = three_points();
  slow.step = " 2.00000E-03";
  const Recordings read = read_uff(text_dataset(force, kThree) + text_dataset(acc, kThree) +
                                   text_dataset(slow, kThree) + text_dataset(force, kThree));
  ASSERT_EQ(read.recordings.size(), 3U) << "an axis between two others parts them";
  EXPECT_EQ(read.recordings[0].channels.size(), 2U);
  EXPECT_EQ(read.recordings[0].channel("acc").values, (Numbers{1, 2, 3}));
  EXPECT_EQ(read.recordings[1].axis.step, 1.0 / 500.0);
}

TEST(UffReader, NamesComeFromTheFirstLineOrThePoint) {
  const auto names = [](std::vector<Function58> functions) {
    std::string text;
    for (const Function58& f : functions) text += text_dataset(f, kThree);
    std::vector<std::string> result;
    const Recordings read = read_uff(text);
    for (const Channel& channel : read.recordings.at(0).channels) result.push_back(channel.name);
    return result;
  };
  Function58 a = three_points();
  a.id = "NONE";
  a.response_node = 3;
  a.response_direction = 3;
  Function58 b = a;
  b.id = "";
  b.response_direction = -4;
  Function58 c = a;
  c.response = "wing";
  EXPECT_EQ(names({a, b, c, a}),
            (std::vector<std::string>{"point 3 +Z", "point 3 -RX", "wing 3 +Z", "point 3 +Z (2)"}));
  a.id = b.id = "Record";
  c.id = "shaker";
  EXPECT_EQ(names({a, b, c}), (std::vector<std::string>{"point 3 +Z", "point 3 -RX", "shaker"}));
}

TEST(UffReader, KeepsWhatElseAHeaderSays) {
  Function58 f = three_points();
  f.function_type = 77;
  f.response_node = 12;
  f.response_direction = -2;
  f.ordinate_type_code = 21;
  f.ordinate_unit = "V, peak";
  const Channel channel = read_channel(text_dataset(f, kThree));
  EXPECT_EQ(channel.attributes, (Attributes{{"id line 3", "01-Jan-24 12:00:00"},
                                            {"function type", "77"},
                                            {"function number", "1"},
                                            {"response node", "12"},
                                            {"response direction", "-Y"},
                                            {"ordinate type", "21"},
                                            {"ordinate label", "y"},
                                            {"ordinate unit", "V, peak"}}));
}

// ---- Ends that come too early, and other faults. ----

TEST(UffReader, FewerValuesThanAnnouncedAreCounted) {
  Function58 f = three_points();
  f.points = 2508876;
  const std::string text = text_dataset(f, kThree);
  EXPECT_EQ(uff_fault(text),
            "t.uff:15: expected 2508876 values (2508876 points) in dataset 1, found 3 before its "
            "end. Record or export it again, or read what is left with `allow_truncated`.");
  const Recordings read = read_uff(text, true);
  EXPECT_EQ(codes(read), Codes{"uff_truncated"});
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 2, 3}));
}

TEST(UffReader, TruncatedBinaryValues) {
  Function58 f = three_points();
  const std::string whole = binary_dataset(f, test::doubles({1, 2, 3}), 24);
  const std::string cut = whole.substr(0, whole.size() - 7 - 3);
  EXPECT_EQ(uff_fault(cut),
            "t.uff:13: expected 24 bytes (3 points) in dataset 1, found 21 before its end. Record "
            "or export it again, or read what is left with `allow_truncated`.");
  EXPECT_EQ(read_channel(cut, true).values, (Numbers{1, 2}));
  f.points = 2508876;
  EXPECT_EQ(read_channel(binary_dataset(f, test::doubles({1, 2, 3}), 24), true).values,
            (Numbers{1, 2, 3}))
      << "the closing line is no value";
  EXPECT_EQ(read_channel(binary_dataset(f, test::doubles({1, 2, 3}), 20071008), true).values,
            (Numbers{1, 2, 3}));
}

TEST(UffReader, CountsThatNoFileHoldsCostNoMemory) {
  Function58 f = three_points();
  f.points = 9'999'999'999;
  EXPECT_NE(uff_fault(text_dataset(f, kThree)).find("found 3 before its end"), std::string::npos);
  EXPECT_NE(uff_fault(binary_dataset(f, test::doubles({1, 2, 3}), 79'999'999'992))
                .find("found 24 before its end"),
            std::string::npos);
  f.even = false;
  f.ordinate_type = 6;
  EXPECT_NE(uff_fault(text_dataset(f, kThree)).find("before its end"), std::string::npos);
}

TEST(UffReader, ADatasetThatTheFileEndsInIsDropped) {
  const std::string whole = text_dataset(three_points(), kThree);
  const std::string text = whole + whole.substr(0, 300);
  EXPECT_NE(uff_fault(text).find("of dataset 2, found the end of the file"), std::string::npos);
  const Recordings read = read_uff(text, true);
  EXPECT_EQ(codes(read), Codes{"uff_truncated"});
  EXPECT_EQ(read.recordings[0].channels.size(), 1U);
}

TEST(UffReader, AMissingLastLineIsForgiven) {
  const std::string whole = text_dataset(three_points(), kThree);
  const Recordings read = read_uff(whole.substr(0, whole.size() - 7));
  EXPECT_EQ(codes(read), Codes{"uff_not_closed"});
  EXPECT_EQ(read.recordings[0].channels[0].values, (Numbers{1, 2, 3}));
}

TEST(UffReader, OnePointIsNoRecording) {
  Function58 f = three_points();
  f.points = 1;
  const std::string one = text_dataset(f, "  1.000000000000E+00\n");
  EXPECT_EQ(codes(read_uff(one + text_dataset(three_points(), kThree))), Codes{"uff_too_short"});
}

TEST(UffReader, RefusesOtherFiles) {
  EXPECT_EQ(uff_fault("time [s],force [N]\n"),
            "t.uff:1:1: expected a universal file, which begins with the line '    -1', found "
            "'time [s],force [N]'");
  EXPECT_EQ(uff_fault(""),
            "t.uff: expected a function of at least two points (dataset 58 or 58b), found an empty "
            "file");
  EXPECT_EQ(uff_fault(text_dataset(three_points(), kThree) + " 1.5E+03\n"),
            "t.uff:16:1: expected the line '    -1' that opens a dataset, or the end of the file, "
            "found ' 1.5E+03'");
  EXPECT_EQ(uff_fault("    -1\nabc\n"),
            "t.uff:2:1: expected an integer as the number of the dataset, found 'abc'");
  EXPECT_NE(uff_fault("    -1\n").find("the number of the dataset of dataset 1"),
            std::string::npos);
  EXPECT_NE(uff_fault(std::string(3'000'000, 'x')).find("t.uff:1:1"), std::string::npos);
}

TEST(UffReader, RefusesFaultyForms) {
  Function58 f = three_points();
  f.ordinate_type = 3;
  EXPECT_EQ(uff_fault(text_dataset(f, kThree)),
            "t.uff:9: expected the ordinate data type 2, 4, 5 or 6, found 3");
  f = three_points();
  f.points = -3;
  EXPECT_NE(uff_fault(text_dataset(f, kThree)).find("a number of points of 0 or more, found -3"),
            std::string::npos);
  f = three_points();
  f.step = "-1.00000E-03";
  EXPECT_NE(uff_fault(text_dataset(f, kThree)).find("must be above 0"), std::string::npos);
  EXPECT_NE(uff_fault(units164(9, "0.0D+00", "1.0D+00")).find("a factor of units above 0"),
            std::string::npos);
}

TEST(UffReader, ReportsProgressAndStops) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("t.uff");
  Function58 f;
  f.points = 2'000'000;
  test::put(path, binary_dataset(f, std::string(16'000'000, '\0'), 16'000'000));
  std::vector<std::size_t> seen;
  std::size_t all = 0;
  (void)read_recordings_uff(path, {.progress = [&](std::size_t done, std::size_t total) {
                              seen.push_back(done);
                              all = total;
                              return true;
                            }});
  ASSERT_GE(seen.size(), 4U);
  EXPECT_EQ(seen.back(), all);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  const RecordingReadOptions stop{.progress = [](std::size_t, std::size_t) { return false; }};
  EXPECT_THROW((void)read_recordings_uff(path, stop), Cancelled);
}

}  // namespace
}  // namespace microslip::uff_reader_test
