// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/structure_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_tables.hpp"
#include "microslip/documents/structure/structure_places.hpp"
#include "microslip/documents/structure/tested_structure_table.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/matrices/abaqus_matrices.hpp"
#include "microslip/io/matrices/calculix_matrices.hpp"
#include "microslip/io/matrices/degree_entries.hpp"
#include "microslip/io/matrices/dmig_matrices.hpp"
#include "microslip/io/open/matrix_file.hpp"
#include "microslip/io/open/mesh_file.hpp"
#include "microslip/structure/entry_rounding.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestStructureFile = std::size_t{16} << 20U;
constexpr std::string_view kAttachmentKey = "attachment";

/// Units of the matrices of a file.
struct MatrixUnits {
  double length = 1.0;  ///< m
  double force = 1.0;   ///< N
};

bool turns(const DegreeOfFreedom& degree) { return degree.direction >= NodalDirection::kTurnX; }

/// Energy is force times length; a rotation has no unit. Where the rows have no degrees of freedom,
/// all are translations.
void convert(SymmetricEntries& matrix, const std::vector<DegreeOfFreedom>& degrees,
             const MatrixUnits& units) {
  if (units.length == 1.0 && units.force == 1.0) return;
  const auto scale = [&](std::int32_t row) {
    const auto i = static_cast<std::size_t>(row);
    return i < degrees.size() && turns(degrees[i]) ? 1.0 : units.length;
  };
  const double energy = units.force * units.length;
  for (std::size_t i = 0; i < matrix.value.size(); ++i) {
    matrix.value[i] *= energy / (scale(matrix.row[i]) * scale(matrix.column[i]));
  }
}

/// With matrices that name the degrees of freedom of their entries themselves.
void refuse_degrees(const TomlTable& table, std::string_view what, std::string_view names) {
  if (!table.has("degrees_of_freedom")) return;
  throw FormatError(table.place("degrees_of_freedom"), fmt::format("no such key with {}", what),
                    fmt::format("it: they name {} themselves", names));
}

StructuralMatrices read_matrix_files(const TomlTable& table, std::string_view file) {
  if (table.has("calculix")) {
    for (const std::string_view key : {"stiffness", "mass", "degrees_of_freedom"}) {
      if (!table.has(key)) continue;
      throw FormatError(table.place(key), "calculix, or stiffness and mass", "both");
    }
    const std::string job = path_beside(table, "calculix", "a job of CalculiX", file);
    return read_named(table, "calculix", job, read_calculix_matrices);
  }
  StructuralMatrices matrices;
  const std::string stiffness = path_beside(table, "stiffness", "a matrix", file);
  const std::string mass = path_beside(table, "mass", "a matrix", file);
  if (read_named(table, "stiffness", stiffness, is_dmig_file)) {
    refuse_degrees(table, "DMIG entries", "points and components");
    return read_named(table, "mass", mass,
                      [&](const std::string& its) { return read_dmig_matrices(stiffness, its); });
  }
  const bool of_abaqus = read_named(table, "stiffness", stiffness, is_abaqus_matrix_file);
  if (of_abaqus != read_named(table, "mass", mass, is_abaqus_matrix_file)) {
    throw InputError(table.name("mass"), in_quotes(mass),
                     fmt::format("must be {}, as the stiffness is",
                                 of_abaqus ? "a matrix of Abaqus" : "of another format"),
                     "The entries of one name degrees of freedom, those of the other rows.");
  }
  if (of_abaqus) {
    for (const auto& [key, path] : {std::pair{"stiffness", stiffness}, std::pair{"mass", mass}}) {
      const std::string variable = part_of_file(path).variable;
      if (variable.empty()) continue;
      throw InputError(table.name(key), in_quotes(":" + variable),
                       "must not follow a file of Abaqus, which has one matrix");
    }
    refuse_degrees(table, "matrices of Abaqus", "nodes and degrees of freedom");
    return read_named(table, "mass", mass,
                      [&](const std::string& its) { return read_abaqus_matrices(stiffness, its); });
  }
  matrices.stiffness = read_named(table, "stiffness", stiffness, read_matrix_file);
  matrices.mass = read_named(table, "mass", mass, read_matrix_file);
  if (table.has("degrees_of_freedom")) {
    const std::string degrees = path_beside(table, "degrees_of_freedom", "a file", file);
    matrices.degrees = read_named(table, "degrees_of_freedom", degrees, read_degrees);
  }
  return matrices;
}

