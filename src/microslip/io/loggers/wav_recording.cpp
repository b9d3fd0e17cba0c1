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

constexpr std::uint32_t kUnknownSize = 0xFFFFFFFF;
constexpr std::size_t kChunkHead = 8;  ///< bytes: its name and its size
constexpr std::string_view kConvert = "Convert it first: sox IN -e floating-point -b 32 OUT.wav.";

/// What the bytes of a sample are.
enum WavCode : std::uint16_t { kIntegers = 1, kFloats = 3, kExtensible = 0xFFFE };

struct WavFormat {
  std::uint16_t code = 0;
  std::uint16_t channels = 0;
  std::uint32_t rate = 0;
  std::size_t row = 0;     ///< bytes of a sample of all channels
  std::uint16_t bits = 0;  ///< of a sample, of which the bytes are the next whole ones; 0: unstated

  [[nodiscard]] std::size_t sample() const { return channels == 0 ? 0 : row / channels; }
};

/// Integers of three bytes, the least significant first, or last where `big`.
template <bool big>
void convert_three_bytes(const char* from, std::size_t stride, std::size_t count, double* to) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t byte = 0; byte < 3; ++byte) {
      const auto part = static_cast<unsigned char>(from[i * stride + byte]);
      bits |= std::uint32_t{part} << (8 * (big ? 2 - byte : byte) + 8);
    }
    to[i] = static_cast<double>(std::bit_cast<std::int32_t>(bits) >> 8);
  }
}

/// Whether bytes are in another order than in memory.
/// @param big  whether the most significant byte is the first.
bool swaps(bool big) { return big == (std::endian::native == std::endian::little); }

