// SPDX-License-Identifier: MIT
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/dynamics/cycle/harmonic_force.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// Tables and working memory that threads of Python may share: they take turns.
class SharedHarmonicForce {
 public:
  SharedHarmonicForce(std::size_t harmonics, std::size_t samples) : of_(harmonics, samples) {}

  /// Force (n), its derivatives (n, n) and, of the displacement, lowest, highest and reversals.
  py::tuple evaluate(const Joint& joint, const RealArray& displacement) {
    const std::size_t length = values(displacement).size();
    std::vector<double> force(length);
    std::vector<double> jacobian(length * length);
    HarmonicForce::Cycle cycle{};
    {
      // The interpreter's lock first: who waits for the mutex must not hold it.
      const py::gil_scoped_release unlocked;
      const std::lock_guard turn(mutex_);
      cycle = of_.evaluate(joint, values(displacement), force, jacobian);
    }
    return py::make_tuple(array_of(std::move(force)), array_of(std::move(jacobian), length),
                          cycle.lowest, cycle.highest, cycle.reversals);
  }

 private:
  HarmonicForce of_;
  std::mutex mutex_;
};

}  // namespace

void add_harmonic_force(py::module_& core) {
  py::class_<SharedHarmonicForce>(core, "HarmonicForce")
      .def(py::init<std::size_t, std::size_t>())
      .def("evaluate", &SharedHarmonicForce::evaluate);
}

}  // namespace microslip::python