/// Rotations that CalculiX numbers 1 to 3.
void name_rotations(const MeshFile& mesh, std::vector<DegreeOfFreedom>& degrees) {
  std::set<std::int64_t> others;  // have rotations beside
  for (const DegreeOfFreedom& degree : degrees) {
    if (turns(degree)) others.insert(degree.node);
  }
  constexpr auto kTurns = static_cast<std::uint8_t>(NodalDirection::kTurnX);
  for (DegreeOfFreedom& degree : degrees) {
    if (!std::ranges::binary_search(mesh.rotation_nodes, degree.node)) continue;
    if (others.contains(degree.node)) continue;
    degree.direction =
        static_cast<NodalDirection>(static_cast<std::uint8_t>(degree.direction) + kTurns);
  }
}

/// Nodes of rows that no element has; where the mesh has no elements, that are none of its nodes.
std::vector<std::int64_t> without_element(const MeshFile& mesh,
                                          const std::vector<DegreeOfFreedom>& degrees) {
  std::vector<std::int64_t> known = mesh.element_nodes;
  if (known.empty()) {
    for (const MeshNode& node : mesh.nodes) known.push_back(node.number);
    std::ranges::sort(known);
  }
  std::set<std::int64_t> unknown;
  if (known.empty()) return {};
  for (const DegreeOfFreedom& degree : degrees) {
    if (!std::ranges::binary_search(known, degree.node)) unknown.insert(degree.node);
  }
  return {unknown.begin(), unknown.end()};
}

/// CalculiX has of axisymmetric elements a wedge of 2°; forces on it are those on the whole ring.
void complete_ring(const TomlTable& table, const MeshFile& mesh, StructureFile& read) {
  if (!mesh.axisymmetric || !table.has("calculix")) return;
  if (mesh.beside_axisymmetric) {
    throw InputError(table.name("calculix"), InputState{"axisymmetric in part"},
                     "must have axisymmetric elements alone, or none: of CAX… its matrices have a "
                     "wedge of 2 degrees, 1/180 of the ring, of other elements all",
                     "Take solid elements for all.");
  }
  constexpr double kWedges = 180.0;
  StructuralMatrices& matrices = read.structure.matrices;
  for (SymmetricEntries* each : {&matrices.stiffness, &matrices.mass}) {
    for (double& value : each->value) value *= kWedges;
  }
  read.warnings.push_back(
      {"axisymmetric",
       "the matrices of CalculiX have a wedge of 2 degrees of axisymmetric elements. They were "
       "multiplied by 180: masses, stiffnesses and forces are those of the whole ring, and modes "
       "with waves around it are not among them."});
}

/// What is in a list twice is added, as the format has it; by mistake it may be there twice.
void warn_of_repeated(const TomlTable& table, const StructuralMatrices& matrices,
                      std::vector<Warning>& warnings) {
  for (const auto& [key, matrix] :
       {std::pair{"stiffness", &matrices.stiffness}, std::pair{"mass", &matrices.mass}}) {
    if (matrix->repeated == 0) continue;
    warnings.push_back(
        {"entries_added",
         fmt::format("{}: entries at the place of another one: {}; those of one place are "
                     "added, as programs for sparse matrices do. Where that is not meant, "
                     "leave out what is there twice",
                     table.has(key) ? table.name(key) : std::string(key), matrix->repeated)});
  }
}

/// A list of lumped masses that lacks its last lines is well formed. An entry 0 on the diagonal
/// says that nothing is missing.
void warn_of_massless(const TomlTable& table, const StructuralMatrices& matrices,
                      std::vector<Warning>& warnings) {
  if (!matrices.mass.is_open_ended || matrices.degrees.empty()) return;
  std::vector<bool> has_mass(matrices.degrees.size(), false);
  for (std::size_t i = 0; i < matrices.mass.value.size(); ++i) {
    const std::int32_t row = matrices.mass.row[i];
    const std::int32_t column = matrices.mass.column[i];
    if (matrices.mass.value[i] == 0.0 && row != column) continue;
    has_mass[static_cast<std::size_t>(row)] = true;
    has_mass[static_cast<std::size_t>(column)] = true;
  }
  std::vector<std::string> lack;
  for (std::size_t row = 0; row < matrices.degrees.size(); ++row) {
    const DegreeOfFreedom& degree = matrices.degrees[row];
    if (!has_mass[row] && !turns(degree) && degree.node > 0) lack.push_back(degree_text(degree));
  }
  if (lack.empty()) return;
  warnings.push_back(
      {"mass_missing",
       fmt::format("{}: {}{} without mass, taken to be massless. Where that is not meant, the file "
                   "may lack its last lines",
                   table.name("mass"), lack.front(),
                   lack.size() == 1
                       ? std::string(" is")
                       : fmt::format(" and {} more displacements are", lack.size() - 1))});
}

