// SPDX-License-Identifier: MIT
#include "microslip/documents/study/about_file.hpp"

#include <algorithm>
#include <array>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestAbout = std::size_t{1} << 16U;
constexpr std::size_t kLargestLogo = std::size_t{1} << 20U;

struct Particular {
  std::string_view key;
  std::string_view heading;
};

/// In the order of a report.
constexpr std::array kParticulars{Particular{"object", "Object"},
                                  Particular{"customer", "Customer"}, Particular{"order", "Order"},
                                  Particular{"operator", "Operator"}, Particular{"date", "Date"}};

std::string line_in(const TomlTable& table, std::string_view key) {
  const std::string text = table.text(key);
  const bool is_line = std::ranges::none_of(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; });
  if (is_line && !trimmed(text).empty()) return text;
  throw FormatError(table.place(key), "a text of one line", in_quotes(text), "Or leave it out.");
}

/// Empty where it is no picture that browsers show.
std::string_view picture_type(std::string_view bytes) {
  if (signature(bytes) == "a PNG picture") return "image/png";
  if (signature(bytes) == "an SVG picture") return "image/svg+xml";
  return bytes.starts_with("\xFF\xD8\xFF") ? "image/jpeg" : "";
}

/// Whether the end of the picture is there, which a browser would show broken.
bool is_whole(std::string_view bytes, std::string_view type) {
  if (type == "image/png") return bytes.find("IEND") < bytes.size();
  if (type == "image/jpeg") return bytes.find("\xFF\xD9") < bytes.size();
  const std::size_t last = bytes.find_last_not_of(" \t\r\n");
  return last < bytes.size() && bytes[last] == '>';
}

void read_logo(const TomlTable& table, std::string_view file, ReportAbout& about) {
  const std::string path = file_beside(std::string(file), line_in(table, "logo"));
  about.logo = read_file_head(path, kLargestLogo + 1);
  about.logo_type = picture_type(about.logo);
  if (about.logo_type.empty()) {
    const std::string_view found = signature(about.logo);
    throw FormatError({path, 0, 0}, "a picture in PNG, JPEG or SVG",
                      about.logo.empty() ? "an empty file"
                      : found.empty()    ? "other contents"
                                         : found);
  }
  if (about.logo.size() > kLargestLogo) {
    throw FileError(path, "is larger than 1 MiB, the most for a logo",
                    "Save the picture with fewer pixels.");
  }
  if (is_whole(about.logo, about.logo_type)) return;
  throw FormatError({path, 0, 0}, "the end of the picture", "the end of the file",
                    "It was truncated: copy it again.");
}

}  // namespace

ReportAbout parse_about(std::string_view text, std::string_view file) {
  const toml::table table = parse_toml(text, file);
  const TomlTable top(table, file);
  check_schema(top.place("schema"), top.text("schema"), kAboutKind, "the head of a report");
  std::vector<std::string_view> keys{"schema", "title", "logo"};
  for (const Particular& particular : kParticulars) keys.push_back(particular.key);
  top.allow_only(keys);
  ReportAbout about;
  if (top.has("title")) about.title = line_in(top, "title");
  for (const auto& [key, heading] : kParticulars) {
    if (top.has(key)) about.particulars.emplace_back(heading, line_in(top, key));
  }
  if (top.has("logo")) read_logo(top, file, about);
  return about;
}

ReportAbout read_about(const std::string& path) {
  return parse_about(read_text(path, kLargestAbout), path);
}

}  // namespace microslip
