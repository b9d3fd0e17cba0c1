// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/flag_meanings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "io/support.hpp"

namespace microslip::flag_meanings_test {
namespace {

const std::filesystem::path kRoot = std::filesystem::path(MICROSLIP_EXAMPLES).parent_path();

/// Codes as they stand in a source: a text follows them, or they are named constants.
void collect(const std::string& source, std::set<std::string>& codes) {
  static const std::regex kBesideText(
      R"re((?:[{?]|add_flag(?:_once)?\(\s*[\w.]+,)\s*"([a-z]+(?:_[a-z]+)*)"(?: : "([a-z_]+)")?,\s*(?:fmt::format\(|"[A-Z]))re");
  static const std::regex kNamed(R"re(string_view k\w+ = "([a-z]+(?:_[a-z]+)+)";)re");
  for (const std::regex* pattern : {&kBesideText, &kNamed}) {
    for (std::sregex_iterator found(source.begin(), source.end(), *pattern), end; found != end;
         ++found) {
      for (std::size_t group = 1; group < found->size(); ++group) {
        if ((*found)[group].matched) codes.insert((*found)[group].str());
      }
    }
  }
}

/// Of levels, records and verifications.
std::set<std::string> codes_in_the_source() {
  std::set<std::string> codes;
  for (const char* folder : {"signal", "rig"}) {
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(kRoot / "src" / "microslip" / folder)) {
      if (file.is_regular_file()) collect(test::get(file.path().string()), codes);
    }
  }
  for (const char* file : {"joint/covered_range.cpp", "observe/record_cycles.hpp",
                           "workflow/reduce/modal_decay.cpp"}) {
    collect(test::get((kRoot / "src/microslip" / file).string()), codes);
  }
  return codes;
}

TEST(FlagMeanings, EveryFlagOfTheSourceIsExplainedInReportAndDocumentation) {
  const std::set<std::string> codes = codes_in_the_source();
  // One of each manner of writing, so that the search is seen to work.
  for (const std::string known : {"spike", "clipped", "amplitude_rises", "mode_lost", "macro_slip",
                                  "inner_reversals", "beyond_identification"}) {
    EXPECT_TRUE(codes.contains(known)) << known;
  }
  const std::string formats = test::get((kRoot / "docs/file_formats.md").string());
  for (const std::string& code : codes) {
    EXPECT_FALSE(flag_meaning(code).empty()) << code << " is not in flag_meanings.cpp";
    EXPECT_NE(formats.find("`" + code + "`"), std::string::npos)
        << code << " is not in file_formats.md";
  }
}

}  // namespace
}  // namespace microslip::flag_meanings_test
