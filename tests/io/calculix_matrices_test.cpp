// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/calculix_matrices.hpp"

#include <gtest/gtest.h>

#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::calculix_matrices_test {
namespace {

using test::message_of;

// As CalculiX 2.20 writes them: one triangle, the upper, and entries that are 0.
TEST(CalculixMatrices, AreReadFromTheThreeFilesOfAJob) {
  const test::TemporaryFolder folder;
  test::put(folder.file("job.sti"),
            "1 1  4.9358974358974e+10\n1 2 -1.6826923076923e+10\n2 2  5e+10\n");
  test::put(folder.file("job.mas"), "1 1  2.9e+02\n1 2  0.0000000000000e+00\n2 2  2.9e+02\n");
  test::put(folder.file("job.dof"), "2.1\n12.3\n");
  const StructuralMatrices matrices = read_calculix_matrices(folder.file("job"));
  EXPECT_EQ(matrices.stiffness.size, 2U);
  EXPECT_EQ(matrices.stiffness.value.size(), 3U);
  EXPECT_EQ(matrices.stiffness.row[1], 1);
  EXPECT_EQ(matrices.stiffness.column[1], 0);
  EXPECT_EQ(matrices.mass.value.size(), 2U);
  ASSERT_EQ(matrices.degrees.size(), 2U);
  EXPECT_EQ(matrices.degrees[1], (DegreeOfFreedom{12, NodalDirection::kZ}));
  EXPECT_THROW((void)read_calculix_matrices(folder.file("other")), FileError);
}

// CalculiX 2.20 expands a shell to solids: of S4 the lower and the upper face have the numbers of
// its nodes. Of a cyclic sector with nodal diameters there are two rows for each line of JOB.dof.
TEST(CalculixMatrices, HaveRowsOfFacesAndNoneOfCyclicSectors) {
  const test::TemporaryFolder folder;
  const auto message = [&](const std::string& degrees) {
    test::put(folder.file("job.dof"), degrees);
    for (const char* ending : {"job.sti", "job.mas"}) {
      test::put(folder.file(ending), "1 1 2\n2 2 3\n3 3 2\n4 4 3\n1 4 1\n");
    }
    return message_of<FormatError>([&] { return read_calculix_matrices(folder.file("job")); });
  };
  EXPECT_EQ(message("2.1\n2.2\n2.1\n2.2\n"), "no error") << "a shell";
  const StructuralMatrices shell = read_calculix_matrices(folder.file("job"));
  EXPECT_TRUE(shell.expanded);
  EXPECT_EQ(shell.degrees[2], shell.degrees[0]);
  const std::string cyclic = message("2.1\n2.2\n");
  EXPECT_NE(cyclic.find("job.dof, found 4 rows. They are real and imaginary part of a cyclic"),
            std::string::npos)
      << cyclic;
  const std::string other = message("2.1\n2.2\n2.3\n");
  EXPECT_NE(other.find("found 4 rows. Both must be of the same run"), std::string::npos) << other;
}

TEST(CalculixMatrices, DegreesAreReadInSeveralForms) {
  const std::vector<DegreeOfFreedom> degrees =
      parse_degrees("# rows\n1.1\r\n 2, y\n3 rz\n4\t6\n5 z\n", "");
  ASSERT_EQ(degrees.size(), 5U);
  EXPECT_EQ(degrees[0], (DegreeOfFreedom{1, NodalDirection::kX}));
  EXPECT_EQ(degrees[1], (DegreeOfFreedom{2, NodalDirection::kY}));
  EXPECT_EQ(degrees[2], (DegreeOfFreedom{3, NodalDirection::kTurnZ}));
  EXPECT_EQ(degrees[3], (DegreeOfFreedom{4, NodalDirection::kTurnZ}));
}

TEST(CalculixMatricesFault, IsNamedByItsPlace) {
  const auto degrees = [](const std::string& text) {
    return message_of<FormatError>([&] { return parse_degrees(text, "d"); });
  };
  EXPECT_EQ(degrees("1.1\n1.7\n"),
            "d:2:1: expected a node and its direction, 12.3 or 12 z, found '1.7'");
  EXPECT_EQ(degrees("1\n"), "d:1:1: expected a node and its direction, 12.3 or 12 z, found '1'");
  EXPECT_EQ(degrees("# none\n"), "d: expected one line per row of the matrices, found none");
  EXPECT_EQ(message_of<FormatError>([] { return parse_triangle("1 1 1\n3 1 1\n", "k", 2); }),
            "k:2:1: expected a row from 1 to 2, found 3");
  EXPECT_EQ(message_of<FormatError>([] { return parse_triangle("", "k", 2); }),
            "k: expected lines of row, column and value, found none");
}

}  // namespace
}  // namespace microslip::calculix_matrices_test
