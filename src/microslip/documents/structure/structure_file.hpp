// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/structure/model_parts.hpp"
#include "microslip/documents/structure/tested_structure.hpp"
#include "microslip/structure/meshed_structure.hpp"
#include "microslip/structure/modal_model.hpp"

/// @file
/// STRUCTURE.toml, schema microslip.structure/1: matrices of a structure, and joints, supports and
/// points on it, of which modes are made. Paths are relative to its folder.
///
///     schema = "microslip.structure/1"
///     [matrices]     stiffness, mass: of read_matrix_file(); degrees_of_freedom: a file with a
///                    line per row, `node.direction`; or, in place of the three, calculix: the path
///                    of JOB.sti, JOB.mas and JOB.dof without the ending. length_unit, force_unit:
///                    of the matrices and of nodes in files without units; m and N without them
///     [test]         in place of [matrices]: shapes, a universal file with datasets 55 or 2414,
///                    and modal_mass_kg = [...]; or frfs, one with datasets 58 or a recording in
///                    CSV, MATLAB or HDF5, and drive, a table with node and direction, band_Hz =
///                    [from, to], start_frequency_Hz = [...], damping = "viscous" (default) or
///                    "hysteretic". length_unit, force_unit: where a universal file has no dataset
///                    164
///     [[test.response]]  of a recording: channel, node, direction; force: node and direction, that
///                    of drive without it; unit where the channel has none
///     [nodes]        file: one or an array of those that read_mesh() takes; optional
///     [[set]]        name, and nodes = […] or box = {x_m = […], y_m = […], z_m = […]}: from, to;
///                    beside the sets of [nodes]
///     [[support]]    a place, directions = ["x", "rz", …]; all without them
///     [[point]]      name, a place, direction
///     [[joint]]      name; to and from, tables with a place, without from against the ground;
///                    direction; file or stiffness_N_per_m and what else a model's joint has of its
///                    own: samples, normal_load_std, linear_damping_J_per_m2
///     [[base]]       name; direction, or rows = […] (from 1) that move by 1: the supports, and the
///                    structure with it, as a shaker table moves them; optional
///     [modes]        count or up_to_Hz; joints = "free" (default) or "stuck"; attachment (default
///                    true); loss_factor or damping_ratio: one per mode, later ones take the last
///                    With [test] all optional, but joints where there are any, and no attachment
///     [excitation], [[static_load]], [response], [[accelerometer]]: as in a model
///
/// A place is one of node, nodes = […], set, or row (of the matrices, from 1); of two nodes or more
/// spider = "average" (default) or "rigid"; at_m = [x, y, z]: where of their body, else its centre.
/// With [test] there is no row, spider, [[support]] or [[base]].
/// A direction is "x", "-z", "ry", …, or a vector [x, y, z] of any length.

namespace microslip {

/// Contents of a STRUCTURE.toml and of the files it names.
struct StructureFile {
  MeshedStructure structure;                     ///< with its matrices, where it has any
  std::optional<TestedStructure> test = {};      ///< in place of matrices
  std::optional<std::size_t> count = {};         ///< of modes
  std::optional<double> highest_frequency = {};  ///< of modes, Hz, in place of their count
  JointsInModes joints = JointsInModes::kFree;   ///< while they are computed
  bool attachment = true;  ///< whether modes get static attachments; of a test never
  /// η of the modes, 2ζ where the damping is viscous; later ones take the last. One at least,
  /// but of a test, whose own damping it stands in place of: there it may be empty.
  std::vector<double> loss_factor = {};
  DampingLaw law = DampingLaw::kHysteretic;  ///< of the damping
  std::vector<JointSource> sources = {};     ///< of each joint
  DrivenPoints driven = {};                  ///< and measured points
  std::vector<Warning> warnings = {};        ///< on its matrices and nodes
};

/// Reads the files it names, too.
/// @param text  the file's whole text. @param file  its name.
/// @throws FormatError, InputError  naming `structure.toml:12:3: joint[1].to` as parse_model()
///     does.
/// @throws FileError  naming the key, where a file cannot be read.
[[nodiscard]] StructureFile parse_structure(std::string_view text, std::string_view file);

/// parse_structure() of a file; "-" is standard input. @throws FileError, FormatError, InputError
[[nodiscard]] StructureFile read_structure_file(const std::string& path);

}  // namespace microslip
