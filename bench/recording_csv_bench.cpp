// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "microslip/base/random.hpp"
#include "microslip/io/recordings/recording_csv.hpp"

namespace microslip::bench {
namespace {

constexpr std::size_t kPoints = 1'000'000;

/// A million points of a force and three accelerations with noise, as full doubles.
Recording noisy_recording() {
  RandomStream random(7, 1);
  Recording recording;
  recording.source = "bench";
  recording.axis.step = 1.0 / 8192.0;
  for (const char* name : {"force", "acc1", "acc2", "acc3"}) {
    Channel channel;
    channel.name = name;
    channel.dimension = name[0] == 'f' ? kForce : kAcceleration;
    for (std::size_t i = 0; i < kPoints; ++i) {
      channel.values.push_back(std::sin(0.05 * static_cast<double>(i)) + 1e-3 * random.normal());
    }
    recording.channels.push_back(std::move(channel));
  }
  return recording;
}

/// A file with a name of its own, removed in the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string content) {
    std::string name = (std::filesystem::temp_directory_path() / "microslip-bench-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    if (file < 0) throw std::runtime_error("no temporary file");
    ::close(file);
    path_ = name;
    std::ofstream(path_, std::ios::binary) << content;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// With nine significant digits, as loggers write, and commas in place of decimal points if asked
/// for.
std::string logger_text(const Recording& recording, bool commas) {
  std::string text = "time [s];force [N];acc1 [m/s^2];acc2 [m/s^2];acc3 [m/s^2]\n";
  char cell[40];
  for (std::size_t i = 0; i < recording.size(); ++i) {
    std::snprintf(cell, sizeof cell, "%.9f", recording.axis.at(i));
    text += cell;
    for (const Channel& channel : recording.channels) {
      std::snprintf(cell, sizeof cell, ";%.9g", channel.values[i]);
      text += cell;
    }
    text += '\n';
  }
  if (commas) {
    for (std::size_t i = text.find('\n'); i < text.size(); ++i) {
      if (text[i] == '.') text[i] = ',';
    }
  }
  return text;
}

void read_text(benchmark::State& state, const std::string& text) {
  const TemporaryFile file(text);
  for (auto _ : state) {
    const Recordings found = read_recordings_csv(file.path(), {});
    benchmark::DoNotOptimize(found.recordings.data());
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void read_csv(benchmark::State& state) { read_text(state, logger_text(noisy_recording(), false)); }
BENCHMARK(read_csv)->Unit(benchmark::kMillisecond);

void read_csv_decimal_commas(benchmark::State& state) {
  read_text(state, logger_text(noisy_recording(), true));
}
BENCHMARK(read_csv_decimal_commas)->Unit(benchmark::kMillisecond);

void read_csv_full_doubles(benchmark::State& state) {
  read_text(state, format_recording_csv(noisy_recording()));
}
BENCHMARK(read_csv_full_doubles)->Unit(benchmark::kMillisecond);

void write_csv(benchmark::State& state) {
  const Recording recording = noisy_recording();
  const TemporaryFile file("");
  for (auto _ : state) write_recording_csv(file.path(), recording);
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(std::filesystem::file_size(file.path())));
}
BENCHMARK(write_csv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
