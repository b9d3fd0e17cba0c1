// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "cli/writings.hpp"
#include "io/support.hpp"
#include "microslip/base/random.hpp"
#include "support/built_file.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/thinned_table.hpp"

/// Ended by a signal at any moment, by one that cannot be caught, too: what stands under a final
/// name is whole, and the next run does all as if nothing had been and takes away what was left.

namespace microslip::cli_test::killed_test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Contents = std::map<std::string, std::string>;

bool kills_given() { return std::getenv("MICROSLIP_KILLS") != nullptr; }

/// Every third short call is killed, but in the studies; under the sanitizers every fifth: each is
/// run whole by other tests, and what a kill leaves is the same.
const std::size_t kStride = test::kSanitized ? 5 : test::in_studies() || kills_given() ? 1 : 3;

/// Random kills: one of each call that is taken, or as many as MICROSLIP_KILLS says.
int kills(std::size_t calls) {
  const char* const given = std::getenv("MICROSLIP_KILLS");
  return given == nullptr ? static_cast<int>(calls) : std::atoi(given);
}

const std::string kTwoJoints = MICROSLIP_TEST_DATA "/two_joints/";

const std::string kStructure =
    "schema = \"microslip.structure/1\"\n"
    "[matrices]\nstiffness = \"stiffness.mtx\"\nmass = \"mass.mtx\"\n"
    "[[point]]\nname = \"drive\"\nrow = 1\n"
    "[[joint]]\nname = \"joint\"\nto = { row = 6 }\nfile = \"joint.json\"\n"
    "[modes]\ncount = 6\njoints = \"stuck\"\nloss_factor = [0.003]\n"
    "[excitation]\npoint = \"drive\"\n";

const std::string kPlan =
    "schema = \"microslip.ensemble/1\"\nkind = \"bootstrap\"\n"
    "[bootstrap]\nlevels = \"levels.csv\"\nstiffness_N_per_m = 1.7e5\ncount = 20\n";

/// A mass on a table that is shaken, without a joint.
const std::string kShaken =
    "schema = \"microslip.model/1\"\n"
    "[structure]\nfrequency_Hz = [12.0]\ndamping_ratio = [0.03]\n"
    "[[structure.point]]\nname = \"mass\"\nshape = [0.5]\n"
    "[[structure.base]]\nname = \"table\"\nparticipation = [2.0]\npoint_motion = [1.0]\n"
    "[excitation]\nbase = \"table\"\n[response]\npoint = \"mass\"\n";

const std::string kRequired = "frequency [Hz],maximax [g]\n10,4\n60,40\n400,40\n";

const std::string kBoltedRig =
    "schema = \"microslip.rig/1\"\n"
    "[modes]\nfrequency_Hz = [80.0]\nexcitation = [0.7]\njoint = [0.7]\n"
    "[damping]\nloss_factor = [0.002]\n[excitation]\nchannel = \"force\"\n"
    "[[accelerometer]]\nchannel = \"acceleration\"\nshape = [0.7]\n";

const std::string kCampaign =
    "schema = \"microslip.campaign/1\"\nstructure = \"bolted.toml\"\n"
    "[identification]\nstiffness_N_per_m = 1.7e5\ndraws = 100\n"
    "[[test]]\nname = \"first\"\nfile = \"levels.csv\"\nuse = \"identify\"\n"
    "[[test]]\nname = \"swept\"\nfile = \"swept.csv\"\nuse = \"predict\"\n";

/// A sweep of one mode, 0.7 kg^-1/2, at 10 N: a = Fω²φ²/(ω₀² − ω² + iηω₀²).
std::string swept_text(double resonance) {
  std::string text = "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n";
  for (int i = 0; i <= 40; ++i) {
    const double r = 0.875 + 0.00625 * i;
    const std::complex<double> a = 4.9 * r * r / std::complex<double>(1.0 - r * r, 0.01);
    text += fmt::format("{:.9g},10,{:.9g},{:.9g}\n", resonance * r, std::abs(a), std::arg(-a));
  }
  return text;
}

