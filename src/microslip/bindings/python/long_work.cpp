// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/long_work.hpp"

#include <cstddef>
#include <utility>

#include "microslip/base/attended_work.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// Signals, and the listener where there is news.
class Attention {
 public:
  explicit Attention(const py::object& listener) : listener_(listener) {}

  /// @return whether to go on. @throws py::error_already_set
  bool operator()(std::size_t done, std::size_t total) {
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
  do_attended(work, Attention(listener));
}

}  // namespace microslip::python
