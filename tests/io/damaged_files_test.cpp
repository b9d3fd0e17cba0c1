// SPDX-License-Identifier: MIT

// Files cut short or with bytes changed at random: each is read as something that keeps the rules,
// or refused with a message of one line that names the file. Run it under the sanitizers.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/damage.hpp"
#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/observe/levels.hpp"

namespace microslip::damaged_files_test {
namespace {

using test::damage;
using test::expect_clear;

const std::string kLevels =
    "# bolted lap joint, 8 levels\n"
    "amplitude [um],dissipation [mJ],frequency [Hz],source,dissipation_std [J]\n"
    "19.562,1.8186e-3,80.3654,\"run 1, left\",1e-9\n"
    "79.241,3.7397e-2,80.1827,run 2,2.5e-9\n"
    "117.46,0.10277,80.1772,\"run \"\"3\"\"\",+3e-9\n"
    "\n"
    "# after a pause\r\n"
    "158.42,0.2418,80.1082,,4e-9\r\n";

const std::string kSemicolonLevels =
    "\xEF\xBB\xBF"
    "amplitude [µm];dissipation [mJ];note\n1,5;2,25e-3;x\n3;4;1,5\n4,125;5;.\n";

const std::string kJoint = R"({ "schema": "microslip.joint/1", "stiffness_N_per_m": 1.7e5,
  "density": [ {"type": "uniform", "from_N": 0, "to_N": 5, "weight": 0.25},
               {"type": "power_law",
                "coefficient": 0.01, "exponent": -0.5, "from_N": 0, "to_N": 25},
               {"type": "piecewise_linear", "slip_force_N": [0, 4, 8],
                "density_per_N": [0.02, 0, 1e-3]},
               {"type": "atoms", "slip_force_N": [1, 2], "weight": [0.1, 0.2]} ],
  "provenance": {"version": "1", "inputs": [{"file": "a", "sha256": "b"}], "seed": 7},
  "identification": {"covered_N": [0, 25], "note": "µ", "deep": {"a": [1, null, "x"]}} }
)";

const std::string kRig = test::get(MICROSLIP_EXAMPLES "/reference_rig/rig.toml");

const std::string kModesRig = R"(schema = 'microslip.rig/1'
damping = { loss_factor = [1e-3] }
modes.frequency_Hz = [ 55.8, +3_49.5,
  978, ] # three
modes.excitation = [1.1, -0.8, 0.3]
"modes".joint = [-2.1e-2, 0x10, 1_0.5]
excitation.channel = """
force"""
accelerometer = [{ shape = [1, 0.5, 0], channel = "a\u00B5" }, { shape = [0, 1, 2], channel = 'b' }]
[vibrometer]
channel = "'"
measures = "joint"
)";

void read_damaged_levels(const std::string& text) {
  const LevelsFile file = parse_levels(text, "the file");
  ASSERT_GT(file.levels.size(), 0U);
  ASSERT_EQ(file.levels.dissipation.size(), file.levels.size());
  ASSERT_EQ(file.line.size(), file.levels.size());
  for (std::size_t i = 0; i < file.levels.size(); ++i) {
    EXPECT_TRUE(std::isfinite(file.levels.amplitude[i]) && file.levels.amplitude[i] > 0.0);
    EXPECT_TRUE(std::isfinite(file.levels.dissipation[i]) && file.levels.dissipation[i] >= 0.0);
  }
}

void read_damaged_joint(const std::string& text) {
  const JointFile file = parse_joint(text, "the file");
  const std::string written = format_joint(file);
  EXPECT_EQ(format_joint(parse_joint(written, "written")), written);
}

TEST(DamagedFiles, Levels) { damage(kLevels, 1, "the file", read_damaged_levels); }

TEST(DamagedFiles, LevelsWithDecimalCommas) {
  damage(kSemicolonLevels, 2, "the file", read_damaged_levels);
}

TEST(DamagedFiles, Joint) { damage(kJoint, 3, "the file", read_damaged_joint); }

void read_damaged_rig(const std::string& text) {
  const Rig rig = parse_rig(text, "the file");
  EXPECT_NO_THROW(check_rig(rig));
  EXPECT_GT(rig.loss_factor_of(0), -1.0);
}

TEST(DamagedFiles, Rig) { damage(kRig, 4, "the file", read_damaged_rig); }

TEST(DamagedFiles, RigOfModes) {
  EXPECT_NO_THROW(read_damaged_rig(kModesRig));
  damage(kModesRig, 5, "the file", read_damaged_rig);
}

TEST(DamagedFiles, RigCutAtEachByte) {
  for (std::size_t size = 0; size <= kRig.size(); ++size) {
    try {
      read_damaged_rig(kRig.substr(0, size));
      EXPECT_GT(size, kRig.find("\"acc1\"")) << "all before it is needed";
    } catch (const Error& error) {
      expect_clear(error.what(), "the file");
    }
  }
}

TEST(DamagedFiles, LevelsCutAtEachByte) {
  for (std::size_t size = 0; size <= kLevels.size(); ++size) {
    try {
      read_damaged_levels(kLevels.substr(0, size));
    } catch (const FormatError& error) {
      expect_clear(error.what(), "the file");
    }
  }
}

TEST(DamagedFiles, JointCutAtEachByte) {
  const std::size_t last_bracket = kJoint.rfind('}');
  for (std::size_t size = 0; size <= last_bracket; ++size) {
    EXPECT_THROW(read_damaged_joint(kJoint.substr(0, size)), FormatError) << size;
  }
}

}  // namespace
}  // namespace microslip::damaged_files_test
