// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip::cli_test::loop_test {
namespace {

const std::string kVaryingLoad =
    "displacement [um],normal_load [%]\n0,100\n80,60\n-120,130\n40,100\n90,0\n";

Sandbox sandbox() {
  return Sandbox{{"joint.json", kJointText},
                 {"path.csv", "displacement [um]\n0\n150\n-30\n90\n-200\n"},
                 {"load.csv", kVaryingLoad}};
}

std::vector<double> forces(const std::string& text) {
  return CsvTable(text, "loop.csv").numbers("force", kForce);
}

std::vector<double> displacements(const std::string& text) {
  return CsvTable(text, "loop.csv").numbers("displacement", kLength);
}

std::vector<double> library_forces(const std::vector<double>& x) {
  const Joint joint = sample_joint();
  std::vector<double> force(x.size());
  Memory(joint).march(x, force);
  return force;
}

TEST(loop, FollowsAPath) {
  const Sandbox box = sandbox();
  const Outcome run =
      expect_done(box, {"loop", "joint.json", "--path", "path.csv", "--out", "loop.csv"});
  EXPECT_EQ(run.out, "");
  const std::string text = box.get("loop.csv");
  EXPECT_TRUE(behind_heading(text).starts_with("displacement [m],force [N]\n")) << text;
  const std::vector<double> x = displacements(text);
  EXPECT_EQ(x, (std::vector<double>{0.0, 150e-6, -30e-6, 90e-6, -200e-6}));
  EXPECT_EQ(forces(text), library_forces(x));
}

TEST(loop, MakesACycle) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(
      box, {"loop", "joint.json", "--amplitude", "0.1mm", "--points", "50", "--out", "-"});
  const std::vector<double> x = displacements(run.out);
  const std::vector<double> f = forces(run.out);
  ASSERT_EQ(x.size(), 151U) << "a start, first loading and two branches of 50 points";
  EXPECT_EQ(x[50], 1e-4);
  EXPECT_EQ(x[100], -1e-4);
  EXPECT_EQ(x[150], 1e-4);
  EXPECT_EQ(*std::max_element(x.begin(), x.end()), 1e-4);
  EXPECT_EQ(f, library_forces(x));
  // Closed and symmetric, to the rounding of a sum over two branches. [Masing]
  EXPECT_NEAR(f[150], f[50], 1e-12 * f[50]);
  EXPECT_NEAR(f[100], -f[50], 1e-12 * f[50]);
}

TEST(loop, ByDefaultHas200PointsABranch) {
  const Sandbox box = sandbox();
  const Outcome run =
      expect_done(box, {"loop", "joint.json", "--amplitude", "300um", "--out", "-"});
  EXPECT_EQ(forces(run.out).size(), 601U);
}

TEST(loop, FollowsAVaryingNormalLoadByBothLaws) {
  const Sandbox box = sandbox();
  const JenkinsNetwork network = JenkinsNetwork::discretise(sample_joint(), 300);
  const std::vector<double> x{0.0, 80e-6, -120e-6, 40e-6, 90e-6};
  const std::vector<double> p{1.0, 0.6, 1.3, 1.0, 0.0};
  std::vector<std::vector<double>> found;
  for (const auto& [name, law] : {std::pair{"incremental", NormalLoadLaw::kIncremental},
                                  std::pair{"total", NormalLoadLaw::kTotal}}) {
    const Outcome run =
        expect_done(box, {"loop", "joint.json", "--path", "load.csv", "--normal-load-law", name,
                          "--elements", "300", "--out", "-"});
    EXPECT_TRUE(run.out.starts_with("displacement [m],normal_load [1],force [N]\n")) << run.out;
    EXPECT_EQ(CsvTable(run.out, "out").numbers("normal_load", kDimensionless), p);
    std::vector<double> expected(x.size());
    NetworkMemory(network, law).march(x, p, expected);
    EXPECT_EQ(forces(run.out), expected) << name;
    found.push_back(forces(run.out));
  }
  EXPECT_NE(found[0], found[1]) << "the laws differ on this path";
  EXPECT_EQ(found[1].back(), 0.0) << "by the total law there is no force without normal load";
}

TEST(loop, TakesTheIncrementalLawByDefault) {
  const Sandbox box = sandbox();
  const Arguments plain{"loop", "joint.json", "--path", "load.csv", "--out", "-"};
  Arguments named = plain;
  named.insert(named.end(), {"--normal-load-law", "incremental"});
  EXPECT_EQ(expect_done(box, plain).out, expect_done(box, named).out);
}

TEST(loop, UnderConstantLoadIsNearThePathWithoutOne) {
  const Sandbox box = sandbox();
  box.put("ones.csv", "displacement [m],normal_load [1]\n0,1\n1.5e-4,1\n-3e-5,1\n");
  const std::vector<double> f =
      forces(expect_done(box, {"loop", "joint.json", "--path", "ones.csv", "--out", "-"}).out);
  const std::vector<double> exact = library_forces({0.0, 1.5e-4, -3e-5});
  for (std::size_t i = 0; i < f.size(); ++i) {
    EXPECT_NEAR(f[i], exact[i], 1e-4 * exact[1]) << "1000 elements";
  }
}

TEST(loop, ReadsThePathFromStandardInput) {
  const Sandbox box = sandbox();
  const Outcome run = expect_done(box, {"loop", "joint.json", "--path", "-", "--out", "-"},
                                  {.in = "displacement [mm]\n0\n0.1\n"});
  EXPECT_EQ(forces(run.out), library_forces({0.0, 1e-4}));
}

}  // namespace
}  // namespace microslip::cli_test::loop_test