/// Beside every format, each subcommand that writes; all but demo().
std::vector<Writing> all_calls() {
  std::vector<Writing> all = all_writings();
  all.push_back({"next.csv", {"plan", "levels.csv", "--stiffness", "1.7e5", "--out", "next.csv"}});
  all.push_back({"result.h5", {"ensemble", "plan.toml", "--out", "result.h5"}});
  all.push_back({"push.csv",
                 {"load", "half-sine", "model.toml", "--peak", "20N", "--pulse", "11ms",
                  "--duration", "0.5s", "--out", "push.csv"}});
  all.push_back({"spectrum.csv",
                 {"spectrum", "decay.csv", "--column", "acc1", "--frequency", "10:200:20", "--out",
                  "spectrum.csv"}});
  all.push_back({"modes.toml", {"modes", "structure.toml", "--out", "modes.toml"}});
  all.push_back({"found/joint1.json",
                 {"calibrate", "two.toml", "modal.csv", "--samples", "100", "--keep-samples",
                  "--out", "found"}});
  all.push_back({"cycles.csv", {"levels", "record.csv", "--out", "cycles.csv"}});
  all.push_back({"watched/next_levels.csv",
                 {"watch", "watched", "--once", "--stiffness", "1.7e5", "--no-report"}});
  all.push_back({"watched/watch.html", {"watch", "watched", "--once", "--stiffness", "1.7e5"}});
  const Arguments compare{"verify", "joint.json", "record.csv", "--out", "compared.csv"};
  all.push_back({"compared.csv", compare});
  all.push_back({"compared.svg", with(compare, {"--picture", "compared.svg"})});
  all.push_back(
      {"swept_compared.csv", {"verify", "model.toml", "slow.csv", "--out", "swept_compared.csv"}});
  all.push_back({"shock.csv",
                 {"load", "shock", "shaken.toml", "--spectrum", "required.csv", "--duration",
                  "0.5s", "--out", "shock.csv"}});
  all.push_back({"results/campaign.csv",
                 {"campaign", "campaign.toml", "--out", "results", "--picture", "results.svg"}});
  all.push_back({"draws.h5",
                 {"identify", "levels.csv", "--stiffness", "1.7e5", "--samples", "100", "--out",
                  "drawn.json", "--samples-out", "draws.h5"}});
  all.push_back({"assemblies/joint.json",
                 {"identify", "levels.csv", "again.csv", "third.csv", "--stiffness", "1.7e5",
                  "--assemblies", "files", "--samples", "100", "--out", "assemblies"}});
  return all;
}

/// As long as all others together: one kill in a hundred is of it.
constexpr int kKillsADemo = 100;
Writing demo() { return {"demo/reference_rig/report.html", {"demo", "--out", "demo"}}; }

void put_all_inputs(const Sandbox& box) {
  put_inputs(box);
  box.put("plan.toml", kPlan);
  box.put("structure.toml", kStructure);
  for (const char* name : {"stiffness.mtx", "mass.mtx", "truth_joint2.json"}) {
    box.put(name, test::get(kTwoJoints + name));
  }
  box.put("shaken.toml", kShaken);
  box.put("required.csv", kRequired);
  box.put("record.csv", record_text(sample_record()));
  box.put("again.csv", sample_levels_text());
  box.put("third.csv", sample_levels_text());
  box.put("bolted.toml", kBoltedRig);
  box.put("campaign.toml", kCampaign);
  box.put("swept.csv", swept_text(80.0));
  box.put("slow.csv", swept_text(0.15));
  fs::create_directory(box.file("watched"));
  box.put("watched/levels.csv", sample_levels_text());
  box.put("two.toml", test::get(kTwoJoints + "model.toml"));
  box.put("modal.csv", testing::every_third_row(test::get(kTwoJoints + "modal_levels.csv")));
}

