// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// @file
/// Other programs that this one starts.

namespace microslip {

/// A running child. It is gone and reaped when this is. On Linux it also ends, by SIGTERM, with the
/// thread that started it, so that a signal that ends this program ends it, too.
class Child {
 public:
  /// Starts command[0], looked up in PATH where it holds no slash, with the arguments that follow;
  /// no shell is involved. Several threads may do this at once.
  /// @param streams  open files that become its standard input, output and error; it gets no other.
  /// @return nothing where there is no such program.
  /// @throws Error  where the system cannot start it.
  [[nodiscard]] static std::optional<Child> start(std::vector<std::string> command,
                                                  const std::array<int, 3>& streams);

  Child(Child&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Child& operator=(Child&&) = delete;
  ~Child();

  /// Waits for its end. @return its exit status, 128 + the signal that ended it; 0 where this
  ///                            program ignores SIGCHLD and cannot know it.
  int wait();

 private:
  explicit Child(pid_t id) : id_(id) {}

  pid_t id_;
};

}  // namespace microslip
