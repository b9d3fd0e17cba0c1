// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/writings.hpp"
#include "support/built_file.hpp"

/// Every format that is written, where it cannot be written whole: status 1, one message, nothing
/// at the final name and nothing beside it. A limit of the size of files stands for a full disk,
/// since it needs no rights: from some byte on the system takes no more. A disk that reports its
/// error late, when the file is synced, closed or renamed, is played by failing_calls.

namespace microslip::cli_test::bad_disk_test {
namespace {

namespace fs = std::filesystem;

class BadDisk : public ::testing::TestWithParam<Writing> {
 protected:
  BadDisk() {
    put_inputs(box_);
    given_ = box_.content();
  }

  /// The size of the file that the call makes where nothing hinders it; all that it made is
  /// removed.
  std::size_t whole_size() const {
    expect_made();
    const std::size_t size = fs::file_size(box_.file(GetParam().out));
    remove_made();
    return size;
  }

  void remove_made() const {
    for (const auto& [name, text] : box_.content()) {
      if (!given_.contains(name)) fs::remove_all(name);
    }
    EXPECT_TRUE(box_.content() == given_);
  }

  void expect_made() const {
    const Outcome run = box_.run(GetParam().call);
    ASSERT_EQ(run.status, 0) << run.err;
    ASSERT_TRUE(box_.has(GetParam().out));
  }

  Sandbox box_;
  std::map<std::string, std::string> given_;
};

TEST_P(BadDisk, ThatIsFullLeavesNothing) {
  constexpr std::size_t kMessage = 700;  // which goes to a file here, too
  const std::size_t whole = whole_size();
  std::set<std::size_t> sizes;
  for (const std::size_t size : {kMessage, whole / 3, whole / 2, whole * 9 / 10, whole - 1}) {
    if (size >= kMessage && size < whole) sizes.insert(size);
  }
  ASSERT_FALSE(sizes.empty()) << whole << " bytes are too few to be cut";
  for (const std::size_t size : sizes) {
    SCOPED_TRACE(size);
    expect_unwritten(box_, GetParam().call, {"annot be written"}, {.file_size = size});
  }
  expect_made();
}

/// Whether the program came to the `number`th such call; it then has to be as if it had not run.
bool failed(const Sandbox& box, const Arguments& call, const std::string& what, int number) {
  SCOPED_TRACE(what + " " + std::to_string(number));
  const Sandbox outside;
  const std::vector<std::string> environment{
      "LD_PRELOAD=" + test::built_file("MICROSLIP_FAILING_CALLS", MICROSLIP_FAILING_CALLS),
      "ASAN_OPTIONS=verify_asan_link_order=0",
      "MICROSLIP_FAILING_FOLDER=" + fs::canonical(box.path()).string(),
      "MICROSLIP_FAILING_CALL=" + what,
      "MICROSLIP_FAILING_NUMBER=" + std::to_string(number),
      "MICROSLIP_FAILED=" + outside.file("failed")};
  const auto before = box.content();
  const Outcome run = box.run(call, {.environment = environment});
  if (!outside.has("failed")) {
    EXPECT_EQ(run.status, 0) << run.err;
    return false;
  }
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_NE(run.err.find("Input/output error"), std::string::npos) << run.err;
  EXPECT_TRUE(box.content() == before) << "something was left";
  return true;
}

TEST_P(BadDisk, ThatFailsLateLeavesNothing) {
  for (const char* call : {"close", "fsync", "link"}) {
    int number = 1;
    while (!HasFailure() && failed(box_, GetParam().call, call, number)) ++number;
    EXPECT_GT(number, 1) << "never called: " << call;
    if (HasFailure()) return;
    remove_made();
  }
}

TEST_P(BadDisk, ThatFailsAmongNamesLeavesTheOldFiles) {
  expect_made();
  int number = 1;
  while (!HasFailure() && failed(box_, GetParam().call, "rename", number)) ++number;
  EXPECT_GT(number, 1) << "never called: rename";
}

/// The call where the first lock of a file below the folder fails.
Outcome run_without_lock(const Sandbox& box, const Arguments& call) {
  const Sandbox outside;
  const std::vector<std::string> environment{
      "LD_PRELOAD=" + test::built_file("MICROSLIP_FAILING_CALLS", MICROSLIP_FAILING_CALLS),
      "ASAN_OPTIONS=verify_asan_link_order=0",
      "MICROSLIP_FAILING_FOLDER=" + fs::canonical(box.path()).string(),
      "MICROSLIP_FAILING_CALL=flock",
      "MICROSLIP_FAILING_NUMBER=1",
      "MICROSLIP_FAILED=" + outside.file("failed")};
  return box.run(call, {.environment = environment});
}

// Lustre without flock, NFS without its lock manager.
TEST(DiskWithoutLocks, TakesEnsemblesAndGivesDraws) {
  const Sandbox box;
  put_inputs(box);
  box.put("plan.toml",
          "schema = \"microslip.ensemble/1\"\nkind = \"bootstrap\"\n[bootstrap]\n"
          "levels = \"levels.csv\"\nstiffness_N_per_m = 1.7e5\ncount = 20\n");
  const Outcome ensemble = run_without_lock(box, {"ensemble", "plan.toml", "--out", "r.h5"});
  EXPECT_EQ(ensemble.status, 0) << ensemble.err;
  EXPECT_NE(ensemble.err.find("the file system has no locks"), std::string::npos) << ensemble.err;
  EXPECT_TRUE(box.has("r.h5"));
  ASSERT_EQ(box.run({"identify", "levels.csv", "--stiffness", "1.7e5", "--samples", "20", "--out",
                     "j.json", "--samples-out", "s.h5"})
                .status,
            0);
  const Outcome draws =
      run_without_lock(box, {"dissipation", "j.json", "--amplitude", "1um:9um:3", "--draws", "40",
                             "--samples", "s.h5", "--out", "x.csv"});
  EXPECT_EQ(draws.status, 0) << draws.err;
}

INSTANTIATE_TEST_SUITE_P(EachFormat, BadDisk, ::testing::ValuesIn(all_writings()),
                         [](const auto& each) {
                           std::string name = each.param.out;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace microslip::cli_test::bad_disk_test
