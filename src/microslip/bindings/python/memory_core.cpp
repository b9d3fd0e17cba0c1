// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/joint/path.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// A memory that keeps its joint. A long path runs without the interpreter's lock: other threads
/// must not use the memory meanwhile.
class OwningMemory {
 public:
  explicit OwningMemory(SharedJoint of) : joint_(std::move(of)), memory_(*joint_) {}

  /// @throws InputError  while a path runs.
  Memory& get() {
    check();
    return memory_;
  }
  [[nodiscard]] const Memory& get() const {
    check();
    return memory_;
  }

  void march(std::span<const double> x, std::span<double> force) {
    constexpr std::size_t kLong = 2000;  // some 10 us
    if (x.size() < kLong) return get().march(x, force);
    const Busy busy(get_flag());
    const py::gil_scoped_release unlocked;  // taken back before the flag is
    memory_.march(x, force);
  }

 private:
  /// Read and written with the interpreter's lock.
  class Busy {
   public:
    explicit Busy(bool& flag) : flag_(flag) { flag_ = true; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
    ~Busy() { flag_ = false; }

   private:
    bool& flag_;
  };

  bool& get_flag() {
    check();
    return busy_;
  }

  void check() const {
    if (!busy_) return;
    throw InputError("memory", InputState{"in use"}, "must not be used by two threads at once",
                     "Give each thread a copy.");
  }

  SharedJoint joint_;
  Memory memory_;
  bool busy_ = false;
};

py::tuple tuple_of(const Memory::Response& response) {
  return py::make_tuple(response.force, response.tangent);
}

/// An array of NumPy's own memory, which uses large pages for large arrays: new pages would cost as
/// much as the march.
RealArray forces_along(const RealArray& x) { return RealArray(x.size()); }

std::span<double> written(RealArray& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

RealArray march(OwningMemory& of, const RealArray& x) {
  RealArray force = forces_along(x);
  of.march(values(x), written(force));
  return force;
}

RealArray reversals(const OwningMemory& of) {
  std::vector<double> rows;
  for (const Memory::ReversalPoint& point : of.get().reversals()) {
    rows.push_back(point.displacement);
    rows.push_back(point.force);
  }
  return array_of(std::move(rows), 2);
}

/// A path of the network between calls of the listener.
void march_in_blocks(NetworkMemory& memory, std::span<const double> x, std::span<const double> load,
                     std::span<double> force, const Progress& progress) {
  constexpr std::size_t kBlock = 1000;
  const std::size_t all = x.size();
  for (std::size_t done = 0; done < all; done += kBlock) {
    if (progress && !progress(done, all)) throw Cancelled();
    const std::size_t n = std::min(kBlock, all - done);
    memory.march(x.subspan(done, n), load.subspan(done, n), force.subspan(done, n));
  }
}

RealArray march_under_load(const Joint& joint, const RealArray& x, const RealArray& load,
                           std::size_t elements, const std::string& law) {
  const auto path = values(x);
  const auto loads = values(load);
  check_path(path, loads, path);  // here, as a block would count from its own first
  return array_of(long_result(
      [&](const Progress& progress) {
        std::vector<double> force(path.size());
        const JenkinsNetwork network = JenkinsNetwork::discretise(joint, elements);
        NetworkMemory memory(network,
                             law == "total" ? NormalLoadLaw::kTotal : NormalLoadLaw::kIncremental);
        march_in_blocks(memory, path, loads, force, progress);
        return force;
      },
      py::none()));
}

}  // namespace

void add_memory(py::module_& core) {
  py::class_<OwningMemory>(core, "Memory")
      .def(py::init([](const std::shared_ptr<Joint>& joint) { return OwningMemory(joint); }))
      .def("copy",
           [](const OwningMemory& of) {
             (void)of.get();
             return of;
           })
      .def_property_readonly("displacement",
                             [](const OwningMemory& of) { return of.get().displacement(); })
      .def_property_readonly("force", [](const OwningMemory& of) { return of.get().force(); })
      .def("reversals", reversals)
      .def("trial", [](const OwningMemory& of, double x) { return tuple_of(of.get().trial(x)); })
      .def("advance", [](OwningMemory& of, double x) { return of.get().advance(x); })
      .def("dissipation", [](const OwningMemory& of, double x) { return of.get().dissipation(x); })
      .def("stored_energy", [](const OwningMemory& of) { return of.get().stored_energy(); })
      .def("march", march)
      .def("reset", [](OwningMemory& of) { of.get().reset(); });
  core.def("march_under_load", march_under_load);
}

}  // namespace microslip::python
