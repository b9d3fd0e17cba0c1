// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/op4_matrices.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/replaced.hpp"

namespace microslip::op4_matrices_test {
namespace {

using test::message_of;
using test::replaced;

// KAA = [4 -1 0; -1 5 -2; 0 -2 6] of form 6, PHI of 3 × 2 and MAA = diag(2, 3, 1), as pyYeti
// 1.4.6.5 writes them in each of the forms; its files are those that Nastran reads.
const std::string kDense =
    "       3       3       6       2KAA     1P,6E12.5\n"
    "       1       1       2\n"
    " 4.00000E+00-1.00000E+00\n"
    "       2       1       3\n"
    "-1.00000E+00 5.00000E+00-2.00000E+00\n"
    "       3       2       2\n"
    "-2.00000E+00 6.00000E+00\n"
    "       4       1       1\n"
    " 1.41421E+00\n"
    "       2       3       2       2PHI     1P,6E12.5\n"
    "       1       1       2\n"
    " 1.00000E+00 3.00000E+00\n"
    "       2       1       3\n"
    " 2.00000E+00 4.00000E+00 5.00000E+00\n"
    "       3       1       1\n"
    " 1.41421E+00\n"
    "       3       3       6       2MAA     1P,6E12.5\n"
    "       1       1       1\n"
    " 2.00000E+00\n"
    "       2       2       1\n"
    " 3.00000E+00\n"
    "       3       3       1\n"
    " 1.00000E+00\n"
    "       4       1       1\n"
    " 1.41421E+00\n";

const std::string kStrings =
    "       3       3       6       2KAA     1P,6E12.5\n"
    "       1       0       5\n"
    "     327681\n"
    " 4.00000E+00-1.00000E+00\n"
    "       2       0       7\n"
    "     458753\n"
    "-1.00000E+00 5.00000E+00-2.00000E+00\n"
    "       3       0       5\n"
    "     327682\n"
    "-2.00000E+00 6.00000E+00\n"
    "       4       1       1\n"
    " 1.41421E+00\n"
    "       2       3       2       2PHI     1P,6E12.5\n"
    "       1       0       5\n"
    "     327681\n"
    " 1.00000E+00 3.00000E+00\n"
    "       2       0       7\n"
    "     458753\n"
    " 2.00000E+00 4.00000E+00 5.00000E+00\n"
    "       3       1       1\n"
    " 1.41421E+00\n"
    "       3       3       6       2MAA     1P,6E12.5\n"
    "       1       0       3\n"
    "     196609\n"
    " 2.00000E+00\n"
    "       2       0       3\n"
    "     196610\n"
    " 3.00000E+00\n"
    "       3       0       3\n"
    "     196611\n"
    " 1.00000E+00\n"
    "       4       1       1\n"
    " 1.41421E+00\n";

const std::string kBigStrings =
    "       3      -3       6       2KAA     1P,6E12.5\n"
    "       1       0       6\n"
    "       5       1\n"
    " 4.00000E+00-1.00000E+00\n"
    "       2       0       8\n"
    "       7       1\n"
    "-1.00000E+00 5.00000E+00-2.00000E+00\n"
    "       3       0       6\n"
    "       5       2\n"
    "-2.00000E+00 6.00000E+00\n"
    "       4       1       1\n"
    " 1.41421E+00\n"
    "       2      -3       2       2PHI     1P,6E12.5\n"
    "       1       0       6\n"
    "       5       1\n"
    " 1.00000E+00 3.00000E+00\n"
    "       2       0       8\n"
    "       7       1\n"
    " 2.00000E+00 4.00000E+00 5.00000E+00\n"
    "       3       1       1\n"
    " 1.41421E+00\n"
    "       3      -3       6       2MAA     1P,6E12.5\n"
    "       1       0       4\n"
    "       3       1\n"
    " 2.00000E+00\n"
    "       2       0       4\n"
    "       3       2\n"
    " 3.00000E+00\n"
    "       3       0       4\n"
    "       3       3\n"
    " 1.00000E+00\n"
    "       4       1       1\n"
    " 1.41421E+00\n";

constexpr std::string_view kDenseBinary =
    "18000000030000000300000006000000020000004b41412020202020180000001c0000000100000001000000"
    "040000000000000000001040000000000000f0bf1c0000002400000002000000010000000600000000000000"
    "0000f0bf000000000000144000000000000000c0240000001c00000003000000020000000400000000000000"
    "000000c000000000000018401c00000014000000040000000100000002000000cd3b7f669ea0f63f14000000"
    "18000000020000000300000002000000020000005048492020202020180000001c0000000100000001000000"
    "04000000000000000000f03f00000000000008401c0000002400000002000000010000000600000000000000"
    "00000040000000000000104000000000000014402400000014000000030000000100000002000000cd3b7f66"
    "9ea0f63f1400000018000000030000000300000006000000020000004d414120202020201800000014000000"
    "0100000001000000020000000000000000000040140000001400000002000000020000000200000000000000"
    "000008401400000014000000030000000300000002000000000000000000f03f140000001400000004000000"
    "0100000002000000cd3b7f669ea0f63f14000000";

constexpr std::string_view kStringsBigEndian =
    "00000018000000030000000300000006000000024b4141202020202000000018000000200000000100000000"
    "00000005000500014010000000000000bff00000000000000000002000000028000000020000000000000007"
    "00070001bff00000000000004014000000000000c00000000000000000000028000000200000000300000000"
    "0000000500050002c00000000000000040180000000000000000002000000014000000040000000100000002"
    "3ff6a09e667f3bcd000000140000001800000002000000030000000200000002504849202020202000000018"
    "00000020000000010000000000000005000500013ff000000000000040080000000000000000002000000028"
    "0000000200000000000000070007000140000000000000004010000000000000401400000000000000000028"
    "000000140000000300000001000000023ff6a09e667f3bcd0000001400000018000000030000000300000006"
    "000000024d414120202020200000001800000018000000010000000000000003000300014000000000000000"
    "0000001800000018000000020000000000000003000300024008000000000000000000180000001800000003"
    "0000000000000003000300033ff000000000000000000018000000140000000400000001000000023ff6a09e"
    "667f3bcd00000014";

constexpr std::string_view kBigStringsBinary =
    "1800000003000000fdffffff06000000020000004b4141202020202018000000240000000100000000000000"
    "0600000005000000010000000000000000001040000000000000f0bf240000002c0000000200000000000000"
    "080000000700000001000000000000000000f0bf000000000000144000000000000000c02c00000024000000"
    "030000000000000006000000050000000200000000000000000000c000000000000018402400000014000000"
    "040000000100000002000000cd3b7f669ea0f63f140000001800000002000000fdffffff0200000002000000"
    "504849202020202018000000240000000100000000000000060000000500000001000000000000000000f03f"
    "0000000000000840240000002c00000002000000000000000800000007000000010000000000000000000040"
    "000000000000104000000000000014402c00000014000000030000000100000002000000cd3b7f669ea0f63f"
    "140000001800000003000000fdffffff06000000020000004d41412020202020180000001c00000001000000"
    "0000000004000000030000000100000000000000000000401c0000001c000000020000000000000004000000"
    "030000000200000000000000000008401c0000001c0000000300000000000000040000000300000003000000"
    "000000000000f03f1c00000014000000040000000100000002000000cd3b7f669ea0f63f14000000";

std::string bytes_of(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    unsigned value = 0;
    std::from_chars(hex.data() + i, hex.data() + i + 2, value, 16);
    bytes += static_cast<char>(value);
  }
  return bytes;
}

void expect_stiffness(const SymmetricEntries& matrix) {
  EXPECT_EQ(matrix.size, 3U);
  EXPECT_EQ(matrix.row, (std::vector<std::int32_t>{0, 1, 1, 2, 2}));
  EXPECT_EQ(matrix.column, (std::vector<std::int32_t>{0, 0, 1, 1, 2}));
  EXPECT_EQ(matrix.value, (std::vector<double>{4.0, -1.0, 5.0, -2.0, 6.0}));
}

TEST(Op4, IsReadInEachForm) {
  for (const std::string& bytes :
       {kDense, kStrings, kBigStrings, bytes_of(kDenseBinary), bytes_of(kStringsBigEndian),
        bytes_of(kBigStringsBinary), replaced(kDense, "\n", "\r\n")}) {
    SCOPED_TRACE(bytes.substr(0, 40));
    EXPECT_TRUE(is_op4(bytes.substr(0, 100)));
    expect_stiffness(parse_op4(bytes, "kaa", "m.op4"));
    const SymmetricEntries mass = parse_op4(bytes, "MAA", "m.op4");
    EXPECT_EQ(mass.value, (std::vector<double>{2.0, 3.0, 1.0}));
  }
}

// A file of single precision with 64-bit integers: reals have the length of the integers, MSC
// Nastran's ILP64. Written by hand after the records that pyYeti reads.
TEST(Op4, IsReadWithIntegersOf64Bits) {
  std::string bytes;
  const auto put32 = [&](std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
  };
  const auto put64 = [&](std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes += static_cast<char>(value >> (8 * i));
  };
  put32(48);
  for (const std::uint64_t value : {1U, 1U, 6U, 1U}) put64(value);
  bytes += "KAA             ";
  put32(48);
  for (const std::uint64_t column : {1U, 2U}) {
    put32(32);
    put64(column);
    put64(1);
    put64(1);
    put64(0x4012000000000000U);  // 4.5
    put32(32);
  }
  const SymmetricEntries matrix = parse_op4(bytes, "", "m.op4");
  EXPECT_EQ(matrix.value, (std::vector<double>{4.5}));
}

TEST(Op4, OfFormSixMayHaveOneTriangle) {
  const std::string upper =
      "       2       2       6       1KAA     1P,5E16.9\n"
      "       1       1       1\n 4.000000000E+00\n"
      "       2       1       2\n-1.000000000E+00 5.000000000E+00\n"
      "       3       1       1\n 1.000000000E+00\n";
  EXPECT_EQ(parse_op4(upper, "", "m.op4").value, (std::vector<double>{4.0, -1.0, 5.0}));
  EXPECT_NE(
      message_of<InputError>([&] {
        (void)parse_op4(replaced(upper, "       6       1", "       1       1"), "", "m.op4");
      })
          .find("must be that of (1, 2), -1, as the matrix must be symmetric. A matrix of one "
                "triangle has form 6."),
      std::string::npos);
}

// A row beyond all numbers must not pass by overflow; strings of a column rise, and its record is
// used up.
TEST(Op4Fault, OfRowsIsNamed) {
  const std::string binary = bytes_of(kBigStringsBinary);
  const auto fault = [](const std::string& bytes) {
    return message_of<FormatError>([&] { (void)parse_op4(bytes, "KAA", "m.op4"); });
  };
  const auto with = [&](std::size_t at, std::string_view bytes) {
    std::string changed = binary;
    changed.replace(at, bytes.size(), bytes);
    return changed;
  };
  constexpr std::size_t kFirstRow = 32 + 16 + 4;  // header; marker and column; length of string
  EXPECT_NE(fault(with(kFirstRow, "\xff\xff\xff\x7f")).find("rows of column 1 beyond it"),
            std::string::npos);
  constexpr std::size_t kWords = 32 + 12;
  EXPECT_NE(fault(with(kWords, std::string_view("\0\0\0\0", 4))).find("found more at byte"),
            std::string::npos);
}

TEST(Op4Fault, IsNamed) {
  const auto input_fault = [](const std::string& text, const std::string& name) {
    return message_of<InputError>([&] { (void)parse_op4(text, name, "m.op4"); });
  };
  const auto format_fault = [](const std::string& text) {
    return message_of<FormatError>([&] { (void)parse_op4(text, "KAA", "m.op4"); });
  };
  EXPECT_EQ(input_fault(kDense, ""),
            "m.op4 = 2 square matrices; must be one; there is 'KAA', 'PHI', 'MAA'. Name one "
            "after a colon, m.op4:KAA.");
  EXPECT_EQ(input_fault(kDense, "K"),
            "m.op4 = no matrix K; must be one of the file. It has 'KAA', 'PHI', 'MAA'.");
  EXPECT_EQ(input_fault(kDense, "phi"),
            "m.op4: PHI = real, 3 × 2, of form 2; must be real and square");
  EXPECT_EQ(format_fault(kDense.substr(0, kDense.find("       3       2"))),
            "m.op4:5: expected the rest of a matrix, found the end of the file. The file is "
            "truncated.");
  EXPECT_EQ(format_fault(replaced(kDense, "5.00000E+00-2", "5.0000*E+00-2")),
            "m.op4:5:13: expected a finite number, found ' 5.0000*E+00'");
  EXPECT_EQ(format_fault(replaced(kStrings, "458753", "458755")),
            "m.op4:6: expected matrix KAA of 3 columns and 3 rows, found rows of column 2 beyond "
            "it. The file is damaged, or not of OUTPUT4.");
  const std::string binary = bytes_of(kDenseBinary);
  EXPECT_EQ(format_fault(binary.substr(0, 120)),
            "m.op4: expected a record of 28 bytes, found the end of the file at byte 117. The file "
            "is damaged or truncated.");
  EXPECT_EQ(format_fault(replaced(binary, std::string("\x24\0\0\0\x1c", 5),
                                  std::string("\x25\0\0\0\x1c", 5))),
            "m.op4: expected the size of the record behind it, found another at byte 113. The file "
            "is damaged or truncated.");
}

}  // namespace
}  // namespace microslip::op4_matrices_test
