// SPDX-License-Identifier: MIT

// faulty_reader WHAT [NUMBER]: does as a reading program what the test of reading processes asks
// for.

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/sample_recordings.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/hdf5/reading_worker.hpp"

namespace microslip {
namespace {

Recordings large_recordings() {
  Recordings whole{test::twelve_recordings(), {{"code", "a text\n"}, {}}};
  whole.recordings.push_back(test::time_recording(300'001));  // more than a pipe holds
  return whole;
}

[[noreturn]] void work_for_ever() {
  volatile unsigned rounds = 0;  // or the compiler takes the loop for one that ends
  for (;;) {
    const unsigned before = rounds;
    rounds = before + 1;
  }
}

/// Not touched: on a busy machine the time would run out first.
void take_memory() {
  std::vector<std::vector<char>> all;
  for (int i = 0; i < 64; ++i) all.emplace_back().reserve(std::size_t{32} << 20U);
}

void print() {
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) (void)!write(stream, "x", 1);
}

int run(const std::string& what, const std::string& number) {
  Recordings read;
  const std::map<std::string, std::function<void(const Progress&)>> deeds{
      {"read", [&](const Progress&) { read = large_recordings(); }},
      {"input",
       [](const Progress&) { throw InputError("a.h5: x", 3.0, "must be 4", "Make it so."); }},
      {"format",
       [](const Progress&) {
         throw FormatError({"a.h5", 3, 7}, "this", "that");
       }},
      {"file", [](const Progress&) { throw FileError("a.h5", "is away"); }},
      {"memory", [](const Progress&) { throw std::bad_alloc(); }},
      {"other",
       [](const Progress&) { throw std::runtime_error("of a kind that no reader throws"); }},
      {"signal", [&](const Progress&) { (void)raise(std::stoi(number)); }},
      {"exit", [](const Progress&) { _exit(0); }},
      {"work", [](const Progress&) { work_for_ever(); }},
      {"wait",
       [](const Progress&) {
         for (;;) pause();
       }},
      {"tell",
       [](const Progress& reported) {
         for (;;) (void)reported(1, 2);
       }},
      {"tell twice",
       [](const Progress& reported) {
         (void)reported(1, 2);
         (void)reported(2, 2);
       }},
      {"take memory", [](const Progress&) { take_memory(); }},
      {"print", [](const Progress&) { print(); }},
  };
  return run_reading_worker("a.h5", {deeds.at(what), [&](ParcelWriter& to) { pass(to, read); }});
}

}  // namespace
}  // namespace microslip

int main(int argc, char** argv) { return microslip::run(argv[1], argc > 2 ? argv[2] : ""); }
