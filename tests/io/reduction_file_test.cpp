// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/reduction_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/levels/levels_file.hpp"

namespace microslip::reduction_file_test {
namespace {

using test::message_of;
using Numbers = std::vector<double>;

/// A level with everything known.
ReducedLevel level(double scale, const std::string& source) {
  ReducedLevel level;
  level.source = source;
  level.frequency = 55.25;
  level.resonance_frequency = 55.5;
  level.force_amplitude = 0.5 * scale;
  level.response_amplitude = 3.0 * scale;
  level.amplitude = {1e-5 * scale, 2e-9};
  level.dissipation = {0.1 * scale, 3e-9};
  level.input_energy = {0.25 * scale, 1e-9};
  level.linear_dissipation = 0.15 * scale;
  level.damping_ratio = 0.02;
  level.secant_stiffness = Measured{1.25e5, 40.0};
  level.force_distortion = 0.001;
  return level;
}

std::string header_of(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string text_of(const std::vector<ReducedLevel>& levels) {
  return reduction_table(levels).str();
}

TEST(ReductionFile, HasTheDocumentedColumns) {
  ReducedLevel flagged = level(1.0, "level_1.csv");
  flagged.reversals = 4;
  flagged.flags = {{"inner_reversals", "4 reversals"}, {"few_cycles", "5 cycles"}};
  EXPECT_EQ(text_of({flagged, level(2.0, "level_2.csv")}),
            "amplitude [m],dissipation [J],amplitude_std [m],dissipation_std [J],"
            "secant_stiffness [N/m],secant_stiffness_std [N/m],source,frequency [Hz],"
            "resonance_frequency [Hz],force_amplitude [N],response_amplitude [m/s^2],"
            "input_energy [J],linear_dissipation [J],damping_ratio [1],force_distortion [1],"
            "reversals [1],flags\n"
            "1e-05,0.1,2e-09,3e-09,125000,40,level_1.csv,55.25,55.5,0.5,3,0.25,0.15,0.02,0.001,4,"
            "inner_reversals few_cycles\n"
            "2e-05,0.2,2e-09,3e-09,125000,40,level_2.csv,55.25,55.5,1,6,0.5,0.3,0.02,0.001,2,"
            "\"\"\n");
}

TEST(ReductionFile, ReadsBackAsLevels) {
  ReducedLevel inner = level(1.0 / 3.0, "a.csv");
  inner.reversals = 6;
  const LevelsFile file = parse_levels(text_of({inner, level(0.7, "b.csv")}), "levels.csv");
  EXPECT_EQ(file.levels.amplitude, (Numbers{inner.amplitude.value, 1e-5 * 0.7}));
  EXPECT_EQ(file.levels.dissipation, (Numbers{inner.dissipation.value, 0.1 * 0.7}));
  EXPECT_EQ(file.levels.amplitude_std, (Numbers{2e-9, 2e-9}));
  EXPECT_EQ(file.levels.dissipation_std, (Numbers{3e-9, 3e-9}));
  EXPECT_EQ(file.levels.secant_stiffness, (Numbers{1.25e5, 1.25e5}));
  EXPECT_EQ(file.levels.secant_stiffness_std, (Numbers{40.0, 40.0}));
  EXPECT_EQ(file.reversals, (Numbers{6.0, 2.0}));
  EXPECT_EQ(file.lines_with_inner_reversals(), (std::vector<std::size_t>{2}));
}

/// A column stands for all levels: where one does not know it, an identification has to do without.
TEST(ReductionFile, LeavesOutWhatOneLevelDoesNotKnow) {
  ReducedLevel other = level(2.0, "b.csv");
  other.amplitude.std = 0.0;
  std::string header = header_of(text_of({level(1.0, "a.csv"), other}));
  EXPECT_EQ(header.find("amplitude_std"), std::string::npos);
  EXPECT_NE(header.find("dissipation_std [J]"), std::string::npos);
  other.dissipation.std = 0.0;
  other.secant_stiffness->std = 0.0;
  header = header_of(text_of({level(1.0, "a.csv"), other}));
  EXPECT_TRUE(header.starts_with("amplitude [m],dissipation [J],secant_stiffness [N/m],source"))
      << header;
  other.secant_stiffness.reset();
  header = header_of(text_of({level(1.0, "a.csv"), other}));
  EXPECT_TRUE(header.starts_with("amplitude [m],dissipation [J],source,")) << header;
}

TEST(ReductionFile, NamesOfFilesMayHoldAnything) {
  const std::string text = text_of({level(1.0, "größe, \"1\"\n.csv"), level(2.0, " ")});
  EXPECT_NE(text.find("\"größe, \"\"1\"\" .csv\""), std::string::npos) << text;
  EXPECT_EQ(parse_levels(text, "levels.csv").levels.size(), 2U);
}

TEST(ReductionFile, RefusesWhatIsNoTable) {
  EXPECT_NE(message_of<InputError>([] { return text_of({}); }), "no error");
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ReducedLevel broken = level(1.0, "a.csv");
    broken.linear_dissipation = value;
    EXPECT_NE(message_of<InputError>([&] { return text_of({broken}); }).find("linear_dissipation"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace microslip::reduction_file_test
