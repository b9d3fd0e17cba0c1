// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/bindings/python/structure.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"
#include "microslip/modes/structure_modes.hpp"
#include "microslip/structure/modal_model.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

ModalModel modal_model_of(const py::dict& linear) {
  const std::vector<double> frequency = copy_of(linear["angular_frequency"].cast<RealArray>());
  const std::vector<double> loss_factor = copy_of(linear["loss_factor"].cast<RealArray>());
  if (loss_factor.size() != frequency.size()) {  // of a damaged pickle, or of another version
    throw InputError("loss_factor", fmt::format("{} values", loss_factor.size()),
                     fmt::format("must have one per mode, {}", frequency.size()));
  }
  std::vector<Mode> modes;
  for (std::size_t i = 0; i < frequency.size(); ++i)
    modes.push_back({frequency[i], loss_factor[i]});
  std::vector<ModalPoint> points;
  for (const py::handle point : linear["points"]) {
    const auto [name, shape] = point.cast<std::pair<std::string, RealArray>>();
    points.push_back({name, copy_of(shape)});
  }
  std::vector<ModalBase> bases;
  for (const py::handle base : linear["bases"]) {
    const auto [name, participation, motion] =
        base.cast<std::tuple<std::string, RealArray, RealArray>>();
    bases.push_back({name, copy_of(participation), copy_of(motion)});
  }
  return {std::move(modes), std::move(points), std::move(bases),
          linear["static_attachments"].cast<std::optional<std::size_t>>().value_or(0)};
}

std::vector<StructuralJoint> joints_of(const py::list& joints) {
  std::vector<StructuralJoint> all;
  for (const py::handle joint : joints) {
    const auto of = joint.cast<py::dict>();
    all.push_back({.name = of["name"].cast<std::string>(),
                   .joint = *of["joint"].cast<std::shared_ptr<Joint>>(),
                   .shape = copy_of(of["shape"].cast<RealArray>()),
                   .spring_in_modes = of["spring_in_modes"].cast<double>(),
                   .series_compliance = of["series_compliance"].cast<double>(),
                   .shortening = copy_of(of["shortening"].cast<py::object>()),
                   .linear_damping = of["linear_damping"].cast<double>()});
  }
  return all;
}

std::vector<Excitation> excitations_of(const py::list& excitations) {
  std::vector<Excitation> all;
  for (const py::handle excitation : excitations) {
    const auto [place, harmonics] = excitation.cast<std::pair<std::string, ComplexArray>>();
    const auto numbers = values(harmonics);
    all.push_back({place, {numbers.begin(), numbers.end()}});
  }
  return all;
}

std::vector<StaticLoad> static_loads_of(const py::list& loads) {
  std::vector<StaticLoad> all;
  for (const py::handle load : loads) {
    const auto [place, value] = load.cast<std::pair<std::string, double>>();
    all.push_back({place, value});
  }
  return all;
}

/// The value of each joint under a key; none where it is not known.
std::vector<std::optional<double>> known_values(const py::list& joints, const char* key) {
  std::vector<std::optional<double>> all;
  for (const py::handle joint : joints) all.push_back(joint[key].cast<std::optional<double>>());
  return all;
}

/// Default point of the response: the driven point, or the first point with a base excitation.
std::string usual_response(const JointedStructure& structure) {
  const std::string& driven = structure.excitations().front().point;
  const ModalModel& linear = structure.linear();
  return linear.is_base(driven) && !linear.points().empty() ? linear.points().front().name : driven;
}

/// Sets what a structure has beside its parts from further_data() of another, or from None.
void set_further_data(const py::object& further, ModelFile& of) {
  if (further.is_none()) return;
  of.response = further["response"].cast<std::string>();
  of.joint_samples = further["joint_samples"].cast<std::vector<std::string>>();
  of.damping_said = further["damping_given"].cast<std::vector<bool>>();
  const auto spread = further["spread"];
  of.spread = {.frequency = spread["frequency"].cast<std::vector<double>>(),
               .loss_factor = spread["loss_factor"].cast<std::vector<double>>(),
               .normal_load = spread["normal_load"].cast<std::vector<double>>(),
               .force_gain = spread["force_gain"].cast<std::vector<double>>(),
               .response_gain = spread["response_gain"].cast<double>()};
}