bool is_temporary(const std::string& path) {
  return fs::path(path).filename().string().starts_with(".microslip-");
}

/// An ensemble goes on from it.
bool is_journal(const std::string& path) { return path.ends_with(".journal"); }

/// One call, what is there before it and after it where nothing hinders it.
class Killed {
 public:
  explicit Killed(Writing writing) : writing_(std::move(writing)) {
    put_all_inputs(box_);
    given_ = box_.content();
    const auto start = Clock::now();
    const Outcome run = box_.run(writing_.call);
    duration_ = Clock::now() - start;
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(box_.has(writing_.out)) << writing_.out;
    whole_ = box_.content();
  }

  [[nodiscard]] const Sandbox& box() const { return box_; }
  [[nodiscard]] const Arguments& call() const { return writing_.call; }
  [[nodiscard]] Clock::duration duration() const { return duration_; }

  /// Removes what the call made.
  void clear() const {
    for (const auto& [path, content] : box_.content()) {
      if (!given_.contains(path)) fs::remove_all(path);
    }
  }

  /// @param replaced  whether the outputs were there before.
  void check_after(int signal, bool replaced) const {
    const Contents now = box_.content();
    for (const auto& [path, content] : now) {
      if (is_temporary(path)) {
        EXPECT_EQ(signal, SIGKILL) << path << " is left";
      } else if (!is_journal(path)) {
        ASSERT_TRUE(whole_.contains(path)) << path << " is left";
        EXPECT_TRUE(content == whole_.at(path)) << path << " is not whole";
      }
    }
    for (const auto& [path, content] : replaced ? whole_ : given_) {
      EXPECT_TRUE(now.contains(path)) << path << " is gone";
    }
  }

  void check_again() const {
    const Outcome run = box_.run(writing_.call);
    EXPECT_EQ(run.status, 0) << run.err;
    const Contents now = box_.content();
    for (const auto& [path, content] : now) {
      EXPECT_TRUE(whole_.contains(path)) << path << " is left for ever";
    }
    for (const auto& [path, content] : whole_) {
      ASSERT_TRUE(now.contains(path)) << path;
      EXPECT_TRUE(now.at(path) == content) << path << " is another than without a kill";
    }
  }

 private:
  Writing writing_;
  Sandbox box_;
  Contents given_;
  Contents whole_;
  Clock::duration duration_{};
};

constexpr std::array kSignals{SIGKILL, SIGINT, SIGTERM};

void expect_ended(const Outcome& run, int signal) {
  EXPECT_TRUE(run.signal == signal || run.status == 0) << run.status << ": " << run.err;
}

// Seeded, so that the order of calls and signals repeats; where each is hit depends on the machine.
TEST(Killed, AtRandomMoments) {
  const std::vector<Writing> writings = all_calls();
  RandomStream random(1, 0);
  const int draws = kills(writings.size() / kStride);
  int hit = 0;
  std::map<std::size_t, Killed> cases;
  for (int i = 0; i < draws && !HasFailure(); ++i) {
    const bool all = i % kKillsADemo == kKillsADemo - 1;
    const std::size_t chosen =
        all ? writings.size() : static_cast<std::size_t>(i) * kStride % writings.size();
    const Killed& one = cases.try_emplace(chosen, all ? demo() : writings[chosen]).first->second;
    const int signal = kSignals.at(static_cast<std::size_t>(3.0 * random.uniform()));
    const bool replaced = random.uniform() < 0.5;
    if (!replaced) one.clear();
    SCOPED_TRACE(typed(one.call()) + " by signal " + std::to_string(signal));
    Running running(one.call(), one.box().path(), {});
    std::this_thread::sleep_for(1.1 * random.uniform() * one.duration());
    running.send(signal);
    const Outcome run = running.wait();
    expect_ended(run, signal);
    hit += run.signal == signal ? 1 : 0;
    one.check_after(signal, replaced);
    one.check_again();
  }
  test::record_sum("kills [1]", hit);
  EXPECT_GT(hit, test::least_of(0.5) * draws);  // few may all come too late
}

