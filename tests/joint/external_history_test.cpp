// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"

namespace microslip::external_history_test {
namespace {

// A shear stress history under earthquake-like shaking that MASTODON computed with its nested
// elastic-plastic springs (github.com/idaholab/mastodon, I-soil, LGPL-2.1): read from where the
// data lie, never copied. Strain stands for x, stress in Pa for f; the recorded component is half
// the shear strain.
class ExternalHistory : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MICROSLIP_DATA_DIR");
    if (folder == nullptr) GTEST_SKIP() << "MICROSLIP_DATA_DIR is not set";
    const std::string data = std::string(folder) + "/mastodon_isoil/";
    if (!std::filesystem::exists(data)) GTEST_SKIP() << data << " is not there";
    const testing::ReferenceTable history(data + "data_file_hysteresis.csv");
    for (const double half : history["strain_zx_el"]) strain_.push_back(2.0 * half);
    stress_ = history["stress_zx_el"];
    for (const double stress : stress_) largest_ = std::max(largest_, std::abs(stress));

    // Ten elements in parallel: each slips at a point of the backbone and has the decrease of the
    // slope there.
    const testing::ReferenceTable backbone(data + "stress_strain_darendeli.csv");
    const std::vector<double>& x = backbone["strain"];
    const std::vector<double>& f = backbone["stress"];
    std::vector<double> slope;
    for (std::size_t i = 0; i < x.size(); ++i) {
      slope.push_back(i == 0 ? f[0] / x[0] : (f[i] - f[i - 1]) / (x[i] - x[i - 1]));
    }
    stiffness_ = slope.front();
    slope.push_back(0.0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double lost = slope[i] - slope[i + 1];
      elements_.push_back({lost, lost * x[i]});
      atoms_.slip_force.push_back(stiffness_ * x[i]);
      atoms_.weight.push_back(lost / stiffness_);
    }
  }

  /// Largest difference over the largest stress. The stresses are printed with 15 digits.
  [[nodiscard]] double error(const std::vector<double>& force) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      largest = std::max(largest, std::abs(force[i] - stress_[i]));
    }
    return largest / largest_;
  }

  std::vector<double> strain_;
  std::vector<double> stress_;
  double largest_ = 0.0;
  double stiffness_ = 0.0;
  std::vector<JenkinsElement> elements_;
  AtomsPart atoms_;
};

TEST_F(ExternalHistory, NetworkReproducesIt) {
  ASSERT_GT(strain_.size(), 700U);
  const JenkinsNetwork network(elements_);
  std::vector<double> force(strain_.size());
  NetworkMemory(network).march(strain_, force);
  EXPECT_LT(error(force), 1e-9);
  test::record_largest("error [1]", error(force));
}

TEST_F(ExternalHistory, MemoryReproducesIt) {
  const Joint joint(stiffness_, SlipDensity({atoms_}));
  std::vector<double> force(strain_.size());
  Memory(joint).march(strain_, force);
  EXPECT_LT(error(force), 1e-9);
  test::record_largest("error [1]", error(force));
}

}  // namespace
}  // namespace microslip::external_history_test
