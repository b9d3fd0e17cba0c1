// SPDX-License-Identifier: MIT
#include "microslip/ensemble/ensemble_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/response/load_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/study/journal_file.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/workflow/predict/march_draws.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/predict/response_draws.hpp"
#include "microslip/workflow/text/nothing_found.hpp"
#include "support/effort.hpp"
#include "support/replaced.hpp"

namespace microslip::ensemble_run_test {
namespace {

const std::string kPlan = R"(schema = "microslip.ensemble/1"
kind = "predict"
raw = ["peak_frequency"]
block = 3
[predict]
model = "model.toml"
draws = 60
[[case]]
name = "low"
kind = "frf"
force_N = 0.02
frequency_Hz = [0.13, 0.18]
[[case]]
name = "backbone"
kind = "backbone"
response_m = [0.1, 0.4]
)";

/// The example of one mass, whose frequency is uncertain, with a plan.
class Campaign {
 public:
  explicit Campaign(const std::string& plan = kPlan) {
    const std::string example = MICROSLIP_EXAMPLES "/one_mass/";
    test::put(file("joint.json"), test::get(example + "joint.json"));
    test::put(file("model.toml"), test::replaced(test::get(example + "model.toml"), "[structure]",
                                                 "[structure]\nfrequency_std = [0.01]\n"));
    test::put(file("plan.toml"), plan);
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::filesystem::exists(file(name));
  }
  [[nodiscard]] std::vector<std::string> names() const { return folder_.names(); }

  [[nodiscard]] EnsembleRun asked(const std::string& out = "r.h5") const {
    return {.plan = file("plan.toml"),
            .out = file(out),
            .table = file(out + ".csv"),
            .command = "a test"};
  }

  FinishedEnsemble run(const EnsembleRun& asked, std::size_t threads = 1) const {
    LocalTeam team(threads == 1 ? Execution::serial() : Execution::threads(threads));
    return *run_ensemble(asked, team);
  }

  /// Of a run that nothing stops.
  [[nodiscard]] std::string whole() const {
    (void)run(asked("whole.h5"));
    return test::get(file("whole.h5"));
  }

