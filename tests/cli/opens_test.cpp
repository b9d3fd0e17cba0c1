// SPDX-License-Identifier: MIT
// How often a call opens its inputs: once to recognise and hash a file, once more to read a
// recording. What is opened again may have changed in between, and over a network each time costs.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "cli/effects_table.hpp"
#include "cli/run_program.hpp"
#include "support/replaced.hpp"

namespace microslip::cli_test::opens_test {
namespace {

/// Counts the opens of files, by the notifications of the kernel.
class Opens {
 public:
  Opens(const Sandbox& box, const std::vector<std::string>& files)
      : queue_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    for (const std::string& file : files) {
      names_[::inotify_add_watch(queue_, box.file(file).c_str(), IN_OPEN)] = file;
    }
  }
  Opens(const Opens&) = delete;
  Opens& operator=(const Opens&) = delete;
  ~Opens() { ::close(queue_); }

  [[nodiscard]] bool watches(std::size_t count) const {
    return names_.size() == count && !names_.contains(-1);
  }

  /// By file, since the last call.
  std::map<std::string, int> counts() {
    std::map<std::string, int> counts;
    std::array<char, 1U << 16U> buffer;
    for (ssize_t size = 0; (size = ::read(queue_, buffer.data(), buffer.size())) > 0;) {
      for (ssize_t at = 0; at < size;) {
        inotify_event event{};
        std::memcpy(&event, buffer.data() + at, sizeof event);
        ++counts[names_.at(event.wd)];
        at += static_cast<ssize_t>(sizeof event) + event.len;
      }
    }
    return counts;
  }

