// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "documents/description.hpp"

namespace microslip::app::help_description_test {
namespace {

using Words = std::vector<std::string>;

struct Values {
  std::string text;
  std::vector<std::string> texts;
  int number = 12;
  bool flag = false;
};

CommandDescription described(const CLI::App& app) { return describe(app, "1").program; }

TEST(HelpDescription, TellsPositionalsFromOptionsAndFlags) {
  Values v;
  CLI::App app("Does it", "it");
  app.add_option("in", v.text, "Where from")->required();
  app.add_option("rest", v.texts, "And more");
  app.add_option("-o,--out", v.text, "Where to")->required();
  app.add_flag("--fast", v.flag, "Hurry");
  const CommandDescription it = described(app);
  EXPECT_EQ(it.name, "it");
  EXPECT_EQ(it.text, "Does it");
  ASSERT_EQ(it.positionals.size(), 2u);
  EXPECT_EQ(it.positionals[0].names, Words{"in"});
  EXPECT_TRUE(it.positionals[0].required);
  EXPECT_FALSE(it.positionals[0].repeated);
  EXPECT_FALSE(it.positionals[1].required);
  EXPECT_TRUE(it.positionals[1].repeated);
  ASSERT_EQ(it.options.size(), 3u);  // with --help
  EXPECT_EQ(it.options[0].names, (Words{"-h", "--help"}));
  EXPECT_FALSE(it.options[0].takes_value);
  EXPECT_EQ(it.options[1].names, (Words{"-o", "--out"}));
  EXPECT_TRUE(it.options[1].takes_value);
  EXPECT_TRUE(it.options[1].required);
  EXPECT_FALSE(it.options[2].takes_value);
}

TEST(HelpDescription, KnowsChoicesRangesAndDefaults) {
  Values v;
  v.text = "slow";
  CLI::App app("Does it", "it");
  app.add_option("--how", v.text, "How")
      ->check(CLI::IsMember({"slow", "fast"}))
      ->capture_default_str();
  app.add_option("--count", v.number, "How many")->check(CLI::Range(1, 100))->capture_default_str();
  const CommandDescription it = described(app);
  const ArgumentDescription& how = it.options.at(1);
  EXPECT_EQ(how.value.offer, Offer::kChoices);
  EXPECT_EQ(how.value.choices, (Words{"slow", "fast"}));
  EXPECT_EQ(conditions(how), "One of slow, fast. Default: slow.");
  const ArgumentDescription& count = it.options.at(2);
  EXPECT_EQ(count.value.offer, Offer::kNothing);
  EXPECT_EQ(conditions(count), "Allowed: from 1 to 100. Default: 12.");
}

TEST(HelpDescription, KnowsFilesAndFoldersByTheNameOfTheirValue) {
  Values v;
  CLI::App app("Does it", "it");
  app.add_option("--csv", v.text)->type_name("FILE.csv");
  app.add_option("--recording", v.text)->type_name("RECORDING");
  app.add_option("--picture", v.text)->type_name("PICTURE");
  app.add_option("--folder", v.text)->type_name("FOLDER");
  app.add_option("--name", v.text);
  app.add_option("in", v.text);
  const CommandDescription it = described(app);
  EXPECT_EQ(it.options.at(1).value.offer, Offer::kFiles);
  EXPECT_EQ(it.options.at(1).value.endings, Words{"csv"});
  EXPECT_EQ(it.options.at(2).value.endings,
            (Words{"csv", "uff", "unv", "uf", "mat", "h5", "hdf5"}));
  EXPECT_EQ(it.options.at(3).value.endings, (Words{"svg", "png", "pdf"}));
  EXPECT_EQ(it.options.at(4).value.offer, Offer::kFolders);
  EXPECT_EQ(it.options.at(5).value.offer, Offer::kNothing);
  EXPECT_EQ(it.positionals.at(0).value.offer, Offer::kFiles);
  EXPECT_TRUE(it.positionals.at(0).value.endings.empty());
}

TEST(HelpDescription, NamesWhatExcludesEachOtherInTheOrderOfTheLetters) {
  Values v;
  CLI::App app("Does it", "it");
  CLI::Option* c = app.add_option("--c", v.text);
  CLI::Option* a = app.add_option("--a", v.text);
  CLI::Option* b = app.add_option("--b", v.text);
  b->excludes(c)->excludes(a);
  EXPECT_EQ(conditions(described(app).options.at(3)), "Not with --a or --c.");
}

TEST(HelpDescription, LeavesOutWhatIsHidden) {
  Values v;
  CLI::App app("Does it", "it");
  app.add_option("--secret", v.text)->group("");
  app.add_subcommand("shown", "One");
  app.add_subcommand("hidden", "Two")->group("");
  const ProgramDescription program = describe(app, "1");
  EXPECT_EQ(program.program.options.size(), 1u);
  ASSERT_EQ(program.commands.size(), 1u);
  EXPECT_EQ(program.commands[0].name, "it shown");
  EXPECT_EQ(subcommand_name(program.commands[0]), "shown");
}

TEST(HelpDescription, TakesTheEndOfTheHelpApart) {
  CLI::App app("Does it", "it");
  app.footer("Plain.\nExamples:\n  it in \\\n     out\n  it\n\nStatus:\n  0  done\n");
  const std::vector<HelpSection> sections = described(app).sections;
  ASSERT_EQ(sections.size(), 3u);
  EXPECT_EQ(sections[0].heading, "");
  EXPECT_EQ(sections[0].lines, Words{"Plain."});
  EXPECT_EQ(sections[1].heading, "Examples");
  EXPECT_EQ(sections[1].lines, (Words{"it in \\", "   out", "it"}));
  EXPECT_EQ(sections[2].lines, Words{"0  done"});
}

}  // namespace
}  // namespace microslip::app::help_description_test
