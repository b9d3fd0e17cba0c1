// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>

#include "documents/documents.hpp"

namespace microslip::app::documents_test {
namespace {

/// A program whose help has each sign that means something to roff, Markdown or a shell.
ProgramDescription awkward() {
  static std::string text;
  CLI::App program("All", "microslip");
  CLI::App* command = program.add_subcommand("go", "Goes: there 'and' back");
  command->add_option("--to", text, R"(.5 of \n [m], beta*A^2 in `χ`, "it's" <b>)")
      ->type_name("FILE.csv");
  command->footer("Example:\n  microslip go --to 'x y'\n  .hidden\n");
  return describe(program, "9.8.7");
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in\n" << text;
}

TEST(Documents, ManPageKeepsEachSign) {
  const ProgramDescription program = awkward();
  const std::string page = command_man_page(program, program.commands.at(0));
  expect_part(page, ".TH MICROSLIP\\-GO 1 \"\" \"microslip 9.8.7\" \"microslip\"\n");
  // A line that began with the dot would be an order to roff.
  expect_part(page,
              "\n\\&.5 of \\(rsn [m], beta*A\\(ha2 in \\(ga\\[u03C7]\\(ga, "
              "\\(dqit\\(aqs\\(dq <b>.\n");
  expect_part(page, "\n\\&.hidden\n");
  expect_part(page, "\\fB\\-\\-to\\fR \\fIFILE.csv\\fR\n");
  for (const char c : page) EXPECT_LT(static_cast<unsigned char>(c), 0x80);
}

TEST(Documents, ReferenceKeepsEachSign) {
  const std::string text = command_reference(awkward());
  expect_part(text, R"(`--to FILE.csv`: .5 of \\n [m], beta\*A^2 in \`χ\`, "it's" \<b>.)");
  expect_part(text, "\n    microslip go --to 'x y'\n");
  expect_part(text, "[`microslip go`](#microslip-go)");
}

TEST(Documents, ZshSpecificationsKeepEachSign) {
  const std::string script = zsh_completion(awkward());
  expect_part(script, R"('go:Goes\: there '\''and'\'' back')");
  expect_part(script, R"(--to=[.5 of \\n \[m\], beta*A^2 in `χ`, "it'\''s" <b>]:FILE.csv:)");
}

TEST(Documents, CompletionsKnowTheCommandAndItsFiles) {
  const std::string bash = bash_completion(awkward());
  expect_part(bash, "'words go'");
  expect_part(bash, "'go --to') kind='files csv' ;;");
}

}  // namespace
}  // namespace microslip::app::documents_test
