// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/identification.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/observe/level_evidence.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"
#include "microslip/workflow/predict/joint_draws.hpp"
#include "microslip/workflow/reduce/level_table.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

/// The columns of Levels by the names of the package, which are those of levels.csv.
Levels levels_of(const py::dict& columns) {
  const auto column = [&](const char* name) { return copy_of(columns[name].cast<py::object>()); };
  return {.amplitude = column("amplitude"),
          .dissipation = column("dissipation"),
          .amplitude_std = column("amplitude_std"),
          .dissipation_std = column("dissipation_std"),
          .secant_stiffness = column("secant_stiffness"),
          .secant_stiffness_std = column("secant_stiffness_std"),
          .linear_dissipation = column("linear_dissipation"),
          .frequency = column("frequency"),
          .frequency_std = column("frequency_std")};
}

py::dict dict_of(const Levels& levels) {
  return py::dict("amplitude"_a = array_or_none(levels.amplitude),
                  "dissipation"_a = array_or_none(levels.dissipation),
                  "amplitude_std"_a = array_or_none(levels.amplitude_std),
                  "dissipation_std"_a = array_or_none(levels.dissipation_std),
                  "secant_stiffness"_a = array_or_none(levels.secant_stiffness),
                  "secant_stiffness_std"_a = array_or_none(levels.secant_stiffness_std),
                  "linear_dissipation"_a = array_or_none(levels.linear_dissipation),
                  "frequency"_a = array_or_none(levels.frequency),
                  "frequency_std"_a = array_or_none(levels.frequency_std));
}

std::optional<std::string> text_or_none(const py::handle& text) {
  return text.is_none() ? std::nullopt : std::optional(text.cast<std::string>());
}

/// The options of the program's `identify`, by the names of the package.
LevelsIdentification level_options_of(const py::dict& given) {
  LevelsIdentification all;
  all.texts.smoothing = given["smoothing"].cast<std::string>();
  all.texts.smoothing_unit = text_or_none(given["smoothing_unit"]);
  all.errors = {.dissipation_gain_std = given["dissipation_gain_std"].cast<double>(),
                .amplitude_gain_std = given["amplitude_gain_std"].cast<double>(),
                .loss_factor_std = given["loss_factor_std"].cast<double>()};
  all.options.method = find_identification_method(given["method"].cast<std::string>()).value();
  all.options.inversion.linear_damping = given["linear_damping"].cast<bool>();
  all.options.inversion.atom = given["atom"].cast<bool>();
  all.options.inversion.edges = given["edges"].cast<bool>();
  if (const auto fit = text_or_none(given["fit"])) all.options.fit = find_parametric_model(*fit);
  if (const auto samples = given["samples"].cast<std::size_t>(); samples > 0) {
    all.options.bands =
        BandOptions{.samples = samples, .seed = given["seed"].cast<std::uint64_t>()};
  }
  set_smoothing(all.texts.smoothing, all.texts.smoothing_unit, all.options);
  return all;
}

/// What Levels.write() writes, from the columns of the package.
std::string csv_of(const Levels& levels) {
  CsvWriter table = levels_table(levels);
  table.add_comment(heading_of("microslip.Levels.write"));
  const auto add = [&](const char* name, const Dimension& dimension,
                       const std::vector<double>& values) {
    if (!values.empty()) table.add_numbers(name, dimension, values);
  };
  add("linear_dissipation", kEnergy, levels.linear_dissipation);
  add("frequency", kFrequency, levels.frequency);
  add("frequency_std", kFrequency, levels.frequency_std);
  return table.str();
}

/// The input recorded in joint.json for levels that came as arrays: the file that they would be.
NamedInput input_of(const Levels& levels) { return {"arrays", csv_of(levels)}; }

py::object draws_or_none(const Identification& found, const Provenance& provenance) {
  if (found.bands() == nullptr && found.records() == nullptr) return py::none();
  return py::cast(joint_samples(found, provenance));
}

py::list verdicts_of(const Identification& found) {
  py::list all;
  for (const LevelDepartureVerdict& verdict : found.verdicts) {
    all.append(py::make_tuple(std::string(to_string(verdict.departure)), verdict.share,
                              verdict.noise, verdict.broken));
  }
  return all;
}

py::list parameters_of(const Identification& found) {
  py::list all;
  if (!found.parametric) return all;
  for (const FittedParameter& parameter : found.parametric->parameters) {
    all.append(py::make_tuple(parameter.name, parameter.unit, parameter.value,
                              parameter.standard_error, parameter.at_bound));
  }
  return all;
}

py::dict dict_of(const Identification& found, const Provenance& provenance) {
  return py::dict(
      "method"_a = std::string(to_string(found.method)),
      "joint"_a = std::make_shared<Joint>(found.joint), "covered_from"_a = found.covered_from,
      "covered_to"_a = found.covered_to, "slip_force"_a = array_of(found.slip_force),
      "density"_a = array_of(found.density),
      "lower"_a = found.lower.empty() ? py::object(py::none()) : array_of(found.lower),
      "upper"_a = found.upper.empty() ? py::object(py::none()) : array_of(found.upper),
      "linear_damping"_a = found.linear_damping, "draws"_a = draws_or_none(found, provenance),
      "parameters"_a = parameters_of(found), "verdicts"_a = verdicts_of(found),
      "warnings"_a = python::list_of(found.warnings), "summary"_a = python::dict_of(found.summary));
}

