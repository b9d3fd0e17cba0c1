// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/ensemble/ensemble_jobs.hpp"
#include "support/replaced.hpp"

/// Designs by virtual records of the reference rig: three accelerometers and a vibrometer.

namespace microslip::rig_tests_test {
namespace {

const std::string kPlan = R"(schema = "microslip.ensemble/1"
kind = "design"
[design]
rig = "rig.toml"
count = 5
levels = [8]
sensor_noise = [0.0, 1.0, 30.0]
sensors = [["acc1", "acc2", "acc3", "ldv"], ["acc1"]]
)";

class Inputs {
 public:
  Inputs() {
    const std::string example = MICROSLIP_EXAMPLES "/reference_rig/";
    test::put(folder_.file("rig.toml"), test::get(example + "rig.toml"));
    test::put(folder_.file("joint.json"), test::get(example + "joint.json"));
  }
  void change_rig(const std::string& old, const std::string& by) const {
    test::put(folder_.file("rig.toml"),
              test::replaced(test::get(folder_.file("rig.toml")), old, by));
  }
  [[nodiscard]] std::unique_ptr<const EnsembleJobs> jobs(const std::string& plan = kPlan) const {
    test::put(folder_.file("plan.toml"), plan);
    return make_ensemble_jobs(read_ensemble_plan(folder_.file("plan.toml")));
  }

 private:
  test::TemporaryFolder folder_;
};

enum Value : std::size_t { kDensityError, kAreaError, kDissipationError };

// Groups: noise 0, 1 and 30, each with all sensors and with one.
TEST(RigTests, ErrMoreWithMoreNoise) {
  const Inputs inputs;
  const auto jobs = inputs.jobs();
  ASSERT_EQ(jobs->groups().size(), 6U);
  EXPECT_EQ(jobs->groups()[3].name, "8 levels - noise of the sensors x 1 - sensors 2");
  EXPECT_EQ(jobs->inputs().size(), 2U);  // rig and joint
  const auto error = [&](std::size_t group, Value value) {
    double sum = 0.0;
    for (std::uint64_t i = 0; i < 2; ++i) sum += std::abs(jobs->run(group, i).values.at(value));
    return sum / 2.0;
  };
  // The last value is D at the highest amplitude. What noise makes of it grows with the noise: the
  // random numbers are the same.
  const auto change = [&](std::size_t group, std::size_t without) {
    double sum = 0.0;
    for (std::uint64_t i = 0; i < 2; ++i) {
      sum += std::pow(jobs->run(group, i).values.back() - jobs->run(without, i).values.back(), 2);
    }
    return std::sqrt(sum);
  };
  for (const std::size_t sensors : {0U, 1U}) {
    // Without noise what is left is that of 8 levels, most of it at the lowest, and of the fit of
    // the records. D of so few levels counts as scattering by about 1 %, and is smoothed for it.
    EXPECT_LT(error(sensors, kDissipationError), 0.04);
    EXPECT_LT(error(sensors, kDensityError), 0.03);
    // A smoothing of its own makes it less than proportional.
    const double ratio = change(4 + sensors, sensors) / change(2 + sensors, sensors);
    EXPECT_GT(ratio, 8.0);
    EXPECT_LT(ratio, 90.0);
  }
}

// Noise of a sensor that nobody looks at counts for nothing; each test is its number's.
TEST(RigTests, LookAtTheirSensorsAlone) {
  const Inputs inputs;
  const auto jobs = inputs.jobs();
  const std::vector<double> all = jobs->run(2, 1).values;
  const std::vector<double> one = jobs->run(3, 1).values;
  EXPECT_EQ(all, inputs.jobs()->run(2, 1).values);
  EXPECT_NE(all, jobs->run(2, 2).values);
  EXPECT_NE(all, one);
  inputs.change_rig("vibrometer_m = 2e-8", "vibrometer_m = 2e-6");
  const auto blurred = inputs.jobs();
  EXPECT_NE(blurred->run(2, 1).values, all);
  EXPECT_EQ(blurred->run(3, 1).values, one);
}

TEST(RigTests, RefuseWhatCannotBe) {
  const Inputs inputs;
  const auto refusal = [&](const std::string& old, const std::string& by) {
    return test::message_of<Error>([&] { (void)inputs.jobs(test::replaced(kPlan, old, by)); });
  };
  EXPECT_NE(refusal("[\"acc1\"]]", "[\"acc9\"]]").find("must be one of acc1, acc2, acc3, ldv"),
            std::string::npos);
  EXPECT_NE(refusal("[\"acc1\"]]", "[\"ldv\"]]").find("design.sensors[1]: accelerometer"),
            std::string::npos);
  inputs.change_rig("[noise]", "[unheard]");
  EXPECT_NE(refusal("count = 5", "count = 6").find("unheard"), std::string::npos);
  inputs.change_rig("joint = \"joint.json\"", "");
  inputs.change_rig("[unheard]", "[noise]");
  EXPECT_NE(refusal("count = 5", "count = 6").find("must name the file of the true joint"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::rig_tests_test
