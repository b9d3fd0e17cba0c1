// SPDX-License-Identifier: MIT

// Tables as loggers, testing machines and spreadsheets write them: what does not matter is
// forgiven, what cannot be used is left out with a warning.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/recordings/table_start.hpp"

namespace microslip::recording_csv_forms_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;
using Names = std::vector<std::string>;

Recordings read_all(const std::string& text, const RecordingReadOptions& options = {}) {
  const test::TemporaryFolder folder;
  test::put(folder.file("r.csv"), text);
  return read_recordings_csv(folder.file("r.csv"), options);
}

std::string fault(const std::string& text) {
  const std::string message = message_of<Error>([&] { return read_all(text); });
  const std::size_t name = message.find("r.csv");
  return name == std::string::npos ? message : message.substr(name);
}

Names names_of(const Recording& recording) {
  Names names;
  for (const Channel& channel : recording.channels) names.push_back(channel.name);
  return names;
}

Names codes_of(const Recordings& read) {
  Names codes;
  for (const Warning& warning : read.warnings) codes.push_back(warning.code);
  return codes;
}

/// The axis of a table of three columns that rise, and the names of the others.
std::string axis_of(const std::string& names) {
  const Recordings read = read_all(names + "\n1,0,3\n2,1,4\n3,2,6\n");
  std::string others;
  for (const std::string& name : names_of(read.recordings.front())) others += " " + name;
  return dimension_name(read.recordings.front().axis.dimension) + " over" + others;
}

// A shaft's speed, the hours of a machine or of a clock are channels where there is a time.
TEST(RecordingCsvForms, TakesTheBestColumnForTheAxis) {
  EXPECT_EQ(axis_of("speed [rpm],time [s],force [N]"), "time over speed force");
  EXPECT_EQ(axis_of("uptime [h],time [s],force [N]"), "time over uptime force");
  EXPECT_EQ(axis_of("uptime [h],t_s [s],force [N]"), "time over uptime force");
  EXPECT_EQ(axis_of("run [min],frequency [Hz],H [m/N]"), "frequency over run H");
  EXPECT_EQ(axis_of("shaft [Hz],time [min],force [N]"), "time over shaft force");
  EXPECT_EQ(axis_of("speed [rpm],f [Hz],H [m/N]"), "frequency over speed H");
  EXPECT_EQ(axis_of("Time [hh:mm:ss],Elapsed [s],force [N]"), "time over Time force");
  EXPECT_EQ(axis_of("Time,Elapsed [min],force [N]"), "time over Time force");
  for (const std::string span : {"tau [s]", "T60 [s]", "decay time [s]", "Rise time [ms]"}) {
    const std::string name = " " + span.substr(0, span.find(" ["));
    EXPECT_EQ(axis_of("frequency [Hz]," + span + ",H [m/N]"), "frequency over" + name + " H");
  }
  // The only one there is.
  EXPECT_EQ(axis_of("speed [rpm],temp [°C],force [N]"), "frequency over temp force");
  EXPECT_EQ(axis_of("uptime [h],temp [°C],force [N]"), "time over temp force");
}

// Better refused than read over something else.
TEST(RecordingCsvForms, TakesNoSpeedForATimeWithoutUnit) {
  EXPECT_NE(fault("time,speed [rpm],force [N]\n0,1,2\n1,2,3\n").find("a unit of time for column 1"),
            std::string::npos);
  EXPECT_NE(fault("Time [hh:mm:ss],speed [rpm],F [N]\n0,1,2\n1,2,3\n")
                .find("found the unknown unit 'hh:mm:ss'"),
            std::string::npos);
}

// With a rate in a comment nothing else need be the time.
TEST(RecordingCsvForms, TakesTheRateBeforeWhatMayBeATime) {
  const Recordings read = read_all("# fs = 8 Hz\nuptime [h],force [N]\n1,2\n1,3\n");
  EXPECT_EQ(read.recordings.front().sampling_rate(), 8.0);
  EXPECT_EQ(read.recordings.front().channels.size(), 2U);
}

// A clock in text is left out like other text, with the first line of its cells.
TEST(RecordingCsvForms, ReadsBesideAClock) {
  const Recordings read =
      read_all("Time [hh:mm:ss],Elapsed [s],force [N]\n09:14:00,0,1\n09:14:01,1,2\n");
  EXPECT_EQ(names_of(read.recordings.front()), (Names{"force"}));
  EXPECT_EQ(codes_of(read), (Names{"unit_unknown", "channel_left_out"}));
}

// Only what is written as a number is one: the names below stand above two rows of numbers.
TEST(RecordingCsvForms, TakesNoNameThatEndsInInfForANumber) {
  const std::string text = "Logger 7,,\ntime [s],T_inf [degC],F_NAN [N]\n0,1,2\n1,2,3\n";
  EXPECT_EQ(find_table_start(text).names, "time [s],T_inf [degC],F_NAN [N]");
  const std::string names = "Logger 7,\nt_inf,F_inf\n";
  EXPECT_EQ(find_table_start(names + "0,1\n1,2\n").names, "t_inf,F_inf");
  EXPECT_EQ(find_table_start(names + "0,-inf\n1,+nan\n").names, "t_inf,F_inf");
}

// A part of a complex channel without the other is none.
TEST(RecordingCsvForms, LeavesOutBothPartsOfAComplexChannel) {
  for (const std::string row : {"1,,2,3", "1,2,,3"}) {
    const Recordings read = read_all("frequency [Hz],a.real [m/N],a.imag [m/N],b [m/N]\n0,1,2,3\n" +
                                     row + "\n2,1,2,3\n");
    const Recording& recording = read.recordings.front();
    EXPECT_EQ(names_of(recording), (Names{"b"})) << row;
    EXPECT_EQ(recording.left_out.size(), 2U) << row;
    EXPECT_EQ(codes_of(read), (Names{"channel_left_out", "channel_left_out"})) << row;
  }
}

