// SPDX-License-Identifier: MIT
#include "microslip/documents/exports/export_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "microslip/base/error.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

constexpr std::array kTargets{
    ExportTarget{"abaqus", "include file of Abaqus with a connector for each slider", ".inp", false,
                 abaqus_connectors},
    ExportTarget{"abaqus-cubes", "include file of Abaqus with a plastic cube for each slider",
                 ".inp", false, abaqus_cubes},
    ExportTarget{"ansys", "APDL with a COMBIN40 for each slider", ".mac", false, ansys_commands},
    ExportTarget{"c", "source file of C, state in and out", ".c", false, c_source},
    ExportTarget{"calculix", "include file of CalculiX with a plastic cube for each slider", ".inp",
                 false, calculix_cubes},
    ExportTarget{"fmu", "FMI 2.0 for model exchange and co-simulation", ".fmu", false, fmu_archive},
    ExportTarget{"mastodon", "backbone of MASTODON, which makes the sliders of it", ".csv", false,
                 mastodon_backbone},
    ExportTarget{"modelica", "model of translational mechanics", ".mo", true, modelica_model},
    ExportTarget{"nastran", "", "", false, nullptr,
                 "a CBUSH1D with a table is elastic and dissipates nothing, and the friction of a "
                 "CGAP follows its normal force: neither is this joint"},
    ExportTarget{"opensees", "Tcl that makes a uniaxial material", ".tcl", false, opensees_tcl},
    ExportTarget{"openseespy", "Python that makes a uniaxial material of OpenSees", ".py", false,
                 opensees_python},
};

std::string names_of_targets() {
  std::string names;
  for (const ExportTarget& target : kTargets) {
    if (target.text == nullptr) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", target.name);
  }
  return names;
}

}  // namespace

std::span<const ExportTarget> all_export_targets() { return kTargets; }

const ExportTarget& export_target(std::string_view name) {
  const auto* const found = std::ranges::find(kTargets, name, &ExportTarget::name);
  const std::string remedy = fmt::format("Targets are {}.", names_of_targets());
  if (found == kTargets.end()) {
    throw InputError("`to`", name, "is no target of an export", remedy);
  }
  if (found->text == nullptr) {
    throw InputError("`to`", name, fmt::format("cannot hold this joint: {}", found->reason),
                     remedy);
  }
  return *found;
}

std::string export_text(const ExportTarget& target, const ExportedJoint& joint) {
  if (target.si_only && (joint.units.newtons != 1.0 || joint.units.metres != 1.0)) {
    throw InputError(
        "`units`", joint.units.name,
        fmt::format("must be SI for {}, whose connectors are in N and m", target.name));
  }
  return target.text(joint);
}

}  // namespace microslip
