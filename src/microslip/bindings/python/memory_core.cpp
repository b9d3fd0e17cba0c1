// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// A memory that keeps its joint.
struct OwningMemory {
  explicit OwningMemory(SharedJoint of) : joint(std::move(of)), memory(*joint) {}

  SharedJoint joint;
  Memory memory;
};

py::tuple tuple_of(const Memory::Response& response) {
  return py::make_tuple(response.force, response.tangent);
}

/// An array of NumPy's own memory, which takes large pages for large ones: new pages would cost as
/// much as the march.
RealArray forces_along(const RealArray& x) { return RealArray(x.size()); }

std::span<double> written(RealArray& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

RealArray march(OwningMemory& of, const RealArray& x) {
  RealArray force = forces_along(x);
  const std::span<double> to = written(force);
  {
    const py::gil_scoped_release unlocked;
    of.memory.march(values(x), to);
  }
  return force;
}

RealArray reversals(const OwningMemory& of) {
  std::vector<double> rows;
  for (const Memory::ReversalPoint& point : of.memory.reversals()) {
    rows.push_back(point.displacement);
    rows.push_back(point.force);
  }
  return array_of(std::move(rows), 2);
}

RealArray march_under_load(const Joint& joint, const RealArray& x, const RealArray& load,
                           std::size_t elements, const std::string& law) {
  std::vector<double> force(values(x).size());
  {
    const py::gil_scoped_release unlocked;
    const JenkinsNetwork network = JenkinsNetwork::discretise(joint, elements);
    NetworkMemory memory(network,
                         law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental);
    memory.march(values(x), values(load), force);
  }
  return array_of(std::move(force));
}

}  // namespace

void add_memory(py::module_& core) {
  py::class_<OwningMemory>(core, "Memory")
      .def(py::init([](const std::shared_ptr<Joint>& joint) { return OwningMemory(joint); }))
      .def("copy", [](const OwningMemory& of) { return of; })
      .def_property_readonly("displacement",
                             [](const OwningMemory& of) { return of.memory.displacement(); })
      .def_property_readonly("force", [](const OwningMemory& of) { return of.memory.force(); })
      .def("reversals", reversals)
      .def("trial", [](const OwningMemory& of, double x) { return tuple_of(of.memory.trial(x)); })
      .def("advance", [](OwningMemory& of, double x) { return of.memory.advance(x); })
      .def("dissipation", [](const OwningMemory& of, double x) { return of.memory.dissipation(x); })
      .def("stored_energy", [](const OwningMemory& of) { return of.memory.stored_energy(); })
      .def("march", march)
      .def("reset", [](OwningMemory& of) { of.memory.reset(); });
  core.def("march_under_load", march_under_load);
}

}  // namespace microslip::python
