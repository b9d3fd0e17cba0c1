// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/recordings_provenance.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/workflow/text/distinct_files.hpp"

namespace microslip {
namespace {

/// More recordings than this share one digest.
constexpr std::size_t kMostNamed = 4;

/// The call. Of many recordings the first and the last stand for all: one name after the other,
/// they would make an unreadable line.
std::string short_call(const std::string& line, const std::vector<std::string>& names) {
  if (names.size() <= kMostNamed) return line;
  const std::size_t first = line.find(names.front());
  const std::size_t last = line.rfind(names.back());
  if (first == std::string::npos || last == std::string::npos || last <= first) return line;
  const std::size_t begin = first + names.front().size();
  const std::string between = line.substr(begin, last - begin);
  const bool names_only =
      between.find('\'') == std::string::npos && between.find(" -") == std::string::npos;
  return names_only ? line.substr(0, begin) + " ... " + line.substr(last) : line;
}

}  // namespace

std::string recordings_provenance(const std::string& command, const NamedInput& test,
                                  const std::vector<std::string>& recordings,
                                  const std::vector<std::string>& digests) {
  std::string text = provenance_of(short_call(command, recordings), {test});
  std::string list;
  std::size_t count = 0;
  for (std::size_t i = 0; i < digests.size(); ++i) {
    if (digests[i].empty()) continue;
    const std::string file = part_of_file(recordings[i]).file;
    list += fmt::format("{}  {}\n", digests[i], file);
    ++count;
    if (digests.size() <= kMostNamed) text += '\n' + hash_comment(file, digests[i]);
  }
  if (digests.size() > kMostNamed && count > 0) {
    text += fmt::format("\n{} recordings: sha256sum | sha256sum {}", count, sha256(list));
  }
  return text;
}

std::vector<Warning> copied_recordings(const std::vector<std::string>& recordings,
                                       const std::vector<std::string>& digests) {
  std::vector<InputHash> files;
  for (std::size_t i = 0; i < digests.size(); ++i) files.push_back({recordings[i], digests[i]});
  return same_content_warnings(files, "the recording");
}

}  // namespace microslip
