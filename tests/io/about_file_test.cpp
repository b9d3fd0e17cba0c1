// SPDX-License-Identifier: MIT
#include "microslip/documents/study/about_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip::about_file_test {
namespace {

using test::message_of;

const std::string kSchema = "schema = \"microslip.about/1\"\n";

TEST(AboutFile, HasWhatStandsAtTheHeadOfAReport) {
  const ReportAbout about = parse_about(
      kSchema +
          "date = \"today\"\ntitle = \"Plate\"\ncustomer = \"Böse & Co\"\nobject = \"No. 12\"\n",
      "about.toml");
  EXPECT_EQ(about.title, "Plate");
  EXPECT_EQ(about.particulars,
            (std::vector<std::pair<std::string, std::string>>{
                {"Object", "No. 12"}, {"Customer", "Böse & Co"}, {"Date", "today"}}));
  EXPECT_TRUE(about.logo.empty());
  EXPECT_TRUE(parse_about(kSchema, "about.toml").particulars.empty());
  EXPECT_EQ(file_kind(kSchema), kAboutKind);
}

TEST(AboutFile, TakesALogoBesideIt) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("about.toml");
  for (const auto& [name, bytes, type] :
       {std::tuple{"a.png", "\x89PNG\r\n\x1A\n and IEND", "image/png"},
        std::tuple{"a.jpg", "\xFF\xD8\xFF\xE0 and \xFF\xD9", "image/jpeg"},
        std::tuple{"a.svg", "<svg></svg>\n", "image/svg+xml"},
        std::tuple{"b.svg", "<!-- by hand -->\n<svg></svg>", "image/svg+xml"},
        std::tuple{"c.svg", "<!DOCTYPE svg PUBLIC \"\">\n<svg></svg>", "image/svg+xml"}}) {
    test::put(folder.file(name), bytes);
    test::put(file, kSchema + "logo = \"" + name + "\"\n");
    EXPECT_EQ(read_about(file).logo, bytes);
    EXPECT_EQ(read_about(file).logo_type, type);
  }
}

TEST(AboutFile, NamesThePlaceOfAFault) {
  const test::TemporaryFolder folder;
  const auto fault = [&](const std::string& line) {
    const std::string text =
        message_of<Error>([&] { (void)parse_about(kSchema + line, folder.file("about.toml")); });
    return text.substr(text.rfind('/') + 1);
  };
  EXPECT_EQ(fault("custumer = \"x\"\n"),
            "about.toml:2:1: expected at the top the keys schema, title, logo, object, customer, "
            "order, operator, date, found the unknown key 'custumer'. Did you mean 'customer'?");
  EXPECT_EQ(fault("date = \" \"\n"),
            "about.toml:2:8: expected a text of one line, found ' '. Or leave it out.");
  EXPECT_EQ(fault("order = 12\n"), "about.toml:2:9: order = 12; must be a text in quotes");
  EXPECT_NE(fault("logo = \"none.png\"\n").find("none.png: cannot be read"), std::string::npos);
  test::put(folder.file("a.pdf"), "%PDF-1.4\n");
  test::put(folder.file("a.png"), "\x89PNG\r\n\x1A\n" + std::string(1U << 20U, 'x') + "IEND");
  EXPECT_EQ(
      fault("logo = \"a.png\"\n"),
      "a.png: is larger than 1 MiB, the most for a logo. Save the picture with fewer pixels.");
  EXPECT_EQ(fault("logo = \"a.pdf\"\n"),
            "a.pdf: expected a picture in PNG, JPEG or SVG, found a PDF document");
  test::put(folder.file("a.png"), "");
  EXPECT_EQ(fault("logo = \"a.png\"\n"),
            "a.png: expected a picture in PNG, JPEG or SVG, found an empty file");
  test::put(folder.file("a.svg"), "<!-- an inner picture --><html><svg></svg></html>");
  EXPECT_EQ(fault("logo = \"a.svg\"\n"),
            "a.svg: expected a picture in PNG, JPEG or SVG, found other contents");
  for (const char* cut : {"\x89PNG\r\n\x1A\n and", "\xFF\xD8\xFF\xE0 and", "<svg><rect width="}) {
    test::put(folder.file("a.png"), cut);
    EXPECT_EQ(
        fault("logo = \"a.png\"\n"),
        "a.png: expected the end of the picture, found the end of the file. It was truncated: "
        "copy it again.");
  }
  EXPECT_EQ(fault("logo = \"\"\n"),
            "about.toml:2:8: expected a text of one line, found ''. Or leave it out.");
}

}  // namespace
}  // namespace microslip::about_file_test
