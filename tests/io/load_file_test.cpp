// SPDX-License-Identifier: MIT
#include "microslip/documents/response/load_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::load_file_test {
namespace {

/// Two points, forces at those named.
JointedStructure structure(const std::vector<std::string>& excited) {
  std::vector<Excitation> excitations;
  for (const std::string& point : excited) excitations.push_back({point, {1.0}});
  return JointedStructure(ModalModel({{6.0, 0.01}}, {{"a", {1.0}}, {"b", {0.5}}}), {},
                          std::move(excitations), DampingLaw::kViscous);
}

LoadHistory loads(const std::vector<std::string>& excited) {
  return parse_loads("time [s],force [N]\n0,1\n1,3\n", "force.csv", structure(excited),
                     NormalLoadLaw::kIncremental);
}

TEST(LoadFile, AForceActsAtTheOnlyExcitation) {
  const LoadHistory found = loads({"b"});
  ASSERT_EQ(found.forces.size(), 1U);
  EXPECT_EQ(found.forces[0].point, "b");
  EXPECT_EQ(found.forces[0].force, (std::vector<double>{1.0, 3.0}));
}

// Two forces of a model at one point, of different harmonics for instance, are one place.
TEST(LoadFile, TwoExcitationsAtOnePointAreOnePlace) {
  const LoadHistory found = loads({"b", "b"});
  ASSERT_EQ(found.forces.size(), 1U);
  EXPECT_EQ(found.forces[0].point, "b");
}

TEST(LoadFile, AForceWithoutPlaceIsRefusedWhereThereAreTwo) {
  try {
    (void)loads({"a", "b"});
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("The model has 2 excitations: 'a', 'b'."),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace microslip::load_file_test
