// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/ensemble/ensemble_jobs.hpp"
#include "microslip/identify/inversion/inversion.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/joint/dissipation.hpp"
#include "support/effort.hpp"

/// Jobs that identify: bootstrap and design. The truth is φ = 1/30 per N up to 30 N with k = 1e6
/// N/m, D = (2/90)k²A³ up to 30 um [AR14 (7)].

namespace microslip::identification_jobs_test {
namespace {

constexpr double kStiffness = 1e6;  // N/m

Joint truth() { return Joint(kStiffness, SlipDensity({UniformPart{0.0, 30.0, 1.0}})); }

constexpr double kNoise = 0.01;

std::string levels_text(std::size_t count, std::uint64_t seed, double noise) {
  RandomStream random(seed, 99);
  Levels levels;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = 1e-6 + 27e-6 * static_cast<double>(i) / static_cast<double>(count - 1);
    levels.amplitude.push_back(a);
    levels.dissipation.push_back(dissipation(truth(), a) * (1.0 + noise * random.normal()));
  }
  return levels_table(levels).str();
}

/// A folder with levels, a joint and a plan.
class Inputs {
 public:
  explicit Inputs(const std::string& plan, double noise = kNoise) {
    test::put(folder_.file("levels.csv"), levels_text(40, 1, noise));
    test::put(folder_.file("joint.json"), format_joint({truth(), {}, {}}));
    test::put(folder_.file("plan.toml"), "schema = \"microslip.ensemble/1\"\n" + plan);
  }

  [[nodiscard]] std::unique_ptr<const EnsembleJobs> jobs() const {
    return make_ensemble_jobs(read_ensemble_plan(folder_.file("plan.toml")));
  }
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

 private:
  test::TemporaryFolder folder_;
};

const std::string kBootstrap = R"(kind = "bootstrap"
[bootstrap]
levels = "levels.csv"
stiffness_N_per_m = 1e6
count = 100
points = 5
)";

struct Spread {
  double mean = 0.0;
  double std = 0.0;
};

/// Of the first value, the area, over jobs.
Spread spread_of_value(const EnsembleJobs& jobs, std::size_t group, std::size_t value,
                       std::size_t count) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const JobResult result = jobs.run(group, i);
    EXPECT_EQ(result.failure, "");
    const double x = result.values.at(value);
    sum += x;
    squares += x * x;
  }
  const auto n = static_cast<double>(count);
  return {sum / n, std::sqrt((squares - sum * sum / n) / (n - 1.0))};
}

// A job is a function of its number alone, and another number is another job.
TEST(BootstrapJobs, AreFunctionsOfTheirNumber) {
  for (const char* resample : {"levels", "residuals"}) {
    const Inputs inputs(kBootstrap + "resample = \"" + resample + "\"\n");
    const auto jobs = inputs.jobs();
    const auto again = inputs.jobs();
    const std::vector<double> third = jobs->run(0, 3).values;
    EXPECT_EQ(third.size(), jobs->groups()[0].width());
    (void)again->run(0, 5);
    EXPECT_EQ(again->run(0, 3).values, third);
    EXPECT_NE(jobs->run(0, 4).values, third);
  }
}

// Without noise there is nothing to draw: residuals of 1e-9 leave what was identified.
TEST(BootstrapJobs, OfExactLevelsAreTheIdentification) {
  const Inputs inputs(kBootstrap + "resample = \"residuals\"\n", 1e-9);
  const auto jobs = inputs.jobs();
  const LevelsFile file = read_levels(inputs.file("levels.csv"));
  const double area = invert(LevelEvidence(file.levels), kStiffness, {.edges = false}).area;
  for (std::uint64_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(jobs->run(0, i).values.front(), area, 1e-5);
  }
}