// A temperature or a voltage beside what is measured says nothing of it.
TEST(RecordingCsvForms, KeepsChannelsOfOtherUnits) {
  const Recordings read =
      read_all("time [s],force [N],temp [°C],raw (mV/g),x [furlong]\n0,1,21,5,7\n1,2,22,6,8\n");
  const Recording& recording = read.recordings.front();
  EXPECT_EQ(names_of(recording), (Names{"force", "temp", "raw", "x"}));
  EXPECT_EQ(recording.channel("force").dimension, kForce);
  for (const char* name : {"temp", "raw", "x"}) EXPECT_FALSE(recording.channel(name).dimension);
  EXPECT_EQ(recording.channel("temp").attributes, (Attributes{{"unit", "°C"}}));
  EXPECT_EQ(codes_of(read), (Names{"unit_unknown"})) << "of the furlong alone";
  EXPECT_EQ(message_of<InputError>([&] { (void)recording.signal("temp", kLength); }),
            "r.csv: channel 'temp' is labelled '°C', which is unknown or doubtful; must have a "
            "known unit of length. Give its unit with `assume_units temp=m`.");
}

TEST(RecordingCsvForms, TellsColumnsOfOneNameApart) {
  const Recordings read =
      read_all("time (s),Force (V),Force (N),x,x,x\n0,1,10,4,5,6\n1,2,20,7,8,9\n");
  EXPECT_EQ(names_of(read.recordings.front()),
            (Names{"Force (V)", "Force (N)", "x", "x (column 5)", "x (column 6)"}));
  EXPECT_EQ(read.recordings.front().channel("Force (N)").values, (Numbers{10, 20}));
  EXPECT_EQ(read.recordings.front().channel("x (column 5)").values, (Numbers{5, 8}));
  EXPECT_EQ(codes_of(read), (Names{"columns_of_one_name", "columns_of_one_name"}));
}

// Of pandas, whose index has no name.
TEST(RecordingCsvForms, CallsAColumnWithoutNameByItsNumber) {
  EXPECT_EQ(names_of(read_all(",time [s],a [N]\n0,0,1\n1,1,2\n").recordings.front()),
            (Names{"column 1", "a"}));
}

TEST(RecordingCsvForms, LeavesOutColumnsWithoutNumbers) {
  const Recordings read = read_all(
      "image,date,time [s],a [N],gap [m],over [N],c [N]\n"
      "step_0,2024-03-12 09:14:00,0,1,,1,5\n"
      "step_1,2024-03-12 09:14:01,1,2,0.1,OL,\n"
      "step_2,2024-03-12 09:14:02,2,3,0.2,3,7\n");
  const Recording& recording = read.recordings.front();
  EXPECT_EQ(names_of(recording), (Names{"a"}));
  EXPECT_EQ(recording.channel("a").values, (Numbers{1, 2, 3}));
  EXPECT_EQ(codes_of(read), Names(5, "channel_left_out"));
  const std::string message = message_of<InputError>([&] { (void)recording.channel("c"); });
  EXPECT_NE(message.find("channel 'c' is left out; must have a value at each point"),
            std::string::npos)
      << message;
  EXPECT_NE(
      message.find("r.csv:3:39: expected a finite number in column 7 'c [N]', found an empty"),
      std::string::npos)
      << message;
}

// Whatever a program writes for a value that it has not: the other channels are whole.
TEST(RecordingCsvForms, LeavesOutAColumnWithACellThatIsNoNumber) {
  for (const std::string cell :
       {"2x", "********", "1.#QNAN", "#WERT!", "+OVER", "\"1,10.374\"", "12 mm"}) {
    const Recordings read = read_all("time [s],a [N],b [N]\n0,1,2\n1," + cell + ",3\n");
    EXPECT_EQ(names_of(read.recordings.front()), Names{"b"}) << cell;
    ASSERT_EQ(codes_of(read), Names{"channel_left_out"}) << cell;
    EXPECT_NE(read.warnings[0].text.find("r.csv:3:"), std::string::npos) << cell;
    EXPECT_NE(fault("time [s],a [N]\n0,1\n1," + cell + "\n")
                  .find("expected a finite number in column 2 'a [N]'"),
              std::string::npos)
        << "there is no other channel";
  }
}

TEST(RecordingCsvForms, RefusesATimeThatIsNone) {
  EXPECT_NE(fault("time [s],a [N],b [N]\n0,1,2\nend,2,3\n").find("r.csv:3:1: expected a finite"),
            std::string::npos);
}

TEST(RecordingCsvForms, PrefersATimeThatHasAUnit) {
  const Recordings read = read_all("Time,Elapsed [s],a [N]\n09:14:00,0,1\n09:14:01,1,2\n");
  EXPECT_EQ(read.recordings.front().axis.step, 1.0);
  EXPECT_EQ(names_of(read.recordings.front()), (Names{"a"}));
}