StructuralMatrices read_matrices(const TomlTable& table, std::string_view file,
                                 const MatrixUnits& units, const MeshFile& mesh) {
  StructuralMatrices matrices = read_matrix_files(table, file);
  if (matrices.mass.size != matrices.stiffness.size) {
    throw InputError(table.name(table.has("mass") ? "mass" : "calculix"),
                     fmt::format("{} rows", matrices.mass.size),
                     fmt::format("must have {}, as the stiffness matrix", matrices.stiffness.size));
  }
  if (!matrices.degrees.empty() && matrices.degrees.size() != matrices.stiffness.size) {
    throw InputError(
        table.name("degrees_of_freedom"), fmt::format("{} lines", matrices.degrees.size()),
        fmt::format("must be {}, one per row of the matrices", matrices.stiffness.size));
  }
  if (table.has("calculix")) name_rotations(mesh, matrices.degrees);
  matrices.stiffness_rounding = entry_rounding(matrices.stiffness);
  matrices.possible_rounding = possible_entry_rounding(matrices.stiffness);
  convert(matrices.stiffness, matrices.degrees, units);
  convert(matrices.mass, matrices.degrees, units);
  return matrices;
}

/// Keeps them rising, each once.
void add_nodes(const std::vector<std::int64_t>& from, std::vector<std::int64_t>& to) {
  std::vector<std::int64_t> all;
  std::ranges::set_union(from, to, std::back_inserter(all));
  to = std::move(all);
}

MeshFile read_nodes(const TomlTable& top, std::string_view file, double length_unit) {
  MeshFile all;
  if (!top.has("nodes")) return all;
  const TomlTable table = top.table("nodes");
  table.allow_only({"file"});
  std::vector<std::string> names;
  if (table.is_text("file")) {
    names.push_back(table.text("file"));
  } else {
    names = table.texts("file");
  }
  for (const std::string& name : names) {
    const std::string path = file_beside(std::string(file), name);
    MeshFile mesh = read_named(table, "file", path,
                               [&](const std::string& its) { return read_mesh(its, length_unit); });
    all.nodes.insert(all.nodes.end(), mesh.nodes.begin(), mesh.nodes.end());
    for (NodeSet& set : mesh.sets) all.sets.push_back(std::move(set));
    add_nodes(mesh.element_nodes, all.element_nodes);
    add_nodes(mesh.rotation_nodes, all.rotation_nodes);
    all.axisymmetric = all.axisymmetric || mesh.axisymmetric;
    all.beside_axisymmetric = all.beside_axisymmetric || mesh.beside_axisymmetric;
    for (Warning& warning : mesh.warnings) all.warnings.push_back(std::move(warning));
    if (mesh.own_unit != 1.0) all.own_unit = mesh.own_unit;
  }
  return all;
}

/// The keys of a place, and others. A test has no rows, and nothing that a spider could bind.
std::vector<std::string_view> place_keys(bool of_test, std::vector<std::string_view> others = {}) {
  others.insert(others.end(), {kNodeKey, kNodesKey, kSetKey, kAtKey});
  if (!of_test) others.insert(others.end(), {kRowKey, kSpiderKey});
  return others;
}

MeshPoint read_mesh_point(const TomlTable& table, const NodeSets& sets, bool of_test,
                          const std::vector<MeshPoint>& before) {
  table.allow_only(place_keys(of_test, {"name", "direction"}));
  MeshPoint point{.name = table.text("name"), .place = {.name = {}, .nodes = {}}};
  check_name(table, point.name, before, "point");
  point.place = read_place(table, sets);
  point.direction = read_direction(table, !point.place.row);
  return point;
}

MeshPlace read_side(const TomlTable& joint, std::string_view key, const NodeSets& sets,
                    bool of_test) {
  const TomlTable side = joint.table(key);
  side.allow_only(place_keys(of_test));
  return read_place(side, sets);
}

MeshJoint read_mesh_joint(const TomlTable& table, const std::string& name, double stiffness,
                          const NodeSets& sets, bool of_test) {
  MeshJoint joint{
      .name = name, .to = read_side(table, "to", sets, of_test), .stiffness = stiffness};
  if (table.has("from")) joint.from = read_side(table, "from", sets, of_test);
  const bool rows = joint.to.row && (!joint.from || joint.from->row);
  joint.direction = read_direction(table, !rows);
  return joint;
}

