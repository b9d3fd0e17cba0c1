// SPDX-License-Identifier: MIT
#include "microslip/io/output/postponed_signals.hpp"

#include <atomic>

namespace microslip {
namespace {

std::atomic<int> postponing{0};
std::atomic<int> waiting_signal{0};
static_assert(std::atomic<int>::is_always_lock_free);

}  // namespace

PostponedSignals::PostponedSignals() : former_{} {
  sigset_t all;
  ::sigfillset(&all);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigdelset(&all, fault);
  ::pthread_sigmask(SIG_BLOCK, &all, &former_);
  ++postponing;
}

PostponedSignals::~PostponedSignals() {
  const bool last = --postponing == 0;
  ::pthread_sigmask(SIG_SETMASK, &former_, nullptr);
  if (!last) return;
  if (const int signal = waiting_signal.exchange(0); signal != 0) ::raise(signal);
}

// The signal is noted before the count is read, and the count lowered before the note is read: one
// of the two sees the other, so that no signal is lost.
bool postpone_signal(int signal) noexcept {
  waiting_signal = signal;
  if (postponing != 0) return true;
  waiting_signal = 0;
  return false;
}

}  // namespace microslip
