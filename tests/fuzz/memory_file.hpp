// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace microslip::fuzz {

/// A file in memory, for readers that take a path. Other processes can open it, too.
class MemoryFile {
 public:
  MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();

  /// Replaces what it holds.
  void put(std::string_view bytes) const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  int descriptor_ = -1;
  std::string path_;
};

}  // namespace microslip::fuzz
