// SPDX-License-Identifier: MIT
#include "microslip/io/output/temporaries.hpp"

#include <unistd.h>

#include <atomic>
#include <utility>

namespace microslip {
namespace {

/// A file, or a folder with nothing in it. Safe in a signal handler.
bool remove_path(const char* path) noexcept { return ::unlink(path) == 0 || ::rmdir(path) == 0; }

}  // namespace

/// A list that only grows; entries are used again. An entry's path changes only while it is
/// claimed, and a signal handler looks only at live ones, which it takes out first.
struct Temporary::Entry {
  enum class State { kFree, kClaimed, kLive, kRemoved };

  std::atomic<State> state{State::kClaimed};
  std::string path;
  Entry* next = nullptr;

  static inline std::atomic<Entry*> first{nullptr};
  static_assert(std::atomic<Entry*>::is_always_lock_free &&
                std::atomic<State>::is_always_lock_free);
};

Temporary::Entry* Temporary::claim_entry() {
  for (Entry* entry = Entry::first.load(); entry != nullptr; entry = entry->next) {
    Entry::State expected = Entry::State::kFree;
    if (entry->state.compare_exchange_strong(expected, Entry::State::kClaimed)) return entry;
  }
  auto* entry = new Entry;  // never freed: a handler may walk the list at any time
  entry->next = Entry::first.load();
  while (!Entry::first.compare_exchange_weak(entry->next, entry)) {
  }
  return entry;
}

Temporary::Temporary(std::string path) : path_(std::move(path)), entry_(claim_entry()) {
  entry_->path = path_;
  entry_->state.store(Entry::State::kLive);
}

Temporary::Temporary(Temporary&& other) noexcept
    : path_(std::move(other.path_)), entry_(std::exchange(other.entry_, nullptr)) {}

Temporary::~Temporary() {
  if (entry_ == nullptr) return;
  remove_path(path_.c_str());
  keep();
}

void Temporary::keep() {
  if (entry_ == nullptr) return;
  Entry::State expected = Entry::State::kLive;
  entry_->state.compare_exchange_strong(expected, Entry::State::kFree);
  entry_ = nullptr;
}

void remove_temporaries() noexcept {
  using Entry = Temporary::Entry;
  // Files first, and again while a folder may have become empty by what went before.
  for (bool removed = true; removed;) {
    removed = false;
    for (auto* entry = Entry::first.load(); entry != nullptr; entry = entry->next) {
      Entry::State expected = Entry::State::kLive;
      if (!entry->state.compare_exchange_strong(expected, Entry::State::kClaimed)) continue;
      const bool gone = remove_path(entry->path.c_str());
      entry->state.store(gone ? Entry::State::kRemoved : Entry::State::kLive);
      removed = removed || gone;
    }
  }
}

}  // namespace microslip