 private:
  test::TemporaryFolder folder_;
};

// ---- The same bytes, whoever did the jobs. ----

TEST(Ensemble, IsTheSameOnTwoThreads) {
  const Campaign campaign;
  const std::string whole = campaign.whole();
  const FinishedEnsemble done = campaign.run(campaign.asked(), 2);
  EXPECT_EQ(test::get(campaign.file("r.h5")), whole);
  EXPECT_EQ(test::get(campaign.file("r.h5.csv")), test::get(campaign.file("whole.h5.csv")));
  EXPECT_EQ(done.jobs, 120U);
  EXPECT_EQ(done.done_now, 120U);
  EXPECT_FALSE(campaign.has("r.h5.journal"));
}

TEST(Ensemble, IsTheSameOfShards) {
  const Campaign campaign;
  const std::string whole = campaign.whole();
  EnsembleRun asked = campaign.asked();
  for (const std::uint64_t number : {2U, 3U, 1U}) {
    asked.shard = EnsembleShard{number, 3};
    const FinishedEnsemble done = campaign.run(asked);
    EXPECT_EQ(done.journal, asked.out + "." + std::to_string(number) + "-of-3.journal");
    EXPECT_FALSE(campaign.has("r.h5"));
  }
  asked.shard.reset();
  asked.merge = true;
  const FinishedEnsemble done = campaign.run(asked);
  EXPECT_EQ(done.done_before, 120U);
  EXPECT_EQ(done.done_now, 0U);
  EXPECT_EQ(test::get(campaign.file("r.h5")), whole);
  EXPECT_TRUE(std::ranges::none_of(
      campaign.names(), [](const std::string& name) { return name.ends_with(".journal"); }));
}

// A merge without all shards says how much is missing; a run without `merge` does the rest.
TEST(Ensemble, TellsWhatAMergeLacks) {
  const Campaign campaign;
  const std::string whole = campaign.whole();
  EnsembleRun asked = campaign.asked();
  asked.shard = EnsembleShard{1, 2};
  (void)campaign.run(asked);
  asked.shard.reset();
  asked.merge = true;
  const std::string refusal = test::message_of<InputError>([&] { (void)campaign.run(asked); });
  EXPECT_NE(refusal.find("60 of 120; must be all for a merge; 1 journal found"), std::string::npos)
      << refusal;
  asked.merge = false;
  EXPECT_EQ(campaign.run(asked).done_before, 60U);
  EXPECT_EQ(test::get(campaign.file("r.h5")), whole);
}

// Stopped after any number of jobs, and with a block torn at any byte, a rerun ends the same.
TEST(Ensemble, GoesOnAfterAStop) {
  const Campaign campaign;
  const std::string whole = campaign.whole();
  RandomStream random(1, 0);
  const int kStops = test::kSanitized ? 2 : 8;
  for (int stop = 0; stop < kStops; ++stop) {
    EnsembleRun asked = campaign.asked();
    const auto most = static_cast<std::size_t>(1.0 + 118.0 * random.uniform());
    asked.progress = [most](std::size_t done, std::size_t) { return done < most; };
    EXPECT_THROW((void)campaign.run(asked, 2), Cancelled);
    EXPECT_FALSE(campaign.has("r.h5"));
    const std::string journal = test::get(campaign.file("r.h5.journal"));
    const auto torn = static_cast<std::size_t>(30.0 * random.uniform());
    test::put(campaign.file("r.h5.journal"), journal.substr(0, journal.size() - torn));
    const FinishedEnsemble done = campaign.run(campaign.asked());
    EXPECT_GT(done.done_before + 6, most);
    EXPECT_EQ(done.done_before + done.done_now, 120U);
    ASSERT_EQ(test::get(campaign.file("r.h5")), whole) << "stopped after " << most;
    std::filesystem::remove(campaign.file("r.h5"));
  }
}

// ---- What has changed. ----

struct Change {
  std::string file;
  std::string old;
  std::string by;
  std::string refusal;
};

TEST(Ensemble, RefusesToGoOnWithAChange) {
  for (const Change& change : std::vector<Change>{
           {"plan.toml", "draws = 60", "draws = 61", "predict.draws = 61, it was 60"},
           {"plan.toml", "[predict]", "seed = 7\n[predict]", "seed = 7 is new"},
           {"plan.toml", "0.18", "0.19", "case[0].frequency_Hz"},
           {"model.toml", "frequency_std = [0.01]", "frequency_std = [0.02]", "model.toml = "},
           {"joint.json", "{", "{ ", "joint.json = "}}) {
    const Campaign campaign;
    EnsembleRun asked = campaign.asked();
    asked.shard = EnsembleShard{1, 40};
    (void)campaign.run(asked);
    test::put(campaign.file(change.file),
              test::replaced(test::get(campaign.file(change.file)), change.old, change.by));
    const std::vector<std::string> before = campaign.names();
    const std::string refusal =
        test::message_of<InputError>([&] { (void)campaign.run(campaign.asked()); });
    EXPECT_NE(refusal.find(change.refusal), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("remove the journal to start again"), std::string::npos) << refusal;
    EXPECT_EQ(campaign.names(), before);
  }
}

// Other values kept and another confidence need no job done again.
TEST(Ensemble, TellsOtherThingsOfKeptJournals) {
  const Campaign campaign;
  EnsembleRun asked = campaign.asked();
  asked.keep_journals = true;
  (void)campaign.run(asked);
  test::put(campaign.file("plan.toml"),
            test::replaced(kPlan, "raw = [\"peak_frequency\"]", "raw = [\"*\"]\nconfidence = 0.5"));
  const FinishedEnsemble done = campaign.run(asked);
  EXPECT_EQ(done.done_now, 0U);
  EXPECT_EQ(done.result.confidence, 0.5);
}

// The band of a design's identification is of that confidence: there another one is another job.
TEST(Ensemble, RefusesAnotherConfidenceForBandsOfDesigns) {
  const std::string plan = R"(schema = "microslip.ensemble/1"
kind = "design"
[design]
joint = "joint.json"
count = 3
levels = [20]
noise = [0.01]
amplitude_m = [0.05, 1.0]
draws = 40
)";
  const Campaign campaign(plan);
  EnsembleRun asked = campaign.asked();
  asked.keep_journals = true;
  (void)campaign.run(asked);
  test::put(campaign.file("plan.toml"),
            test::replaced(plan, "[design]", "confidence = 0.5\n[design]"));
  const std::string refusal = test::message_of<InputError>([&] { (void)campaign.run(asked); });
  EXPECT_NE(refusal.find("confidence = 0.5, it was 0.95"), std::string::npos) << refusal;
  test::put(campaign.file("plan.toml"),
            test::replaced(plan, "[design]", "confidence = 0.95\n[design]"));
  EXPECT_EQ(campaign.run(asked).done_now, 0U);
}