py::dict further_data(const ModelFile& of) {
  return py::dict(
      "response"_a = of.response, "joint_samples"_a = of.joint_samples,
      "damping_given"_a = of.damping_said,
      "spread"_a =
          py::dict("frequency"_a = of.spread.frequency, "loss_factor"_a = of.spread.loss_factor,
                   "normal_load"_a = of.spread.normal_load, "force_gain"_a = of.spread.force_gain,
                   "response_gain"_a = of.spread.response_gain));
}

std::shared_ptr<ModelFile> structure_of(const py::dict& linear, const py::list& joints,
                                        const py::list& excitations, const std::string& damping,
                                        const py::list& loads, const py::object& further) {
  ModalModel modes = modal_model_of(linear);
  std::vector<StructuralJoint> parts = joints_of(joints);
  std::vector<Excitation> driven = excitations_of(excitations);
  std::vector<StaticLoad> acting = static_loads_of(loads);
  std::optional<JointedStructure> structure;
  {
    const py::gil_scoped_release unlocked;  // hundreds of modes take a while
    structure.emplace(std::move(modes), std::move(parts), std::move(driven),
                      damping == "hysteretic" ? DampingLaw::kHysteretic : DampingLaw::kViscous,
                      std::move(acting));
  }
  auto made = std::make_shared<ModelFile>(ModelFile{
      .structure = *structure,
      .response = usual_response(*structure),
      .joint_files = std::vector<std::string>(joints.size()),
      .covered_to = known_values(joints, "covered_to"),
      .identified_damping = known_values(joints, "identified_damping"),
      .static_attachments = linear["static_attachments"].cast<std::optional<std::size_t>>()});
  set_further_data(further, *made);
  return made;
}

// The parts of a structure, as structure_of() takes them.

py::dict linear_part(const ModalModel& linear, std::optional<std::size_t> static_modes) {
  std::vector<double> frequency;
  std::vector<double> loss_factor;
  for (const Mode& mode : linear.modes()) {
    frequency.push_back(mode.angular_frequency);
    loss_factor.push_back(mode.loss_factor);
  }
  py::list points;
  for (const ModalPoint& point : linear.points()) {
    points.append(py::make_tuple(point.name, array_of(point.shape)));
  }
  py::list bases;
  for (const ModalBase& base : linear.bases()) {
    bases.append(
        py::make_tuple(base.name, array_of(base.participation), array_of(base.point_motion)));
  }
  return py::dict("angular_frequency"_a = array_of(std::move(frequency)),
                  "loss_factor"_a = array_of(std::move(loss_factor)), "points"_a = points,
                  "bases"_a = bases, "static_attachments"_a = static_modes);
}

/// Entry j, or none beyond the last.
std::optional<double> entry(const std::vector<std::optional<double>>& of, std::size_t j) {
  return j < of.size() ? of[j] : std::nullopt;
}

py::list joint_parts(const ModelFile& of) {
  py::list all;
  for (const StructuralJoint& joint : of.structure.joints()) {
    const std::size_t j = all.size();
    all.append(py::dict(
        "name"_a = joint.name, "joint"_a = std::make_shared<Joint>(joint.joint),
        "shape"_a = array_of(joint.shape), "spring_in_modes"_a = joint.spring_in_modes,
        "series_compliance"_a = joint.series_compliance,
        "shortening"_a = joint.shortening.empty() ? py::object(py::none())
                                                  : array_of(joint.shortening, joint.shape.size()),
        "linear_damping"_a = joint.linear_damping, "covered_to"_a = entry(of.covered_to, j),
        "identified_damping"_a = entry(of.identified_damping, j)));
  }
  return all;
}

py::list excitation_parts(const ModelFile& of) {
  py::list all;
  for (const Excitation& excitation : of.structure.excitations()) {
    all.append(py::make_tuple(excitation.point, array_of(excitation.harmonics)));
  }
  return all;
}

py::list load_parts(const ModelFile& of) {
  py::list all;
  for (const StaticLoad& load : of.structure.static_loads()) {
    all.append(py::make_tuple(load.place, load.value));
  }
  return all;
}

/// Entries on and below the diagonal, as `rows`, `columns` and `values` of the package.
SymmetricEntries entries_of(std::size_t size, const py::tuple& entries) {
  using IndexArray = py::array_t<std::int32_t, py::array::c_style>;
  const auto rows = entries[0].cast<IndexArray>();
  const auto columns = entries[1].cast<IndexArray>();
  return {.size = size,
          .row = {rows.data(), rows.data() + rows.size()},
          .column = {columns.data(), columns.data() + columns.size()},
          .value = copy_of(entries[2].cast<RealArray>())};
}

