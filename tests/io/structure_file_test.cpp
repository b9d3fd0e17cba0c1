// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/structure_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/replaced.hpp"

namespace microslip::structure_file_test {
namespace {

using test::message_of;

/// All keys there are but those that exclude each other; lines are those of the messages below.
const std::string kText =
    "schema = \"microslip.structure/1\"\n"
    "[matrices]\n"
    "stiffness = \"k.mtx\"\n"
    "mass = \"m.mtx\"\n"
    "degrees_of_freedom = \"rows.dof\"\n"
    "length_unit = \"mm\"\n"
    "force_unit = \"kN\"\n"
    "[nodes]\n"
    "file = [\"nodes.csv\", \"sets.inp\"]\n"
    "[[set]]\n"
    "name = \"low\"\n"
    "box = {z_m = [0, 0.1]}\n"
    "[[set]]\n"
    "name = \"pair\"\n"
    "nodes = [1, 2]\n"
    "[[support]]\n"
    "set = \"top\"\n"
    "directions = [\"x\", \"rz\"]\n"
    "[[support]]\n"
    "rows = [3]\n"
    "[[point]]\n"
    "name = \"tip\"\n"
    "node = 2\n"
    "direction = \"-z\"\n"
    "[[point]]\n"
    "name = \"first\"\n"
    "row = 1\n"
    "[[joint]]\n"
    "name = \"bolt\"\n"
    "from = {set = \"pair\", spider = \"rigid\", at_m = [0, 0, 0.05]}\n"
    "to = {node = 1}\n"
    "direction = [3, 0, 4]\n"
    "file = \"joint.json\"\n"
    "linear_damping_J_per_m2 = 12\n"
    "[[joint]]\n"
    "name = \"pin\"\n"
    "to = {nodes = [1, 2]}\n"
    "direction = \"ry\"\n"
    "stiffness_N_per_m = 2e5\n"
    "[modes]\n"
    "count = 2\n"
    "joints = \"stuck\"\n"
    "attachment = false\n"
    "loss_factor = [0.003, 0.002]\n"
    "[excitation]\n"
    "point = \"tip\"\n"
    "channel = \"force\"\n"
    "[response]\n"
    "point = \"first\"\n"
    "[[accelerometer]]\n"
    "channel = \"acc\"\n"
    "point = \"tip\"\n";

class StructureFolder {
 public:
  StructureFolder() {
    test::put(folder_.file("k.mtx"),
              "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 5\n2 2 6\n3 3 7\n");
    test::put(folder_.file("m.mtx"),
              "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 1\n2 2 2\n3 3 3\n");
    test::put(folder_.file("rows.dof"), "1 z\n2 z\n2 rx\n");
    test::put(folder_.file("nodes.csv"), "node [1],x [m],y [m],z [m]\n1,0,0,0\n2,0,0,0.1\n");
    test::put(folder_.file("sets.inp"), "*NSET,NSET=TOP\n2\n");
    test::put(folder_.file("joint.json"),
              R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e5, "density": []})");
  }
  void put(const std::string& name, const std::string& text) const {
    test::put(folder_.file(name), text);
  }
  [[nodiscard]] StructureFile parse(const std::string& text = kText) const {
    return parse_structure(text, folder_.file("s.toml"));
  }
  /// The message on the text with one piece replaced, without the folder.
  [[nodiscard]] std::string fault(const std::string& from, const std::string& to) const {
    const std::string message =
        message_of<Error>([&] { return parse(test::replaced(kText, from, to)); });
    const std::size_t name = message.find("s.toml");
    return name == std::string::npos ? message : message.substr(name);
  }

