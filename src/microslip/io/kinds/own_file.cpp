// SPDX-License-Identifier: MIT
#include "microslip/io/kinds/own_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/kinds/comment_text.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

/// A format and the text by which a file of it shows that it was written here.
struct FormatMark {
  std::string_view signature;
  std::string_view mark;
};

constexpr std::array kFormatMarks{
    FormatMark{"JSON", "\"program\": \"microslip\""},
    FormatMark{"an HDF5 file", "microslip."},  // of the schema
    FormatMark{"a MATLAB file", ", written by microslip"},
    FormatMark{"a universal file", "\nmicroslip "},  // a line of dataset 151
    FormatMark{"an SVG picture", "<desc>Produced by microslip "},
    FormatMark{"a PNG picture", std::string_view("Software\0microslip ", 19)},
    FormatMark{"a PDF document", "/Producer (microslip "},
    FormatMark{"a PDF document", "\n% microslip "},  // its last line
    FormatMark{kZipSignature, kFmuMark},
    FormatMark{"an HTML page", "<meta name=\"generator\" content=\"microslip report\">"},
};

/// The mark of pictures of PDF and of JSON stands behind their contents; that of all others in
/// their head.
bool needs_whole(std::string_view signature) {
  return signature == "JSON" || signature == "a PDF document";
}

/// A comment "# microslip 1.2.3: …" above the first line of a table, of TOML or of an export.
bool has_heading(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  constexpr std::string_view kHeading = "microslip ";
  while (!text.empty()) {
    const std::string_view line = take_dos_line(text);
    const std::string_view comment = comment_text(line);
    if (!trimmed(line).empty() && line.front() != '#' && comment.empty()) return false;
    const bool is_heading = comment.starts_with(kHeading) && comment.size() > kHeading.size() &&
                            comment[kHeading.size()] >= '0' && comment[kHeading.size()] <= '9';
    if (is_heading) return true;
  }
  return false;
}

}  // namespace

bool has_own_mark(std::string_view content) {
  if (content.starts_with(kJournalKind)) return true;
  const std::string_view format = signature(content);
  if (format.empty()) return has_heading(content);
  return std::ranges::any_of(kFormatMarks, [&](const FormatMark& one) {
    return one.signature == format && content.find(one.mark) != std::string_view::npos;
  });
}

bool is_own_file(const std::string& path) {
  InputStream file(path);
  const std::string_view head = peek_kind_head(file);
  if (!needs_whole(signature(head))) return has_own_mark(head);
  constexpr std::size_t kLargest = std::size_t{1} << 28U;  // as of JSON that is read
  if (file.size().value_or(0) > kLargest) return false;
  return has_own_mark(read_rest(file, kLargest));
}

bool has_same_bytes(const std::string& a, const std::string& b) {
  InputStream one(a);
  InputStream other(b);
  if (one.size() != other.size()) return false;
  std::string block(std::size_t{1} << 16U, '\0');
  std::string of_other(block.size(), '\0');
  for (;;) {
    const std::size_t size = one.read(block.data(), block.size());
    if (other.read(of_other.data(), of_other.size()) != size) return false;
    if (std::string_view(block).substr(0, size) != std::string_view(of_other).substr(0, size)) {
      return false;
    }
    if (size < block.size()) return true;
  }
}

}  // namespace microslip