// As testing machines write their reports; `;;` are cells of a spreadsheet.
TEST(RecordingCsvForms, TakesLinesAboveTheHeaderForComments) {
  const Recordings read = read_all(
      "Test: lap joint, 25 Nm;;\n"
      "Date: 12.03.2024 09:14;;\n"
      "Operator;Ann;\n"
      "\n"
      "Zeit;Weg;Kraft\n"
      "s;mm;kN\n"
      "0,000;1,25;-0,5\n"
      "0,005;1,50;-0,25\n");
  const Recording& recording = read.recordings.front();
  EXPECT_EQ(recording.axis.step, 0.005);
  EXPECT_EQ(recording.channel("Weg").values, (Numbers{1.25e-3, 1.5e-3}));
  EXPECT_EQ(recording.channel("Kraft").values, (Numbers{-500, -250}));
  EXPECT_EQ(recording.attributes,
            (Attributes{
                {"Test", "lap joint, 25 Nm"}, {"Date", "12.03.2024 09:14"}, {"Operator", "Ann"}}));
}

TEST(RecordingCsvForms, FindsTheRateAboveTheHeader) {
  const Recordings read =
      read_all("Logger 3\nSampling rate,200\nforce [N],gap [um]\n1,2\n3,4\n5,6\n");
  EXPECT_EQ(read.recordings.front().sampling_rate(), 200.0);
  EXPECT_EQ(names_of(read.recordings.front()), (Names{"force", "gap"}));
}

TEST(RecordingCsvForms, TakesNoRowForAHeader) {
  for (const char* text : {"a,b\n1,2\n3,4\n", "a,b\ns,m\n1,2\n3,4\n", "a,b\nNaN,NaN\n1,2\n3,4\n",
                           "# c\na,b\n1,2\n", "a\n1\n2\n", "", "a\n"}) {
    EXPECT_TRUE(find_table_start(text).preamble.empty()) << text;
  }
}

TEST(RecordingCsvForms, NamesBlanksBetweenColumns) {
  EXPECT_NE(fault("time [s]   force [N]   disp [mm]\n0.000  0.000  0.0000\n")
                .find("expected columns separated by commas, semicolons or tabs, found blanks"),
            std::string::npos);
  // What the remedy makes of decimal commas between blanks, which commas cannot separate.
  EXPECT_NE(fault("time[s] force[N]\n0,0 1,5\n0,5 2,5\n").find("blanks between columns by ';'"),
            std::string::npos);
  EXPECT_EQ(fault("time[s];force[N]\n0,0;1,5\n0,5;2,5\n"), "no error");
}

// Dry friction knows no time; for others it must be there.
TEST(RecordingCsvForms, NumbersPointsWhereThatIsAllowed) {
  const std::string text = "gap [um],load [kN]\n1,2\n2,3\n";
  EXPECT_NE(fault(text).find("expected a column of time"), std::string::npos);
  const Recordings read = read_all(text, {.allow_untimed = true});
  EXPECT_EQ(read.recordings.front().axis.step, 1.0);
  EXPECT_EQ(codes_of(read), (Names{"points_untimed"}));
}

TEST(RecordingColumns, AreThoseOfTheTableInTheFile) {
  const auto columns = recording_columns("Machine 4\nZeit;Kraft\ns;kN\n0,1;2,5\n0,2;2,5\n");
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_EQ(columns[1].name, "Kraft");
  EXPECT_EQ(columns[1].unit, "kN");
  EXPECT_TRUE(recording_columns("\x89PNG\r\n\x1A\n").empty());
}

// As LabVIEW's "space", Fortran and numpy.savetxt write tables.
TEST(RecordingCsvForms, BlanksMaySeparateColumns) {
  for (const char* text :
       {"time[s] force[kN] acc[g]\n0.0 1 -2\n0.5 3 4e0\n1.0 5 6\n",
        "  time [s]   force [kN]  acc [g]  \r\n  0.0   1 -2\r\n0.5 3 4 \r\n"
        " 1.0 5   6  \r\n",
        "Bench 7\noperator: me\ntime force acc\ns kN g\n0.0 1 -2\n0.5 3 4\n1 5 6\n",
        "# a comment\ntime [s] force [kN] acc [g]\n0 1 -2\n.5 3 4\n1.0 5 6"}) {
    const Recording recording = read_all(text).recordings.at(0);
    EXPECT_EQ(recording.axis.step, 0.5) << text;
    EXPECT_EQ(recording.channel("force").values, (Numbers{1000, 3000, 5000})) << text;
    EXPECT_EQ(recording.channel("acc").dimension, kAcceleration) << text;
  }
  EXPECT_EQ(fault("time[s] force[N]\n0 1\n1 2\n2 3 4\n"),
            "r.csv:4:1: expected 2 cells as in the header, found 3. The separator of this table is "
            "' '.");
  EXPECT_EQ(
      fault("time[s] force[N]\n0 1\n1 2\n2 1,5\n"),
      "r.csv:4:3: expected a finite number in column 2 'force [N]', found '1,5'. Decimal commas "
      "need ';' or tabs between the columns.");
}

// As numpy.savetxt(header=…), R's write.table() and spreadsheets write what stands above rows.
TEST(RecordingCsvForms, HeadersAboveBlanksMayHaveAnotherForm) {
  for (const char* header :
       {"time[s], force[kN], acc[g]", "time[s];force[kN];acc[g];", "time [s]\tforce [kN]\tacc [g]",
        "time force acc\n[s] [kN] [g]", " time  force  acc\n (s) (kN)  (g)",
        "time,force,acc\ns,kN,g", "\"time [s]\" \"force [kN]\"  \"acc [g]\"",
        "\"time\" \"force\" \"acc\"\n\"s\" \"kN\" \"g\"", "time [ s ] force ( kN ) acc [g]"}) {
    const Recording recording =
        read_all(std::string(header) + "\n0.0 1 -2\n0.5 3 4\n1.0 5 6\n").recordings.at(0);
    EXPECT_EQ(recording.axis.step, 0.5) << header;
    EXPECT_EQ(recording.channel("force").values, (Numbers{1000, 3000, 5000})) << header;
    EXPECT_EQ(recording.channel("acc").dimension, kAcceleration) << header;
  }
  const std::string quoted = "\"time [s]\" \"load cell [N]\"\n0.0 1\n0.5 2\n1.0 3\n";
  EXPECT_EQ(names_of(read_all(quoted).recordings.at(0)), Names{"load cell"});
  EXPECT_EQ(read_all("time [s] a [m / s^2]\n0 1\n1 2\n2 4\n").recordings.at(0).channel("a").values,
            (Numbers{1, 2, 4}));
}

