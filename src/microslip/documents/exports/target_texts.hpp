// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/documents/exports/exported_joint.hpp"

/// @file
/// The text of a joint for each target, a source file each.

namespace microslip {

/// Keywords of CalculiX and Abaqus: a unit cube of a perfectly plastic material for each slider,
/// its faces tied to two nodes.
[[nodiscard]] std::string calculix_cubes(const ExportedJoint& joint);
[[nodiscard]] std::string abaqus_cubes(const ExportedJoint& joint);

/// Keywords of Abaqus: an elastic, perfectly plastic connector for each slider.
[[nodiscard]] std::string abaqus_connectors(const ExportedJoint& joint);

/// Fortran of a user element of Abaqus, UEL, between two nodes.
[[nodiscard]] std::string abaqus_element(const ExportedJoint& joint);

/// Commands of APDL: COMBIN40 elements.
[[nodiscard]] std::string ansys_commands(const ExportedJoint& joint);

/// One source file of C without dependencies.
[[nodiscard]] std::string c_source(const ExportedJoint& joint);

/// The same without comments at its head, for sources that contain it: NAME_state and NAME_force().
[[nodiscard]] std::string c_code(const ExportedJoint& joint);

/// Archive of FMI 2.0: `modelDescription.xml`, a source file of C and, on Linux on x86-64, the
/// shared object that the C compiler of this machine makes of it. @throws Error  where there is
/// none.
[[nodiscard]] std::string fmu_archive(const ExportedJoint& joint);

/// Python for command files of Code_Aster: a mesh of discrete elements, their law and stiffness.
[[nodiscard]] std::string code_aster_functions(const ExportedJoint& joint);

/// Backbone of MASTODON, strain and stress: it makes the sliders of it.
[[nodiscard]] std::string mastodon_backbone(const ExportedJoint& joint);

/// A model of translational mechanics.
[[nodiscard]] std::string modelica_model(const ExportedJoint& joint);

/// Uniaxial materials in Tcl, and in Python.
[[nodiscard]] std::string opensees_tcl(const ExportedJoint& joint);
[[nodiscard]] std::string opensees_python(const ExportedJoint& joint);

}  // namespace microslip
