// SPDX-License-Identifier: MIT
#include "microslip/documents/study/calibration_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip::calibration_file_test {
namespace {

CalibrationFile sample_file() {
  Provenance provenance;
  provenance.version = "1";
  provenance.command = "microslip calibrate m.toml l.csv --out d";
  provenance.inputs = {{"m.toml", "ab"}, {"l.csv", "cd"}};
  provenance.seed = 7;
  return {provenance,
          {{"status", "converged"},
           {"scatter", 0.01},
           {"joint", list_of_texts({"wall", "a \"b\""})},
           {"degrees_of_freedom", std::vector<double>{2.5, 7.0}}}};
}

TEST(CalibrationFile, ReadsBackWhatItWrites) {
  const CalibrationFile file = sample_file();
  const std::string text = format_calibration(file);
  EXPECT_EQ(file_kind(text), kCalibrationFileKind);
  const CalibrationFile read = parse_calibration(text, "calibration.json");
  EXPECT_EQ(read.provenance, file.provenance);
  EXPECT_EQ(read.calibration.size(), file.calibration.size());
  EXPECT_EQ(format_calibration(read), text);
}

TEST(CalibrationFile, NamesWhatIsWrong) {
  const auto message = [](const std::string& text) {
    try {
      (void)parse_calibration(text, "c.json");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("{\"schema\": \"microslip.joint/1\"}").find("microslip.calibration/1"),
            std::string::npos);
  const std::string schema = "{\"schema\": \"microslip.calibration/1\"";
  EXPECT_NE(message(schema + "}").find("calibration"), std::string::npos);
  EXPECT_NE(message(schema + ", \"calibration\": 1}").find("calibration"), std::string::npos);
  EXPECT_NE(message(schema + ", \"calibration\": {}, \"more\": 1}").find("more"),
            std::string::npos);
  EXPECT_NE(message(schema + ", ").find("c.json"), std::string::npos);
}

TEST(CalibrationFile, RefusesWhatNoJsonHolds) {
  CalibrationFile file = sample_file();
  file.calibration.emplace_back("x", std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW((void)format_calibration(file), InputError);
}

}  // namespace
}  // namespace microslip::calibration_file_test