// A column without a name and a name of two words have as many words as two names: the first column
// of pandas' to_string() and of R's write.table() has none.
TEST(RecordingCsvForms, RefusesWordsThatMayBeOneName) {
  const std::string rows = "0 0.000 1 2\n1 0.001 3 4\n2 0.002 5 6\n";
  EXPECT_EQ(fault("     Time [s]  Axial Force [N]    x [mm]\n" + rows),
            "r.csv:1:16: expected a unit behind each name, for blanks separate them, found 'Axial' "
            "without one before 'Force'. Join words of one name by '_', name each column, and give "
            "those without unit a [1].");
  EXPECT_NE(
      fault("time[s] Top force[N] gap[mm]\n0.0 1 2 7\n0.1 2 3 7\n").find("found 'Top' without"),
      std::string::npos);
  // The first column counts the rows, from 0 or from 1.
  EXPECT_EQ(
      fault("time [s] load cell\n0 0.000 1\n1 0.001 2\n2 0.002 3\n"),
      "r.csv:1:1: expected a unit behind each name, for blanks separate them, found column 1 "
      "'time [s]' over 0, 1, 2 or 1, 2, 3, which may be numbers of rows. Name each column with "
      "its unit, [1] where it has none, and join words of one name by '_'.");
  EXPECT_NE(fault("time [s] load cell\n1 0.000 1\n2 0.001 2\n").find("over 0, 1, 2"),
            std::string::npos);
  // As the remedies have it; and times of one second that are no numbers of rows.
  for (const char* text :
       {"No [1] Time [s] Axial_Force [N] x [mm]\n0 0 1 2\n1 0.1 3 4\n",
        "time [s] cycle [1] F [N]\n0 1 2\n1 1 3\n", "time [s] force [N]\n0 1\n1 2\n2 3\n",
        "time force\ns N\n0 1\n1 2\n2 3\n", "time [s] force [N] flag\n0.0 1 0\n0.1 2 0\n",
        "time [s],load,cell [N]\n0 0.1 1\n1 0.2 2\n"}) {
    EXPECT_EQ(fault(text), "no error") << text;
  }
}

TEST(RecordingCsvForms, NamesAMissingCellBetweenBlanks) {
  const std::string head = "time[s] force[N] x[mm]\n0.1 1 2\n0.2 3 4\n";
  EXPECT_EQ(fault(head + "      5 6\n0.4 7 8\n"),
            "r.csv:4:1: expected 3 cells as in the header, found 2. Blanks separate the columns of "
            "this table: write nan for a value that is missing.");
  EXPECT_EQ(codes_of(read_all(head + "0.3 nan 6\n0.4 7 8\n")), Names{"channel_left_out"});
}

// Commas separate, so that no number has a decimal one.
TEST(RecordingCsvForms, NamesQuotedDecimalCommas) {
  EXPECT_EQ(fault("time [s],force [N]\n\"0,000\",\"0,00\"\n\"0,001\",\"1,00\"\n"),
            "r.csv:2:2: expected a finite number in column 1 'time [s]', found '0,000'. Decimal "
            "commas need ';' or tabs between the columns.");
  EXPECT_EQ(fault("time [s];force [N]\n\"0,000\";\"0,00\"\n\"0,001\";\"1,00\"\n"), "no error");
}

// As a table of HDF5, Hdf5NetCdf.TakesTheFrequencyOfATableBesideTimesThatRise: by the first rows.
TEST(RecordingCsvForms, TakesAFrequencyBeforeASpanOfAnyName) {
  for (const std::string mark : {",", " "}) {
    const auto axis = [&](const std::string& span, const std::string& rows) {
      std::string text = "frequency[Hz]," + span + ",H[m/N]\n" + rows;
      std::ranges::replace(text, ',', mark[0]);
      const Recordings read = read_all(text);
      Names codes = codes_of(read);
      codes.insert(codes.begin(), dimension_name(read.recordings.front().axis.dimension));
      return codes;
    };
    const std::string rows = "20,0.1,1\n21,0.2,2\n22,0.3,5\n";
    for (const char* span : {"settling[s]", "lag[ms]", "averaging[s]"}) {
      EXPECT_EQ(axis(span, rows), (Names{"frequency", "axis_chosen"})) << span;
    }
    EXPECT_EQ(axis("settling[s]", "20,0.1,1\n21,0.1,2\n22,0.3,5\n"), Names{"frequency"});
    EXPECT_EQ(axis("elapsed[s]", rows), Names{"time"});
    EXPECT_EQ(axis("settling[s]", "20,0.1,1\n20,0.2,2\n22,0.3,5\n"), Names{"time"})
        << "the frequency does not rise";
  }
}

