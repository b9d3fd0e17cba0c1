// SPDX-License-Identifier: MIT
// Frequencies of meshes of CalculiX against those that it prints itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/documents/structure/model_file.hpp"

namespace microslip::cli_test::calculix_test {
namespace {

constexpr std::size_t kModes = 10;

/// The number of a node of a skewed block of 6 × 2 × 1 bricks.
int node(int i, int j, int k) { return 1 + k + 2 * (j + 3 * i); }

/// Its nodes, bricks and the set of its root, in mm.
std::string mesh() {
  std::string text = "*NODE\n";
  for (int i = 0; i <= 6; ++i) {
    for (int j = 0; j <= 2; ++j) {
      for (int k = 0; k <= 1; ++k) {
        text += fmt::format("{}, {}, {}, {}\n", node(i, j, k), 20 * i, 15 * j, 10 * k + 2 * i);
      }
    }
  }
  text += "*ELEMENT, TYPE=C3D8I, ELSET=bricks\n";
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 2; ++j) {
      text += fmt::format("{}", 1 + j + 2 * i);
      for (int k = 0; k <= 1; ++k) {
        text += fmt::format(", {}, {}, {}, {}", node(i, j, k), node(i + 1, j, k),
                            node(i + 1, j + 1, k), node(i, j + 1, k));
      }
      text += "\n";
    }
  }
  return text + "*NSET, NSET=root\n1, 2, 3, 4, 5, 6\n";
}

/// A job that asks for the modes, or for the matrices.
std::string job(const std::string& support, const std::string& solver) {
  return "*INCLUDE, INPUT=mesh.inp\n"
         "*MATERIAL, NAME=steel\n*ELASTIC\n210000., 0.3\n*DENSITY\n7.85e-9\n"
         "*SOLID SECTION, ELSET=bricks, MATERIAL=steel\n" +
         support + "*STEP\n*FREQUENCY" + solver + fmt::format("\n{}\n*END STEP\n", kModes);
}

const std::string kHeldRoot = "*BOUNDARY\nroot, 1, 3\n";
const std::string kMatrices = ", SOLVER=MATRIXSTORAGE";

bool run_in(const Sandbox& box, const std::string& command) {
  return std::system(fmt::format("cd '{}' && {} >log 2>&1", box.path(), command).c_str()) == 0;
}

/// The frequencies in the table of eigenvalues, Hz.
std::vector<double> printed_frequencies(const std::string& text) {
  std::vector<double> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && result.size() < kModes;) {
    std::istringstream words(line);
    double mode = 0.0;
    double eigenvalue = 0.0;
    double radians = 0.0;
    double cycles = 0.0;
    if (words >> mode >> eigenvalue >> radians >> cycles) result.push_back(cycles);
  }
  return result;
}

/// What `microslip modes` makes of the job of matrices with more in its file.
std::vector<double> found_frequencies(const Sandbox& box, const std::string& more) {
  box.put("s.toml", fmt::format("schema = \"microslip.structure/1\"\n"
                                "[matrices]\ncalculix = \"matrices\"\nlength_unit = \"mm\"\n"
                                "[nodes]\nfile = \"mesh.inp\"\n{}"
                                "[[point]]\nname = \"p\"\nnode = 42\ndirection = \"z\"\n"
                                "[modes]\ncount = {}\nattachment = false\nloss_factor = [0.0]\n"
                                "[excitation]\npoint = \"p\"\n",
                                more, kModes));
  EXPECT_EQ(box.run({"modes", "s.toml", "--out", "m.toml", "--quiet"}).status, 0);
  std::vector<double> result;
  const ModelFile model = read_model(box.file("m.toml"));
  for (const Mode& mode : model.structure.linear().modes()) {
    result.push_back(mode.angular_frequency / (2.0 * std::numbers::pi));
  }
  return result;
}

struct Case {
  std::string name;
  std::string printed_support;   ///< in the job whose frequencies are printed
  std::string matrices_support;  ///< in that of the matrices
  std::string our_support;       ///< in the structure.toml
  std::size_t rigid_bodies;
};

class calculix : public ::testing::TestWithParam<Case> {};

// It prints 7 digits, of which half a unit is 5e-7 at most. Rigid bodies have rounding there.
TEST_P(calculix, HasTheSameFrequencies) {
  if (std::system("command -v ccx >/dev/null") != 0) GTEST_SKIP() << "ccx is not installed";
  const Case& given = GetParam();
  const Sandbox box{{"mesh.inp", mesh()},
                    {"print.inp", job(given.printed_support, "")},
                    {"matrices.inp", job(given.matrices_support, kMatrices)}};
  ASSERT_TRUE(run_in(box, "ccx print") && run_in(box, "ccx matrices")) << box.get("log");
  const std::vector<double> expected = printed_frequencies(box.get("print.dat"));
  const std::vector<double> found = found_frequencies(box, given.our_support);
  ASSERT_EQ(expected.size(), kModes);
  ASSERT_EQ(found.size(), kModes);
  for (std::size_t i = 0; i < kModes; ++i) {
    if (i < given.rigid_bodies) {
      EXPECT_EQ(found[i], 0.0) << i;
    } else {
      EXPECT_NEAR(found[i], expected[i], 1e-6 * expected[i]) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, calculix,
                         ::testing::Values(Case{"FreeBricks", "", "", "", 6},
                                           Case{"BricksThatItHolds", kHeldRoot, kHeldRoot, "", 0},
                                           Case{"BricksThatWeHold", kHeldRoot, "",
                                                "[[support]]\nset = \"root\"\n", 0}),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace microslip::cli_test::calculix_test
