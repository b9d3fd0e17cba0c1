// SPDX-License-Identifier: MIT

// Feeds a reader with what libFuzzer makes up. The environment variable MICROSLIP_FUZZ_READER names
// the reader. Beside what the sanitizers find, an input is a finding that takes more than a second
// of processor time or 256 MiB of memory; scripts/fuzz bounds it to 64 KiB.

#include <fmt/format.h>
#include <sanitizer/allocator_interface.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "fuzz/readers.hpp"

namespace microslip::fuzz {
namespace {

constexpr std::int64_t kMostMemory = std::int64_t{256} << 20U;
constexpr double kMostSeconds = 1.0;

/// Whether a reader runs, bytes on the heap beyond those at the start of the run, and the most of
/// any run.
std::atomic<bool> is_reading{false};
std::atomic<std::int64_t> heap{0};
std::atomic<std::int64_t> most_heap{0};
double most_seconds = 0.0;

void note_allocation(const volatile void* /*pointer*/, std::size_t size) {
  if (!is_reading) return;
  const std::int64_t now = heap += static_cast<std::int64_t>(size);
  if (now > most_heap.load(std::memory_order_relaxed)) most_heap = now;
  if (now > kMostMemory) {
    is_reading = false;
    std::fputs("microslip_fuzz: more than 256 MiB of memory\n", stderr);
    std::abort();
  }
}

void note_release(const volatile void* pointer) {
  const void* const block = const_cast<const void*>(pointer);
  if (is_reading && block != nullptr)
    heap -= static_cast<std::int64_t>(__sanitizer_get_allocated_size(block));
}

/// Of this process alone: the program that reads HDF5 keeps limits of its own.
double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

const Reader& chosen_reader() {
  const char* const name = std::getenv("MICROSLIP_FUZZ_READER");
  const auto all = readers();
  const auto found =
      std::ranges::find(all, std::string_view(name == nullptr ? "" : name), &Reader::name);
  if (found != all.end()) return *found;
  std::fputs("microslip_fuzz: MICROSLIP_FUZZ_READER must be one of", stderr);
  for (const Reader& one : all) fmt::print(stderr, " {}", one.name);
  std::fputc('\n', stderr);
  std::_Exit(2);  // of std::exit() libFuzzer would make a finding
}

void say_most() {
  fmt::print(stderr, "microslip_fuzz: largest heap {} KiB, longest run {:.3f} s\n",
             most_heap.load() >> 10U, most_seconds);
}

const Reader& reader() {
  static const Reader& chosen = chosen_reader();
  return chosen;
}

void begin() {
  (void)reader();
  __sanitizer_install_malloc_and_free_hooks(note_allocation, note_release);
  std::atexit(say_most);
}

void run(const std::string& bytes) {
  static MemoryFile file;
  heap = 0;
  const double start = processor_seconds();
  is_reading = true;
  reader().read(bytes, file);
  is_reading = false;
  const double seconds = processor_seconds() - start;
  most_seconds = std::max(most_seconds, seconds);
  if (seconds > kMostSeconds) {
    fmt::print(stderr, "microslip_fuzz: {:.1f} s of processor time\n", seconds);
    std::abort();
  }
}

}  // namespace
}  // namespace microslip::fuzz

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  microslip::fuzz::begin();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  microslip::fuzz::run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