// More blocks than memory could name are refused before any is begun.
TEST(Ensemble, RefusesBlocksThatAreTooSmall) {
  const Campaign campaign(test::replaced(test::replaced(kPlan, "block = 3", "block = 4"),
                                         "draws = 60", "draws = 400000000"));
  const std::string refusal =
      test::message_of<InputError>([&] { (void)campaign.run(campaign.asked()); });
  EXPECT_NE(refusal.find("block = 4; must be 80 or more for 8e+08 jobs"), std::string::npos)
      << refusal;
}

// ---- The numbers. ----

/// Statistics of an output of a group.
const ColumnStatistics& statistics_of(const FinishedEnsemble& done, const std::string& group,
                                      const std::string& output) {
  for (const GroupResult& result : done.result.groups) {
    std::size_t at = 0;
    for (const EnsembleOutput& one : result.group.outputs) {
      if (result.group.name == group && one.name == output) return result.values[at];
      at += one.size();
    }
  }
  throw Error(group + ": no " + output);
}

// Draw i is that of `frf` with the same seed: the peak's quantiles are the same numbers as those of
// response_spread(), which another path computes.
TEST(Ensemble, DrawsWhatAResponseDraws) {
  const Campaign campaign;
  const FinishedEnsemble done = campaign.run(campaign.asked());
  const ModelFile model = read_model(campaign.file("model.toml"));
  const HarmonicBalance balance(model.structure, {model.response});
  constexpr double kTwoPi = 6.283185307179586;
  const ResponseRange range{{Quantity::kForceAmplitude, 0.02}, kTwoPi * 0.13, kTwoPi * 0.18};
  const ResponseCurve curve =
      balance.follow(range.kept, Quantity::kAngularFrequency, range.from, range.to);
  const DrawOptions options{60, 0.95, 1};
  const ResponseSpread spread = response_spread(
      balance, curve, range, draws_of(model, campaign.file("model.toml"), options), options);
  ASSERT_EQ(spread.peaks.size(), 1U);
  const ColumnStatistics& frequency = statistics_of(done, "low", "peak_frequency");
  EXPECT_EQ(frequency.lower, spread.peaks[0].frequency_lower);
  EXPECT_EQ(frequency.upper, spread.peaks[0].frequency_upper);
  const ColumnStatistics& height = statistics_of(done, "low", "peak_displacement");
  EXPECT_EQ(height.lower, spread.peaks[0].height_lower);
  EXPECT_EQ(height.upper, spread.peaks[0].height_upper);
}

