// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/long_work.hpp"

#include <cstddef>
#include <ctime>
#include <utility>

#include "microslip/base/attended_work.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// A thread that nobody waits for may still work while the interpreter ends. Whoever asks for the lock
/// then is ended by Python in a way that C++ cannot follow, so that it must never return there.
bool interpreter_ends() { return Py_IsInitialized() == 0; }

void stay_while_interpreter_ends() {
  constexpr std::timespec kWhile{1, 0};
  while (interpreter_ends()) ::nanosleep(&kWhile, nullptr);
}

/// Signals, and the listener where there is news.
class Attention {
 public:
  explicit Attention(const py::object& listener) : listener_(listener) {}

  /// @return whether to go on. @throws py::error_already_set
  bool operator()(std::size_t done, std::size_t total) {
    if (interpreter_ends()) return false;
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const std::pair news{done, total};
    if (listener_.is_none() || news == last_) return true;
    last_ = news;
    const py::object answer = listener_(done, total);
    return answer.is_none() || py::bool_(answer);
  }

 private:
  const py::object& listener_;
  std::pair<std::size_t, std::size_t> last_{0, 0};
};

}  // namespace

void do_long_work(const std::function<void(const Progress& progress)>& work,
                  const py::object& listener) {
  const py::gil_scoped_release unlocked;
  try {
    do_attended(work, Attention(listener));
  } catch (...) {
    stay_while_interpreter_ends();
    throw;
  }
  stay_while_interpreter_ends();
}

}  // namespace microslip::python
