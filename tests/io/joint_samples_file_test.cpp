// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/joint_samples_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"

namespace microslip::joint_samples_file_test {
namespace {

using test::message_of;

/// Three draws of an atom on a triangle, each of a stiffness of its own.
JointSamples three_draws() {
  JointSamples samples;
  samples.method = "posterior of levels";
  samples.seed = std::numeric_limits<std::uint64_t>::max();
  samples.slip_displacement = {0.0, 1e-5, 3e-5};
  samples.stiffness = {1e5, 2e5, 0.3e5};
  samples.stiffness_density = {2e9, 1e9, 0.0, 1e9, 0.0, 5e9, 0.0, 0.0, 1e9};
  samples.atom_slip_displacement = 3e-5;
  samples.atom_weight = {0.0, 0.25, 0.125};
  samples.linear_damping = {0.0, 3.0, 1e4};
  samples.viscous = {1.0, 0.0, 2.0};
  samples.provenance = Provenance{.version = "1.2",
                                  .command = "microslip identify levels.csv",
                                  .inputs = {{"levels.csv", "ab12"}},
                                  .options = {{"bands", 3.0}, {"method", "inversion"}},
                                  .seed = 7,
                                  .other = {}};
  return samples;
}

class JointSamplesFile : public ::testing::Test {
 protected:
  void write(const JointSamples& samples) {
    std::filesystem::remove(path_);
    write_file(path_, joint_samples_bytes(samples, path_));
  }
  /// Changes the file by the library.
  void edit(const std::function<void(hid_t file)>& change) {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
  }
  std::string message() {
    return message_of<Error>([&] { return read_joint_samples(path_); });
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("joint_samples.h5");
};

TEST_F(JointSamplesFile, SurvivesTheRoundTrip) {
  const JointSamples written = three_draws();
  write(written);
  const JointSamples read = read_joint_samples(path_);
  EXPECT_EQ(read.method, written.method);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.slip_displacement, written.slip_displacement);
  EXPECT_EQ(read.stiffness_density, written.stiffness_density);
  EXPECT_EQ(read.stiffness, written.stiffness);
  EXPECT_EQ(read.atom_slip_displacement, written.atom_slip_displacement);
  EXPECT_EQ(read.atom_weight, written.atom_weight);
  EXPECT_EQ(read.linear_damping, written.linear_damping);
  EXPECT_EQ(read.viscous, written.viscous);
  EXPECT_EQ(read.provenance, written.provenance);
  EXPECT_EQ(joint_samples_bytes(read, path_), read_file(path_));
}

TEST_F(JointSamplesFile, SurvivesWithWhatItNeedsAlone) {
  JointSamples written = three_draws();
  written.atom_slip_displacement.reset();
  written.atom_weight.clear();
  written.linear_damping.clear();
  written.viscous.clear();
  written.provenance.reset();
  write(written);
  const JointSamples read = read_joint_samples(path_);
  EXPECT_FALSE(read.atom_slip_displacement);
  EXPECT_TRUE(read.atom_weight.empty());
  EXPECT_TRUE(read.linear_damping.empty());
  EXPECT_TRUE(read.viscous.empty());
  EXPECT_FALSE(read.provenance);
  EXPECT_EQ(read.joint(1).density().parts().size(), 1U);
}

// k²φ(kx) = ψ(x), by hand for the second draw: k = 2e5 N/m, knots at 0, 2 and 6 N, ψ of 5e9 N/m² is
// 0.125/N, and the atom stands at 6 N.
TEST_F(JointSamplesFile, GivesJoints) {
  const Joint joint = three_draws().joint(1);
  EXPECT_EQ(joint.stiffness(), 2e5);
  EXPECT_NEAR(joint.density().density(0.0), 0.025, 1e-15);
  EXPECT_NEAR(joint.density().density(4.0), 0.0625, 1e-15);
  const auto& atom = std::get<AtomsPart>(joint.density().parts().back());
  EXPECT_NEAR(atom.slip_force.front(), 6.0, 1e-14);
  EXPECT_EQ(atom.weight.front(), 0.25);
  // ∫ψ dx* = 0.5·1e9·1e-5 + 0.5·5e9·2e-5 = 5.5e4 N/m, of 2e5.
  EXPECT_NEAR(joint.density().total().zeroth, 0.275 + 0.25, 1e-14);
  EXPECT_EQ(three_draws().joint(0).density().parts().size(), 1U);  // an atom of nothing
  EXPECT_NE(
      message_of<InputError>([] { return three_draws().joint(3); }).find("number of a draw = 3"),
      std::string::npos);
}

TEST_F(JointSamplesFile, IsToldByItsContent) {
  write(three_draws());
  EXPECT_EQ(file_kind(read_kind_head(path_)), kSamplesKind);
  EXPECT_NO_THROW(check_output(path_, kSamplesKind));
}

TEST_F(JointSamplesFile, IsNotWrittenWithValuesThatBreakTheirRules) {
  const auto fault = [&](const std::function<void(JointSamples&)>& spoil) {
    JointSamples samples = three_draws();
    spoil(samples);
    return message_of<InputError>([&] { return joint_samples_bytes(samples, path_); });
  };
  const std::vector<std::pair<std::function<void(JointSamples&)>, std::string>> faults{
      {[](JointSamples& s) { s.stiffness.clear(); }, "number of draws"},
      {[](JointSamples& s) { s.slip_displacement.resize(1); }, "slip_displacement = 1"},
      {[](JointSamples& s) { s.slip_displacement[1] = 5e-5; }, "slip_displacement[2]"},
      {[](JointSamples& s) { s.slip_displacement[0] = -1e-9; }, "slip_displacement[0]"},
      {[](JointSamples& s) { s.stiffness_density.pop_back(); }, "values of stiffness_density = 8"},
      {[](JointSamples& s) { s.stiffness_density[4] = -1.0; }, "stiffness_density[4] = -1"},
      {[](JointSamples& s) { s.stiffness[1] = 0.0; }, "stiffness[1] = 0"},
      {[](JointSamples& s) { s.stiffness[1] = std::numeric_limits<double>::quiet_NaN(); },
       "stiffness[1]"},
      {[](JointSamples& s) { s.stiffness_density[0] = 1e11; }, "slipping fraction of k in draw 0"},
      {[](JointSamples& s) { s.atom_weight.clear(); }, "values of atom_weight = 0"},
      {[](JointSamples& s) { s.atom_weight[2] = 0.99; }, "slipping fraction of k in draw 2"},
      {[](JointSamples& s) { s.atom_slip_displacement = 0.0; }, "atom_slip_displacement[0]"},
      {[](JointSamples& s) { s.linear_damping.pop_back(); }, "values of linear_damping = 2"},
      {[](JointSamples& s) { s.viscous[1] = -2.0; }, "viscous[1] = -2"},
  };
  for (const auto& [spoil, expected] : faults) {
    EXPECT_NE(fault(spoil).find(expected), std::string::npos) << expected << ": " << fault(spoil);
  }
}

void replace_numbers(hid_t file, const char* name, std::vector<double> values, const char* unit) {
  if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
  const hsize_t size = values.size();
  const hid_t space = H5Screate_simple(1, &size, nullptr);
  const hid_t set =
      H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::string(unit).size());
  const hid_t scalar = H5Screate(H5S_SCALAR);
  const hid_t text = H5Acreate2(set, "unit_str", type, scalar, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(text, type, unit);
  H5Aclose(text);
  H5Sclose(scalar);
  H5Tclose(type);
  H5Dclose(set);
  H5Sclose(space);
}

TEST_F(JointSamplesFile, IsNotReadWhereAnotherProgramSpoiltIt) {
  const std::vector<std::pair<std::function<void(hid_t)>, std::string>> faults{
      {[](hid_t file) { H5Ldelete(file, "stiffness", H5P_DEFAULT); },
       ":/stiffness: expected a dataset, found none"},
      {[](hid_t file) {
         replace_numbers(file, "stiffness", {1e5, 2e5, -1.0}, "N/m");
       },
       "joint_samples.h5: stiffness[2] = -1"},
      {[](hid_t file) {
         replace_numbers(file, "stiffness", {1e5, 2e5}, "N/m");
       },
       "found 3 × 3"},
      {[](hid_t file) {
         replace_numbers(file, "stiffness", {1e2, 2e2, 3e2}, "N/mm");
       },
       "expected the unit N/m, found 'N/mm'"},
      {[](hid_t file) {
         replace_numbers(file, "stiffness_density", {1e9, 1e9}, "N/m^2");
       },
       "expected 2 dimensions, found 1"},
      {[](hid_t file) {
         replace_numbers(file, "atom_slip_displacement", {1e-5, 2e-5}, "m");
       },
       "expected 1 value, found 2"},
      {[](hid_t file) { replace_numbers(file, "viscous", {1.0}, "N*s/m"); },
       "values of viscous = 1"},
      {[](hid_t file) { replace_numbers(file, "frequency", {1.0}, "Hz"); }, "found 'frequency'"},
      {[](hid_t file) { H5Adelete(file, "schema"); },
       "expected the schema microslip.joint_samples/1, found none"},
      {[](hid_t file) { H5Adelete(file, "seed"); }, "the attribute 'seed'"},
  };
  for (const auto& [spoil, expected] : faults) {
    write(three_draws());
    edit(spoil);
    EXPECT_NE(message().find(expected), std::string::npos) << expected << ": " << message();
  }
}

TEST_F(JointSamplesFile, IsNotReadWhereItIsNone) {
  EXPECT_NE(message().find("joint_samples.h5"), std::string::npos);
  write_file(path_, "time [s]\n1\n");
  EXPECT_NE(message().find("joint_samples.h5"), std::string::npos);
  EXPECT_NE(message_of<FileError>([] { return read_joint_samples("-"); }).find("standard input"),
            std::string::npos);
}

// Cut off anywhere it is refused, and never read as fewer draws.
TEST_F(JointSamplesFile, IsNotReadWhereItIsCutOff) {
  const std::string bytes = joint_samples_bytes(three_draws(), path_);
  for (std::size_t i = 1; i < 8; ++i) {
    std::ofstream(path_, std::ios::binary) << bytes.substr(0, i * bytes.size() / 8);
    EXPECT_NE(message().find("joint_samples.h5"), std::string::npos) << i;
  }
}

}  // namespace
}  // namespace microslip::joint_samples_file_test