// So is a march, at times that are not equally far apart: peaks and rms are the same numbers as
// those of drawn_march().
TEST(Ensemble, MarchesAsAMarchOfDraws) {
  const std::size_t cases = kPlan.find("[[case]]");
  const Campaign campaign(kPlan.substr(0, kPlan.find("raw")) +
                          kPlan.substr(kPlan.find("[predict]"), cases - kPlan.find("[predict]")) +
                          "[[case]]\nkind = \"march\"\nforce_file = \"force.csv\"\n");
  std::string force = "time [s],force [N]\n";
  for (int i = 0; i < 60; ++i) {
    const double time = i < 40 ? 0.05 * i : 2.0 + 1.5 * (i - 40);
    force += std::to_string(time) + "," + (i % 3 == 0 ? "0.1" : "-0.02") + "\n";
  }
  test::put(campaign.file("force.csv"), force);
  const FinishedEnsemble done = campaign.run(campaign.asked());
  const ModelFile model = read_model(campaign.file("model.toml"));
  const DrawOptions options{60, 0.95, 1};
  const DrawnMarch march = drawn_march(
      model, read_loads(campaign.file("force.csv"), model.structure), {.points = {model.response}},
      draws_of(model, campaign.file("model.toml"), options), options);
  const std::vector<std::string> kinds{"displacement", "velocity", "acceleration"};
  for (std::size_t s = 0; s < kinds.size(); ++s) {
    const ColumnStatistics& peak = statistics_of(done, "case 1", "largest_" + kinds[s]);
    EXPECT_EQ(peak.lower, march.signals[s].peak.lower) << kinds[s];
    EXPECT_EQ(peak.upper, march.signals[s].peak.upper) << kinds[s];
    const ColumnStatistics& rms = statistics_of(done, "case 1", "rms_" + kinds[s]);
    EXPECT_EQ(rms.lower, march.signals[s].rms.lower) << kinds[s];
    EXPECT_EQ(rms.upper, march.signals[s].rms.upper) << kinds[s];
  }
}

const std::string kSweepPlan = R"(schema = "microslip.ensemble/1"
kind = "sweep"
[sweep]
model = "model.toml"
[[sweep.axis]]
number = "structure.damping_ratio[0]"
values = [0.005, 0.01]
[[sweep.axis]]
number = "joint: stiffness_N_per_m"
values = [0.2, 0.25, 0.3]
[[case]]
name = "backbone"
kind = "backbone"
response_m = [0.4]
)";

/// Whose stiffness can change alone.
const std::string kUniformJoint =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 0.25,
        "density": [{"type": "uniform", "from_N": 0, "to_N": 0.1, "weight": 0.8}]})";

// Each point of the grid is the structure with these numbers, solved by itself.
TEST(Ensemble, SweepsTheGrid) {
  const Campaign campaign(kSweepPlan);
  test::put(campaign.file("joint.json"), kUniformJoint);
  const FinishedEnsemble done = campaign.run(campaign.asked());
  ASSERT_EQ(done.jobs, 6U);
  const CsvTable table(test::get(campaign.file("r.h5.csv")), "r.csv");
  std::vector<std::string> output = table.text("output");
  std::vector<std::string> value = table.text("value");
  const ModelFile model = read_model(campaign.file("model.toml"));
  std::vector<double> expected;
  for (const double damping : {0.005, 0.01}) {
    for (const double stiffness : {0.2, 0.25, 0.3}) {
      std::vector<Mode> modes(model.structure.linear().modes().begin(),
                              model.structure.linear().modes().end());
      modes[0].loss_factor = 2.0 * damping;
      const auto points = model.structure.linear().points();
      std::vector<StructuralJoint> joints(model.structure.joints().begin(),
                                          model.structure.joints().end());
      joints[0].joint = Joint(stiffness, joints[0].joint.density());
      const auto excitations = model.structure.excitations();
      const JointedStructure structure(ModalModel(modes, {points.begin(), points.end()}), joints,
                                       {excitations.begin(), excitations.end()},
                                       model.structure.damping());
      const ResponseCurve curve =
          HarmonicBalance(structure, {model.response}).resonances(std::vector{0.4}, 0);
      expected.push_back(curve.points.front().damping_ratio());
    }
  }
  std::vector<double> found;
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (output[i] == "damping_ratio") found.push_back(std::stod(value[i]));
  }
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