 private:
  test::TemporaryFolder folder_;
};

TEST(StructureFile, IsReadWhole) {
  const StructureFolder folder;
  const StructureFile file = folder.parse();
  const MeshedStructure& structure = file.structure;
  ASSERT_EQ(structure.matrices.degrees.size(), 3U);
  EXPECT_EQ(structure.nodes.size(), 2U);
  ASSERT_EQ(structure.supports.size(), 2U);
  EXPECT_EQ(structure.supports[0].nodes.size(), 1U);
  EXPECT_EQ(structure.supports[0].held,
            (std::array<bool, 6>{true, false, false, false, false, true}));
  EXPECT_EQ(structure.supports[1].rows, (std::vector<std::size_t>{2}));
  ASSERT_EQ(structure.points.size(), 2U);
  EXPECT_EQ(structure.points[0].direction.axis, (Vector3{0.0, 0.0, -1.0}));
  EXPECT_EQ(structure.points[1].place.row, std::size_t{0});
  ASSERT_EQ(structure.joints.size(), 2U);
  const MeshJoint& bolt = structure.joints[0];
  EXPECT_EQ(bolt.stiffness, 1e5);
  EXPECT_EQ(bolt.direction.axis, (Vector3{0.6, 0.0, 0.8}));
  ASSERT_TRUE(bolt.from.has_value());
  EXPECT_EQ(bolt.from->spider, Spider::kRigid);
  EXPECT_EQ(bolt.from->at, (Vector3{0.0, 0.0, 0.05}));
  EXPECT_TRUE(structure.joints[1].direction.turns);
  EXPECT_EQ(structure.joints[1].stiffness, 2e5);
  EXPECT_EQ(file.sources[0].linear_damping, 12.0);
  EXPECT_TRUE(file.sources[1].file.empty());
  EXPECT_EQ(file.count, std::size_t{2});
  EXPECT_EQ(file.joints, JointsInModes::kStuck);
  EXPECT_FALSE(file.attachment);
  EXPECT_EQ(file.loss_factor, (std::vector<double>{0.003, 0.002}));
  EXPECT_EQ(file.law, DampingLaw::kHysteretic);
  EXPECT_EQ(file.driven.response, "first");
  EXPECT_EQ(file.driven.channels[0], "force");
  EXPECT_EQ(file.driven.accelerometers.size(), 1U);
}

// kN and mm: 1 kN/mm = 1e6 N/m; of a rotation 1 kN mm = 1 N m; 1 kN s²/mm = 1e6 kg.
TEST(StructureFile, MatricesBecomeSI) {
  const StructureFile file = StructureFolder().parse();
  const std::vector<double>& stiffness = file.structure.matrices.stiffness.value;
  EXPECT_DOUBLE_EQ(stiffness[0], 5e6);
  EXPECT_DOUBLE_EQ(stiffness[2], 7.0);
  EXPECT_DOUBLE_EQ(file.structure.matrices.mass.value[1], 2e6);
}

/// A job of CalculiX in mm and N: node 1 moves along x, nodes 10 and 30 as the input says.
std::string calculix_job(const test::TemporaryFolder& folder, const std::string& input) {
  test::put(folder.file("job.dof"), "1.1\n10.1\n30.1\n");
  test::put(folder.file("job.sti"), "1 1 5.\n2 2 6.\n3 3 7.\n");
  test::put(folder.file("job.mas"), "1 1 1.\n2 2 2.\n3 3 3.\n");
  test::put(folder.file("job.inp"), input);
  return "schema = \"microslip.structure/1\"\n[matrices]\ncalculix = \"job\"\nlength_unit = "
         "\"mm\"\nforce_unit = \"N\"\n[nodes]\nfile = \"job.inp\"\n[[point]]\nname = \"tip\"\n"
         "node = 1\ndirection = \"x\"\n[modes]\ncount = 2\nloss_factor = [0.0]\n[excitation]\n"
         "point = \"tip\"\n";
}

// 6 N mm/rad of a rotation are 6e-3 N m, where 6 N/mm of a translation are 6000 N/m.
TEST(StructureFile, RotationsThatCalculixNumbersFromOneAreRotations) {
  const test::TemporaryFolder folder;
  const std::string text = calculix_job(
      folder,
      "*NODE\n1,0,0,0\n10,0,0,0\n*ELEMENT,TYPE=MASS\n1,1\n*RIGID BODY, NSET=F, ROT NODE=10\n");
  const StructureFile file = parse_structure(text, folder.file("s.toml"));
  const StructuralMatrices& matrices = file.structure.matrices;
  EXPECT_EQ(matrices.degrees[0].direction, NodalDirection::kX);
  EXPECT_EQ(matrices.degrees[1].direction, NodalDirection::kTurnX);
  EXPECT_DOUBLE_EQ(matrices.stiffness.value[0], 5e3);
  EXPECT_DOUBLE_EQ(matrices.stiffness.value[1], 6e-3);
  EXPECT_DOUBLE_EQ(matrices.mass.value[1], 2e-3);
  // Node 30 is in no input, as inner nodes of elements are.
  EXPECT_EQ(file.structure.nodes_without_element, (std::vector<std::int64_t>{10, 30}));
  EXPECT_TRUE(file.warnings.empty());
}

// CalculiX expands axisymmetric elements to a wedge of 2 degrees.
TEST(StructureFile, AWedgeOfCalculixIsTheRing) {
  const test::TemporaryFolder folder;
  const std::string ring = "*NODE\n1,1,0\n*ELEMENT,TYPE=CAX8R,ELSET=e\n1,1,10,30\n";
  const StructureFile file = parse_structure(calculix_job(folder, ring), folder.file("s.toml"));
  EXPECT_DOUBLE_EQ(file.structure.matrices.stiffness.value[0], 180.0 * 5e3);
  EXPECT_DOUBLE_EQ(file.structure.matrices.mass.value[2], 180.0 * 3e3);
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_EQ(file.warnings[0].code, "axisymmetric");
  const std::string both = calculix_job(folder, ring + "*ELEMENT,TYPE=SPRING1\n2,1\n");
  EXPECT_NE(message_of<InputError>([&] {
              return parse_structure(both, folder.file("s.toml"));
            }).find("must have axisymmetric elements alone, or none"),
            std::string::npos);
}

// Nothing else shows that matrices in inches and pounds are taken for those of SI: frequencies are
// right.
TEST(StructureFile, AsksForTheUnitOfMatricesBesideNodesOfAnother) {
  const StructureFolder folder;
  EXPECT_TRUE(folder.parse().warnings.empty());
  folder.put("nodes.csv", "node [1],x [in],y [in],z [in]\n1,0,0,0\n2,0,0,0.1\n");
  EXPECT_TRUE(folder.parse().warnings.empty()) << "length_unit is given";
  const StructureFile file =
      folder.parse(test::replaced(kText, "length_unit = \"mm\"\nforce_unit = \"kN\"\n", ""));
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_EQ(file.warnings[0].code, "matrix_units_assumed");
}

// A file that lacks its last lines may be well formed; entries of one place are added.
TEST(StructureFile, WarnsOfMassesThatAreMissingAndEntriesThatAreThereTwice) {
  const StructureFolder folder;
  folder.put(
      "k.mtx",
      "%%MatrixMarket matrix coordinate real symmetric\n3 3 4\n1 1 5\n2 2 6\n3 3 3\n3 3 4\n");
  folder.put("m.mtx", "1 1 1\n3 3 3\n");
  const StructureFile file = folder.parse();
  ASSERT_EQ(file.warnings.size(), 2U);
  const auto warning = [&](std::size_t i) {
    return file.warnings[i].text.substr(file.warnings[i].text.find("matrices."));
  };
  EXPECT_EQ(warning(0),
            "matrices.stiffness: entries at the place of another one: 1; those of one place are "
            "added, as programs for sparse matrices do. Where that is not meant, leave "
            "out what is there twice");
  EXPECT_EQ(warning(1),
            "matrices.mass: z of 2 is without mass, taken to be massless. Where that is not meant, "
            "the file may lack its last lines");
  folder.put("m.mtx", "3 3 3\n");
  EXPECT_NE(folder.parse().warnings.at(1).text.find("z of 1 and 1 more displacements are without"),
            std::string::npos);
  // Such a file lacks nothing: it has an entry 0, or says how many entries there are.
  for (const char* whole :
       {"1 1 1\n2 2 0\n3 3 3\n", "3 3 2\n1 1 1\n3 3 3\n",
        "%%MatrixMarket matrix coordinate real symmetric\n3 3 2\n1 1 1\n3 3 3\n"}) {
    folder.put("m.mtx", whole);
    EXPECT_EQ(folder.parse().warnings.size(), 1U) << whole;
  }
}

TEST(StructureFile, DampingRatiosAreViscous) {
  const StructureFolder folder;
  const StructureFile file = folder.parse(
      test::replaced(kText, "loss_factor = [0.003, 0.002]", "damping_ratio = [0.003]"));
  EXPECT_EQ(file.law, DampingLaw::kViscous);
  EXPECT_EQ(file.loss_factor, (std::vector<double>{0.006}));
}

TEST(StructureFileFault, NamesThePlace) {
  const StructureFolder folder;
  const auto expect = [&](const std::string& from, const std::string& to,
                          const std::string& message) {
    EXPECT_EQ(folder.fault(from, to), message);
  };
  expect("mass = \"m.mtx\"\n", "",
         "s.toml:2:1: expected the key 'mass' in matrices, found the keys 'degrees_of_freedom, "
         "force_unit, length_unit, stiffness'");
  expect("mass = \"m.mtx\"\n", "mass = \"m.mtx\"\ncalculix = \"job\"\n",
         "s.toml:3:13: expected calculix, or stiffness and mass, found both");
  expect("length_unit = \"mm\"", "length_unit = \"kg\"",
         "s.toml:6:15: matrices.length_unit = 'kg'; must be a unit of length and is one of mass. "
         "Units "
         "that fit: m, mm, um (µm), nm, cm, in, ft, mil.");
  expect("set = \"top\"", "set = \"tap\"",
         "s.toml:17:7: support[0].set = 'tap'; must be a [[set]] of the file, or a set of the mesh "
         "of [nodes]. Did you mean 'TOP'?");
  expect("node = 2\n", "",
         "s.toml:21:1: expected one of the keys node, nodes, set, row, found none");
  expect("node = 2\n", "node = 2\nrow = 1\n",
         "s.toml:24:7: expected one of the keys node, nodes, set, row, found node and row");
  expect("node = 2\n", "node = 0\n",
         "s.toml:23:8: point[0].node = 0; must be the number of a node, 1 or more");
  expect(
      "direction = \"-z\"", "direction = \"up\"",
      "s.toml:24:13: point[0].direction = 'up'; must be x, y, z, rx, ry or rz, one of them with - "
      "before it, or a vector [x, y, z]");
  expect("direction = \"-z\"\n", "",
         "s.toml:21:1: expected the key 'direction' in point[0], found the keys 'name, node'");
  expect("row = 1\n", "row = 1\ndirection = \"x\"\n",
         "s.toml:28:13: expected a place with nodes, found rows, which define their own. Leave it "
         "out.");
  expect("row = 1\n", "row = 1.5\n",
         "s.toml:27:7: point[1].row = 1.5; must be a row of the matrices, counted from 1");
  expect("to = {node = 1}", "to = {node = 1, spider = \"rigid\"}",
         "s.toml:31:26: joint[0].to.spider = 'rigid'; needs two nodes or more, and would have no "
         "effect. Leave it out.");
  expect("nodes = [1, 2]\n", "nodes = [1, 2, 1]\n",
         "s.toml:15:16: set[1].nodes[2] = 1; must be given only once");
  expect(
      "{z_m = [0, 0.1]}", "{z_m = [0.2, 0.3]}",
      "s.toml:12:7: set[0].box = none of 2 nodes; must have at least one node. Its numbers are in "
      "m.");
  expect("name = \"pair\"", "name = \"top\"",
         "s.toml:14:8: set[1].name = 'top'; must be a text that no earlier set of the file or mesh "
         "has");
  expect("name = \"pin\"", "name = \"bolt\"",
         "s.toml:36:8: joint[1].name = 'bolt'; must differ from joint[0].name");
  expect("stiffness_N_per_m = 2e5\n", "",
         "s.toml:35:1: expected the key 'file' in joint[1], found the keys 'direction, name, to'");
  expect("count = 2\n", "",
         "s.toml:40:1: expected in modes one of the keys count and up_to_Hz, found neither");
  expect("count = 2\n", "count = 0\n", "s.toml:41:9: modes.count = 0; must be from 1 to 5000");
  expect("count = 2\n", "up_to_Hz = -1.0\n",
         "s.toml:41:12: modes.up_to_Hz = -1; must be above 0, to 1e+09");
  expect("joints = \"stuck\"", "joints = \"fixed\"",
         "s.toml:42:10: modes.joints = 'fixed'; must be free or stuck");
  expect("attachment = false", "attachment = 0",
         "s.toml:43:14: modes.attachment = 0; must be true or false");
  expect("loss_factor = [0.003, 0.002]", "loss_factor = []",
         "s.toml:44:15: modes.loss_factor = 0 values; must have at least one");
  expect("point = \"tip\"\nchannel", "point = \"tap\"\nchannel",
         "s.toml:46:9: excitation.point = 'tap'; must be the name of a point: 'tip, first'. Did "
         "you mean 'tip'?");
}

// A key of [test] that is for the other kind of file says so, and what for.
TEST(StructureFile, KeysOfATestThatChangeNothingAreRefused) {
  const auto refused = [](const std::string& keys) {
    const std::string text = "schema = \"microslip.structure/1\"\n[test]\n" + keys;
    return message_of<InputError>([&] { return parse_structure(text, "s.toml"); });
  };
  EXPECT_EQ(refused("shapes = \"s.unv\"\nband_Hz = [1.0, 2.0]\n"),
            "s.toml:4:11: test.band_Hz is given; has no effect with mode shapes: it applies to "
            "frequency responses, frfs. Leave it out.");
  EXPECT_EQ(refused("frfs = \"f.unv\"\nmodal_mass_kg = [1.0]\n"),
            "s.toml:4:17: test.modal_mass_kg is given; has no effect with frequency responses: it "
            "applies to mode shapes, shapes. Leave it out.");
}

}  // namespace
}  // namespace microslip::structure_file_test
