// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/io/uff/uff_recording.hpp"

namespace microslip::bench {
namespace {

/// Channels of noise in a file that is removed in the end. It has just been written: it is read
/// from the page cache.
class NoiseFile {
 public:
  NoiseFile(std::size_t channels, std::size_t points, bool binary) {
    Recording recording{.source = "bench",
                        .axis = {.step = 1.0 / 65536.0, .values = {}},
                        .channels = {},
                        .attributes = {}};
    RandomStream random(1, 0);
    for (std::size_t i = 0; i < channels; ++i) {
      std::vector<double> values(points);
      for (double& value : values) value = random.uniform() - 0.5;
      recording.channels.push_back({.name = "channel " + std::to_string(i),
                                    .dimension = kForce,
                                    .values = std::move(values),
                                    .imaginary = {},
                                    .attributes = {}});
    }
    write_recordings_uff(path_, {&recording, 1}, binary);
  }
  NoiseFile(const NoiseFile&) = delete;
  NoiseFile& operator=(const NoiseFile&) = delete;
  ~NoiseFile() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] auto size() const {
    return static_cast<std::int64_t>(std::filesystem::file_size(path_));
  }

 private:
  std::string path_ =
      (std::filesystem::temp_directory_path() / ("microslip-bench-" + std::to_string(::getpid())))
          .string();
};

void read_file(benchmark::State& state, const NoiseFile& file) {
  for (auto _ : state) {
    const Recordings read = read_recordings_uff(file.path());
    benchmark::DoNotOptimize(read.recordings.data());
  }
  state.SetBytesProcessed(state.iterations() * file.size());
}

/// Four channels of 16 million points, 512 MB: as long records lie on a disk.
void read_uff58b(benchmark::State& state) { read_file(state, NoiseFile(4, 16'000'000, true)); }
BENCHMARK(read_uff58b)->Unit(benchmark::kMillisecond)->UseRealTime();

void read_uff58(benchmark::State& state) { read_file(state, NoiseFile(4, 500'000, false)); }
BENCHMARK(read_uff58)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace microslip::bench
