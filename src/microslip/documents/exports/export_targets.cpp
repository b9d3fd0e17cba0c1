// SPDX-License-Identifier: MIT
#include "microslip/documents/exports/export_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "microslip/base/error.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// Of Python. [The Python Language Reference 3.11, 2.3.1]
constexpr std::array<std::string_view, 35> kPythonWords{
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

/// Of Modelica, the names of its own types, and those that the model refers to. [Modelica Language
/// Specification 3.6, 2.3.3, 4.9]
constexpr std::array<std::string_view, 71> kModelicaWords{"algorithm",
                                                          "and",
                                                          "annotation",
                                                          "block",
                                                          "break",
                                                          "class",
                                                          "connect",
                                                          "connector",
                                                          "constant",
                                                          "constrainedby",
                                                          "der",
                                                          "discrete",
                                                          "each",
                                                          "else",
                                                          "elseif",
                                                          "elsewhen",
                                                          "encapsulated",
                                                          "end",
                                                          "enumeration",
                                                          "equation",
                                                          "expandable",
                                                          "extends",
                                                          "external",
                                                          "false",
                                                          "final",
                                                          "flow",
                                                          "for",
                                                          "function",
                                                          "if",
                                                          "import",
                                                          "impure",
                                                          "in",
                                                          "initial",
                                                          "inner",
                                                          "input",
                                                          "loop",
                                                          "model",
                                                          "not",
                                                          "operator",
                                                          "or",
                                                          "outer",
                                                          "output",
                                                          "package",
                                                          "parameter",
                                                          "partial",
                                                          "protected",
                                                          "public",
                                                          "pure",
                                                          "record",
                                                          "redeclare",
                                                          "replaceable",
                                                          "return",
                                                          "stream",
                                                          "then",
                                                          "true",
                                                          "type",
                                                          "when",
                                                          "while",
                                                          "within",
                                                          "Real",
                                                          "Integer",
                                                          "Boolean",
                                                          "String",
                                                          "Clock",
                                                          "AssertionLevel",
                                                          "StateSelect",
                                                          "ExternalObject",
                                                          "time",
                                                          "Modelica",
                                                          "flange_a",
                                                          "flange_b"};

/// Groups of Code_Aster have 24 letters, of which `_` and the number of a slider take five.
constexpr std::size_t kLongestAsterName = 19;
/// Its nodes and elements have 8, a letter and seven digits.
constexpr std::size_t kLargestAsterNumber = 9'000'000;
/// Parameters and macros of APDL have 32 letters; `_T` is behind the name of a parameter.
constexpr std::size_t kLongestMacro = 32;
constexpr std::size_t kLongestAnsysName = kLongestMacro - 2;
/// A user element of Abaqus is of type Un, n below 10000.
constexpr std::size_t kLargestElementType = 9999;

constexpr std::array kTargets{
    ExportTarget{"abaqus", "include file of Abaqus with a connector for each slider", ".inp", false,
                 abaqus_connectors},
    ExportTarget{"abaqus-cubes", "include file of Abaqus with a plastic cube for each slider",
                 ".inp", false, abaqus_cubes},
    ExportTarget{.name = "abaqus-uel",
                 .words = "Fortran of a user element of Abaqus, UEL",
                 .ending = ".for",
                 .text = abaqus_element,
                 .largest_number = kLargestElementType},
    ExportTarget{.name = "ansys",
                 .words = "APDL with a COMBIN40 for each slider",
                 .ending = ".mac",
                 .text = ansys_commands,
                 .longest_name = kLongestAnsysName,
                 .longest_file = kLongestMacro},
    ExportTarget{"c", "source file of C, state in and out", ".c", false, c_source},
    ExportTarget{"calculix", "include file of CalculiX with a plastic cube for each slider", ".inp",
                 false, calculix_cubes},
    ExportTarget{.name = "code-aster",
                 .words = "Python for command files of Code_Aster: DIS_ECRO_CINE elements",
                 .ending = ".py",
                 .text = code_aster_functions,
                 .longest_name = kLongestAsterName,
                 .largest_number = kLargestAsterNumber},
    ExportTarget{.name = "fmu",
                 .words = "FMI 2.0 for model exchange and co-simulation",
                 .ending = ".fmu",
                 .text = fmu_archive,
                 .archive = true},
    ExportTarget{"mastodon", "backbone of MASTODON, which makes the sliders of it", ".csv", false,
                 mastodon_backbone},
    ExportTarget{.name = "modelica",
                 .words = "model of translational mechanics",
                 .ending = ".mo",
                 .si_only = true,
                 .text = modelica_model,
                 .reserved = kModelicaWords},
    ExportTarget{"nastran", "", "", false, nullptr,
                 "a CBUSH1D with a table is elastic and dissipates nothing, and the friction of a "
                 "CGAP follows its normal force: neither is this joint"},
    ExportTarget{"opensees", "Tcl that makes a uniaxial material", ".tcl", false, opensees_tcl},
    ExportTarget{.name = "openseespy",
                 .words = "Python that makes a uniaxial material of OpenSees",
                 .ending = ".py",
                 .text = opensees_python,
                 .reserved = kPythonWords},
};

std::string names_of_targets() {
  std::string names;
  for (const ExportTarget& target : kTargets) {
    if (target.text == nullptr) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", target.name);
  }
  return names;
}

bool is_reserved(const ExportTarget& target, std::string_view name) {
  return std::ranges::find(target.reserved, name) != target.reserved.end();
}

void check_name_and_number(const ExportTarget& target, const ExportedJoint& joint) {
  if (is_reserved(target, joint.name)) {
    throw InputError("`name`", joint.name,
                     fmt::format("is a word of the language of {} and no name there", target.name),
                     fmt::format("Take {}.", name_for_target(target, joint.name)));
  }
  if (joint.name.size() > target.longest_name) {
    throw InputError(
        "`name`", joint.name,
        fmt::format("must have at most {} letters for {}", target.longest_name, target.name));
  }
  if (joint.first_number > target.largest_number) {
    throw InputError("`first_number`", static_cast<double>(joint.first_number),
                     fmt::format("must be at most {} for {}", target.largest_number, target.name));
  }
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

std::string name_for_target(const ExportTarget& target, std::string_view text) {
  std::string name = name_in_exports(text);
  if (is_reserved(target, name)) name += "_joint";
  if (name.size() > target.longest_name) name.resize(target.longest_name);
  return name;
}

std::string export_text(const ExportTarget& target, const ExportedJoint& joint) {
  if (target.si_only && (joint.units.newtons != 1.0 || joint.units.metres != 1.0)) {
    throw InputError(
        "`units`", joint.units.name,
        fmt::format("must be SI for {}, whose connectors are in N and m", target.name));
  }
  check_name_and_number(target, joint);
  return target.text(joint);
}

}  // namespace microslip