// The shape of a point that is not requested changes nothing: that is reported of its axis, and of
// no other.
TEST(Ensemble, TellsOfANumberThatChangesNothing) {
  const Campaign campaign(
      test::replaced(kSweepPlan, "joint: stiffness_N_per_m", "structure.point[1].shape[0]"));
  test::put(campaign.file("model.toml"),
            test::replaced(test::get(campaign.file("model.toml")), "[[joint]]",
                           "[[structure.point]]\nname = \"beside\"\nshape = [1.0]\n[[joint]]"));
  const FinishedEnsemble done = campaign.run(campaign.asked());
  ASSERT_EQ(done.warnings.size(), 1U);
  EXPECT_EQ(done.warnings[0].code, "axis_without_effect");
  EXPECT_NE(done.warnings[0].text.find("'structure.point[1].shape[0]' changes nothing"),
            std::string::npos);
  EXPECT_NE(test::get(campaign.file("r.h5.csv")).find("axis_without_effect"), std::string::npos);
}

TEST(Ensemble, RefusesANumberThatIsNotThere) {
  for (const auto& [old, by, refusal] :
       std::vector<std::tuple<std::string, std::string, std::string>>{
           {"structure.damping_ratio[0]", "structure.dampingratio[0]",
            "must be the path of a number"},
           {"joint: stiffness", "bolt: stiffness", "must name a joint of the model"},
           {"joint: stiffness_N_per_m", "joint: stifness", "must be the path of a number"},
           {"structure.damping_ratio[0]", "structure.frequency_std",
            "must be one that a prediction"},
           {"kind = \"backbone\"\nresponse_m = [0.4]",
            "kind = \"frf\"\nforce_N = 0.02\nfrequency_Hz = [0.1, 0.2]\nharmonics = 1\nsamples = 5",
            ""}}) {
    const Campaign campaign(test::replaced(kSweepPlan, old, by));
    if (refusal.empty()) continue;
    const std::string found =
        test::message_of<Error>([&] { (void)campaign.run(campaign.asked()); });
    EXPECT_NE(found.find(refusal), std::string::npos) << found;
  }
}

// A stiffness below 0 is no joint: such points fail with their reason, the rest
// is there; more of them than allowed stop the run, whose journal goes on when that is changed.
TEST(Ensemble, KeepsFailedJobsWithTheirReason) {
  const std::string plan =
      test::replaced(kSweepPlan, "values = [0.2, 0.25, 0.3]", "values = [-0.2, 0.25, 0.3]");
  const Campaign campaign("most_failed = 0.4\n" + plan);
  test::put(campaign.file("joint.json"), kUniformJoint);
  const FinishedEnsemble done = campaign.run(campaign.asked());
  EXPECT_EQ(done.failed, 2U);
  ASSERT_EQ(done.result.groups[0].failed.reasons.size(), 1U);
  EXPECT_NE(done.result.groups[0].failed.reasons[0].text.find("stiffness_N_per_m"),
            std::string::npos);
  EXPECT_EQ(done.result.groups[0].failed.jobs, (std::vector<std::uint64_t>{0, 3}));
  EXPECT_EQ(done.result.groups[0].values[0].count, 4U);
  ASSERT_FALSE(done.warnings.empty());
  EXPECT_EQ(done.warnings[0].code, "jobs_failed");
  EXPECT_NE(test::get(campaign.file("r.h5.csv")).find("# failed: backbone: 2, first number 0"),
            std::string::npos);

  const std::string before = test::get(campaign.file("r.h5"));
  test::put(campaign.file("plan.toml"), "most_failed = 0.1\n" + plan);
  const EnsembleRun again = campaign.asked();
  const std::string refusal = test::message_of<NothingFound>([&] { (void)campaign.run(again); });
  EXPECT_NE(refusal.find("of 6 jobs failed, more than most_failed = 0.1"), std::string::npos)
      << refusal;
  EXPECT_EQ(test::get(campaign.file("r.h5")), before);
  test::put(campaign.file("plan.toml"), "most_failed = 0.5\n" + plan);
  EXPECT_GT(campaign.run(again).done_before, 0U);
}

