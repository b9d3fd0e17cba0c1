// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/named_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/input_stream.hpp"

namespace microslip {
namespace {

/// Readers begin the source of a recording with the name of its file: that is not said twice.
std::string name_of_one(const std::string& path, const std::string& source) {
  const std::string file = part_of_file(path).file;
  const std::size_t folders = file.rfind('/') + 1;
  if (!source.starts_with(file.substr(folders))) {
    return fmt::format("{}:{}", input_name(path), source);
  }
  return file.substr(0, folders) + source;
}

}  // namespace

std::vector<Recording> named_recordings(Recordings found, const std::string& path,
                                        std::vector<Warning>& warnings) {
  warnings = std::move(found.warnings);
  const bool several = found.recordings.size() > 1;
  for (Recording& recording : found.recordings) {
    recording.source = several ? name_of_one(path, recording.source) : input_name(path);
  }
  return std::move(found.recordings);
}

void check_opened(const std::vector<TestFile>& opened, const std::vector<std::string>& paths) {
  if (opened.empty() || std::ranges::equal(opened, paths, {}, &TestFile::path)) return;
  throw InputError("opened", fmt::format("{} files", opened.size()),
                   fmt::format("must be those of the {} recordings, in their order", paths.size()));
}

std::string recording_sha256(const std::string& path) {
  InputStream file(part_of_file(path).file);
  return sha256_of_rest(file);
}

std::vector<Warning> joined_warnings(const std::vector<std::vector<Warning>>& warnings) {
  constexpr std::size_t kMost = 50;
  std::vector<Warning> all;
  std::size_t more = 0;
  for (const std::vector<Warning>& of_one : warnings) {
    for (const Warning& warning : of_one) {
      if (std::ranges::find(all, warning.text, &Warning::text) != all.end()) continue;
      if (all.size() < kMost) {
        all.push_back(warning);
      } else {
        ++more;
      }
    }
  }
  if (more > 0) all.push_back({"more_warnings", fmt::format("{} more like these", more)});
  return all;
}

}  // namespace microslip
