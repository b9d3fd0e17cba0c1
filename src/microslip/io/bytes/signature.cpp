// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/signature.hpp"

#include <array>

#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

using std::literals::operator""sv;

constexpr std::string_view kUtf16Text = "UTF-16 text";

struct Signature {
  std::string_view start;
  std::string_view name;
};

constexpr std::array kBinary{
    Signature{"\x89PNG\r\n\x1A\n"sv, "a PNG picture"},
    Signature{"\x89HDF\r\n\x1A\n"sv, "an HDF5 file"},
    Signature{"MATLAB 7.3 MAT-file"sv, "a MATLAB file"},
    Signature{"MATLAB 5.0 MAT-file"sv, "a MATLAB file"},
    Signature{"%PDF-"sv, "a PDF document"},
    Signature{"PK\x03\x04"sv, "a ZIP archive or a spreadsheet"},
    Signature{"\x1F\x8B"sv, "a gzip archive"},
    Signature{"\xFF\xFE"sv, kUtf16Text},
    Signature{"\xFE\xFF"sv, kUtf16Text},
};

/// After blanks and line breaks.
constexpr std::array kTextSignatures{
    Signature{"{"sv, "JSON"},
    Signature{"<svg"sv, "an SVG picture"},
    Signature{"<!doctype html"sv, "an HTML page"},
    Signature{"<!DOCTYPE html"sv, "an HTML page"},
    Signature{"<html"sv, "an HTML page"},
};

/// A universal file: the first line is -1, right-adjusted in six columns.
bool is_universal_file(std::string_view head) {
  if (!head.starts_with("    -1")) return false;
  const std::string_view rest = head.substr(6, head.find('\n') - 6);
  return head.find('\n') != std::string_view::npos &&
         rest.find_first_not_of(" \r") == std::string_view::npos;
}

}  // namespace

std::string_view signature(std::string_view head) {
  for (const Signature& s : kBinary) {
    if (head.starts_with(s.start)) return s.name;
  }
  if (is_universal_file(head)) return "a universal file";
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  head.remove_prefix(first);
  for (const Signature& s : kTextSignatures) {
    if (head.starts_with(s.start)) return s.name;
  }
  if (head.starts_with("<?xml") && head.find("<svg") != std::string_view::npos) {
    return "an SVG picture";
  }
  return {};
}

std::string_view remedy_for_signature(std::string_view signature) {
  return signature == kUtf16Text ? "Save it as UTF-8." : "Is it the right file?";
}

}  // namespace microslip
