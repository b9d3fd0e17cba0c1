// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/march.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/bindings/python/structure.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/workflow/predict/model_text.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

LoadHistory loads_of(const RealArray& time, const py::list& forces, const py::list& normal_loads) {
  LoadHistory all;
  all.time = copy_of(time);
  for (const py::handle force : forces) {
    const auto [place, numbers] = force.cast<std::pair<std::string, RealArray>>();
    all.forces.push_back({place, copy_of(numbers)});
  }
  for (const py::handle load : normal_loads) {
    const auto [joint, numbers, law] = load.cast<std::tuple<std::string, RealArray, std::string>>();
    all.normal_loads.push_back(
        {joint, copy_of(numbers),
         law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental});
  }
  return all;
}

py::dict dict_of(MarchResult result) {
  py::list points;
  for (PointMotion& motion : result.points) {
    points.append(py::make_tuple(motion.point, array_of(std::move(motion.displacement)),
                                 array_of(std::move(motion.velocity)),
                                 array_of(std::move(motion.acceleration))));
  }
  py::list joints;
  for (JointMotion& motion : result.joints) {
    joints.append(py::make_tuple(motion.joint, array_of(std::move(motion.displacement)),
                                 array_of(std::move(motion.force))));
  }
  const MarchEnergy& energy = result.energy;
  py::dict energies("initial"_a = energy.initial, "input"_a = energy.input,
                    "linear_dissipation"_a = energy.linear_dissipation,
                    "kinetic"_a = energy.kinetic, "elastic"_a = energy.elastic,
                    "joint_dissipation"_a = energy.joint_dissipation(),
                    "joint_stored"_a = energy.joint_stored(),
                    "joint_linear_dissipation"_a = energy.joint_linear_dissipation(),
                    "imbalance"_a = energy.imbalance());
  return py::dict("time"_a = array_of(std::move(result.time)), "points"_a = points,
                  "joints"_a = joints, "reached"_a = result.reached, "steps"_a = result.steps,
                  "error_estimate"_a = result.error_estimate, "energy"_a = energies,
                  "warnings"_a = list_of(result.warnings),
                  "summary"_a = python::dict_of(result.summary));
}

py::dict march_structure(const std::shared_ptr<ModelFile>& model, const RealArray& time,
                         const py::list& forces, const py::list& normal_loads,
                         const py::dict& options, const py::object& listener) {
  const LoadHistory loads = loads_of(time, forces, normal_loads);
  const MarchOptions of = march_options_of(options);
  return dict_of(long_result(
      [&](const Progress& progress) { return judged_march(*model, loads, of, progress); },
      listener));
}

}  // namespace

LoadHistory load_history_of(const RealArray& time, const py::list& forces,
                            const py::list& normal_loads) {
  return loads_of(time, forces, normal_loads);
}

MarchOptions march_options_of(const py::dict& given) {
  return {.step = given["step"].cast<double>(),
          .every = given["every"].cast<std::size_t>(),
          .points = given["points"].cast<std::vector<std::string>>(),
          .start = {copy_of(given["displacement"].cast<py::object>()),
                    copy_of(given["velocity"].cast<py::object>())},
          .tolerance = given["tolerance"].cast<double>(),
          .max_iterations = given["max_iterations"].cast<int>(),
          .largest_imbalance = given["largest_imbalance"].cast<double>(),
          .estimate_error = given["estimate_error"].cast<bool>(),
          .largest_error = given["largest_error"].cast<double>(),
          .elements = given["elements"].cast<std::size_t>()};
}

py::dict march_dict(MarchResult result) { return dict_of(std::move(result)); }

void add_march(py::module_& core) { core.def("march", march_structure); }

}  // namespace microslip::python