MeshPlace place_of(std::size_t row) {
  return {.name = "row " + std::to_string(row), .nodes = {}, .row = row};
}

MeshedStructure meshed_structure_of(std::size_t size, const py::tuple& stiffness,
                                    const py::tuple& mass, const py::dict& on_it) {
  MeshedStructure all;
  all.matrices = {.stiffness = entries_of(size, stiffness), .mass = entries_of(size, mass)};
  if (const auto held = on_it["held"].cast<std::vector<std::size_t>>(); !held.empty()) {
    all.supports.push_back({.name = "held", .nodes = {}, .rows = held});
  }
  for (const py::handle point : on_it["points"]) {
    const auto [name, row] = point.cast<std::pair<std::string, std::size_t>>();
    all.points.push_back({.name = name, .place = place_of(row)});
  }
  for (const py::handle base : on_it["bases"]) {
    const auto [name, rows] = base.cast<std::pair<std::string, std::vector<std::size_t>>>();
    all.bases.push_back({.name = name, .rows = rows});
  }
  for (const py::handle joint : on_it["joints"]) {
    const auto [name, from, to, stiffness_of_it] =
        joint.cast<std::tuple<std::string, std::optional<std::size_t>, std::size_t, double>>();
    MeshJoint made{.name = name, .to = place_of(to), .stiffness = stiffness_of_it};
    if (from) made.from = place_of(*from);
    all.joints.push_back(std::move(made));
  }
  return all;
}

py::dict dict_of(const StructureModes& modes) {
  py::list shapes;
  for (const std::vector<double>& shape : modes.joint_shapes) shapes.append(array_of(shape));
  py::list compliances;
  for (const StaticCompliance& of : modes.compliances) {
    compliances.append(py::make_tuple(of.name, std::string(to_string(of.place)), of.exact,
                                      of.in_modes, of.in_model));
  }
  return py::dict("linear"_a = linear_part(modes.model, modes.model.static_modes()),
                  "joint_shapes"_a = shapes, "compliances"_a = compliances,
                  "degrees_of_freedom"_a = modes.degrees_of_freedom,
                  "warnings"_a = list_of(modes.warnings));
}

py::dict compute_modes(std::size_t size, const py::tuple& stiffness, const py::tuple& mass,
                       const py::dict& on_it, const py::dict& options, const py::object& listener) {
  const MeshedStructure structure = meshed_structure_of(size, stiffness, mass, on_it);
  ModesOptions of{
      .count = options["count"].cast<std::optional<std::size_t>>(),
      .highest_frequency = options["highest_frequency"].cast<std::optional<double>>(),
      .joints = options["stuck"].cast<bool>() ? JointsInModes::kStuck : JointsInModes::kFree,
      .attachment = options["attachment"].cast<bool>(),
      .attached_points = options["attached_points"].cast<std::vector<std::string>>()};
  return dict_of(long_result(
      [&](const Progress& progress) {
        of.progress = progress;
        return compute_structure_modes(structure, of);
      },
      listener));
}

}  // namespace

void add_structure(py::module_& core) {
  py::class_<ModelFile, std::shared_ptr<ModelFile>>(core, "Structure")
      .def(py::init(&structure_of))
      .def("linear",
           [](const ModelFile& of) {
             return linear_part(of.structure.linear(), of.static_attachments);
           })
      .def("joints", joint_parts)
      .def("excitations", excitation_parts)
      .def("static_loads", load_parts)
      .def("further_data", further_data)
      .def_property_readonly("damping",
                             [](const ModelFile& of) {
                               const bool lags = of.structure.damping() == DampingLaw::kHysteretic;
                               return lags ? "hysteretic" : "viscous";
                             })
      .def_property_readonly("response", [](const ModelFile& of) { return of.response; })
      .def_property_readonly("base_driven",
                             [](const ModelFile& of) { return of.structure.base_driven(); })
      .def("stuck_frequencies",
           [](const ModelFile& of) { return array_of(of.structure.stuck_frequencies()); })
      .def("stuck_mode", [](const ModelFile& of, std::size_t mode) {
        return array_of(of.structure.stuck_mode(mode));
      });
  core.def(
      "read_structure",
      [](const std::string& path) { return std::make_shared<ModelFile>(read_model(path)); },
      py::call_guard<py::gil_scoped_release>());
  core.def("compute_modes", compute_modes);
}

}  // namespace microslip::python
