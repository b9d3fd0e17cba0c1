// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace microslip {

/// The SHA-256 digest of a byte sequence given piece by piece. [FIPS 180-4, sections 5 and 6.2]
class Sha256 {
 public:
  /// Appends bytes to the sequence.
  void update(std::string_view bytes);

  /// The digest of all that was given, as 64 lower-case hexadecimal digits. Ends the sequence.
  [[nodiscard]] std::string finish();

 private:
  static constexpr std::size_t kBlockSize = 64;

  void compress(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6A09E667U, 0xBB67AE85U, 0x3C6EF372U, 0xA54FF53AU,
                                      0x510E527FU, 0x9B05688CU, 0x1F83D9ABU, 0x5BE0CD19U};
  std::array<unsigned char, kBlockSize> buffer_{};
  std::uint64_t length_ = 0;  ///< bytes so far
};

/// The digest of a text.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace microslip
