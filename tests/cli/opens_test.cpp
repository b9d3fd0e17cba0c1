// SPDX-License-Identifier: MIT
// How often a call opens its inputs: once to recognise and hash a file, once more to read a
// recording. What is opened again may have changed in between, and over a network each time costs.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "cli/effects_table.hpp"
#include "cli/run_program.hpp"

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

}  // namespace
}  // namespace microslip::cli_test::opens_test