// A frequency response states the rate of its samples, too; as in MAT and HDF5.
TEST(RecordingCsvForms, SaysThatAFrequencyIsTheAxisBesideARate) {
  const std::string text = "# fs = 8 Hz\nfrequency [Hz],force [N]\n1,2\n2,3\n";
  const Recordings read = read_all(text);
  EXPECT_EQ(read.recordings.front().axis.dimension, kFrequency);
  EXPECT_EQ(codes_of(read), Names{"axis_chosen"});
  for (const std::string more : {"2,4\n", "1.5,4\n"}) {  // it stays as it is, or falls
    const Recordings over_time = read_all(text + more);
    EXPECT_EQ(over_time.recordings.front().sampling_rate(), 8.0);
    EXPECT_EQ(over_time.recordings.front().channels.size(), 2U);
    EXPECT_EQ(codes_of(over_time), Names{});
  }
  // Seen too late in a file for its first rows to show it.
  std::string late = "# fs = 8 Hz\nfrequency [Hz],force [N]\n";
  for (int i = 1; i < 1500; ++i) late += std::to_string(i) + ",1\n";
  const Recordings falls = read_all(late + "1,1\n");
  EXPECT_EQ(falls.recordings.front().sampling_rate(), 8.0);
  EXPECT_EQ(falls.recordings.front().channel("frequency").values.size(), 1500U);
}

// ISO 80000-1 and DIN write quantity/unit; others a comma, "in" or an underscore.
TEST(RecordingCsvForms, TakesUnitsFromNames) {
  for (const std::string names :
       {"t/s,F/kN,v/(mm/s)", "Time / s,F / kN,v / mm/s", "\"Time, s\",\"F, kN\",\"v, mm/s\"",
        "Zeit in s,F in kN,v in mm/s", "Pr\u00fcfzeit / s,F / kN,v / (mm/s)"}) {
    const Recordings read = read_all(names + "\n0,1.5,2\n0.5,2.5,4\n");
    EXPECT_EQ(read.recordings.front().axis.step, 0.5) << names;
    EXPECT_EQ(read.recordings.front().channel("F").values, (Numbers{1500, 2500})) << names;
    EXPECT_EQ(read.recordings.front().channel("v").values, (Numbers{2e-3, 4e-3})) << names;
    EXPECT_EQ(codes_of(read), Names{}) << names;
  }
  const Recordings read =
      read_all("time_s,force_kN,k_N_per_m,x_1,state_of\n0,1,2,3,4\n1,2,3,4,5\n");
  EXPECT_EQ(read.recordings.front().channel("force_kN").values, (Numbers{1000, 2000}));
  EXPECT_EQ(read.recordings.front().channel("k_N_per_m").dimension, kStiffness);
  EXPECT_FALSE(read.recordings.front().channel("x_1").dimension);
  EXPECT_FALSE(read.recordings.front().channel("state_of").dimension);
  EXPECT_EQ(codes_of(read), Names{"units_in_names"});
  const Recordings assumed = read_all(
      "time_s,force_kN\n0,1\n1,2\n",
      {.assumed_units = parse_assumed_units(std::vector<std::string>{"time_s=ms", "force_kN=N"})});
  EXPECT_EQ(assumed.recordings.front().axis.step, 1e-3);
  EXPECT_FALSE(assumed.recordings.front().channel("force_kN").dimension) << "which is given later";
  EXPECT_EQ(recording_columns("t/s,F/N\n0,1\n1,2\n").at(1).unit, "N");
  // Where the time has brackets, so do the others.
  const Recordings plain = read_all("time [s],rise/fall,F/N\n0,1,2\n1,2,3\n");
  EXPECT_EQ(names_of(plain.recordings.front()), (Names{"rise/fall", "F/N"}));
}

// FORMAT(3E11.4): a sign takes the place of the blank.
TEST(RecordingCsvForms, TakesNumbersOfFixedWidthApart) {
  for (const std::string names : {"time [s] force [N] gap [m]\n", "# time[s] force[N] gap[m]\n"}) {
    const Recordings read =
        read_all(names + " 0.0000E+00-1.2340E+00-5.6780E+00\n 1.0000E+00 1.2340E+00-2.5000E-01\n");
    EXPECT_EQ(read.recordings.front().channel("force").values, (Numbers{-1.234, 1.234})) << names;
    EXPECT_EQ(read.recordings.front().channel("gap").values, (Numbers{-5.678, -0.25})) << names;
  }
  const Recordings fixed = read_all(
      "time [s] force [N] gap [m]\n   0.00000-1000.2500-999.50000\n   1.00000   "
      "12.5000-6.27905-105\n");
  EXPECT_EQ(fixed.recordings.front().channel("force").values, (Numbers{-1000.25, 12.5}));
  EXPECT_EQ(fixed.recordings.front().channel("gap").values, (Numbers{-999.5, -6.27905e-105}));
  EXPECT_NE(fault("time [s] day\n0.0 12-03-2024\n1.0 13-03-2024\n"), "no error");
}

TEST(RecordingCsvForms, LeavesOutTextBetweenBlanks) {
  for (const std::string names :
       {"time [s] force [N] state gap [mm]\n", "time [s]   force [N]   state   gap [mm]\n"}) {
    const Recordings read = read_all(names + "0.0 1 OK 2\n0.5 2 hold 4\n");
    EXPECT_EQ(names_of(read.recordings.front()), (Names{"force", "gap"})) << names;
    EXPECT_EQ(codes_of(read), Names{"channel_left_out"});
  }
}

