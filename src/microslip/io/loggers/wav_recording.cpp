// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/loggers/byte_values.hpp"
#include "microslip/io/loggers/logger_recording.hpp"
#include "microslip/io/loggers/piece_reader.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

/// WAV files are little-endian.
constexpr bool kSwapWav = std::endian::native != std::endian::little;
constexpr std::uint32_t kUnknownSize = 0xFFFFFFFF;

/// What the bytes of a sample are.
enum WavCode : std::uint16_t { kIntegers = 1, kFloats = 3, kExtensible = 0xFFFE };

struct WavFormat {
  std::uint16_t code = 0;
  std::uint16_t channels = 0;
  std::uint32_t rate = 0;
  std::size_t row = 0;  ///< bytes of a sample of all channels

  [[nodiscard]] std::size_t sample() const { return channels == 0 ? 0 : row / channels; }
};

template <class T>
T wav_value(std::string_view bytes, std::size_t at) {
  return value_of_bytes<T>(bytes.data() + at, kSwapWav);
}

/// Integers of three bytes, the least significant first.
void convert_three_bytes(const char* from, std::size_t stride, std::size_t count, double* to) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t byte = 0; byte < 3; ++byte) {
      const auto part = static_cast<unsigned char>(from[i * stride + byte]);
      bits |= std::uint32_t{part} << (8 * byte + 8);
    }
    to[i] = static_cast<double>(std::bit_cast<std::int32_t>(bits) >> 8);
  }
}

/// Null where samples of this format are not known here.
ConvertBytes converter_of(const WavFormat& format) {
  if (format.code == kFloats) {
    if (format.sample() == sizeof(float)) return converter<float>(kSwapWav);
    return format.sample() == sizeof(double) ? converter<double>(kSwapWav) : nullptr;
  }
  if (format.code != kIntegers) return nullptr;
  switch (format.sample()) {
    case 1:
      return converter<std::uint8_t>(kSwapWav);
    case 2:
      return converter<std::int16_t>(kSwapWav);
    case 3:
      return convert_three_bytes;
    case 4:
      return converter<std::int32_t>(kSwapWav);
    default:
      return nullptr;
  }
}

/// Integers as fractions of full scale; those of one byte are unsigned.
void scale_integers(const WavFormat& format, std::vector<double>& values) {
  if (format.code != kIntegers) return;
  const double full = std::ldexp(1.0, static_cast<int>(8 * format.sample() - 1));
  const double middle = format.sample() == 1 ? full : 0.0;
  for (double& value : values) value = (value - middle) / full;
}

class WavReader {
 public:
  WavReader(const std::string& path, const RecordingReadOptions& options)
      : path_(path), options_(options), file_(path, options.progress) {}

  Recordings read() {
    const std::string riff(file_.take(12));
    const bool is_long = riff.starts_with("RF64");
    if ((!is_long && !riff.starts_with("RIFF")) || riff.substr(8) != "WAVE") {
      file_.fail("a WAV file, 'RIFF'", "other bytes");
    }
    std::optional<WavFormat> format;
    std::optional<std::uint64_t> long_size;
    for (;;) {
      const std::string head(file_.take(8));
      const std::string_view name = std::string_view(head).substr(0, 4);
      const auto size = wav_value<std::uint32_t>(head, 4);
      if (name == "data") {
        if (!format) file_.fail("the chunk 'fmt ' before the samples", "none");
        const bool unknown = size == kUnknownSize || (size == 0 && file_.left() > 0);
        return read_samples(*format, unknown ? long_size.value_or(file_.left()) : size);
      }
      const std::string_view chunk = file_.take(size);
      if (name == "fmt ") format = format_of(chunk);
      if (name == "ds64" && is_long && size >= 16) long_size = wav_value<std::uint64_t>(chunk, 8);
      if (size % 2 == 1 && file_.left() > 0) file_.skip(1);
    }
  }

 private:
  [[nodiscard]] WavFormat format_of(std::string_view chunk) const {
    if (chunk.size() < 16) file_.fail("a format of 16 bytes", fmt::format("{}", chunk.size()));
    WavFormat format;
    format.code = wav_value<std::uint16_t>(chunk, 0);
    format.channels = wav_value<std::uint16_t>(chunk, 2);
    format.rate = wav_value<std::uint32_t>(chunk, 4);
    format.row = wav_value<std::uint16_t>(chunk, 12);
    if (format.code == kExtensible && chunk.size() >= 26) {
      format.code = wav_value<std::uint16_t>(chunk, 24);
    }
    if (format.channels == 0 || format.row % format.channels != 0 ||
        converter_of(format) == nullptr) {
      file_.fail("samples of integers or floating-point numbers",
                 fmt::format("format {} of {} bytes for {} channels", format.code, format.row,
                             format.channels),
                 "Convert it first: sox IN -e floating-point -b 32 OUT.wav.");
    }
    return format;
  }

  Recordings read_samples(const WavFormat& format, std::uint64_t bytes) {
    Recordings result;
    if (bytes > file_.left()) {
      if (!options_.allow_truncated) {
        file_.fail(fmt::format("{} bytes of samples", bytes), fmt::format("{}", file_.left()),
                   "It was truncated: copy it again, or read what is left with `allow_truncated`.");
      }
      result.warnings.push_back({"file_truncated", path_ + ": ends within its samples"});
      bytes = file_.left();
    }
    const std::size_t rows = bytes / format.row;
    std::vector<std::vector<double>> values(format.channels);
    for (auto& channel : values) channel.resize(rows);
    const ConvertBytes convert = converter_of(format);
    std::size_t done = 0;
    take_rows(file_, rows, format.row, [&](const char* from, std::size_t count) {
      for (auto& channel : values) {
        convert(from, format.row, count, channel.data() + done);
        from += format.sample();
      }
      done += count;
    });
    result.recordings.push_back(recording_of(format, values));
    check_foreign(result.recordings.front(), path_, result.warnings);
    return result;
  }

  [[nodiscard]] Recording recording_of(const WavFormat& format,
                                       std::vector<std::vector<double>>& values) const {
    Recording recording;
    recording.source = file_name(path_);
    recording.axis.step = step_of_rate(format.rate, path_);
    for (std::size_t i = 0; i < values.size(); ++i) {
      scale_integers(format, values[i]);
      Channel& channel = recording.channels.emplace_back();
      channel.name = fmt::format("channel_{}", i + 1);
      channel.values = std::move(values[i]);
    }
    return recording;
  }

  const std::string& path_;
  const RecordingReadOptions& options_;
  PieceReader file_;
};

}  // namespace

Recordings read_recordings_wav(const std::string& path, const RecordingReadOptions& options) {
  return WavReader(path, options).read();
}

}  // namespace microslip
