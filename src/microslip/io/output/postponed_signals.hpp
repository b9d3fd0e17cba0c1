// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

namespace microslip {

/// While one lives, signals that end a process wait: in this thread the system keeps them back, and
/// a handler that another thread runs asks postpone_signal(). At the end they take effect. May be
/// nested; other threads are not kept from their work.
class PostponedSignals {
 public:
  PostponedSignals();
  PostponedSignals(const PostponedSignals&) = delete;
  PostponedSignals& operator=(const PostponedSignals&) = delete;
  ~PostponedSignals();

 private:
  sigset_t former_;
};

/// For the handler of a signal that is to end the process: whether it must return, because files
/// are getting their names. The signal is then raised again at the end of PostponedSignals. Safe in
/// a handler.
/// @param signal  its number.
[[nodiscard]] bool postpone_signal(int signal) noexcept;

}  // namespace microslip
