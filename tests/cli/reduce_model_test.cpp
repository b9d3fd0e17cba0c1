// SPDX-License-Identifier: MIT
// reduce with a model.toml: modal levels of a structure with several joints.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::cli_test::reduce_model_test {
namespace {

const std::string kFolder = MICROSLIP_TEST_DATA "/two_joints/";

Sandbox two_joints() {
  return Sandbox{{"model.toml", test::get(kFolder + "model.toml")},
                 {"low.csv", test::get(kFolder + "recordings/mode2_level10.csv")},
                 {"high.csv", test::get(kFolder + "recordings/mode3_level22.csv")}};
}

const Arguments kAllSensors{"--sensor", "acc1=drive", "--sensor", "acc2=p2", "--sensor", "acc3=p3",
                            "--sensor", "acc4=p4",    "--sensor", "acc5=p5", "--sensor", "acc6=p6"};

Arguments reduce_call(const Arguments& more) {
  return with(with({"reduce", "model.toml", "low.csv", "high.csv"}, more), {"--out", "m.csv"});
}

// Against the truth of an independent program: 34th and 71st row, counted from 0.
TEST(reduce_model, FindsWhatTheJointsDo) {
  const Sandbox box = two_joints();
  const Outcome run = expect_done(box, reduce_call(kAllSensors));
  EXPECT_NE(run.out.find("mode 2               1 level, 65.5445 Hz with stuck joints, the nearest"),
            std::string::npos)
      << run.out;
  const CsvTable found(box.get("m.csv"), "m.csv");
  const CsvTable truth(test::get(kFolder + "truth.csv"), "truth.csv");
  const std::vector<std::size_t> rows{34, 71};
  const auto compare = [&](const std::string& name, const Dimension& dimension, double tolerance) {
    const std::vector<double> values = found.numbers(name, dimension);
    const std::vector<double> expected = truth.numbers(name, dimension);
    ASSERT_EQ(values.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(values[i], expected[rows[i]], tolerance * expected[rows[i]]) << name;
    }
  };
  compare("mode", kDimensionless, 0.0);
  compare("displacement", kLength, 1e-3);
  compare("frequency", kFrequency, 5e-6);
  for (const std::string joint : {"joint1", "joint2"}) {
    compare("amplitude_" + joint, kLength, 1e-3);
    compare("dissipation_" + joint, kEnergy, 0.02);
  }
}

TEST(reduce_model, SaysInTheFileWhatIsNotSeen) {
  const Sandbox box = two_joints();
  const Outcome run = expect_done(box, reduce_call({"--sensor", "acc1=drive", "--quiet"}));
  EXPECT_EQ(run.out, "");
  const std::string text = box.get("m.csv");
  EXPECT_NE(text.find("# warning: joint_not_seen"), std::string::npos);
  EXPECT_NE(text.find("assumed_amplitude_joint1 [m]"), std::string::npos);
  EXPECT_EQ(text.find("dissipation_joint1"), std::string::npos);
}

TEST(reduce_model, TakesAnAskedForMode) {
  const Sandbox box = two_joints();
  const Outcome run = expect_done(box, reduce_call(with(kAllSensors, {"--mode", "3"})));
  EXPECT_NE(run.out.find("2 levels, 93.3986 Hz with stuck joints, as specified"),
            std::string::npos);
  EXPECT_NE(box.get("m.csv").find("far_from_mode"), std::string::npos);
}

TEST(reduce_model, NamesWhatIsWrong) {
  const Sandbox box = two_joints();
  box.put("sweep.csv", "frequency [Hz],force [N],acceleration [m/s^2],phase [deg]\n1,1,1,1\n");
  const auto refused = [&](const Arguments& more, const std::string& part) {
    const Outcome run = box.run(reduce_call(more));
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  };
  refused({}, "[[accelerometer]] with channel and point, or give --sensor CHANNEL=POINT");
  refused({"--sensor", "acc1=driv"}, "--sensor acc1=driv = 'driv'; must be the name of a");
  refused({"--sensor", "acc1=driv"}, "Did you mean 'drive'?");
  refused({"--sensor", "acc1"}, "must read CHANNEL=POINT");
  refused({"--sensor", "acc9=p2"}, "low.csv: channel 'acc9' is missing");
  refused({"--sensor", "force=p2"}, "channel 'force' = force; must be acceleration");
  refused({"--sensor", "acc1=p2", "--sensor", "acc1=p3"}, "acc1; must differ");
  refused({"--sensor", "acc1=p2", "--force", "acc2"}, "channel 'acc2' = acceleration; must be");
  refused({"--sensor", "acc1=p2", "--mode", "7"}, "mode = 7; must be from 1 to 6");
  refused({"--sensor", "acc1=p2", "--modes", "7"}, "--modes");
  refused({"--sensor", "acc1=p2", "--no-vibrometer"}, "--no-vibrometer");
  refused({"sweep.csv", "--sensor", "acc1=p2"}, "a stepped-sine table");
  const Outcome rig =
      box.run({"reduce", "low.csv", "low.csv", "--sensor", "a=b", "--out", "m.csv"});
  EXPECT_EQ(rig.status, 2);
  EXPECT_NE(rig.err.find("--sensor = a=b; must not be given"), std::string::npos) << rig.err;
}

}  // namespace
}  // namespace microslip::cli_test::reduce_model_test
