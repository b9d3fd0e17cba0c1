// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/named_recordings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace microslip::named_recordings_test {
namespace {

std::vector<std::string> names_of(const std::vector<std::string>& sources,
                                  const std::string& path) {
  Recordings found;
  for (const std::string& source : sources) found.recordings.emplace_back().source = source;
  std::vector<Warning> warnings;
  std::vector<std::string> names;
  for (const Recording& recording : named_recordings(found, path, warnings)) {
    names.push_back(recording.source);
  }
  return names;
}

// Readers begin a source with the name of the file; a file that was converted has that of another.
TEST(NamedRecordings, SayTheFileOnce) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of({"a.tdms:Run"}, "lab/a.tdms"), Names{"lab/a.tdms"});
  EXPECT_EQ(names_of({"a.tdms:Run", "a.tdms #2", "b.mat:x"}, "lab/a.tdms"),
            (Names{"lab/a.tdms:Run", "lab/a.tdms #2", "lab/a.tdms:b.mat:x"}));
  EXPECT_EQ(names_of({"a.tdms:Run", "other"}, "a.tdms"), (Names{"a.tdms:Run", "a.tdms:other"}));
}

}  // namespace
}  // namespace microslip::named_recordings_test