// The spread by the bootstrap of one test against that of virtual tests of the same joint differ
// by: D in the middle of the range. 300 draws know a deviation to 4 %, the scatter of one test of
// 40 levels to 12 %, and what a smooth fit takes of the residuals is known to 10 or 20 %.
TEST(BootstrapJobs, SpreadAsTestsDo) {
  MICROSLIP_OF_RELEASE_ALONE();
  const Inputs design(R"(kind = "design"
[design]
joint = "joint.json"
count = 300
levels = [40]
noise = [0.01]
amplitude_m = [1e-6, 28e-6]
)");
  const auto tests = design.jobs();
  const std::size_t middle = 25;  // of 50 values of D, the last ones
  const std::uint64_t count = test::draws_of(300, 60);
  const Spread true_spread = spread_of_value(*tests, 0, tests->groups()[0].width() - middle, count);
  for (const char* resample : {"levels", "residuals"}) {
    const Inputs inputs(kBootstrap.substr(0, kBootstrap.find("points")) + "resample = \"" +
                        resample + "\"\n");
    const auto jobs = inputs.jobs();
    const Spread spread = spread_of_value(*jobs, 0, jobs->groups()[0].width() - middle, count);
    EXPECT_NEAR(spread.std / true_spread.std, 1.0, test::bound_of(0.4)) << resample;
  }
}

const std::string kDesign = R"(kind = "design"
[design]
joint = "joint.json"
count = 30
levels = [10, 40]
noise = [0.001, 0.01]
amplitude_m = [1e-6, 28e-6]
)";

// More levels and less noise err less, by what is known of the mean of n values: noise ten times
// less is some ten times less error of D.
TEST(DesignJobs, TellWhatMoreLevelsAreWorth) {
  const Inputs inputs(kDesign);
  const auto jobs = inputs.jobs();
  ASSERT_EQ(jobs->groups().size(), 4U);
  EXPECT_EQ(jobs->groups()[1].name, "10 levels - noise 0.01");
  const auto error = [&](std::size_t group) {
    return spread_of_value(*jobs, group, 2, 30).mean;  // dissipation_error
  };
  const double ten = error(1);
  const double forty = error(3);
  EXPECT_LT(forty, 0.75 * ten);
  EXPECT_LT(error(0), 0.25 * ten);
  EXPECT_LT(error(2), 0.25 * forty);
}

// Designs of one test have the same random numbers: with little noise the errors of all are
// proportional to it.
TEST(DesignJobs, DifferByTheDesignAlone) {
  const Inputs inputs(kDesign);
  const auto jobs = inputs.jobs();
  EXPECT_EQ(jobs->run(0, 7).values, inputs.jobs()->run(0, 7).values);
  const auto last_error = [&](std::size_t group) {
    const double a = 28e-6;
    return jobs->run(group, 7).values.back() / dissipation(truth(), a) - 1.0;
  };
  EXPECT_EQ(std::signbit(last_error(0)), std::signbit(last_error(1)));
}

TEST(DesignJobs, HaveABandWhereDrawsAreAskedFor) {
  const Inputs inputs(kDesign + "draws = 200\n");
  const auto jobs = inputs.jobs();
  EXPECT_EQ(jobs->groups()[0].outputs[3].name, "band_coverage");
  double coverage = 0.0;
  for (std::uint64_t i = 0; i < 10; ++i) coverage += jobs->run(3, i).values[3] / 10.0;
  EXPECT_GT(coverage, 0.8);
  EXPECT_LE(coverage, 1.0);
}

// k_eq is measured in designs that give its noise: it also determines the density below the levels.
TEST(DesignJobs, MeasureTheSecantStiffness) {
  const Inputs inputs(kDesign + "secant_noise = [1e-5]\n");
  const Inputs without(kDesign);
  const auto jobs = inputs.jobs();
  const auto other = without.jobs();
  EXPECT_EQ(jobs->groups()[1].name, "10 levels - noise 0.01 - of k_eq 1e-05");
  EXPECT_LT(spread_of_value(*jobs, 1, 0, 20).mean, spread_of_value(*other, 1, 0, 20).mean);
}

TEST(DesignJobs, RefuseAmplitudesWithoutLoss) {
  const Inputs inputs(kDesign);
  test::put(inputs.file("joint.json"),
            format_joint({Joint(kStiffness, SlipDensity({UniformPart{20.0, 30.0, 1.0}})), {}, {}}));
  const std::string refusal = test::message_of<InputError>([&] { (void)inputs.jobs(); });
  EXPECT_NE(refusal.find("must be an amplitude at which the joint dissipates"), std::string::npos)
      << refusal;
}

}  // namespace
}  // namespace microslip::identification_jobs_test
