// SPDX-License-Identifier: MIT
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/version.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/normal_load_scale.hpp"
#include "microslip/joint/secant.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// A part of a density as (type, numbers…), with the names and the order of joint.json.
DensityPart part_of(const py::tuple& part) {
  const auto type = part[0].cast<std::string>();
  const auto number = [&](std::size_t at) { return part[at].cast<double>(); };
  const auto list = [&](std::size_t at) { return copy_of(part[at].cast<RealArray>()); };
  if (type == "uniform") return UniformPart{number(1), number(2), number(3)};
  if (type == "power_law") return PowerLawPart{number(1), number(2), number(3), number(4)};
  if (type == "piecewise_linear") return PiecewiseLinearPart{list(1), list(2)};
  if (type == "atoms") return AtomsPart{list(1), list(2)};
  return FourParameterPart{number(1), number(2), number(3), number(4)};
}

py::tuple tuple_of(const DensityPart& part) {
  return std::visit(
      [](const auto& of) -> py::tuple {
        using Part = std::decay_t<decltype(of)>;
        if constexpr (std::is_same_v<Part, UniformPart>) {
          return py::make_tuple("uniform", of.from, of.to, of.weight);
        } else if constexpr (std::is_same_v<Part, PowerLawPart>) {
          return py::make_tuple("power_law", of.coefficient, of.exponent, of.from, of.to);
        } else if constexpr (std::is_same_v<Part, PiecewiseLinearPart>) {
          return py::make_tuple("piecewise_linear", array_of(of.slip_force), array_of(of.density));
        } else if constexpr (std::is_same_v<Part, AtomsPart>) {
          return py::make_tuple("atoms", array_of(of.slip_force), array_of(of.weight));
        } else {
          return py::make_tuple("four_parameter", of.macroslip_force, of.stiffness, of.chi,
                                of.beta);
        }
      },
      part);
}

SharedJoint made_of(double stiffness, const py::list& parts) {
  std::vector<DensityPart> all;
  for (const py::handle part : parts) all.push_back(part_of(part.cast<py::tuple>()));
  return std::make_shared<const Joint>(stiffness, SlipDensity(std::move(all)));
}

py::list parts_of(const Joint& joint) {
  py::list all;
  for (const DensityPart& part : joint.density().parts()) all.append(tuple_of(part));
  return all;
}

/// f at each number, without the interpreter's lock.
template <class Function>
RealArray each(const RealArray& at, const Function& function) {
  const auto from = values(at);
  std::vector<double> to(from.size());
  {
    const py::gil_scoped_release unlocked;
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = function(from[i]);
  }
  return array_of(std::move(to));
}

/// A function of a joint and a number, for one number and for many.
template <class Function>
void define_both(py::class_<Joint, std::shared_ptr<Joint>>& joint, const char* name,
                 const Function& function) {
  joint.def(name, [function](const Joint& of, double at) { return function(of, at); });
  joint.def(name, [function](const Joint& of, const RealArray& at) {
    return each(at, [&](double x) { return function(of, x); });
  });
}

py::tuple moments_of(const Joint& joint, double s) {
  const PartialMoments moments = joint.density().moments(s);
  return py::make_tuple(moments.zeroth, moments.first, moments.second);
}

}  // namespace

void add_joint(py::module_& core) {
  using namespace py::literals;
  py::class_<Joint, std::shared_ptr<Joint>> joint(core, "Joint");
  joint.def(py::init([](double stiffness, const py::list& parts) {
    return std::const_pointer_cast<Joint>(made_of(stiffness, parts));
  }));
  joint.def("parts", parts_of);
  joint.def_property_readonly("stiffness", &Joint::stiffness);
  joint.def_property_readonly("macroslip_force", &Joint::macroslip_force);
  joint.def_property_readonly("macroslip_displacement", &Joint::macroslip_displacement);
  joint.def_property_readonly("elastic_remainder",
                              [](const Joint& of) { return of.density().elastic_remainder(); });
  joint.def_property_readonly("largest_slip_force",
                              [](const Joint& of) { return of.density().largest_slip_force(); });
  joint.def("moments", moments_of);
  define_both(joint, "force", [](const Joint& of, double x) { return of.virgin_force(x); });
  define_both(joint, "tangent", [](const Joint& of, double x) { return of.tangent_stiffness(x); });
  define_both(joint, "density", [](const Joint& of, double f) { return of.density().density(f); });
  define_both(joint, "dissipation", [](const Joint& of, double a) { return dissipation(of, a); });
  define_both(joint, "secant_stiffness",
              [](const Joint& of, double a) { return secant_stiffness(of, a); });
  define_both(joint, "loss_factor", [](const Joint& of, double a) { return loss_factor(of, a); });
  joint.def("with_normal_load", [](const Joint& of, double scale) {
    return std::make_shared<Joint>(with_normal_load(of, scale));
  });
  core.def("read_joint", [](const std::string& path) {
    const JointFile file = read_joint(path);
    return py::make_tuple(std::make_shared<Joint>(file.joint), identified_damping(file),
                          covered_to(file));
  });
  core.def("write_file",
           [](const std::string& path, const std::string& content) { write_file(path, content); });
  core.def("joint_json", [](const Joint& of, const std::string& command) {
    Provenance provenance;
    provenance.version = std::string(kVersion);
    provenance.command = command;
    return format_joint({of, provenance, {}});
  });
}

}  // namespace microslip::python