/// @return their names.
std::vector<std::string> read_bases(const TomlTable& top, MeshedStructure& structure) {
  std::vector<std::string> names;
  if (!top.has("base")) return names;
  for (const TomlTable& table : top.tables("base")) {
    table.allow_only({"name", "direction", kRowsKey});
    MeshBase base{.name = table.text("name")};
    check_name(table, base.name, structure.points, "point");
    check_name(table, base.name, structure.bases, "base");
    if (table.has(kRowsKey)) base.rows = read_rows(table);
    base.direction = read_direction(table, base.rows.empty());
    names.push_back(base.name);
    structure.bases.push_back(std::move(base));
  }
  return names;
}

void read_joints(const TomlTable& top, std::string_view file, const NodeSets& sets,
                 StructureFile& read) {
  if (!top.has("joint")) return;
  const std::vector<TomlTable> tables = top.tables("joint");
  for (const TomlTable& table : tables) {
    table.allow_only({"name", "to", "from", "direction", "file", kStiffnessKey, kSamplesKey,
                      kNormalLoadSpreadKey, kLinearDampingKey});
    const std::string name = joint_name(table, read.sources.size(), tables.size());
    check_name(table, name, read.structure.joints, "joint");
    read.sources.push_back(read_joint_source(table, file, JointsToFind::kAllowed));
    const double stiffness = read.sources.back().joint.stiffness();
    read.structure.joints.push_back(
        read_mesh_joint(table, name, stiffness, sets, read.test.has_value()));
  }
}

void read_mode_range(const TomlTable& modes, StructureFile& read) {
  const bool limited = modes.has("count") || modes.has("up_to_Hz");
  if (modes.has("count") == modes.has("up_to_Hz") && (limited || !read.test)) {
    throw FormatError(modes.place("up_to_Hz"), "in modes one of the keys count and up_to_Hz",
                      limited ? "both" : "neither");
  }
  if (modes.has("count")) {
    read.count = modes.whole("count");
    if (*read.count == 0 || *read.count > kMostModes) {
      throw InputError(modes.name("count"), static_cast<double>(*read.count),
                       fmt::format("must be from 1 to {}", kMostModes));
    }
  }
  if (modes.has("up_to_Hz")) {
    read.highest_frequency = modes.number("up_to_Hz");
    if (!(*read.highest_frequency > 0.0 && *read.highest_frequency <= kHighestFrequency)) {
      throw InputError(modes.name("up_to_Hz"), *read.highest_frequency,
                       fmt::format("must be above 0, to {:g}", kHighestFrequency));
    }
  }
}

void read_joints_in_modes(const TomlTable& modes, StructureFile& read) {
  const std::string joints = modes.text("joints");
  if (joints != "free" && joints != "stuck") {
    throw InputError(modes.name("joints"), in_quotes(joints), "must be free or stuck");
  }
  read.joints = joints == "stuck" ? JointsInModes::kStuck : JointsInModes::kFree;
}

void read_modal_damping(const TomlTable& modes, StructureFile& read) {
  ModalDamping damping = read_damping(modes, "modes", "count");
  if (damping.loss_factor.empty()) {
    throw wrong_count(modes, damping.key, 0, "must have at least one");
  }
  read.loss_factor = std::move(damping.loss_factor);
  read.law = damping.law;
}

void read_modes(const TomlTable& modes, StructureFile& read) {
  modes.allow_only({"count", "up_to_Hz", "joints", kAttachmentKey, "loss_factor", "damping_ratio"});
  read_mode_range(modes, read);
  if (modes.has("joints")) read_joints_in_modes(modes, read);
  if (modes.has(kAttachmentKey)) read.attachment = modes.boolean(kAttachmentKey);
  read_modal_damping(modes, read);
}

/// Keys that a test itself determines may be left out, but not whether joints were stuck in it.
void read_tested_modes(const TomlTable& top, StructureFile& read) {
  const bool joints = top.has("joint");
  const std::string rule = "free or stuck: state of the joints in the test";
  if (!top.has("modes")) {
    if (!joints) return;
    throw FormatError(top.place("joint"), "in modes the key joints, " + rule, "no [modes]");
  }
  const TomlTable modes = top.table("modes");
  if (modes.has(kAttachmentKey)) {
    throw FormatError(modes.place(kAttachmentKey), "attachment with [matrices]", "a test",
                      "Leave it out: static shapes need matrices.");
  }
  modes.allow_only({"count", "up_to_Hz", "joints", "loss_factor", "damping_ratio"});
  if (modes.has("count") && !read.test->start_frequency.empty()) {
    throw FormatError(modes.place("count"), "count, or start_frequency_Hz of each mode", "both",
                      "Leave it out.");
  }
  read_mode_range(modes, read);
  if (modes.has("joints") != joints) {
    throw FormatError(modes.place("joints"), joints ? "the key joints, " + rule : "[[joint]]",
                      joints ? "none" : "joints without one");
  }
  if (joints) read_joints_in_modes(modes, read);
  if (modes.has("loss_factor") || modes.has("damping_ratio")) read_modal_damping(modes, read);
}

