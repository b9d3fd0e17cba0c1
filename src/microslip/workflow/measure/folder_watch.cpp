// SPDX-License-Identifier: MIT
#include "microslip/workflow/measure/folder_watch.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// A file that was last changed so long ago by its own clock need not be watched first.
bool is_old(const fs::file_time_type& time, std::chrono::milliseconds still) {
  return fs::file_time_type::clock::now() - time > still;
}

}  // namespace

FolderWatch::FolderWatch(std::string folder, std::chrono::milliseconds still, Wanted wanted)
    : folder_(std::move(folder)), still_(still), wanted_(std::move(wanted)) {}

bool FolderWatch::is_temporary(const std::string& name) {
  constexpr std::array<std::string_view, 7> kEndings{"~",    ".tmp",        ".part", ".partial",
                                                     ".swp", ".crdownload", "#"};
  if (name.empty() || name.front() == '.' || name.front() == '~' || name.front() == '#') {
    return true;
  }
  return std::ranges::any_of(kEndings,
                             [&](std::string_view ending) { return name.ends_with(ending); });
}

void FolderWatch::note(const std::string& path, Clock::time_point now, FolderChange& change) {
  std::error_code no_size;
  std::error_code no_time;
  const std::uintmax_t size = fs::file_size(path, no_size);
  const fs::file_time_type time = fs::last_write_time(path, no_time);
  if (no_size || no_time) return;  // gone between two calls
  const std::int64_t changed = time.time_since_epoch().count();
  const auto [entry, is_new] = files_.try_emplace(path);
  Seen& seen = entry->second;
  seen.there = true;
  if (is_new || seen.size != size || seen.changed != changed) {
    seen = {size, changed, now, false, true};
    if (is_new && is_old(time, still_)) seen.since = now - still_;
  }
  if (!seen.whole && now - seen.since >= still_ && size > 0) {
    seen.whole = true;
    change.changed.push_back(path);
  }
  if (seen.whole) change.whole.push_back(path);
  // An empty file is one that somebody is about to write.
  if (!seen.whole && size > 0) change.waiting = true;
}

FolderChange FolderWatch::look(Clock::time_point now) {
  FolderChange change;
  for (auto& [path, seen] : files_) seen.there = false;
  for (const std::string part : {"", "recordings"}) {
    const fs::path folder = part.empty() ? fs::path(folder_) : fs::path(folder_) / part;
    std::error_code error;
    for (fs::directory_iterator next(folder, error), end; !error && next != end;
         next.increment(error)) {
      const std::string name = next->path().filename().string();
      std::error_code none;
      if (is_temporary(name) || !wanted_(name) || !next->is_regular_file(none)) continue;
      note(next->path().string(), now, change);
    }
    if (error && part.empty()) throw FileError(folder_, "cannot be read: " + error.message());
  }
  std::erase_if(files_, [&](const auto& entry) {
    if (!entry.second.there && entry.second.whole) change.gone = true;
    return !entry.second.there;
  });
  std::ranges::sort(change.whole);
  std::ranges::sort(change.changed);
  return change;
}

}  // namespace microslip
