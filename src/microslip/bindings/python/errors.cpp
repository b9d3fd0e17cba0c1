// SPDX-License-Identifier: MIT
#include <exception>
#include <new>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/core.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// The classes of _errors.py, looked up when they are needed: that module does not import this one.
void raise(const char* name, const std::exception& error) {
  const py::object type = py::module_::import("microslip._errors").attr(name);
  PyErr_SetString(type.ptr(), error.what());
}

void raise_of(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise("InputError", error);
  } catch (const FormatError& error) {
    raise("FormatError", error);
  } catch (const FileError& error) {
    raise("FileError", error);
  } catch (const Cancelled& error) {
    raise("Cancelled", error);
  } catch (const Error& error) {
    raise("Error", error);
  }
}

}  // namespace

// Others, std::bad_alloc among them, pybind11 translates itself.
void add_errors(py::module_& /*core*/) { py::register_local_exception_translator(raise_of); }

}  // namespace microslip::python
