// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/mat/mat_recording.hpp"

namespace microslip::bench {
namespace {

constexpr std::size_t kPoints = std::size_t{1} << 23U;
constexpr std::size_t kChannels = 2;
constexpr std::size_t kBytes = kChannels * kPoints * sizeof(double);

/// A recording on the disk (or in the system's memory of it) while it lives.
class RecordingFile {
 public:
  template <class Write>
  RecordingFile(const char* name, const Write& write)
      : path_((std::filesystem::temp_directory_path() / name).string()) {
    Recording recording;
    recording.axis.step = 1.0 / 8192.0;
    for (const char* channel : {"force", "acceleration"}) {
      recording.channels.emplace_back();
      recording.channels.back().name = channel;
      std::vector<double>& values = recording.channels.back().values;
      values.resize(kPoints);
      for (std::size_t i = 0; i < kPoints; ++i) values[i] = 1e-3 * static_cast<double>(i % 1009);
    }
    write(path_, std::vector{recording});
  }
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;
  ~RecordingFile() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void count_bytes(benchmark::State& state) {
  state.SetBytesProcessed(static_cast<std::int64_t>(kBytes) * state.iterations());
}

/// Two channels of 64 MB, checksums and the check for finite values included.
void read_hdf5(benchmark::State& state) {
  const RecordingFile file("microslip_bench.h5", [](const auto& path, const auto& recordings) {
    write_recordings_hdf5(path, recordings);
  });
  for (auto _ : state) benchmark::DoNotOptimize(read_recordings_hdf5(file.path()));
  count_bytes(state);
}
BENCHMARK(read_hdf5)->Unit(benchmark::kMillisecond);

/// The recording from a MAT file of version 5.
void read_mat(benchmark::State& state) {
  const RecordingFile file("microslip_bench.mat", [](const auto& path, const auto& recordings) {
    write_recordings_mat(path, recordings);
  });
  for (auto _ : state) benchmark::DoNotOptimize(read_recordings_mat(file.path()));
  count_bytes(state);
}
BENCHMARK(read_mat)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
