// SPDX-License-Identifier: MIT

// Files of data loggers, put together by their descriptions: NI, "The NI TDMS File Format"
// (version 2.0; what it leaves open of DAQmx as npTDMS 1.10 reads it), NI, "Specification for the
// LabVIEW Measurement File", Microsoft and IBM, "Multimedia Programming Interface" (RIFF WAVE).

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip::logger_recording_test {
namespace {

using test::message_of;

/// Bytes of a file, in one of the byte orders.
class Bytes {
 public:
  explicit Bytes(bool big = false) : big_(big) {}

  template <class T>
  Bytes& add(T value) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (big_) std::ranges::reverse(raw);
    bytes_.append(raw.data(), raw.size());
    return *this;
  }
  Bytes& u32(std::uint32_t value) { return add(value); }
  Bytes& text(const std::string& text) {
    u32(static_cast<std::uint32_t>(text.size()));
    return raw(text);
  }
  Bytes& raw(const std::string& bytes) {
    bytes_ += bytes;
    return *this;
  }
  [[nodiscard]] const std::string& str() const { return bytes_; }
  [[nodiscard]] bool big() const { return big_; }

 private:
  bool big_;
  std::string bytes_;
};

constexpr std::uint32_t kI16 = 2;
constexpr std::uint32_t kI64 = 4;
constexpr std::uint32_t kDouble = 10;
constexpr std::uint32_t kSingle = 9;
constexpr std::uint32_t kText = 0x20;
constexpr std::uint32_t kMetadata = 2;
constexpr std::uint32_t kNewList = 4;
constexpr std::uint32_t kRaw = 8;
constexpr std::uint32_t kInterleaved = 32;
constexpr std::uint32_t kBigEndian = 64;
constexpr std::uint32_t kDaqmx = 128;

std::string number(const std::string& name, double value, bool big = false) {
  return Bytes(big).text(name).u32(kDouble).add(value).str();
}

std::string word(const std::string& name, const std::string& value) {
  return Bytes().text(name).u32(kText).text(value).str();
}

/// An object of a segment. @param index  bytes of its raw data index.
std::string object(const std::string& path, const std::string& index,
                   const std::vector<std::string>& properties, bool big = false) {
  Bytes bytes(big);
  bytes.text(path).raw(index).u32(static_cast<std::uint32_t>(properties.size()));
  for (const std::string& property : properties) bytes.raw(property);
  return bytes.str();
}

std::string index_of(std::uint32_t type, std::uint64_t count, bool big = false) {
  return Bytes(big).u32(20).u32(type).u32(1).add(count).str();
}

const std::string kSame = Bytes().u32(0).str();
const std::string kNone = Bytes().u32(0xFFFFFFFF).str();

std::string segment(std::uint32_t contents, const std::vector<std::string>& objects,
                    const std::string& values, bool big = false) {
  Bytes metadata(big);
  if ((contents & kMetadata) != 0) {
    metadata.u32(static_cast<std::uint32_t>(objects.size()));
    for (const std::string& o : objects) metadata.raw(o);
  }
  Bytes bytes(big);
  bytes.raw("TDSm").raw(Bytes().u32(contents | (big ? kBigEndian : 0)).str()).u32(4713);
  bytes.add(std::uint64_t{metadata.str().size() + values.size()});
  bytes.add(std::uint64_t{metadata.str().size()});
  return bytes.raw(metadata.str()).raw(values).str();
}

template <class T>
std::string values(const std::vector<T>& all, bool big = false) {
  Bytes bytes(big);
  for (const T value : all) bytes.add(value);
  return bytes.str();
}

const std::string kForcePath = "/'Run'/'force'";
const std::string kAccPath = "/'Run'/'it''s acc'";

std::vector<std::string> waveform(double step, const std::string& unit) {
  return {number("wf_increment", step), word("unit_string", unit)};
}

class Tdms : public testing::Test {
 protected:
  Recordings read(const std::string& bytes, const RecordingReadOptions& options = {}) {
    test::put(path_, bytes);
    return read_recordings(path_, options);
  }
  std::string message(const std::string& bytes) {
    return message_of<Error>([&] { (void)read(bytes); });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("a.tdms");
};

constexpr std::uint32_t kAll = kMetadata | kNewList | kRaw;

// Two chunks of a segment, then a segment that states nothing again, then one that says "as
// before".
TEST_F(Tdms, JoinsSegmentsAndChunks) {
  const std::string file =
      segment(kAll,
              {object("/", kNone, {word("operator", "me")}),
               object(kForcePath, index_of(kDouble, 2), waveform(0.5, "kN")),
               object(kAccPath, index_of(kI16, 2), waveform(0.5, "g"))},
              values<double>({1, 2}) + values<std::int16_t>({7, 8}) + values<double>({3, 4}) +
                  values<std::int16_t>({9, 10})) +
      segment(kRaw, {}, values<double>({5, 6}) + values<std::int16_t>({0, 0})) +
      segment(kMetadata | kRaw, {object(kForcePath, kSame, {})},
              values<double>({7, 8}) + values<std::int16_t>({0, 11}));
  const Recordings read = this->read(file);
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.axis.step, 0.5);
  EXPECT_EQ(recording.channel("force").values,
            (std::vector<double>{1e3, 2e3, 3e3, 4e3, 5e3, 6e3, 7e3, 8e3}));
  EXPECT_DOUBLE_EQ(recording.channel("it's acc").values[7], 11 * 9.80665);
  EXPECT_DOUBLE_EQ(recording.channel("it's acc").values[3], 10 * 9.80665);
}

TEST_F(Tdms, TakesRowsOfInterleavedValuesAndTheOtherByteOrder) {
  const auto properties = [](bool big) { return std::vector{number("wf_increment", 0.25, big)}; };
  for (const bool big : {false, true}) {
    std::string rows;
    for (const int i : {1, 2, 3}) {
      rows += values<float>({static_cast<float>(i)}, big) +
              values<std::int16_t>({static_cast<std::int16_t>(-i)}, big);
    }
    const Recordings read =
        this->read(segment(kAll | kInterleaved,
                           {object(kForcePath, index_of(kSingle, 3, big), properties(big), big),
                            object(kAccPath, index_of(kI16, 3, big), properties(big), big)},
                           rows, big));
    EXPECT_EQ(read.recordings.at(0).channel("force").values, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(read.recordings.at(0).channel("it's acc").values, (std::vector<double>{-1, -2, -3}));
  }
}

// Nanoseconds since 1970: doubles are 256 ns apart there, at 51.2 kHz 1.3 % of a step.
TEST_F(Tdms, KeepsTheDigitsOfWholeTimes) {
  constexpr std::int64_t kStart = 1704067200000000123;
  const std::vector<std::int64_t> times{kStart, kStart + 19531, kStart + 2 * 19531};
  for (const bool stated : {false, true}) {
    const std::vector<std::string> unit{word("unit_string", "ns")};
    const Recordings read = this->read(segment(
        kAll,
        {object("/'Run'/'time'", index_of(kI64, 3), stated ? unit : std::vector<std::string>()),
         object(kForcePath, index_of(kDouble, 3), {})},
        values(times) + values<double>({1, 2, 3})));
    EXPECT_EQ(read.recordings.at(0).axis.start, 0.0);
    EXPECT_NEAR(read.recordings[0].axis.step, 19531e-9, 1e-12 * 19531e-9) << "but for rounding";
    EXPECT_EQ(read.warnings.size(), stated ? 0U : 1U);
  }
}

/// Raw data index of DAQmx of one source, an I16 at this byte of rows of 4 bytes.
std::string daqmx_index(std::uint32_t byte, std::uint32_t scale) {
  return Bytes()
      .u32(0x1269)
      .u32(0xFFFFFFFF)
      .u32(1)
      .add(std::uint64_t{3})
      .u32(1)
      .u32(3)
      .u32(0)
      .u32(byte)
      .u32(0)
      .u32(scale)
      .u32(1)
      .u32(4)
      .str();
}

std::string count(const std::string& name, std::uint32_t value) {
  return Bytes().text(name).u32(7).u32(value).str();
}

// V = 0.001 counts + 0.5, then newtons by a polynomial of V, 2 V + 3 V².
TEST_F(Tdms, ScalesCountsOfDaqmx) {
  std::vector<std::string> scales = waveform(1e-3, "N");
  for (const std::string& property :
       {count("NI_Number_Of_Scales", 3), word("NI_Scaling_Status", "unscaled"),
        word("NI_Scale[1]_Scale_Type", "Linear"), number("NI_Scale[1]_Linear_Slope", 1e-3),
        number("NI_Scale[1]_Linear_Y_Intercept", 0.5), count("NI_Scale[1]_Linear_Input_Source", 0),
        word("NI_Scale[2]_Scale_Type", "Polynomial"),
        count("NI_Scale[2]_Polynomial_Coefficients_Size", 3),
        number("NI_Scale[2]_Polynomial_Coefficients[0]", 0),
        number("NI_Scale[2]_Polynomial_Coefficients[1]", 2),
        number("NI_Scale[2]_Polynomial_Coefficients[2]", 3),
        count("NI_Scale[2]_Polynomial_Input_Source", 1)}) {
    scales.push_back(property);
  }
  const Recordings read =
      this->read(segment(kAll | kDaqmx,
                         {object(kAccPath, daqmx_index(0, 0), waveform(1e-3, "V")),
                          object(kForcePath, daqmx_index(2, 0), scales)},
                         values<std::int16_t>({1, 500, 2, -500, 3, 1500})));
  const Recording& recording = read.recordings.at(0);
  EXPECT_EQ(recording.channel("it's acc").values, (std::vector<double>{1, 2, 3}));
  const std::vector<double>& force = recording.channel("force").values;
  ASSERT_EQ(force.size(), 3U);
  EXPECT_DOUBLE_EQ(force[0], 5.0);
  EXPECT_DOUBLE_EQ(force[1], 0.0);
  EXPECT_DOUBLE_EQ(force[2], 16.0);
}

/// Properties of a table, the first scale, of the stored values.
std::vector<std::string> table_of(const std::vector<double>& pre,
                                  const std::vector<double>& scaled) {
  const std::string table = "NI_Scale[0]_Table_";
  const auto size = static_cast<std::uint32_t>(pre.size());
  std::vector<std::string> properties = waveform(1e-3, "N");
  for (const std::string& property :
       {word("NI_Scale[0]_Scale_Type", "Table"), count(table + "Pre_Scaled_Values_Size", size),
        count(table + "Scaled_Values_Size", size), count(table + "Input_Source", 0xFFFFFFFF)}) {
    properties.push_back(property);
  }
  for (std::size_t i = 0; i < pre.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    properties.push_back(number(table + "Pre_Scaled_Values" + at, pre[i]));
    properties.push_back(number(table + "Scaled_Values" + at, scaled[i]));
  }
  return properties;
}

// npTDMS 1.10, scaling.py, TableScaling: "the scaled values are the input values".
TEST_F(Tdms, ScalesByTables) {
  std::vector<std::string> scales = table_of({0, 100, 200}, {0, 4, 8});
  scales.push_back(count("NI_Number_Of_Scales", 1));
  const Recordings read = this->read(segment(kAll, {object(kForcePath, index_of(kI16, 5), scales)},
                                             values<std::int16_t>({1, 2, 4, 8, 9})));
  EXPECT_EQ(read.recordings.at(0).channel("force").values,
            (std::vector<double>{25, 50, 100, 200, 200}))
      << "beyond the table its last value";
}

TEST_F(Tdms, ScalesByDifferencesAndTablesThatFall) {
  std::vector<std::string> scales = table_of({20, 10}, {2, 0});
  for (const std::string& property :
       {count("NI_Number_Of_Scales", 3), word("NI_Scale[1]_Scale_Type", "AdvancedAPI"),
        word("NI_Scale[2]_Scale_Type", "Subtract"),
        count("NI_Scale[2]_Subtract_Left_Operand_Input_Source", 1),
        count("NI_Scale[2]_Subtract_Right_Operand_Input_Source", 0)}) {
    scales.push_back(property);
  }
  const Recordings read = this->read(segment(kAll, {object(kForcePath, index_of(kI16, 4), scales)},
                                             values<std::int16_t>({-5, 0, 1, 9})));
  EXPECT_EQ(read.recordings.at(0).channel("force").values, (std::vector<double>{15, 10, 14, 11}))
      << "right less left";
}

// npTDMS 1.10, scaling.py, _get_number_of_scalings: the highest index of a type and one more. The
// first scale of DAQmx is what the file stores and has no type.
TEST_F(Tdms, CountsScalesWithoutTheirNumber) {
  std::vector<std::string> scales = waveform(1e-3, "V");
  for (const std::string& property :
       {word("NI_Scale[1]_Scale_Type", "Linear"), number("NI_Scale[1]_Linear_Slope", 2),
        number("NI_Scale[1]_Linear_Y_Intercept", 1), count("NI_Scale[1]_Linear_Input_Source", 0)}) {
    scales.push_back(property);
  }
  const Recordings read =
      this->read(segment(kAll | kDaqmx, {object(kForcePath, daqmx_index(0, 0), scales)},
                         values<std::int16_t>({1, 0, 2, 0, 3, 0})));
  EXPECT_EQ(read.recordings.at(0).channel("force").values, (std::vector<double>{3, 5, 7}));
}

TEST_F(Tdms, LeavesOutChannelsItCannotScale) {
  std::vector<std::string> scales = waveform(1e-3, "°C");
  scales.push_back(count("NI_Number_Of_Scales", 1));
  scales.push_back(word("NI_Scale[0]_Scale_Type", "Thermocouple"));
  const Recordings read =
      this->read(segment(kAll,
                         {object(kAccPath, index_of(kI16, 2), scales),
                          object(kForcePath, index_of(kI16, 2), waveform(1e-3, "N"))},
                         values<std::int16_t>({1, 2, 3, 4})));
  EXPECT_EQ(read.recordings.at(0).channels.size(), 1U);
  EXPECT_EQ(read.warnings.at(0).code, "channel_left_out");
  EXPECT_NE(read.warnings[0].text.find("'Thermocouple'"), std::string::npos);
}

// Two scales that take each other: read on, the file would never end.
TEST_F(Tdms, LeavesOutScalesInACircle) {
  std::vector<std::string> scales = waveform(1e-3, "N");
  scales.push_back(count("NI_Number_Of_Scales", 1));
  scales.push_back(word("NI_Scale[0]_Scale_Type", "Add"));
  scales.push_back(count("NI_Scale[0]_Add_Left_Operand_Input_Source", 0));
  scales.push_back(count("NI_Scale[0]_Add_Right_Operand_Input_Source", 0));
  EXPECT_NE(message(segment(kAll, {object(kForcePath, index_of(kI16, 2), scales)},
                            values<std::int16_t>({1, 2})))
                .find("circle"),
            std::string::npos);
}

/// A time stamp of so many half seconds behind some day, and of 2^-64 s.
std::string stamp(const std::string& name, std::uint64_t halves, std::uint64_t fraction = 0) {
  return Bytes()
      .text(name)
      .u32(0x44)
      .add(std::uint64_t{(halves % 2 << 63U) + fraction})
      .add(std::int64_t{3'800'000'000} + static_cast<std::int64_t>(halves / 2))
      .str();
}

std::string rising(std::size_t count) {
  std::vector<std::int16_t> all(count);
  std::iota(all.begin(), all.end(), std::int16_t{0});
  return values(all);
}

std::vector<std::string> codes_of(const Recordings& read) {
  std::vector<std::string> codes;
  for (const Warning& warning : read.warnings) codes.push_back(warning.code);
  return codes;
}

using Codes = std::vector<std::string>;

TEST_F(Tdms, CutsChannelsThatStartApartToTheirCommonTime) {
  std::vector<std::string> early = waveform(0.5, "N");
  early.push_back(stamp("wf_start_time", 1));
  std::vector<std::string> late = waveform(0.5, "V");
  late.push_back(stamp("wf_start_time", 3));
  const Recordings read = this->read(segment(
      kAll,
      {object(kForcePath, index_of(kI16, 24), early), object(kAccPath, index_of(kI16, 24), late)},
      rising(24) + rising(24)));
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].axis.start, 1.0);
  EXPECT_EQ(read.recordings[0].size(), 22U);
  EXPECT_EQ(read.recordings[0].channel("force").values.front(), 2.0);
  EXPECT_EQ(read.recordings[0].channel("it's acc").values.back(), 21.0);
  EXPECT_EQ(codes_of(read), Codes{"channels_cut"});
}

// A marker of few points does not cut what the others have: at most a tenth of the longest.
TEST_F(Tdms, KeepsShortChannelsApart) {
  for (const std::size_t count : {5U, 35U, 37U}) {
    const Recordings read =
        this->read(segment(kAll,
                           {object(kForcePath, index_of(kI16, 40), waveform(1e-3, "N")),
                            object("/'Run'/'marker'", index_of(kI16, count), waveform(1e-3, "V")),
                            object(kAccPath, index_of(kI16, 40), waveform(1e-3, "g"))},
                           rising(40) + rising(count) + rising(40)));
    if (count == 37) {
      EXPECT_EQ(read.recordings.at(0).channels.size(), 3U);
      EXPECT_EQ(read.recordings[0].size(), 37U);
      EXPECT_EQ(codes_of(read), Codes{"channels_cut"});
      continue;
    }
    ASSERT_EQ(read.recordings.size(), 2U);
    EXPECT_EQ(read.recordings[0].channel("force").values.size(), 40U);
    EXPECT_EQ(read.recordings[0].channel("it's acc").values.size(), 40U);
    EXPECT_EQ(read.recordings[1].channel("marker").values.size(), count);
    EXPECT_EQ(codes_of(read), Codes{"channels_apart"});
    EXPECT_NE(read.warnings[0].text.find("'marker'"), std::string::npos);
  }
}

// Steps that differ by the rounding of a division, and stamps of whole microseconds.
TEST_F(Tdms, TakesRoundedStepsAndStartsTogether) {
  const double step = 1.0 / 51200;
  const auto microseconds = [](double count) {
    return static_cast<std::uint64_t>(std::ldexp(count * 1e-6, 64));
  };
  const auto count = [&](double other, double later) {
    std::vector<std::string> first = waveform(step, "N");
    first.push_back(stamp("wf_start_time", 0));
    std::vector<std::string> second = waveform(other, "g");
    second.push_back(stamp("wf_start_time", 0, microseconds(later)));
    const Recordings read = this->read(segment(kAll,
                                               {object(kForcePath, index_of(kI16, 20), first),
                                                object(kAccPath, index_of(kI16, 20), second)},
                                               rising(20) + rising(20)));
    EXPECT_EQ(codes_of(read), read.recordings.size() == 1 ? Codes{} : Codes{"channels_apart"});
    return read.recordings.size();
  };
  EXPECT_EQ(count(std::nextafter(step, 1.0), 0), 1U);
  EXPECT_EQ(count(step * (1 + 1e-9), 0), 1U);
  EXPECT_EQ(count(step, 1.9), 1U);
  EXPECT_EQ(count(step, 2.5), 2U);
  EXPECT_EQ(count(step * 1.01, 0), 2U);
}

// A property of the waveform, NI, "Channel properties": wf_xunit_string is the unit of the x axis.
TEST_F(Tdms, TakesTheUnitOfTheAxis) {
  const auto file = [](const std::string& unit) {
    return segment(kAll,
                   {object(kForcePath, index_of(kI16, 4),
                           {number("wf_increment", 1.5), number("wf_start_offset", 2),
                            word("wf_xunit_string", unit)})},
                   rising(4));
  };
  const auto axis = [&](const std::string& unit) { return read(file(unit)).recordings.at(0).axis; };
  EXPECT_EQ(axis("kHz"), (Axis{kFrequency, 2000, 1500, {}}));
  EXPECT_DOUBLE_EQ(axis("ms").step, 1.5e-3);
  EXPECT_DOUBLE_EQ(axis("ms").start, 2e-3);
  EXPECT_EQ(axis("min").step, 90.0);
  EXPECT_EQ(axis(""), (Axis{kTime, 2, 1.5, {}}));
  EXPECT_EQ(axis("s"), axis(""));
  EXPECT_NE(message(file("mm")).find("over 'mm', not over a time or frequency"), std::string::npos);
  EXPECT_NE(message(file("blob")).find("'blob', an unknown unit"), std::string::npos);
}

TEST_F(Tdms, WarnsOfPropertiesThatChange) {
  const auto codes = [&](const std::vector<std::string>& before, const std::string& after) {
    return codes_of(
        read(segment(kAll, {object(kForcePath, index_of(kI16, 4), before)}, rising(4)) +
             segment(kMetadata | kRaw, {object(kForcePath, kSame, {after})}, rising(4))));
  };
  const std::vector<std::string> step = waveform(0.5, "N");
  EXPECT_EQ(codes(step, number("wf_increment", 0.5)), Codes{});
  EXPECT_EQ(codes(step, word("unit_string", "kN")), Codes{"properties_change"});
  EXPECT_EQ(codes(step, word("operator", "me")), Codes{});
  std::vector<std::string> started = step;
  started.push_back(stamp("wf_start_time", 2));
  EXPECT_EQ(codes(started, stamp("wf_start_time", 6)), Codes{}) << "goes on where it ended";
  EXPECT_EQ(codes(started, stamp("wf_start_time", 26)), Codes{"properties_change"});
}

// The values before keep their step.
TEST_F(Tdms, TakesAnIncrementThatChanges) {
  const auto part = [&](std::uint32_t contents, double step) {
    return segment(contents,
                   {object(kForcePath, index_of(kI16, 2), waveform(step, "N")),
                    object(kAccPath, index_of(kI16, 2), waveform(step, "g"))},
                   rising(2) + rising(2));
  };
  const Recordings read =
      this->read(part(kAll, 0.5) + part(kAll, 0.5) + part(kAll, 0.25) + part(kAll, 2.0));
  ASSERT_EQ(read.recordings.size(), 1U);
  EXPECT_EQ(read.recordings[0].channels.size(), 2U);
  EXPECT_EQ(read.recordings[0].axis.values, (std::vector{0.0, 0.5, 1.0, 1.5, 2.0, 2.25, 2.5, 4.5}));
  EXPECT_EQ(codes_of(read), (Codes{"step_changes", "step_changes"}));
}

// A step that differs by rounding is none, as between channels, nor is one without values.
TEST_F(Tdms, TakesOneIncrementThatIsStatedAgain) {
  const auto part = [&](double step, bool has_values) {
    const std::vector<std::string> properties = waveform(step, "N");
    return has_values
               ? segment(kAll, {object(kForcePath, index_of(kI16, 2), properties)}, rising(2))
               : segment(kMetadata, {object(kForcePath, kNone, properties)}, "");
  };
  const Axis even{kTime, 0, 0.5, {}};
  for (const std::string& file : {part(0.5, true) + part(0.5 * (1 + 1e-12), true) + part(0.5, true),
                                  part(0.5, true) + part(0.25, false) + part(0.5, true),
                                  part(0.5, true) + part(0.25, false)}) {
    const Recordings read = this->read(file);
    EXPECT_EQ(read.recordings.at(0).axis, even);
    EXPECT_EQ(codes_of(read), Codes{});
  }
  const Recordings back = read(part(0.5, true) + part(0.25, true) + part(0.5, true));
  EXPECT_EQ(back.recordings.at(0).axis.values, (std::vector{0.0, 0.5, 1.0, 1.25, 1.5, 2.0}));
  EXPECT_NE(back.warnings.at(0).text.find("(0.5, then 0.25)"), std::string::npos);
}

TEST_F(Tdms, WarnsOfAChannelThatDoesNotSayWhenItBegins) {
  std::vector<std::string> started = waveform(0.5, "N");
  started.push_back(stamp("wf_start_time", 2));
  const Recordings read =
      this->read(segment(kAll,
                         {object(kForcePath, index_of(kI16, 4), started),
                          object(kAccPath, index_of(kI16, 4), waveform(0.5, "g"))},
                         rising(4) + rising(4)));
  EXPECT_EQ(codes_of(read), Codes{"start_time_missing"});
  EXPECT_NE(read.warnings[0].text.find("it's acc"), std::string::npos);
}

TEST_F(Tdms, WarnsWhereTimesContradictARate) {
  const auto read_with = [&](const std::string& property) {
    return read(segment(kAll,
                        {object("/'Run'/'Time'", index_of(kDouble, 3), {}),
                         object(kForcePath, index_of(kI16, 3), {property})},
                        values<double>({1.0, 1.25, 1.5}) + rising(3)));
  };
  EXPECT_EQ(codes_of(read_with(number("fs", 4))), Codes{});
  const Recordings rate = read_with(number("fs", 5));
  EXPECT_EQ(codes_of(rate), Codes{"rate_contradicts"});
  EXPECT_EQ(rate.recordings.at(0).axis.step, 0.25);
  const Recordings increment = read_with(number("wf_increment", 0.2));
  EXPECT_EQ(codes_of(increment), Codes{"rate_contradicts"});
  EXPECT_EQ(increment.recordings.at(0).axis.step, 0.2);
}

// DIAdem gives a channel of times an increment too, of 1 where it knows none.
TEST_F(Tdms, WarnsWhereTimesContradictIncrementsOfAll) {
  const auto read_with = [&](double increment) {
    return read(segment(kAll,
                        {object("/'Run'/'Time'", index_of(kDouble, 3),
                                {number("wf_increment", increment), word("unit_string", "s")}),
                         object(kForcePath, index_of(kI16, 3), waveform(increment, "N"))},
                        values<double>({1.0, 1.25, 1.5}) + rising(3)));
  };
  EXPECT_EQ(codes_of(read_with(0.25)), Codes{});
  const Recordings contradicted = read_with(1.0);
  EXPECT_EQ(codes_of(contradicted), Codes{"rate_contradicts"});
  EXPECT_EQ(contradicted.recordings.at(0).axis.step, 1.0);
  EXPECT_EQ(contradicted.recordings[0].channels.size(), 2U);
}

TEST_F(Tdms, KeepsChannelsApartWhoseSamplesAreNotTogether) {
  std::vector<std::string> late = waveform(0.4, "m");
  late.push_back(stamp("wf_start_time", 2));
  std::vector<std::string> early = waveform(0.4, "N");
  early.push_back(stamp("wf_start_time", 1));
  const Recordings read = this->read(segment(
      kAll,
      {object(kForcePath, index_of(kI16, 4), early), object(kAccPath, index_of(kI16, 4), late)},
      values<std::int16_t>({1, 2, 3, 4, 5, 6, 7, 8})));
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[1].axis.start, 0.5);
}

TEST_F(Tdms, TakesTimesFromAChannel) {
  const Recordings read =
      this->read(segment(kAll,
                         {object("/'Run'/'Time'", index_of(kDouble, 3), {}),
                          object(kForcePath, index_of(kI16, 3), {word("unit_string", "N")})},
                         values<double>({1.0, 1.25, 1.5}) + values<std::int16_t>({1, 2, 3})));
  EXPECT_EQ(read.recordings.at(0).axis.start, 1.0);
  EXPECT_EQ(read.recordings[0].axis.step, 0.25);
}

// LabVIEW writes 0 where it knows no step.
TEST_F(Tdms, TakesAnIncrementOf0ForNone) {
  const std::string zero = number("wf_increment", 0);
  const auto force = [&](const std::vector<std::string>& properties) {
    return object(kForcePath, index_of(kI16, 3), properties);
  };
  const Recordings timed = this->read(
      segment(kAll, {object("/'Run'/'Time'", index_of(kDouble, 3), {zero}), force({zero})},
              values<double>({1.0, 1.25, 1.5}) + values<std::int16_t>({1, 2, 3})));
  EXPECT_EQ(timed.recordings.at(0).axis, (Axis{kTime, 1.0, 0.25, {}}));
  const Recordings later =
      this->read(segment(kAll, {force({number("wf_increment", 0.5)})}, rising(3)) +
                 segment(kMetadata | kRaw, {object(kForcePath, kSame, {zero})}, rising(3)));
  EXPECT_EQ(later.recordings.at(0).axis.step, 0.5) << "stated before";
  EXPECT_EQ(later.recordings[0].size(), 6U);
  const Recordings first =
      this->read(segment(kAll, {force({zero})}, rising(3)) +
                 segment(kMetadata | kRaw,
                         {object(kForcePath, kSame, {number("wf_increment", 0.5)})}, rising(3)));
  EXPECT_EQ(first.recordings.at(0).axis, (Axis{kTime, 0.0, 0.5, {}})) << "stated later";
  EXPECT_EQ(codes_of(first), Codes{});
  const std::string alone = segment(kAll, {force({zero})}, rising(3));
  EXPECT_NE(message(alone).find("found a wf_increment of 0. Write waveforms whose wf_increment is "
                                "their step, or give `rate`."),
            std::string::npos)
      << message(alone);
  EXPECT_EQ(this->read(alone, {.rate = 8.0}).recordings.at(0).axis.step, 0.125);
}

constexpr std::uint32_t kExtended = 11;

TEST_F(Tdms, LeavesOutTypesThatItDoesNotRead) {
  const std::string extended = Bytes().text("p").u32(kExtended).raw(std::string(16, '\1')).str();
  const std::string nothing = Bytes().text("q").u32(0).str();
  std::vector<std::string> properties = waveform(1e-3, "N");
  properties.insert(properties.end(), {extended, nothing});
  const Recordings read =
      this->read(segment(kAll,
                         {object(kAccPath, index_of(kExtended, 3), waveform(1e-3, "g")),
                          object(kForcePath, index_of(kI16, 3), properties)},
                         std::string(48, '\1') + rising(3)));
  EXPECT_EQ(read.recordings.at(0).channel("force").values, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(codes_of(read), Codes{"channel_left_out"});
  EXPECT_NE(read.warnings[0].text.find("extended precision"), std::string::npos);
}

// npTDMS 1.10, daqmx.py: scalers of the types 8 and 9 are of single and double precision.
TEST_F(Tdms, ReadsScalersOfFloatingPointNumbers) {
  const auto read_as = [&](std::uint32_t type, const std::string& bytes) {
    const std::string index = Bytes()
                                  .u32(0x1269)
                                  .u32(0xFFFFFFFF)
                                  .u32(1)
                                  .add(std::uint64_t{2})
                                  .u32(1)
                                  .u32(type)
                                  .u32(0)
                                  .u32(0)
                                  .u32(0)
                                  .u32(0)
                                  .u32(1)
                                  .u32(static_cast<std::uint32_t>(bytes.size() / 2))
                                  .str();
    return message_of<Error>([&] {
      const Recordings read =
          this->read(segment(kAll | kDaqmx, {object(kForcePath, index, waveform(1, "N"))}, bytes));
      EXPECT_EQ(read.recordings.at(0).channel("force").values, (std::vector<double>{1.5, -2}));
    });
  };
  EXPECT_EQ(read_as(8, values<float>({1.5F, -2})), "no error");
  EXPECT_EQ(read_as(9, values<double>({1.5, -2})), "no error");
  EXPECT_NE(read_as(12, values<double>({1.5, -2})).find("the type 12 of DAQmx"), std::string::npos);
}

// As npTDMS, which warns: what is whole is read.
TEST_F(Tdms, ReadsWholeChunksWhereTheLastIsNot) {
  const std::string file =
      segment(kAll, {object(kForcePath, index_of(kI16, 4), waveform(1, "N"))}, rising(10));
  EXPECT_NE(message(file).find("allow_truncated"), std::string::npos);
  const Recordings read = this->read(file, {.allow_truncated = true});
  EXPECT_EQ(read.recordings.at(0).size(), 8U);
  EXPECT_EQ(codes_of(read), Codes{"file_truncated"});
  EXPECT_NE(read.warnings[0].text.find("4 bytes"), std::string::npos);
}

TEST_F(Tdms, KnowsEmptyNamesFromTheFileItself) {
  const Recordings read = this->read(segment(
      kAll,
      {object("/", kNone, {word("of", "file")}), object("/''", kNone, {word("of", "group")}),
       object("/''/'x'", index_of(kI16, 4), waveform(1, "N"))},
      rising(4)));
  EXPECT_EQ(read.recordings.at(0).channel("x").values.size(), 4U);
  EXPECT_EQ(read.recordings[0].attributes, (Attributes{{"of", "group"}}));
}

// "The TDMS File Format", Object list: an object that is without values in a segment comes last
// when it has some again.
TEST_F(Tdms, TakesObjectsOffTheListAndPutsThemBack) {
  const Recordings read = this->read(
      segment(kAll,
              {object(kForcePath, index_of(kI16, 2), waveform(1, "N")),
               object(kAccPath, index_of(kI16, 2), waveform(1, "m"))},
              values<std::int16_t>({1, 2, 11, 12})) +
      segment(kMetadata | kRaw, {object(kForcePath, kNone, {})}, values<std::int16_t>({13, 14})) +
      segment(kMetadata | kRaw, {object(kForcePath, kSame, {})},
              values<std::int16_t>({15, 16, 3, 4})));
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[0].channel("force").values, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(read.recordings[1].channel("it's acc").values,
            (std::vector<double>{11, 12, 13, 14, 15, 16}));
}

TEST_F(Tdms, SaysWhatIsDamagedOrMissing) {
  const std::string good = segment(kAll, {object(kForcePath, index_of(kI16, 2), waveform(1, "N"))},
                                   values<std::int16_t>({1, 2}));
  EXPECT_NE(message(good + good.substr(0, 40)).find("allow_truncated"), std::string::npos);
  EXPECT_EQ(read(good + good.substr(0, 40), {.allow_truncated = true}).warnings.at(0).code,
            "file_truncated");
  EXPECT_NE(message(good + "rubbish that is no segment at all").find("'TDSm'"), std::string::npos);
  EXPECT_NE(message(segment(kAll, {object(kForcePath, index_of(kI16, 2), {word("u", "N")})},
                            values<std::int16_t>({1, 2})))
                .find("wf_increment"),
            std::string::npos);
  EXPECT_NE(message(segment(kAll, {object(kForcePath, index_of(kI16, 1ULL << 62U), {})},
                            values<std::int16_t>({1, 2})))
                .find("expected"),
            std::string::npos);
}

struct WavForm {
  std::uint16_t code = 1;  ///< 1: integers, 3: floating-point numbers
  std::uint16_t channels = 1;
  std::uint16_t block = 2;  ///< bytes of a sample of all channels
  std::uint16_t bits = 16;
};

/// @param samples  from the head of the chunk of samples on.
std::string riff(const WavForm& form, const std::string& samples) {
  const std::string format = Bytes()
                                 .add(form.code)
                                 .add(form.channels)
                                 .u32(1000)
                                 .u32(1000U * form.block)
                                 .add(form.block)
                                 .add(form.bits)
                                 .str();
  const std::string inner =
      "WAVEfmt " + Bytes().text(format).str() + "LIST" + Bytes().text("odd").str() + '\0' + samples;
  return "RIFF" + Bytes().text(inner).str();
}

/// @param bytes  of a sample of one channel.
std::string wav(std::uint16_t code, std::uint16_t channels, std::uint16_t bytes,
                const std::string& samples) {
  return riff({code, channels, static_cast<std::uint16_t>(channels * bytes),
               static_cast<std::uint16_t>(8 * bytes)},
              "data" + Bytes().text(samples).str());
}

class Wav : public Tdms {};

TEST_F(Wav, HasFractionsOfFullScale) {
  const Recordings read = this->read(wav(1, 2, 2, values<std::int16_t>({-32768, 0, 16384, 1})));
  const Recording& recording = read.recordings.at(0);
  EXPECT_EQ(recording.sampling_rate(), 1000.0);
  EXPECT_EQ(recording.channel("channel_1").values, (std::vector<double>{-1.0, 0.5}));
  EXPECT_EQ(recording.channel("channel_2").values, (std::vector<double>{0.0, 1.0 / 32768}));
  EXPECT_FALSE(recording.channels[0].dimension);
}

TEST_F(Wav, HasIntegersOfEverySizeAndFloats) {
  const auto first = [&](const std::string& bytes) {
    return read(bytes).recordings.at(0).channels.at(0).values;
  };
  const std::vector<double> expected{-1.0, 0.5};
  EXPECT_EQ(first(wav(1, 1, 1, std::string("\0\xC0", 2))), expected) << "unsigned, 128 is zero";
  EXPECT_EQ(first(wav(1, 1, 3, std::string("\0\0\x80\0\0\x40", 6))), expected);
  EXPECT_EQ(first(wav(1, 1, 4, values<std::int32_t>({INT32_MIN, 1 << 30}))), expected);
  EXPECT_EQ(first(wav(3, 1, 4, values<float>({-1.0F, 0.5F}))), expected);
  EXPECT_EQ(first(wav(3, 1, 8, values<double>({-1.0, 0.5}))), expected);
}

// RIFX has the most significant byte first ("Multimedia Programming Interface", 1991); BW64 is RF64
// by another name (ITU-R BS.2088).
TEST_F(Wav, HasTheOtherByteOrderAndSizesOf64Bits) {
  const auto rifx = [](std::uint16_t code, std::uint16_t bytes, const std::string& samples) {
    const Bytes format = Bytes(true)
                             .add(code)
                             .add(std::uint16_t{1})
                             .u32(1000)
                             .u32(1000U * bytes)
                             .add(bytes)
                             .add(static_cast<std::uint16_t>(8 * bytes));
    const std::string inner = "WAVEfmt " + Bytes(true).text(format.str()).str() + "data" +
                              Bytes(true).text(samples).str();
    return "RIFX" + Bytes(true).text(inner).str();
  };
  const auto first = [&](const std::string& bytes) {
    const Recordings read = this->read(bytes);
    EXPECT_TRUE(read.warnings.empty());
    return read.recordings.at(0).channels.at(0).values;
  };
  const std::vector<double> expected{-1.0, 0.5};
  EXPECT_EQ(first(rifx(1, 2, values<std::int16_t>({INT16_MIN, 1 << 14}, true))), expected);
  EXPECT_EQ(first(rifx(1, 3, std::string("\x80\0\0\x40\0\0", 6))), expected);
  EXPECT_EQ(first(rifx(3, 4, values<float>({-1.0F, 0.5F}, true))), expected);
  EXPECT_EQ(first(rifx(3, 8, values<double>({-1.0, 0.5}, true))), expected);
  const std::string samples = values<std::int16_t>({INT16_MIN, 1 << 14});
  const std::string sizes = Bytes()
                                .add(std::uint64_t{0})
                                .add(std::uint64_t{samples.size()})
                                .add(std::uint64_t{2})
                                .u32(0)
                                .str();
  std::string wide = riff({}, "data" + Bytes().u32(0xFFFFFFFF).raw(samples).str());
  wide.replace(0, 12,
               "BW64" + Bytes().u32(0xFFFFFFFF).str() + "WAVEds64" + Bytes().text(sizes).str());
  EXPECT_EQ(first(wide), expected);
}

TEST_F(Wav, NamesOtherSamplesAndTheEnd) {
  EXPECT_NE(message(wav(7, 1, 1, "ab")).find("sox"), std::string::npos) << "µ-law";
  std::string cut = wav(1, 1, 2, values<std::int16_t>({1, 2, 3}));
  cut.resize(cut.size() - 2);
  EXPECT_NE(message(cut).find("allow_truncated"), std::string::npos);
  EXPECT_EQ(read(cut, {.allow_truncated = true}).recordings.at(0).size(), 2U);
}

// RIFF: a chunk is a name of four letters, its size and its contents. A size of 0 is that of a
// program that did not go back to write it only where no chunk follows.
TEST_F(Wav, TellsAnEmptyChunkFromAnUnknownSize) {
  const std::string list = "LIST" + Bytes().text("INFOISFT").str();
  const std::string empty = "data" + Bytes().u32(0).str();
  EXPECT_NE(message(riff({}, empty + list)).find("an empty chunk 'data'"), std::string::npos);
  EXPECT_NE(message(riff({}, empty)).find("an empty chunk 'data'"), std::string::npos);
  const std::string samples = values<std::int16_t>({16384, 0, -16384, 1, 2, 3, 4});
  EXPECT_EQ(read(riff({}, empty + samples)).recordings.at(0).size(), 7U);
}

TEST_F(Wav, WarnsOfSamplesThatItsHeaderDoesNotCount) {
  const std::string two = "data" + Bytes().text(values<std::int16_t>({16384, 1})).str();
  const Recordings less = read(riff({}, two + values<std::int16_t>({1, 2, 3, 4, 5, 6})));
  EXPECT_EQ(less.recordings.at(0).size(), 2U);
  ASSERT_EQ(less.warnings.size(), 1U);
  EXPECT_EQ(less.warnings[0].code, "samples_left_out");
  EXPECT_NE(less.warnings[0].text.find("12 bytes follow"), std::string::npos);
  const Recordings second = read(riff({}, two + two));
  ASSERT_EQ(second.warnings.size(), 1U);
  EXPECT_NE(second.warnings[0].text.find("a second chunk"), std::string::npos);
  const Recordings part =
      read(riff({.block = 4, .bits = 32}, "data" + Bytes().text("1234567890").str()));
  EXPECT_EQ(part.warnings.at(0).code, "samples_left_out");
  EXPECT_NE(part.warnings[0].text.find("2 of the 4 bytes"), std::string::npos);
  // As programs write them: a list behind an odd number of bytes, with its padding or without.
  for (const std::string& padding : {std::string(1, '\0'), std::string()}) {
    const std::string odd = "data" + Bytes().text("\x40\x80\xC0").str() + padding;
    const Recordings listed =
        read(riff({.block = 1, .bits = 8}, odd + "LIST" + Bytes().text("INFO").str()));
    EXPECT_EQ(listed.recordings.at(0).size(), 3U);
    EXPECT_TRUE(listed.warnings.empty());
  }
}

// "Multimedia Programming Interface": the bytes of a sample are the bits rounded up to whole bytes,
// the value in the most significant ones.
TEST_F(Wav, ComparesBitsWithBytes) {
  const std::string samples = values<std::int16_t>({INT16_MIN, 1 << 14});
  const std::string data = "data" + Bytes().text(samples).str();
  EXPECT_EQ(read(riff({.block = 2, .bits = 12}, data)).recordings.at(0).channels.at(0).values,
            (std::vector<double>{-1.0, 0.5}));
  EXPECT_NE(message(riff({.block = 4, .bits = 16}, data)).find("samples of 16 bits in 2 bytes"),
            std::string::npos);
  EXPECT_NE(message(riff({.block = 0}, data)).find("block size"), std::string::npos);
  EXPECT_NE(message(riff({.channels = 0}, data)).find("0 channels"), std::string::npos);
}

const std::string kLvmHead =
    "LabVIEW Measurement\t\r\nWriter_Version\t2\r\nReader_Version\t2\r\nSeparator\tTab\r\n";

class Lvm : public Tdms {};

// As LabVIEW writes pieces of one measurement: a section each, the first with a comment.
TEST_F(Lvm, JoinsSectionsThatGoOn) {
  const auto section = [](const std::string& start, const std::string& rows) {
    return "\r\nChannels\t2\t\t\r\nSamples\t2\t2\t\r\nY_Unit_Label\tN\tg\t\r\nX0\t" + start + "\t" +
           start +
           "\t\r\nDelta_X\t1.0E-3\t1.0E-3\t\r\n***End_of_Header***\t\t\t\r\n"
           "X_Value\tForce\tAcc\tComment\r\n" +
           rows;
  };
  const Recordings read = this->read(kLvmHead + "X_Columns\tNo\r\n***End_of_Header***\t\r\n" +
                                     section("0.0", "\t1.0\t2.0\tfirst\r\n\t3.0\t4.0\r\n") +
                                     section("2.0E-3", "\t5.0\t6.0\r\n\t7.0\t8.0\r\n"));
  ASSERT_EQ(read.recordings.size(), 1U);
  const Recording& recording = read.recordings[0];
  EXPECT_EQ(recording.axis.step, 1e-3);
  EXPECT_EQ(recording.channel("Force").values, (std::vector<double>{1, 3, 5, 7}));
  EXPECT_EQ(recording.channel("Force").dimension, kForce);
  EXPECT_DOUBLE_EQ(recording.channel("Acc").values[3], 8 * 9.80665);
}

TEST_F(Lvm, TakesColumnsOfTimeAndDecimalCommas) {
  const std::string rows = "0,5\t1,5\t0,5\t2,5\r\n0,75\t3,5\t0,75\t4,5\r\n1,0\t5,5\t1,0\t6,5\r\n";
  const Recordings each = read(kLvmHead +
                               "Decimal_Separator\t,\r\nX_Columns\tMulti\r\n***End_of_Header***\r\n"
                               "\r\nChannels\t2\r\n***End_of_Header***\r\n"
                               "X_Value\tA\tX_Value\tB\tComment\r\n" +
                               rows);
  EXPECT_EQ(each.recordings.at(0).axis.start, 0.5);
  EXPECT_EQ(each.recordings[0].axis.step, 0.25);
  EXPECT_EQ(each.recordings[0].channel("B").values, (std::vector<double>{2.5, 4.5, 6.5}));
  const Recordings one = read(kLvmHead +
                              "X_Columns\tOne\r\n***End_of_Header***\r\n\r\nChannels\t1\r\n"
                              "***Start_Special***\r\nanything\t1\r\n***End_Special***\r\n"
                              "***End_of_Header***\r\nX_Value\tA\r\n1.5\t1\r\n1.75\t2\r\n");
  EXPECT_EQ(one.recordings.at(0).channel("A").values, (std::vector<double>{1, 2}));
  EXPECT_EQ(one.recordings[0].axis.step, 0.25);
}

TEST_F(Lvm, NamesTheLineOfAFault) {
  const std::string head = kLvmHead +
                           "X_Columns\tOne\r\n***End_of_Header***\r\n\r\nChannels\t1\r\n"
                           "***End_of_Header***\r\nX_Value\tA\r\n";
  EXPECT_NE(message(head + "0\there\r\n").find(":11"), std::string::npos);
  EXPECT_NE(message(kLvmHead).find("***End_of_Header***"), std::string::npos);
  EXPECT_NE(message(head).find("a section of values"), std::string::npos);
}

}  // namespace
}  // namespace microslip::logger_recording_test