TEST(Ensemble, RefusesAnOutputThatIsNotThere) {
  const Campaign campaign(test::replaced(kPlan, "peak_frequency", "peak_freqency"));
  const std::string refusal =
      test::message_of<InputError>([&] { (void)campaign.run(campaign.asked()); });
  EXPECT_NE(refusal.find("raw[0] = 'peak_freqency'; must be '*' or one of"), std::string::npos)
      << refusal;
}

// A mass of 1 kg that its base shakes by a feels −1 kg·a in the relative motion: case for case the
// numbers are those of as many newtons, and a march also has the absolute motion.
TEST(Ensemble, TakesAccelerationsOfABase) {
  const auto plan = [](const std::string& kept) {
    return test::replaced(kPlan, "force_N = 0.02", kept) +
           "[[case]]\nname = \"pushed\"\nkind = \"march\"\nforce_file = \"push.csv\"\n";
  };
  const Campaign forced(plan("force_N = 0.02"));
  test::put(forced.file("push.csv"), "time [s],force [N]\n0,0\n2,-0.1\n9,0\n");
  const Campaign shaken(plan("acceleration_m_per_s2 = 0.02"));
  test::put(shaken.file("push.csv"), "time [s],acceleration of table [m/s^2]\n0,0\n2,0.1\n9,0\n");
  test::put(shaken.file("model.toml"),
            test::replaced(test::replaced(test::get(forced.file("model.toml")), "[[joint]]",
                                          "[[structure.base]]\nname = \"table\"\nparticipation = "
                                          "[1.0]\npoint_motion = [1.0]\n[[joint]]"),
                           "[excitation]\npoint = \"mass\"",
                           "[excitation]\nbase = \"table\"\n[response]\npoint = \"mass\""));
  const EnsembleResult by_force = forced.run(forced.asked()).result;
  const EnsembleResult by_base = shaken.run(shaken.asked()).result;
  ASSERT_EQ(by_base.groups.size(), 3U);
  for (std::size_t g : {0U, 1U}) {
    ASSERT_EQ(by_force.groups[g].values.size(), by_base.groups[g].values.size());
    for (std::size_t i = 0; i < by_force.groups[g].values.size(); ++i) {
      EXPECT_NEAR(by_base.groups[g].values[i].mean, by_force.groups[g].values[i].mean,
                  1e-9 * std::abs(by_force.groups[g].values[i].mean));
    }
  }
  const std::string table = test::get(shaken.file("r.h5.csv"));
  for (const char* output : {"largest_absolute_displacement", "rms_absolute_acceleration"}) {
    EXPECT_NE(table.find(std::string("pushed,") + output), std::string::npos) << output;
  }
  EXPECT_EQ(test::get(forced.file("r.h5.csv")).find("absolute"), std::string::npos);
  test::put(shaken.file("plan.toml"), plan("force_N = 0.02"));
  const std::string refusal =
      test::message_of<InputError>([&] { (void)shaken.run(shaken.asked("other.h5")); });
  EXPECT_NE(refusal.find("force_N = 0.02; must be left out: the model is driven by its base"),
            std::string::npos)
      << refusal;
}

TEST(EnsembleShard, IsANumberOfACount) {
  EXPECT_EQ(EnsembleShard::parse("3/20").number, 3U);
  EXPECT_EQ(EnsembleShard::parse("3/20").count, 20U);
  for (const char* wrong :
       {"", "3", "0/2", "3/2", "/2", "2/", "1/2x", "-1/2", "1/1000001", "a/b"}) {
    EXPECT_THROW((void)EnsembleShard::parse(wrong), InputError) << wrong;
  }
}

}  // namespace
}  // namespace microslip::ensemble_run_test