// Rows of 5 kHz with three digits. Rows that are there twice are no such clock.
TEST(RecordingCsvForms, TakesAClockThatRoundsForEven) {
  std::string text = "time [s],force [N]\n";
  for (int i = 0; i < 400; ++i) text += fmt::format("{:.3f},{}\n", i / 5000.0, i % 7);
  const Recordings read = read_all(text);
  ASSERT_TRUE(read.recordings.front().axis.even());
  EXPECT_NEAR(1.0 / read.recordings.front().axis.step, 5000.0, 50.0) << "1 ms of 80";
  EXPECT_EQ(codes_of(read), Names{"times_rounded"});
  const Recordings stated = read_all(text, {.rate = 5000.0});
  EXPECT_EQ(stated.recordings.front().axis.step, 1.0 / 5000.0);
  EXPECT_EQ(codes_of(stated), Names{});
  EXPECT_TRUE(stated.rate_used);
  const std::string wrong = message_of<Error>([&] { return read_all(text, {.rate = 6000.0}); });
  EXPECT_NE(wrong.find("must agree with the times"), std::string::npos) << wrong;
  const Recordings commented = read_all("# fs = 5000 Hz\n" + text);
  EXPECT_EQ(commented.recordings.front().axis.step, 1.0 / 5000.0);
  EXPECT_EQ(codes_of(commented), Names{});
}

// Pairs of time and value, as loggers write channels of different rates.
TEST(RecordingCsvForms, TellsOfASecondTime) {
  const Recordings read = read_all("t1 [s],F [N],t2 [s],x [mm]\n0,1,0,1\n1,2,2,2\n2,3,4,3\n");
  EXPECT_EQ(codes_of(read), Names{"other_times"});
  EXPECT_EQ(codes_of(read_all("time [s],F [N],delay [s],elapsed [min]\n0,1,0,1\n60,2,5,2\n")),
            Names{})
      << "a span; the same from another start, over which nothing is";
}

// Channels that were started 50 ms apart: their loops are not those of the rows.
TEST(RecordingCsvForms, TellsOfASecondTimeFromAnotherStart) {
  const auto read = [](double start) {
    std::string text = "t1 [s],F [N],t2 [s],x [mm]\n";
    for (int i = 0; i < 40; ++i) {
      text += fmt::format("{:.3f},{},{:.3f},{}\n", i * 1e-3, i % 7, start + i * 1e-3, i % 5);
    }
    return read_all(text);
  };
  EXPECT_EQ(codes_of(read(0.0)), Names{});
  EXPECT_EQ(codes_of(read(0.05)), Names{"other_times"});
  EXPECT_NE(read(0.05).warnings.at(0).text.find("from 0.05 s on in place of 0 s"),
            std::string::npos)
      << read(0.05).warnings.at(0).text;
}

// As MTS (a count of segments) and an oscilloscope of Keysight write them; HBM's catman has a line
// of rates between names and units.
TEST(RecordingCsvForms, FindsLinesOfUnits) {
  const Recordings mts = read_all(
      "Station Name:\tAxial.cfg\nRunning Time\tAxial Count\tAxial Displacement\tAxial Force\n"
      "Sec\tsegments\tmm\tkN\n0.001\t0\t1\t2\n0.002\t0\t3\t4\n");
  EXPECT_EQ(mts.recordings.front().channel("Axial Force").values, (Numbers{2e3, 4e3}));
  EXPECT_EQ(codes_of(mts), Names{"unit_unknown"});
  const Recordings scope = read_all("x-axis,1,2\nsecond,Volt,Volt\n-0.1,5,1\n-0.05,6,2\n");
  EXPECT_EQ(names_of(scope.recordings.front()), (Names{"1", "2"}));
  EXPECT_EQ(scope.recordings.front().channel("1").values, (Numbers{5, 6}));
  const Recordings catman = read_all(
      "Werte:\t2\nZeit 1\tKraft\tWeg\nStandardmessrate: 1000 Hz; dt = 0,001 s\t\t\n"
      "s\tkN\tmm\n0,000\t1\t2\n0,001\t3\t4\n");
  EXPECT_EQ(catman.recordings.front().channel("Kraft").values, (Numbers{1e3, 3e3}));
}

// Rows of Pulse below pairs; settings of an oscilloscope in columns beside them, or above them with
// other cells.
TEST(RecordingCsvForms, TellsWhereRowsWithoutNamesBegin) {
  const std::string pulse = "Header Size:\t3\nType:\tReal\nSource:\tPULSE\n";
  const std::string rows = "1\t0.0\t5\n2\t0.5\t6\n3\t1.0\t7\n";
  EXPECT_NE(
      fault(pulse + rows)
          .find("r.csv:4:1: expected a line of 3 names above the rows of numbers, found rows of "
                "numbers that begin here, without names. Put one above line 4"),
      std::string::npos)
      << fault(pulse + rows);
  const Recordings named = read_all(pulse + "n [1]\ttime [s]\tacc [g]\n" + rows);
  EXPECT_EQ(named.recordings.front().channel("acc").values.size(), 3U);

  const std::string beside =
      "Record Length,2.5e+03,,-0.6,1.0,\nSource,CH1,,-0.5,2.0,\nUnits,V,,-0.4,3.0,\n"
      ",,,-0.3,4.0,\n";
  EXPECT_TRUE(fault(beside).starts_with("r.csv:1:1: expected a line of 5 names")) << fault(beside);
  const Recordings times = read_all("a,b,c,time [s],CH1 [V]\n" + beside);
  EXPECT_EQ(times.recordings.front().channel("CH1").values, (Numbers{1, 2, 3, 4}));

  const std::string counted =
      "X,CH1,Start,Increment,\nSequence,Volt,-0.1,5e-4\n0,1.0,\n1,2.0,\n2,3.0,\n";
  EXPECT_TRUE(fault(counted).starts_with("r.csv:3:1: expected a line of 2 names"))
      << fault(counted);
}