/// Null where samples of this format are not known here.
/// @param big  whether the most significant byte is the first.
ConvertBytes converter_of(const WavFormat& format, bool big) {
  const bool swap = swaps(big);
  if (format.code == kFloats) {
    if (format.sample() == sizeof(float)) return converter<float>(swap);
    return format.sample() == sizeof(double) ? converter<double>(swap) : nullptr;
  }
  if (format.code != kIntegers) return nullptr;
  switch (format.sample()) {
    case 1:
      return converter<std::uint8_t>(swap);
    case 2:
      return converter<std::int16_t>(swap);
    case 3:
      return big ? convert_three_bytes<true> : convert_three_bytes<false>;
    case 4:
      return converter<std::int32_t>(swap);
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
    const bool is_long = riff.starts_with("RF64") || riff.starts_with("BW64");
    big_ = riff.starts_with("RIFX");
    if ((!is_long && !big_ && !riff.starts_with("RIFF")) || riff.substr(8) != "WAVE") {
      file_.fail("a WAV file, 'RIFF'", "other bytes");
    }
    std::optional<WavFormat> format;
    std::optional<std::uint64_t> long_size;
    for (;;) {
      const std::string head(file_.take(kChunkHead));
      const std::string_view name = std::string_view(head).substr(0, 4);
      const auto size = wav_value<std::uint32_t>(head, 4);
      if (name == "data") {
        if (!format) file_.fail("the chunk 'fmt ' before the samples", "none");
        return read_samples(*format, bytes_of_samples(size, long_size));
      }
      const std::string_view chunk = file_.take(size);
      if (name == "fmt ") format = format_of(chunk);
      if (name == "ds64" && is_long && size >= 16) long_size = wav_value<std::uint64_t>(chunk, 8);
      skip_padding(size);
    }
  }

 private:
  template <class T>
  [[nodiscard]] T wav_value(std::string_view bytes, std::size_t at) const {
    return value_of_bytes<T>(bytes.data() + at, swaps(big_));
  }

  [[nodiscard]] WavFormat format_of(std::string_view chunk) const {
    if (chunk.size() < 16) file_.fail("a format of 16 bytes", fmt::format("{}", chunk.size()));
    WavFormat format;
    format.code = wav_value<std::uint16_t>(chunk, 0);
    format.channels = wav_value<std::uint16_t>(chunk, 2);
    format.rate = wav_value<std::uint32_t>(chunk, 4);
    format.row = wav_value<std::uint16_t>(chunk, 12);
    format.bits = wav_value<std::uint16_t>(chunk, 14);
    if (format.code == kExtensible && chunk.size() >= 28) {
      format.code = static_cast<std::uint16_t>(wav_value<std::uint32_t>(chunk, 24));
    }
    check_format(format);
    return format;
  }

  void check_format(const WavFormat& format) const {
    if (format.channels == 0) file_.fail("a channel or more", "0 channels");
    if (format.row == 0) {
      file_.fail("bytes of a sample of all channels (block size) above 0", "0",
                 "The program that wrote it left out its block size: write it again as WAV.");
    }
    if (format.row % format.channels != 0 || converter_of(format, big_) == nullptr) {
      file_.fail("samples of integers or floating-point numbers",
                 fmt::format("format {} of {} bytes for {} channels", format.code, format.row,
                             format.channels),
                 kConvert);
    }
    const std::size_t stated = (std::size_t{format.bits} + 7) / 8;
    if (format.bits != 0 && stated != format.sample()) {
      file_.fail(fmt::format("samples of {} bits in {} bytes each", format.bits, stated),
                 fmt::format("{} bytes each", format.sample()),
                 "Its header contradicts itself: write it again as WAV.");
    }
  }

  /// Whether the head of a chunk follows whose contents the file can hold. Its name is of printable
  /// ASCII.
  bool is_chunk_next() {
    const std::string_view head = file_.peek(kChunkHead);
    if (head.size() < kChunkHead) return false;
    const bool is_name =
        std::ranges::all_of(head.substr(0, 4), [](char c) { return c >= ' ' && c <= '~'; });
    return is_name && wav_value<std::uint32_t>(head, 4) <= file_.left() - kChunkHead;
  }

  /// A chunk of an odd number of bytes has one more behind it, which some programs leave out.
  void skip_padding(std::uint64_t size) {
    if (size % 2 == 1 && file_.left() > 0 && !is_chunk_next()) file_.skip(1);
  }

  /// Where a program did not go back to write the size, all that follows are samples.
  std::uint64_t bytes_of_samples(std::uint32_t size, const std::optional<std::uint64_t>& of_long) {
    const bool is_unknown =
        size == kUnknownSize || (size == 0 && file_.left() > 0 && !is_chunk_next());
    if (is_unknown) return of_long.value_or(file_.left());
    if (size == 0) {
      file_.fail("samples", "an empty chunk 'data'", "Nothing was recorded: record it again.");
    }
    return size;
  }

  /// Warns of what is not read behind the samples.
  void read_rest(std::uint64_t bytes, std::vector<Warning>& warnings) {
    const auto warn = [&](const std::string& what) {
      warnings.push_back(
          {"samples_left_out", fmt::format("{}, byte {}: {}", path_, file_.offset(), what)});
    };
    skip_padding(bytes);
    while (is_chunk_next()) {
      const std::string head(file_.take(kChunkHead));
      const auto size = wav_value<std::uint32_t>(head, 4);
      if (head.starts_with("data")) {
        warn(
            fmt::format("a second chunk of samples, of {} bytes, is left out; have "
                        "them written in one chunk",
                        size));
      }
      file_.skip(size);
      skip_padding(size);
    }
    if (file_.left() == 0) return;
    warn(fmt::format(
        "{} bytes follow that are no chunk of a WAV file and are left out. Where they "
        "are samples, the size of {} bytes in the header of the samples is wrong, as of "
        "a recording above 4 GiB: sox --ignore-length IN.wav OUT.wav",
        file_.left(), bytes));
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
    std::vector<std::vector<double>> values = read_rows(format, bytes / format.row);
    const std::size_t part = bytes % format.row;
    if (part != 0 && result.warnings.empty()) {
      result.warnings.push_back(
          {"samples_left_out",
           fmt::format(
               "{}, byte {}: {} of the {} bytes of the last sample of all channels are left "
               "out; the size of the samples in the header is wrong",
               path_, file_.offset(), part, format.row)});
    }
    file_.skip(part);
    read_rest(bytes, result.warnings);
    result.recordings.push_back(recording_of(format, values));
    check_foreign(result, path_);
    return result;
  }

  std::vector<std::vector<double>> read_rows(const WavFormat& format, std::size_t rows) {
    std::vector<std::vector<double>> values(format.channels);
    for (auto& channel : values) channel.reserve(rows);
    const ConvertBytes convert = converter_of(format, big_);
    take_rows(file_, rows, format.row, [&](const char* from, std::size_t count) {
      for (auto& channel : values) {
        channel.resize(channel.size() + count);  // piece by piece, which stays in the cache
        convert(from, format.row, count, channel.data() + channel.size() - count);
        from += format.sample();
      }
    });
    return values;
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
  bool big_ = false;  ///< whether the most significant byte is the first
};

}  // namespace

Recordings read_recordings_wav(const std::string& path, const RecordingReadOptions& options) {
  return WavReader(path, options).read();
}

}  // namespace microslip