/// @param notes  warnings of the reader of the levels, which are added to those of the result.
py::dict identify_levels(const py::dict& columns, double stiffness, const py::dict& given,
                         const std::string& command,
                         const std::vector<std::pair<std::string, std::string>>& notes,
                         const py::object& listener) {
  const Levels levels = levels_of(columns);
  const LevelsIdentification of = level_options_of(given);
  Identification found = long_result(
      [&](const Progress& progress) {
        IdentificationOptions options = of.options;
        if (options.bands) options.bands->progress = progress;
        return identify(LevelEvidence(levels, of.errors), stiffness, options);
      },
      listener);
  for (const auto& [code, words] : notes) found.warnings.push_back({code, words});
  return identification_dict(found, identified_joint(of, found, {input_of(levels)}, command));
}

/// The levels of a file that an identification uses, and warnings about the others.
py::tuple read_levels_of(const std::string& path, bool use_inner_reversals, bool of_one_joint) {
  const LevelTable table = read_level_table(
      path, {.use_inner_reversals = use_inner_reversals,
             .linear_dissipation = LinearLossColumn::kUsed,
             .assemblies = of_one_joint ? AssemblyColumn::kIgnored : AssemblyColumn::kUnsaid});
  return py::make_tuple(dict_of(table.used.levels), python::list_of(table.warnings));
}

/// The provenance of draws, as a joint.json of the first.
std::optional<std::string> origin_of(const JointSamples& of) {
  if (!of.provenance) return std::nullopt;
  return format_joint({of.joint(0), of.provenance, {}});
}

/// The state of draws, for pickle.
py::dict state_of(const JointSamples& of) {
  return py::dict("method"_a = of.method, "seed"_a = of.seed,
                  "slip_displacement"_a = array_of(of.slip_displacement),
                  "stiffness_density"_a = array_of(of.stiffness_density),
                  "stiffness"_a = array_of(of.stiffness),
                  "atom_slip_displacement"_a = of.atom_slip_displacement,
                  "atom_weight"_a = array_of(of.atom_weight),
                  "linear_damping"_a = array_of(of.linear_damping),
                  "viscous"_a = array_of(of.viscous), "origin"_a = origin_of(of));
}

JointSamples draws_of(const py::dict& state) {
  const auto numbers = [&](const char* name) { return copy_of(state[name].cast<RealArray>()); };
  JointSamples of{
      .method = state["method"].cast<std::string>(),
      .seed = state["seed"].cast<std::uint64_t>(),
      .slip_displacement = numbers("slip_displacement"),
      .stiffness_density = numbers("stiffness_density"),
      .stiffness = numbers("stiffness"),
      .atom_slip_displacement = state["atom_slip_displacement"].cast<std::optional<double>>(),
      .atom_weight = numbers("atom_weight"),
      .linear_damping = numbers("linear_damping"),
      .viscous = numbers("viscous")};
  if (const auto origin = state["origin"].cast<std::optional<std::string>>()) {
    of.provenance = parse_joint(*origin, "origin").provenance;
  }
  of.check();
  return of;
}

void add_draws(py::class_<JointSamples>& draws) {
  draws.def("__len__", &JointSamples::size);
  draws.def("joint", [](const JointSamples& of, std::size_t i) {
    return std::make_shared<Joint>(of.joint(i));
  });
  draws.def_property_readonly("method", [](const JointSamples& of) { return of.method; });
  draws.def_property_readonly("seed", [](const JointSamples& of) { return of.seed; });
  draws.def_property_readonly("stiffness",
                              [](const JointSamples& of) { return array_of(of.stiffness); });
  draws.def_property_readonly(
      "slip_displacement", [](const JointSamples& of) { return array_of(of.slip_displacement); });
  draws.def_property_readonly("stiffness_density", [](const JointSamples& of) {
    return array_of(of.stiffness_density, of.slip_displacement.size());
  });
  draws.def_property_readonly("linear_damping",
                              [](const JointSamples& of) { return array_of(of.linear_damping); });
  draws.def_property_readonly("atom_slip_displacement",
                              [](const JointSamples& of) { return of.atom_slip_displacement; });
  draws.def_property_readonly("atom_weight",
                              [](const JointSamples& of) { return array_of(of.atom_weight); });
  draws.def("state", state_of);
  draws.def("hdf5", [](const JointSamples& of, const std::string& path) {
    return py::bytes(joint_samples_bytes(of, path));
  });
}

}  // namespace

Levels levels_of_columns(const py::dict& columns) { return levels_of(columns); }

py::dict identification_dict(const Identification& found, const JointFile& file) {
  py::dict all = dict_of(found, file.provenance.value());
  all["json"] = format_joint(file);
  return all;
}

void add_identification(py::module_& core) {
  py::class_<JointSamples> draws(core, "JointDraws");
  add_draws(draws);
  core.def("draws_of", draws_of);
  core.def("read_draws", [](const std::string& path) { return read_joint_samples(path); });
  core.def("identify_levels", identify_levels);
  core.def("read_levels", read_levels_of);
  core.def("parse_levels", [](const std::string& text) {
    return dict_of(
        without_inner_reversals(
            parse_levels(text, "levels", {.linear_dissipation = LinearLossColumn::kUsed}))
            .levels);
  });
  core.def("levels_csv", [](const py::dict& columns) { return csv_of(levels_of(columns)); });
}

}  // namespace microslip::python
