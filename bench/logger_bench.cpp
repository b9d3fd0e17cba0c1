// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "microslip/io/open/recording_file.hpp"

namespace microslip::bench {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes of the files are written so");

constexpr std::size_t kPoints = std::size_t{1} << 23U;
constexpr std::size_t kChannels = 2;

template <class Number>
void append_bytes(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append_text(std::string& bytes, std::string_view text) {
  append_bytes(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

template <class Number>
void append_samples(std::string& bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    append_bytes(bytes, static_cast<Number>(1e-3 * static_cast<double>(i % 1009)));
  }
}

/// One segment of waveforms in doubles, channel by channel, as LabVIEW writes it
/// [NI, "The NI TDMS File Format"].
std::string tdms_file() {
  constexpr std::uint32_t kDoubles = 10;
  std::string metadata;
  append_bytes(metadata, static_cast<std::uint32_t>(kChannels));
  for (const char* path : {"/'Run'/'force'", "/'Run'/'acceleration'"}) {
    append_text(metadata, path);
    append_bytes(metadata, std::uint32_t{20});
    append_bytes(metadata, kDoubles);
    append_bytes(metadata, std::uint32_t{1});
    append_bytes(metadata, std::uint64_t{kPoints});
    append_bytes(metadata, std::uint32_t{1});
    append_text(metadata, "wf_increment");
    append_bytes(metadata, kDoubles);
    append_bytes(metadata, 1.0 / 8192.0);
  }
  const std::uint64_t values = kChannels * kPoints * sizeof(double);
  std::string file = "TDSm";
  append_bytes(file, std::uint32_t{0xE});
  append_bytes(file, std::uint32_t{4713});
  append_bytes(file, std::uint64_t{metadata.size() + values});
  append_bytes(file, std::uint64_t{metadata.size()});
  file += metadata;
  append_samples<double>(file, kChannels * kPoints);
  return file;
}

/// Two channels of floating-point numbers in four bytes.
std::string wav_file() {
  constexpr std::uint32_t kRate = 51200;
  constexpr std::uint32_t kRow = kChannels * sizeof(float);
  const auto samples = static_cast<std::uint32_t>(kPoints * kRow);
  std::string file = "RIFF";
  append_bytes(file, 36 + samples);
  file += "WAVEfmt ";
  append_bytes(file, std::uint32_t{16});
  append_bytes(file, std::uint16_t{3});
  append_bytes(file, static_cast<std::uint16_t>(kChannels));
  append_bytes(file, kRate);
  append_bytes(file, kRate * kRow);
  append_bytes(file, static_cast<std::uint16_t>(kRow));
  append_bytes(file, std::uint16_t{32});
  file += "data";
  append_bytes(file, samples);
  append_samples<float>(file, kChannels * kPoints);
  return file;
}

void read_logger_file(benchmark::State& state, const char* name, const std::string& bytes) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / name;
  std::ofstream(path, std::ios::binary) << bytes;
  for (auto _ : state) benchmark::DoNotOptimize(read_recordings(path.string(), {}));
  std::filesystem::remove(path);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}

void read_tdms(benchmark::State& state) {
  read_logger_file(state, "microslip_bench.tdms", tdms_file());
}
BENCHMARK(read_tdms)->Unit(benchmark::kMillisecond);

void read_wav(benchmark::State& state) {
  read_logger_file(state, "microslip_bench.wav", wav_file());
}
BENCHMARK(read_wav)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
