// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/long_work.hpp"

#include <atomic>
#include <cstddef>
#include <ctime>
#include <utility>

#include "microslip/base/attended_work.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

// A thread that nobody waits for may still work while the interpreter ends. Work is then stopped
// and waited for, as the data that it uses are destroyed next. Its thread must never return: Python
// ends a thread that asks for the lock of an ended interpreter without unwinding C++.
std::atomic<bool> interpreter_ends = false;
std::atomic<int> working = 0;

void sleep_for_a_while() {
  constexpr std::timespec kWhile{0, 5'000'000};
  ::nanosleep(&kWhile, nullptr);
}

void stay_while_interpreter_ends() {
  while (interpreter_ends) sleep_for_a_while();
}

/// A piece of work that is waited for.
struct Working {
  Working() { ++working; }
  ~Working() { --working; }
  Working(const Working&) = delete;
  Working& operator=(const Working&) = delete;
};

/// Handles signals, and calls the listener where there is progress.
class Attention {
 public:
  explicit Attention(const py::object& listener) : listener_(listener) {}

  /// @return whether to go on. @throws py::error_already_set
  bool operator()(std::size_t done, std::size_t total) {
    if (interpreter_ends) return false;
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
    const Working one;
    if (!interpreter_ends) do_attended(work, Attention(listener));
  } catch (...) {
    stay_while_interpreter_ends();
    throw;
  }
  stay_while_interpreter_ends();
}

void stop_long_work() {
  const py::gil_scoped_release unlocked;
  interpreter_ends = true;
  while (working > 0) sleep_for_a_while();
}

}  // namespace microslip::python
