// SPDX-License-Identifier: MIT
#include "microslip/io/open/mesh_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::mesh_file_test {
namespace {

using test::message_of;
using Nodes = std::vector<std::int64_t>;

MeshFile mesh_of(const std::string& text, double length_unit = 1.0) {
  const test::TemporaryFolder folder;
  test::put(folder.file("mesh"), text);
  return read_mesh(folder.file("mesh"), length_unit);
}

TEST(MeshFile, ReadsAnInputOfCalculix) {
  const MeshFile mesh = mesh_of(
      "** a plate\n*Heading\nno nodes\n*NODE, NSET=Nall\n1, 0, 0, 0\n 2 , 1.5e3, +2, -1.\n7,3\n"
      "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1,2,3,4,5,6,7,8\n"
      "*NSET, NSET=left\n7, 1,\n2\n*NSET, NSET=even, GENERATE\n2, 6, 2\n*nset, nset=both\nLEFT, "
      "9\r\n*STEP\n",
      1e-3);
  ASSERT_EQ(mesh.nodes.size(), 3U);
  EXPECT_EQ(mesh.nodes[1].number, 2);
  EXPECT_EQ(mesh.nodes[1].position, (Vector3{1.5, 2e-3, -1e-3}));
  EXPECT_EQ(mesh.nodes[2].position, (Vector3{3e-3, 0.0, 0.0}));
  ASSERT_EQ(mesh.sets.size(), 4U);
  EXPECT_EQ(mesh.sets[0].name, "NALL");
  EXPECT_EQ(mesh.sets[1].nodes, (Nodes{1, 2, 7}));
  EXPECT_EQ(mesh.sets[2].nodes, (Nodes{2, 4, 6}));
  EXPECT_EQ(mesh.sets[3].nodes, (Nodes{1, 2, 7, 9}));
}

// What CalculiX numbers as translations of nodes and is none, by its manual: degrees of freedom of
// ROT NODE and of the last node of MEANROT, whose list may go on behind 0.
TEST(MeshFile, KnowsRotationsAndElements) {
  const MeshFile mesh = mesh_of(
      "*NODE\n1,0,0,0\n2,1,0,0\n9,0,0,0\n"
      "*ELEMENT, TYPE=C3D20\n1, 1, 2,\n3,4\n2, 5,6\n*ELEMENT, TYPE=MASS, ELSET=M\n70, 9\n"
      "*RIGID BODY, NSET=F, REF NODE=9, ROT NODE=10\n"
      "*MPC\nMEANROT,1,1,1,2,2\n0,2,11\nPLANE,1,2,3\nMEANROT,2,2,2,12\n");
  EXPECT_EQ(mesh.element_nodes, (Nodes{1, 2, 3, 4, 5, 6, 9}));
  EXPECT_EQ(mesh.rotation_nodes, (Nodes{10, 11, 12}));
  EXPECT_FALSE(mesh.axisymmetric);
  const MeshFile ring = mesh_of("*NODE\n1,1,0\n*ELEMENT,TYPE=CAX4,ELSET=e\n1,1,2,3,4\n");
  EXPECT_TRUE(ring.axisymmetric);
  EXPECT_FALSE(ring.beside_axisymmetric);
}

TEST(MeshFile, FollowsFilesThatAreIncluded) {
  const test::TemporaryFolder folder;
  test::put(folder.file("all.inp"), "*INCLUDE, INPUT=mesh.msh\n*NSET,NSET=A\n1\n");
  test::put(folder.file("mesh.msh"), "*NODE\n1,0,0,0\n");
  const MeshFile mesh = read_mesh(folder.file("all.inp"), 1.0);
  EXPECT_EQ(mesh.nodes.size(), 1U);
  EXPECT_EQ(mesh.sets.size(), 1U);
  test::put(folder.file("mesh.msh"), "*INCLUDE, INPUT=all.inp\n");
  EXPECT_NE(message_of<InputError>([&] {
              return read_mesh(folder.file("all.inp"), 1.0);
            }).find("Do files include each other?"),
            std::string::npos);
}

// Found by scripts/fuzz: the message held all of a name of thousands of bytes.
TEST(MeshFile, NamesOfFilesLeaveTheMessageShort) {
  const std::string name(257, 'x');
  const std::string message =
      message_of<FormatError>([&] { mesh_of("*INCLUDE, INPUT=" + name + "\n"); });
  EXPECT_TRUE(message.ends_with("/mesh:1: expected a name of at most 256 bytes, found '" +
                                name.substr(0, 40) + "…' (257 bytes)"))
      << message;
}

// Found by scripts/fuzz: a set that has itself, line after line, doubled with each.
TEST(MeshFile, SetsOfSetsStaySmall) {
  std::string itself = "*NSET,NSET=A\n1,2\n";
  std::string twice = itself;
  for (int i = 0; i < 64; ++i) itself += "A\n";
  EXPECT_EQ(mesh_of(itself).sets[0].nodes, (Nodes{1, 2}));
  for (int i = 0; i < 64; ++i) {
    twice += fmt::format("*NSET,NSET=S{}\n{},{}\n", i, i == 0 ? "A" : fmt::format("S{}", i - 1),
                         i == 0 ? "A" : fmt::format("S{}", i - 1));
  }
  EXPECT_NE(message_of<FormatError>([&] { mesh_of(twice); }).find("nodes in all sets"),
            std::string::npos);
}

TEST(MeshFile, ReadsUniversalFiles) {
  const std::string label = "        12         0         0        11";
  const MeshFile short_form =
      mesh_of("    -1\n    15\n" + label + "  1.50000E+00 -2.00000E+00  0.00000E+00\n    -1\n");
  ASSERT_EQ(short_form.nodes.size(), 1U);
  EXPECT_EQ(short_form.nodes[0].number, 12);
  EXPECT_EQ(short_form.nodes[0].position, (Vector3{1.5, -2.0, 0.0}));
  const MeshFile long_form = mesh_of(
      "    -1\n   164\n         5mm (milli-newton)           2\n"
      "  1.0000000000000000D+03  1.0000000000000000D+03  1.0000000000000000D+00\n"
      "  2.7314999999999998D+02\n    -1\n    -1\n  2411\n" +
      label +
      "\n   1.5000000000000000D+03  -2.0000000000000000D+00   0.0000000000000000D+00\n    -1\n");
  ASSERT_EQ(long_form.nodes.size(), 1U);
  EXPECT_DOUBLE_EQ(long_form.nodes[0].position[0], 1.5);
  EXPECT_DOUBLE_EQ(long_form.nodes[0].position[1], -2e-3);
}

TEST(MeshFile, ReadsATable) {
  const MeshFile mesh = mesh_of("# nodes\nnode [1],x [mm],y [m],z [m]\n3,1500,2,0\n");
  ASSERT_EQ(mesh.nodes.size(), 1U);
  EXPECT_EQ(mesh.nodes[0].number, 3);
  EXPECT_EQ(mesh.nodes[0].position, (Vector3{1.5, 2.0, 0.0}));
}

// As CalculiX 2.20 reads coordinates: nothing is 0, D is an exponent, blanks within count for
// nothing, of a node that is there twice the last counts.
TEST(MeshFile, ReadsCoordinatesAsCalculixDoes) {
  const MeshFile mesh = mesh_of(
      "*NODE\n1, 1.0D1, , 1 5\n2, 10,,\n3, 1d-1\n2, 7, 0, 0\n*NODE, SYSTEM=R\n4, 1, 2, 3\n");
  ASSERT_EQ(mesh.nodes.size(), 4U);
  EXPECT_EQ(mesh.nodes[0].position, (Vector3{10.0, 0.0, 15.0}));
  EXPECT_EQ(mesh.nodes[1].position, (Vector3{7.0, 0.0, 0.0}));
  EXPECT_EQ(mesh.nodes[2].position, (Vector3{0.1, 0.0, 0.0}));
  EXPECT_TRUE(mesh.warnings.empty());
}

// CalculiX 2.20 reads 20 characters of a number: 1 of 1.000000000000000e+01.
TEST(MeshFile, WarnsOfNumbersThatAreCut) {
  const MeshFile mesh = mesh_of("*NODE\n1, 0.000000000000000e+00, 1.000000000000000e+01, 0\n");
  ASSERT_EQ(mesh.warnings.size(), 1U);
  EXPECT_EQ(mesh.warnings[0].code, "numbers_cut");
  EXPECT_NE(mesh.warnings[0].text.find("has 21 characters, of which CalculiX and Abaqus read 20: 1 "
                                       "instead of 10"),
            std::string::npos)
      << mesh.warnings[0].text;
  EXPECT_EQ(mesh.nodes[0].position[1], 10.0);
}

TEST(MeshFile, KnowsTheUnitOfItsOwn) {
  EXPECT_EQ(mesh_of("node [1],x [in],y [in],z [in]\n3,1,2,0\n").own_unit, 0.0254);
  EXPECT_EQ(mesh_of("node [1],x [m],y [m],z [m]\n3,1,2,0\n").own_unit, 1.0);
}

TEST(MeshFileFault, IsNamedByItsPlace) {
  const auto fault = [](const std::string& text) {
    const std::string message = message_of<FormatError>([&] { return mesh_of(text); });
    const std::size_t end = message.find("/mesh");
    return end == std::string::npos ? message : message.substr(end + 1);
  };
  EXPECT_EQ(fault("*NODE\n1, a, 0, 0\n"), "mesh:2: expected a coordinate, found 'a'");
  EXPECT_EQ(fault("*NODE\n-1, 0, 0, 0\n"), "mesh:2: expected the number of a node, found '-1'");
  EXPECT_EQ(fault("*NSET\n1\n"), "mesh:1: expected *NSET, NSET=NAME, found '*NSET'");
  EXPECT_EQ(fault("*NSET,NSET=A\nfoo\n"), "mesh:2: expected the number of a node, found 'foo'");
  EXPECT_EQ(fault("*NSET,NSET=A,GENERATE\n1,999999999999\n"),
            "mesh:2: expected up to 10000000 nodes in all sets, found 999999999999");
  EXPECT_EQ(fault("*NSET,NSET=A,GENERATE\n3,2\n"),
            "mesh:2: expected the first node before the last, found 3 to 2");
  EXPECT_EQ(fault("*SYSTEM\n"),
            "mesh:1: expected nodes in global coordinates, found *SYSTEM. Give the nodes in a "
            "table: node [1], x [m], y [m], z [m].");
  EXPECT_EQ(fault("*Node, System=C\n1, 100, 90, 0\n"),
            "mesh:1: expected nodes in x, y and z, found '*Node, System=C'. Give the nodes in a "
            "table: node [1], x [m], y [m], z [m]. CalculiX ignores SYSTEM: for its matrices "
            "remove it.");
  for (const char* keyword : {"*NMAP", "*NCOPY", "*NGEN", "*NFILL"}) {
    EXPECT_NE(fault(keyword + std::string("\n1, 2, 1\n")).find("in global coordinates"),
              std::string::npos)
        << keyword;
  }
  EXPECT_NE(fault("*INSTANCE, NAME=A, PART=B\n1, 0, 0\n").find("an *INSTANCE that is moved"),
            std::string::npos);
  EXPECT_EQ(
      fault("*HEADING\nnothing\n"),
      "mesh: expected nodes: *NODE of CalculiX, datasets 15 or 2411, or a table node, x, y, z, "
      "found none");
  EXPECT_EQ(fault("node [1],x [m],y [m],z [m]\n1.5,0,0,0\n"),
            "mesh:2:1: expected the number of a node in column 1 'node [1]', found '1.5'");
}

// As gmsh 4.8 writes physical groups with "Save groups of nodes": nodes (7) and elements (8).
TEST(MeshFile, TakesGroupsOfUniversalFilesForSets) {
  const auto number = [](int n) { return fmt::format("{:10}", n); };
  const auto line = [&](const std::vector<int>& numbers) {
    std::string text;
    for (const int n : numbers) text += number(n);
    return text + "\n";
  };
  const std::string node = line({1, 1, 1, 11}) + fmt::format("{:25}{:25}{:25}\n", 0.5, 0.0, 0.0);
  const std::string text =
      "    -1\n  2411\n" + node + "    -1\n    -1\n  2477\n" + line({1, 0, 0, 0, 0, 0, 0, 3}) +
      "fix\n" + line({7, 9, 0, 0, 8, 4, 0, 0}) + line({7, 1, 0, 0}) +
      line({2, 0, 0, 0, 0, 0, 0, 1}) + "bar\n" + line({8, 4, 0, 0}) + "    -1\n";
  const MeshFile mesh = mesh_of(text);
  EXPECT_EQ(mesh.nodes.size(), 1U);
  ASSERT_EQ(mesh.sets.size(), 1U) << "one has nodes";
  EXPECT_EQ(mesh.sets[0].name, "fix");
  EXPECT_EQ(mesh.sets[0].nodes, (Nodes{1, 9}));
}

TEST(MeshFileFault, NamesAMeshThatIsNotRead) {
  const auto fault = [](const std::string& text) {
    return message_of<FormatError>([&] { (void)mesh_of(text); });
  };
  EXPECT_NE(fault("$MeshFormat\n4.1 0 8\n").find("found a mesh of gmsh. In gmsh save it as .inp"),
            std::string::npos);
  EXPECT_NE(fault("# vtk DataFile Version 2.0\nbar\nASCII\n").find("found a mesh of VTK"),
            std::string::npos);
  EXPECT_NE(fault("GRID    1       0       0.00E+00\n").find("found bulk data of Nastran"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::mesh_file_test