void read_support_tables(const TomlTable& top, const NodeSets& sets, StructureFile& read) {
  if (!top.has("support")) return;
  for (const TomlTable& table : top.tables("support")) {
    read.structure.supports.push_back(read_support(table, sets));
  }
}

/// The tables that name places.
void read_places(const TomlTable& top, std::string_view file, const NodeSets& sets,
                 StructureFile& read) {
  std::vector<std::string> names;
  for (const TomlTable& table : top.tables("point")) {
    read.structure.points.push_back(
        read_mesh_point(table, sets, read.test.has_value(), read.structure.points));
    names.push_back(read.structure.points.back().name);
  }
  read_joints(top, file, sets, read);
  read.driven = read_driven_points(top, names, read_bases(top, read.structure));
}

/// Frequencies do not depend on the unit of length: nothing else shows that it is missing.
void warn_of_units(const TomlTable& matrices, const MeshFile& mesh,
                   std::vector<Warning>& warnings) {
  if (mesh.own_unit == 1.0 || matrices.has("length_unit")) return;
  warnings.push_back(
      {"matrix_units_assumed",
       fmt::format("{} is missing, and the matrices are taken as of m and N, but the nodes are in "
                   "units of {:g} m. If the matrices are so too, give length_unit and force_unit; "
                   "if they are not, length_unit = \"m\"",
                   matrices.name("length_unit"), mesh.own_unit)});
}

StructureFile read_with_matrices(const TomlTable& top, std::string_view file) {
  top.allow_only({"schema", "matrices", "test", "nodes", "set", "support", "point", "joint",
                  "modes", "base", "excitation", "static_load", "response", "accelerometer"});
  StructureFile read;
  const TomlTable matrices = top.table("matrices");
  matrices.allow_only(
      {"stiffness", "mass", "degrees_of_freedom", "calculix", "length_unit", "force_unit"});
  const MatrixUnits units{.length = read_unit_factor(matrices, "length_unit", kLength),
                          .force = read_unit_factor(matrices, "force_unit", kForce)};
  // The short tables first: a slip in them need not wait for millions of entries.
  read_modes(top.table("modes"), read);
  MeshFile mesh = read_nodes(top, file, units.length);
  const NodeSets sets(top, mesh);
  read_support_tables(top, sets, read);
  read_places(top, file, sets, read);
  read.warnings = std::move(mesh.warnings);
  warn_of_units(matrices, mesh, read.warnings);
  read.structure.matrices = read_matrices(matrices, file, units, mesh);
  warn_of_repeated(matrices, read.structure.matrices, read.warnings);
  warn_of_massless(matrices, read.structure.matrices, read.warnings);
  complete_ring(matrices, mesh, read);
  read.structure.nodes_without_element = without_element(mesh, read.structure.matrices.degrees);
  read.structure.nodes = std::move(mesh.nodes);
  return read;
}

StructureFile read_with_test(const TomlTable& top, std::string_view file) {
  top.allow_only({"schema", "test", "nodes", "set", "point", "joint", "modes", "excitation",
                  "static_load", "response", "accelerometer"});
  StructureFile read;
  read.test = read_tested_structure(top.table("test"), file);
  read.attachment = false;
  read_tested_modes(top, read);
  MeshFile mesh = read_nodes(top, file, read.test->units ? read.test->units->length : 1.0);
  read_places(top, file, NodeSets(top, mesh), read);
  read.structure.nodes = std::move(mesh.nodes);
  return read;
}

StructureFile read_tables(const TomlTable& top, std::string_view file) {
  if (top.has("test") && top.has("matrices")) {
    throw FormatError(top.place("test"), "one of the tables matrices and test", "both");
  }
  return top.has("test") ? read_with_test(top, file) : read_with_matrices(top, file);
}

}  // namespace

StructureFile parse_structure(std::string_view text, std::string_view file) {
  const toml::table content = parse_toml(text, file);
  const TomlTable top(content, file);
  check_schema(top.place("schema"), top.text("schema"), kStructureKind, "a structure");
  return read_tables(top, file);
}

StructureFile read_structure_file(const std::string& path) {
  return parse_structure(read_text(path, kLargestStructureFile), input_name(path));
}

}  // namespace microslip
