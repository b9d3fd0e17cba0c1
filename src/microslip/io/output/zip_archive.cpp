// SPDX-License-Identifier: MIT
#include "microslip/io/output/zip_archive.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr std::uint16_t kZipVersion = 20;        // 2.0: folders in names
constexpr std::uint16_t kUtf8Names = 1U << 11U;  // a flag
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kMidnight = 0;
constexpr std::uint16_t kFirstDay = (0U << 9U) | (1U << 5U) | 1U;  // 1980-01-01
constexpr std::uint16_t kNone = 0;
constexpr std::uint32_t kLargestZip = 0xFFFFFFFFU;
constexpr std::size_t kMostFiles = 0xFFFFU;

constexpr std::array<std::uint32_t, 256> crc_table() {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value & 1U) != 0 ? kPolynomial ^ (value >> 1U) : value >> 1U;
    }
    table[i] = value;
  }
  return table;
}

/// CRC-32 of ZIP. [ITU-T V.42, 8.1.1.6.2]
std::uint32_t crc_of(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc = kTable[(crc ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (crc >> 8U);
  }
  return ~crc;
}

/// Appends numbers, the lowest byte first.
template <class... Unsigned>
void append(std::string& bytes, Unsigned... numbers) {
  const auto one = [&](auto number) {
    for (std::size_t i = 0; i < sizeof number; ++i) {
      bytes += static_cast<char>((number >> (8U * i)) & 0xFFU);
    }
  };
  (one(numbers), ...);
}

/// What the header of a file and its entry in the directory have in common.
std::string description_of(const ArchiveFile& file) {
  const auto size = static_cast<std::uint32_t>(file.content.size());
  std::string bytes;
  append(bytes, kZipVersion, kUtf8Names, kStored, kMidnight, kFirstDay, crc_of(file.content), size,
         size, static_cast<std::uint16_t>(file.name.size()), kNone);
  return bytes;
}

}  // namespace

std::string zip_archive(std::span<const ArchiveFile> files) {
  std::string archive;
  std::string directory;
  for (const ArchiveFile& file : files) {
    const std::string description = description_of(file);
    append(directory, std::uint32_t{0x02014B50U}, kZipVersion);
    directory += description;
    append(directory, kNone, kNone, kNone, std::uint32_t{0},
           static_cast<std::uint32_t>(archive.size()));
    directory += file.name;
    append(archive, std::uint32_t{0x04034B50U});
    archive += description + file.name + file.content;
    if (files.size() > kMostFiles || archive.size() + directory.size() >= kLargestZip) {
      throw InputError("archive", static_cast<double>(archive.size()),
                       "must have less than 4 GiB, and at most 65535 files");
    }
  }
  const auto start = static_cast<std::uint32_t>(archive.size());
  const auto count = static_cast<std::uint16_t>(files.size());
  archive += directory;
  append(archive, std::uint32_t{0x06054B50U}, kNone, kNone, count, count,
         static_cast<std::uint32_t>(directory.size()), start, kNone);
  return archive;
}

}  // namespace microslip