/// Environment of a call that gets a signal before the `number`th call of the system of this name
/// on its files; the file tells that it came to it.
std::vector<std::string> signalled(const Sandbox& box, int signal, const std::string& what,
                                   int number, const std::string& came) {
  return {"LD_PRELOAD=" + test::built_file("MICROSLIP_FAILING_CALLS", MICROSLIP_FAILING_CALLS),
          "ASAN_OPTIONS=verify_asan_link_order=0",
          "MICROSLIP_FAILING_FOLDER=" + fs::canonical(box.path()).string(),
          "MICROSLIP_FAILING_CALL=" + what,
          "MICROSLIP_FAILING_NUMBER=" + std::to_string(number),
          "MICROSLIP_FAILING_SIGNAL=" + std::to_string(signal),
          "MICROSLIP_FAILED=" + came};
}

/// Runs the call and kills it before that call of the system; whether it came to it.
bool killed_before(const Killed& one, const std::string& what, int number) {
  const Sandbox outside;
  const Circumstances how{.environment =
                              signalled(one.box(), SIGKILL, what, number, outside.file("failed"))};
  expect_ended(one.box().run(one.call(), how), SIGKILL);
  return outside.has("failed");
}

Arguments three_files(const std::string& seed) {
  return {"identify",      "levels.csv", "--stiffness",   "1.7e5", "--out",  "j.json",
          "--density-csv", "d.csv",      "--samples-out", "s.h5",  "--seed", seed,
          "--samples",     "20",         "--quiet"};
}

// A signal that can be caught waits until all outputs have their names: no set of two calls stays.
TEST(Killed, AmongNamesLeavesTheFilesOfOneCall) {
  const Sandbox box{{"levels.csv", sample_levels_text()}};
  ASSERT_EQ(box.run(three_files("2")).status, 0);
  const Contents second = box.content();
  ASSERT_EQ(box.run(three_files("1")).status, 0);
  const Contents first = box.content();
  int number = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1}) {
    const Sandbox outside;
    number = number % 3 + 1;
    const auto environment = signalled(box, signal, "rename", number, outside.file("came"));
    const Outcome run = box.run(three_files("2"), {.environment = environment});
    EXPECT_TRUE(outside.has("came"));
    EXPECT_EQ(run.signal, signal) << run.err;
    EXPECT_TRUE(box.content() == second) << "signal " << signal << " at name " << number;
    for (const auto& [name, text] : first) box.put(name, text);
  }
}

class KilledBefore : public ::testing::TestWithParam<std::string> {};

// Where files get their names it is a matter of single calls, which a random moment hardly hits:
// all of them in the studies, else the first three and every third, of many alike.
TEST_P(KilledBefore, EachCallOfTheSystem) {
  const auto writings = all_calls();
  const auto writing = std::ranges::find(writings, GetParam(), &Writing::out);
  const Killed one(*writing);
  for (const std::string what : {"close", "fsync", "link", "rename"}) {
    const auto step = [](int number) { return number < 3 || test::in_studies() ? 1 : 3; };
    for (int number = 1; !HasFailure(); number += step(number)) {
      SCOPED_TRACE(fmt::format("before {} {}", what, number));
      const bool replaced = number % 2 == 0 || what == "rename";  // new files get theirs by link
      if (!replaced) one.clear();
      const bool came = killed_before(one, what, number);
      one.check_after(SIGKILL, replaced);
      one.check_again();
      if (!came) break;
    }
  }
}

// One of each way of writing: a text, two files, one by another library, a folder, a picture,
// blocks, rows.
INSTANTIATE_TEST_SUITE_P(Of, KilledBefore,
                         ::testing::Values("loop.csv", "density.csv", "rec.h5", "made/level_01.csv",
                                           "levels.svg", "result.h5", "march.csv"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace microslip::cli_test::killed_test
