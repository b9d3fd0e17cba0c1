// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace microslip {

/// The name of a file that is to vanish: it is removed on destruction, unless keep() was called,
/// and by remove_temporaries(). So is a folder, unless it holds something.
class Temporary {
 public:
  /// @param path  of the file or folder; it need not exist yet.
  explicit Temporary(std::string path);
  /// Takes over what the other was to remove.
  Temporary(Temporary&& other) noexcept;
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary();

  /// The name, as given.
  [[nodiscard]] const std::string& path() const { return path_; }

  /// The file has got its final name: there is nothing to remove any more.
  void keep();

 private:
  struct Entry;

  static Entry* claim_entry();
  friend void remove_temporaries() noexcept;

  std::string path_;
  Entry* entry_;
};

/// Removes the files and empty folders of all Temporary objects of the process. It allocates
/// nothing and takes no lock, so that a handler of a signal may call it before it ends the process.
void remove_temporaries() noexcept;

}  // namespace microslip
