// SPDX-License-Identifier: MIT

// Files cut short or with bytes changed at random: each is read as something that keeps the rules,
// or refused with a message of one line that names the file. Run it under the sanitizers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "microslip/base/error.hpp"
#include "microslip/identify/levels.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"

namespace microslip {
namespace {

constexpr int kCases = 10000;

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

/// Bytes that matter to the formats come more often than chance would have it.
char any_byte(std::mt19937_64& random) {
  static const std::string favourites = "\n\r\t ,;\"#[]{}:.+-eE0919nai\\/\xEF\xBB\xBF\xB5\xFF";
  const std::uint64_t choice = random();
  return choice % 3 == 0 ? static_cast<char>(choice >> 32U)
                         : favourites[(choice >> 8U) % favourites.size()];
}

std::string damaged(std::string text, std::mt19937_64& random) {
  const auto position = [&] { return random() % (text.size() + 1); };
  for (std::uint64_t n = 1 + random() % 4; n > 0; --n) {
    const std::size_t at = position();
    switch (random() % 6) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text.erase(at, random() % 20);
        break;
      case 2:
        text.insert(at, 1, any_byte(random));
        break;
      case 3:
        text.insert(at, text.substr(position(), random() % 60));
        break;
      default:
        if (at < text.size()) text[at] = any_byte(random);
    }
  }
  return text;
}

void expect_clear(const std::string& message, const std::string& file) {
  EXPECT_EQ(message.substr(0, file.size()), file) << message;
  EXPECT_LT(message.size(), 500U) << message;
  EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20;
  })) << message;
}

struct Counts {
  int read = 0;
  int refused = 0;
};

template <class Read>
Counts damage(const std::string& original, std::uint64_t seed, const Read& read) {
  Counts counts;
  std::mt19937_64 random(seed);
  for (int i = 0; i < kCases; ++i) {
    const std::string text = damaged(original, random);
    (void)file_kind(text);
    try {
      read(text);
      ++counts.read;
    } catch (const Error& error) {
      ++counts.refused;
      expect_clear(error.what(), "the file");
    }
  }
  EXPECT_GT(counts.read, kCases / 100);
  EXPECT_GT(counts.refused, kCases / 10);
  return counts;
}

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

TEST(DamagedFiles, Levels) { damage(kLevels, 1, read_damaged_levels); }

TEST(DamagedFiles, LevelsWithDecimalCommas) { damage(kSemicolonLevels, 2, read_damaged_levels); }

TEST(DamagedFiles, Joint) { damage(kJoint, 3, read_damaged_joint); }

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
}  // namespace microslip