 private:
  int queue_;
  std::map<int, std::string> names_;
};

/// A record in all formats, and as a variable of a file.
const std::vector<std::string> kFormats{"csv", "uff", "mat", "h5"};

/// Runs a call of the inputs and expects that it opens each of the files twice at most.
void expect_two_opens(const Sandbox& box, const std::vector<std::string>& files,
                      const Arguments& call) {
  Opens opens(box, files);
  ASSERT_TRUE(opens.watches(files.size()));
  expect_done(box, call);
  const std::map<std::string, int> counts = opens.counts();
  for (const std::string& name : files) {
    EXPECT_GE(counts.at(name), 1) << name;
    EXPECT_LE(counts.at(name), 2) << name << " by " << call.front();
  }
}

/// The campaign of docs/file_formats.md: two tables of levels, and a sweep that is predicted.
TEST(Opens, OfTablesInACampaign) {
  const std::map<std::string, std::string> documented = documented_files();
  const std::vector<std::string> inputs{"campaign.toml", "beam.toml", "monday.csv", "tuesday.csv",
                                        "stepped.csv"};
  const Sandbox box;
  for (const std::string& name : inputs) box.put(name, documented.at(name));
  Opens opens(box, inputs);
  ASSERT_TRUE(opens.watches(inputs.size()));
  expect_done(box, {"campaign", "campaign.toml", "--out", "found", "--quiet"});
  const std::map<std::string, int> counts = opens.counts();
  for (const std::string& name : inputs) EXPECT_EQ(counts.at(name), 1) << name;
}

/// A decay that is predicted by the model that a campaign has found, in three formats.
TEST(Opens, OfRecordingsThatAreVerified) {
  const std::map<std::string, std::string> documented = documented_files();
  const Sandbox box;
  for (const char* name :
       {"campaign.toml", "beam.toml", "monday.csv", "tuesday.csv", "stepped.csv"}) {
    box.put(name, documented.at(name));
  }
  expect_done(box, {"campaign", "campaign.toml", "--out", "found", "--quiet"});
  expect_done(
      box, {"march", "found/model.toml", "--release", "1:250um", "--duration", "2s",
            "--sampling-rate", "2048Hz", "--no-error-estimate", "--out", "march.csv", "--quiet"});
  const std::string marched = box.get("march.csv");  // whose last row is off the raster
  box.put("decay.csv", marched.substr(0, marched.rfind('\n', marched.size() - 2) + 1));
  const std::vector<std::string> formats{"decay.csv", "decay.uff", "decay.mat"};
  for (const std::string& name : formats) {
    if (name != "decay.csv") expect_done(box, {"convert", "decay.csv", name, "--quiet"});
  }
  Opens opens(box, formats);
  ASSERT_TRUE(opens.watches(formats.size()));
  for (const std::string& name : formats) {
    expect_done(box, {"verify", "found/model.toml", name, "--kind", "ringdown", "--sensor",
                      "acceleration=acc1", "--out", name + ".compared.csv", "--quiet"});
  }
  const std::map<std::string, int> counts = opens.counts();
  for (const std::string& name : formats) EXPECT_LE(counts.at(name), 2) << name;
}

/// Steady records of a rig, reduced, in a campaign and verified.
TEST(Opens, OfSteadyRecords) {
  const std::string example = MICROSLIP_EXAMPLES "/reference_rig/";
  const Sandbox box{
      {"rig.toml", test::replaced(test::get(example + "rig.toml"), "count = 90", "count = 4")},
      {"joint.json", test::get(example + "joint.json")}};
  expect_done(box, {"measure", "rig.toml", "--out", "test", "--quiet"});
  const std::vector<std::string> levels{"1", "2", "3", "4"};
  for (const std::string& format : kFormats) {
    std::vector<std::string> files;
    for (const std::string& level : levels) {
      files.push_back("l" + level + "." + format);
      expect_done(box, {"convert", "test/level_0" + level + ".csv", files.back(), "--quiet"});
    }
    for (const std::string variable : {"", ":recording_1"}) {
      if (!variable.empty() && format != "mat") continue;
      std::string campaign =
          "schema = \"microslip.campaign/1\"\nstructure = \"rig.toml\"\n"
          "[identification]\nstiffness_N_per_m = 1.7e5\n";
      Arguments reduce{"reduce", "rig.toml"};
      Arguments verify{"verify", "rig.toml", "joint.json"};
      for (std::size_t i = 0; i < files.size(); ++i) {
        campaign += "[[test]]\nname = \"" + levels[i] + "\"\nfile = \"" + files[i] + variable +
                    "\"\nuse = \"identify\"\n";
        reduce.push_back(files[i] + variable);
        verify.push_back(files[i] + variable);
      }
      box.put("campaign.toml", campaign);
      reduce.insert(reduce.end(), {"--out", "levels.csv", "--quiet"});
      verify.insert(verify.end(), {"--out", "verified.csv", "--quiet"});
      expect_two_opens(box, files, reduce);
      expect_two_opens(box, files, verify);
      expect_two_opens(box, files, {"campaign", "campaign.toml", "--out", "found", "--quiet"});
    }
  }
}

/// Force and displacement of a joint, from which it is identified.
TEST(Opens, OfEvidence) {
  const Sandbox box{{"joint.json", test::get(MICROSLIP_EXAMPLES "/reference_joint/joint.json")}};
  std::string path = "displacement [m]\n";
  for (int i = 0; i <= 400; ++i) {
    const double turn = 0.02 * 3.14159265358979 * i;
    path += fmt::format("{}\n", 2e-4 * (0.2 + 0.002 * i) * std::sin(turn));
  }
  box.put("path.csv", path);
  expect_done(box, {"loop", "joint.json", "--path", "path.csv", "--out", "e.csv"});
  for (const std::string format : {"csv", "mat", "h5"}) {
    if (format != "csv") {
      expect_done(box, {"convert", "e.csv", "e." + format, "--rate", "100", "--quiet"});
    }
    expect_two_opens(box, {"e." + format},
                     {"identify", "e." + format, "--out", format + ".json", "--quiet"});
  }
  expect_two_opens(box, {"e.mat"},
                   {"identify", "e.mat:recording_1", "--out", "variable.json", "--quiet"});
}

}  // namespace
}  // namespace microslip::cli_test::opens_test