TEST(RecordingCsvForms, NamesMatricesAndMeshes) {
  for (const auto& [text, name] :
       {std::pair{"%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n1 1 4.0\n",
                  "found a matrix of Matrix Market"},
        {"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "found a mesh of gmsh"},
        {"*NODE, NSET=NALL\n1, 0.0, 0.0, 0.0\n", "found an input file of Abaqus"}}) {
    EXPECT_NE(fault(text).find(name), std::string::npos) << fault(text);
    EXPECT_NE(fault(text).find("`modes` takes matrices"), std::string::npos) << fault(text);
  }
}

// As pandas writes them.
TEST(RecordingCsvForms, NamesComplexCells) {
  const std::string text = fault("frequency [Hz],H [m/s^2/N]\n78,(-7.9+1.06j)\n79,(-8-1e-3j)\n");
  EXPECT_NE(text.find("It is complex: write its parts as columns 'H.real' and 'H.imag'."),
            std::string::npos)
      << text;
}

// Whole thousands, of which a comma may as well be that of decimals.
TEST(RecordingCsvForms, NamesThousandsOfATableWithCommas) {
  const std::string text = fault("time [s],F [N]\n0.5,\"12.5\"\n1.0,\"1,004\"\n");
  EXPECT_NE(text.find("Where its comma separates thousands, write it without"), std::string::npos)
      << text;
}

TEST(RecordingCsvForms, TakesIndicesForNames) {
  const Recordings read = read_all("time [s]\tY[0]\tY[1]\n0\t1\t2\n1\t3\t4\n");
  EXPECT_EQ(names_of(read.recordings.front()), (Names{"Y_0", "Y_1"}));
  EXPECT_EQ(codes_of(read), Names{});
  EXPECT_TRUE(read_all("time [s],n [1]\n0,1\n1,3\n").recordings.front().channel("n").dimension);
}

TEST(RecordingCsvForms, TakesThousandsApart) {
  const Recordings comma = read_all("time [s];F [N]\n0,0;1.234,5\n0,5;-12.345.678,25\n");
  EXPECT_EQ(comma.recordings.front().channel("F").values, (Numbers{1234.5, -12345678.25}));
  const Recordings point = read_all("time [s];F [N]\n0.0;1,234.5\n0.5;12.5\n");
  EXPECT_EQ(point.recordings.front().channel("F").values, (Numbers{1234.5, 12.5}));
  const Recordings quoted = read_all("time [s],F [N]\n0,1\n1,\"1,104.374\"\n");
  EXPECT_EQ(quoted.recordings.front().channel("F").values, (Numbers{1, 1104.374}));
  EXPECT_EQ(codes_of(read_all("time [s];x [m];F [N]\n0,0;1;1.23,5\n0,5;1;2,5\n")),
            Names{"channel_left_out"});
}

// catman (HBM) writes tabs and decimal commas below lines of its own.
TEST(RecordingCsvForms, TakesTabsBeforeDecimalCommas) {
  const Recordings read =
      read_all("Created: 11.06.2024\nChannels:\t2\n\nTime [s]\tF [kN]\n0,0\t1,5\n0,5\t2,5\n");
  EXPECT_EQ(read.recordings.front().axis.step, 0.5);
  EXPECT_EQ(read.recordings.front().channel("F").values, (Numbers{1500, 2500}));
  EXPECT_EQ(fault("time [s],\tforce [N]\n0.0,\t1.5\n0.5,\t2.5\n"), "no error") << "aligned";
}

// Instron and Zwick write names and units in quotes, and the former the numbers as well.
TEST(RecordingCsvForms, TakesQuotedNamesUnitsAndRows) {
  const std::string names = "\"Time\";\"Load\"\n";
  for (const std::string above : {"", "\"Specimen\";\"lap 3\"\n\n", "Report\n"}) {
    for (const std::string units : {"\"s\";\"kN\"\n", "\"(s)\";\"(kN)\"\n"}) {
      for (const std::string rows : {"0,0;1,5\n0,5;2,5\n", "\"0.0\";\"1.5\"\n\"0.5\";\"2.5\"\n"}) {
        const Recordings read = read_all(above + names + units + rows);
        EXPECT_EQ(read.recordings.front().axis.step, 0.5) << above << units << rows;
        EXPECT_EQ(read.recordings.front().channel("Load").values, (Numbers{1500, 2500}));
      }
    }
  }
  // In the character set of Windows, whose micro sign is no UTF-8.
  const Recordings read = read_all(
      "Pr\xFC"
      "fer;M\nPr\xFCzeit;Weg\ns;\xB5m\n0,0;1,5\n0,5;2,5\n");
  EXPECT_EQ(read.recordings.front().channel("Weg").dimension, kLength);
}

// Oscilloscopes write what was set, a name and a number each, above the table.
TEST(RecordingCsvForms, TakesNoPairsForRows) {
  const Recordings read =
      read_all("Model,X\nInterval,0.5\nLength,600\nTime (s),Force (N)\n0.0,1\n0.5,2\n1.0,3\n");
  EXPECT_EQ(read.recordings.front().axis.step, 0.5);
  EXPECT_EQ(names_of(read.recordings.front()), Names{"Force"});
  EXPECT_EQ(read_all("s,force [N]\na,1\nb,2\n", {.allow_untimed = true, .rate = 8.0})
                .recordings.front()
                .channel("force")
                .values,
            (Numbers{1, 2}))
      << "a table of names and numbers";
}

// gfortran: D of double precision, and no letter where the exponent has three digits.
TEST(RecordingCsvForms, ReadsExponentsOfFortran) {
  const Recordings read = read_all(
      "time[s] a[N] b[N]\n0.0D+00 1.5D+01 6.27905-105\n"
      "5.0D-01 -2.5d1 -1.25+100\n1.0D+00 1.0D0 0.0\n");
  EXPECT_EQ(read.recordings.front().axis.step, 0.5);
  EXPECT_EQ(read.recordings.front().channel("a").values, (Numbers{15, -25, 1}));
  EXPECT_EQ(read.recordings.front().channel("b").values, (Numbers{6.27905e-105, -1.25e100, 0}));
}

// As Fortran writes a number that fills its field.
TEST(RecordingCsvForms, TakesNoTwoNumbersForADate) {
  EXPECT_EQ(fault("time[s] a[N]\n0.0 1.0\n0.5 2.0\n1.0-112.619 2\n"),
            "r.csv:4:1: expected 2 cells as in the header, found 3. The separator of this table is "
            "' '.");
}

// Clocks and dates are no times in seconds: a rate serves.
TEST(RecordingCsvForms, TakesTheRateBesideTimesInText) {
  for (const std::string time : {"10:12:33.00", "2024-06-11 10:12:33.00"}) {
    const std::string text = "Time,force [N]\n" + time + "0,1\n" + time + "1,2\n" + time + "2,3\n";
    EXPECT_EQ(fault(text),
              "r.csv:1:1: expected times as numbers in column 1 'Time', found text, '" + time +
                  "0'. Write seconds from the start, with the unit [s], or give the "
                  "rate by `rate`.");
    const Recordings read = read_all(text, {.allow_untimed = true, .rate = 1000.0});
    EXPECT_EQ(read.recordings.front().sampling_rate(), 1000.0);
    EXPECT_EQ(names_of(read.recordings.front()), Names{"force"});
  }
}

// numpy.savetxt(header=…) without comments=''.
TEST(RecordingCsvForms, TakesNamesOfAComment) {
  for (const std::string text : {"# time[s] force[kN]\n0.0 1\n0.5 2\n1.0 3\n",
                                 "# made by me\n% time [s], force [kN]\n0.0,1\n0.5,2\n1.0,3\n"}) {
    const Recordings read = read_all(text);
    EXPECT_EQ(read.recordings.front().axis.step, 0.5) << text;
    EXPECT_EQ(read.recordings.front().channel("force").values, (Numbers{1e3, 2e3, 3e3})) << text;
    EXPECT_EQ(recording_columns(text).at(1).name, "force");
  }
  for (const char* text : {"# 12 channels\n0.0 1\n0.5 2\n", "0.0 1\n0.5 2\n", "0.0,1\n0.5,2\n"}) {
    EXPECT_NE(fault(text).find("found a row of numbers"), std::string::npos) << fault(text);
  }
}

// R: write.table() begins each row with a name that the header does not have.
TEST(RecordingCsvForms, SkipsNamesOfRows) {
  const Recordings read =
      read_all("\"time [s]\" \"load cell [kN]\"\n\"1\" 0 1\n\"2\" 0.5 2\n\"3\" 1 3\n");
  EXPECT_EQ(read.recordings.front().axis.step, 0.5);
  EXPECT_EQ(names_of(read.recordings.front()), (Names{"row", "load cell"}));
  EXPECT_EQ(read.recordings.front().channel("load cell").values, (Numbers{1e3, 2e3, 3e3}));
}

// Blanks within names, which two blanks or more separate.
TEST(RecordingCsvForms, TakesNamesOfSeveralWordsBetweenBlanks) {
  for (const std::string head : {"Time   Axial Force   Crosshead x\ns      kN            mm\n",
                                 "Time [s]   Axial Force [kN]   Crosshead x [mm]\n"}) {
    const Recordings read = read_all(head + "0.0   1   2\n0.5   2   3\n1.0   3   4\n");
    EXPECT_EQ(names_of(read.recordings.front()), (Names{"Axial Force", "Crosshead x"})) << head;
    EXPECT_EQ(read.recordings.front().channel("Axial Force").values, (Numbers{1e3, 2e3, 3e3}));
    EXPECT_EQ(read.recordings.front().axis.step, 0.5);
  }
}

// lb is a mass; as that of a force lbf is meant. 4.4482216152605 N by definition.
TEST(RecordingCsvForms, TakesALoadInPoundsForAForce) {
  const Recordings read = read_all("time [s],load (lb),mass (lb)\n0,1,1\n1,2,2\n");
  EXPECT_EQ(read.recordings.front().channel("load").dimension, kForce);
  EXPECT_DOUBLE_EQ(read.recordings.front().channel("load").values[0], 4.4482216152605);
  EXPECT_EQ(read.recordings.front().channel("mass").dimension, kMass);
  EXPECT_EQ(codes_of(read), Names{"unit_doubtful"});
}

// What is not text is named, with the way out.
TEST(RecordingCsvForms, NamesSoundsAndArchivesOfOthers) {
  const auto named = [&](const std::string& head, const std::string& name) {
    EXPECT_NE(fault(head + std::string(40, '\0')).find(name), std::string::npos) << fault(head);
  };
  named("fLaC", "found a FLAC sound file. Make it WAV: sndfile-convert");
  named(".snd", "found an AU sound file");
  named("caff", "found a CAF sound file");
  named("riff\x2E\x91\xCF\x11", "found a Wave64 sound file");
  named(std::string("FORM\0\0\x10\0AIFF", 12), "found an AIFF sound file. Make it WAV");
  named("\x80\x05\x95", "found a pickle of Python. Save its table as CSV");
  std::string archive("PK\x03\x04", 4);
  archive.append(22, '\0').append(
      "\x05\0\0\0"
      "a.npy",
      9);
  named(archive, "found an NPZ archive of NumPy");
}

}  // namespace
}  // namespace microslip::recording_csv_forms_test
