// SPDX-License-Identifier: MIT
#include "microslip/io/kinds/file_kind.hpp"

#include <gtest/gtest.h>

#include <string>

#include "io/support.hpp"

namespace microslip::file_kind_test {
namespace {

using std::literals::operator""s;

TEST(FileKind, KnowsTheFilesOfTheProgram) {
  EXPECT_EQ(file_kind("{\n \"schema\": \"microslip.joint/1\", \"stiff"), kJointKind);
  EXPECT_EQ(file_kind("# a rig\n\nschema = \"microslip.rig/1\"\n[beam]"), kRigKind);
  EXPECT_EQ(file_kind("\xEF\xBB\xBFschema='microslip.rig/1' # a rig\r\n"), kRigKind);
  EXPECT_EQ(file_kind("# c\namplitude [um],dissipation [J],source\n1,2,"), kLevelsKind);
  EXPECT_EQ(file_kind("mode [1],displacement [m],frequency [Hz],damping_ratio [1]\n1,2,3,4"),
            kModalLevelsKind);
  EXPECT_EQ(file_kind("assembly,levels [1],stiffness [N/m],slip_force_scale [1]\na,1,2,3"),
            kAssembliesKind);
  EXPECT_EQ(file_kind("assembly,slip_force [N],density [1/N],lower [1/N]\na,1,2,3"),
            kDensitiesKind);
  EXPECT_EQ(
      file_kind("amplitude [m],force [N],dissipation [J],secant_stiffness [N/m],loss_factor [1]\n"),
      kDissipationKind);
  EXPECT_EQ(file_kind("rank [1],amplitude [m],repeats [1],width_before [1/N],width_after [1/N]\n"),
            kPlanKind);
  EXPECT_EQ(file_kind("slip_force [N],density [1/N]\n"), kDensityKind);
  EXPECT_EQ(file_kind("draw [1],file,stiffness [N/m],macroslip_force [N]\n"), kExportedDrawsKind);
  EXPECT_EQ(file_kind("PK\x03\x04" + std::string(26, '\0') + std::string(kFmuMark)),
            export_kind("fmu"));
  EXPECT_EQ(file_kind("displacement [m],normal_load [1]\n"), kPathKind);
  EXPECT_EQ(file_kind("displacement [m],force [N]\n"), kLoopKind);
  EXPECT_EQ(file_kind("frequency [Hz],force [N],displacement [m],phase [rad]\n"), kResponseKind);
  EXPECT_EQ(file_kind("displacement [m],force [N],frequency [Hz],damping_ratio [1]\n"),
            kBackboneKind);
}

TEST(FileKind, HasWordsForTheFilesOfTheProgram) {
  const auto words = [](const std::string& head) {
    const KnownKind* const known = known_kind_of(head);
    return known == nullptr ? std::string() : std::string(known->words);
  };
  EXPECT_EQ(words("amplitude [m],dissipation [J]\n"), "a table of levels (levels.csv)");
  EXPECT_EQ(words("schema = \"microslip.model/1\"\n"), "a structure with joints (model.toml)");
  EXPECT_EQ(words("{\"schema\": \"microslip.joint/1\"}"), "a joint (joint.json)");
  EXPECT_EQ(words("frequency [Hz],force [N],acceleration [g],phase [rad]\n"),
            "a stepped-sine table");
  // A version that this program does not have, a recording, and tables that any may be.
  EXPECT_EQ(words("schema = \"microslip.model/9\"\n"), "");
  EXPECT_EQ(words("time [s],force [N],acceleration [g],phase [rad]\n"), "");
  EXPECT_EQ(words("displacement [m],force [N]\n"), "");
  EXPECT_EQ(words(""), "");
}

TEST(FileKind, OfAFileIsEmptyWhereItCannotBeRead) {
  const test::TemporaryFolder folder;
  test::put(folder.file("rig.toml"), "schema = \"microslip.rig/1\"\n");
  EXPECT_EQ(kind_of_file(folder.file("rig.toml")), kRigKind);
  EXPECT_EQ(kind_of_file(folder.file("none.toml")), "");
  EXPECT_EQ(kind_of_file("-"), "");
}

TEST(FileKind, KnowsTablesOfATestAndOfAMarch) {
  EXPECT_EQ(
      file_kind("# c\nlevel [1],frequency [Hz],force_before [N],force_after [N],after_2 [1]\n"),
      kForceControlKind);
  EXPECT_EQ(file_kind("source,time [s],force_recorded [N],force_predicted [N]\n"), kHistoriesKind);
  EXPECT_EQ(file_kind("source,kind,part,quantity,unit,axis,at,measured,predicted,verdict\n"),
            kComparisonKind);
  const std::string motion = "displacement [m],velocity [m/s],acceleration [m/s^2]";
  const std::string joint = ",joint displacement [m],joint force [N]";
  EXPECT_EQ(file_kind("time [s],force [N]," + motion + joint + "\n"), kMarchKind);
  EXPECT_EQ(file_kind("time [s],force at a [N],force at b [N]," + motion + joint + "\n"),
            kMarchKind);
  const std::string band = ",displacement_lower [m],displacement_upper [m],joint force_upper [N]";
  EXPECT_EQ(file_kind("time [s],force [N]," + motion + joint + band + "\n"), kMarchKind);
  EXPECT_EQ(file_kind("statistic,displacement [m],displacement_lower [m],draws [1]\n"),
            kMarchPeaksKind);
  // A recording of the same channels, and one whose joint was measured but not marched.
  EXPECT_NE(file_kind("time [s],force [N]," + motion + "\n"), kMarchKind);
  EXPECT_NE(file_kind("time [s],force [N]" + joint + "\n"), kMarchKind);
  EXPECT_NE(file_kind("source,time [s],force [N],acc1 [m/s^2]\n"), kHistoriesKind);
}

TEST(FileKind, KnowsOtherFormats) {
  EXPECT_EQ(file_kind("\x89PNG\r\n\x1A\nrest"), "a PNG picture");
  EXPECT_EQ(file_kind("<?xml version=\"1.0\"?>\n<svg>"), "an SVG picture");
  EXPECT_EQ(file_kind("<!DOCTYPE html>"), "an HTML page");
  EXPECT_EQ(file_kind("{\"a\": 1}"), "JSON");
  EXPECT_EQ(file_kind("MATLAB 5.0 MAT-file, Platform"), "a MATLAB file");
  EXPECT_EQ(file_kind("\x89HDF\r\n\x1A\n"), "an HDF5 file");
  EXPECT_EQ(file_kind("    -1\n    58\n"), "a universal file");
}

// Only the mark in its head makes a page a report, not a text that speaks of it.
TEST(FileKind, TellsAReportFromOtherPages) {
  const std::string mark = "<meta name=\"generator\" content=\"microslip report\">";
  EXPECT_EQ(file_kind("<!doctype html>\n<html><head>" + mark + "</head><body>"), kReportKind);
  EXPECT_EQ(file_kind("<!doctype html>\n<html><head></head><body>" + mark), "an HTML page");
}

TEST(FileKind, TellsHistoriesApartByAllOfTheirColumns) {
  EXPECT_EQ(file_kind("time [s],force [N],acc1 [m/s^2]\n"), "a table of 'time, force, acc1'");
  EXPECT_NE(file_kind("time [s],displacement [m],force [N]\n"),
            file_kind("displacement [m],force [N]\n"));
}

TEST(FileKind, TellsOtherTablesApart) {
  EXPECT_EQ(file_kind("a,b\n1,2\n"), "a table of 'a, b'");
  EXPECT_NE(file_kind("a,b\n1,2\n"), file_kind("a,c\n1,2\n"));
}

// Comments and headers of any length do not hide what a file is.
TEST(FileKind, IsReadBehindManyComments) {
  const test::TemporaryFolder folder;
  std::string comments;
  while (comments.size() < 5 * kKindHeadSize) comments += "# turns back: frequency 16.67 Hz\n";
  const auto kind = [&](const std::string& text) {
    test::put(folder.file("f"), text);
    return file_kind(read_kind_head(folder.file("f")));
  };
  EXPECT_EQ(kind(comments + "frequency [Hz],force [N],displacement [m],phase [rad]\n1,1,1,1\n"),
            kResponseKind);
  EXPECT_EQ(kind("\r\n" + comments + "schema = \"microslip.model/1\"\n"), kModelKind);
  EXPECT_EQ(kind(comments), "");
  std::string names = "frequency [Hz],displacement [m],phase [rad]";
  for (int i = 0; i < 10000; ++i) names += ",amplitude_" + std::to_string(i) + " [m]";
  EXPECT_EQ(kind(names + "\n"), kResponseKind);
}

TEST(FileKind, IsEmptyForTheRest) {
  EXPECT_EQ(file_kind(""), "");
  EXPECT_EQ(file_kind("\n \n"), "");
  EXPECT_EQ(file_kind("\0\1\2"s), "");
  EXPECT_EQ(file_kind("1,2,3\n"), "");
}

}  // namespace
}  // namespace microslip::file_kind_test
