// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <utility>

#include "microslip/base/progress.hpp"

namespace microslip::python {

/// Does the work on another thread, and waits for it here without the interpreter's lock. The
/// waiting thread answers signals, so that Ctrl-C works, and calls the listener: no other thread
/// ever needs the interpreter.
/// @param work      called with a Progress to report to; must not use Python objects.
/// @param listener  None, or called with (done, total) some ten times a second; False cancels.
/// @throws what the work throws; KeyboardInterrupt, or what the listener raised, in its place.
void do_long_work(const std::function<void(const Progress& progress)>& work,
                  const pybind11::object& listener);

/// As do_long_work(), for work with a result.
template <class Work>
[[nodiscard]] auto long_result(const Work& work, const pybind11::object& listener) {
  std::optional<decltype(work(Progress{}))> result;
  do_long_work([&](const Progress& progress) { result.emplace(work(progress)); }, listener);
  return std::move(*result);
}

/// Stops what other threads do in do_long_work() and waits for its end: when the interpreter ends.
/// They stay there.
void stop_long_work();

}  // namespace microslip::python
