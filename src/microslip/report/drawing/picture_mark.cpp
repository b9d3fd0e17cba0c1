// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/picture_mark.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "microslip/base/version.hpp"

namespace microslip {
namespace {

std::string program_text() { return fmt::format("microslip {}", kVersion); }

/// The check of a chunk of PNG: W3C, Portable Network Graphics Specification, annex D.
std::uint32_t cyclic_check(std::string_view bytes) {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::uint32_t check = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    check ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      check = (check >> 1U) ^ ((check & 1U) != 0 ? kPolynomial : 0U);
    }
  }
  return ~check;
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
  }
  return bytes;
}

/// A PDF file counts its bytes, so the text keeps its length.
/// @return whether the producer stands there so that it can be named.
bool mark_producer(std::string& picture) {
  constexpr std::string_view kKey = "/Producer (";
  constexpr std::string_view kEnd = "))";  // of "(cairo 1.16.0 (https://cairographics.org))"
  const std::size_t at = picture.find(kKey);
  const std::size_t end = at == std::string::npos ? at : picture.find(kEnd, at);
  if (end == std::string::npos) return false;
  const std::size_t start = at + kKey.size();
  const std::size_t length = end + 1 - start;
  std::string text = program_text() + ", gnuplot, cairo";
  if (picture.find('\n', at) < end || text.size() > length) return false;
  text.resize(length, ' ');
  picture.replace(start, length, text);
  return true;
}

}  // namespace

void mark_svg(std::string& picture) {
  constexpr std::string_view kBefore = "<desc>Produced by ";
  const std::size_t at = picture.find(kBefore);
  if (at != std::string::npos) picture.insert(at + kBefore.size(), program_text() + " with ");
}

/// A chunk tEXt behind the first, IHDR, which has 13 bytes of content.
void mark_png(std::string& picture) {
  constexpr std::size_t kAfterHeader = 8 + 4 + 4 + 13 + 4;
  if (picture.size() < kAfterHeader || picture.compare(12, 4, "IHDR") != 0) return;
  const std::string chunk = "tEXtSoftware" + std::string(1, '\0') + program_text();
  picture.insert(kAfterHeader, big_endian(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk +
                                   big_endian(cyclic_check(chunk)));
}

/// Newer releases of cairo compress the producer: then a comment at the end, which moves no byte.
void mark_pdf(std::string& picture) {
  if (!mark_producer(picture)) picture += "\n% " + program_text() + "\n";
}

}  // namespace microslip
