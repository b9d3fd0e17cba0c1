// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <dmumps_c.h>

#include <string>

#include "microslip/base/error.hpp"

/// @file
/// MUMPS and the libraries that it brings, BLAS among them, take as long to load as the program
/// takes for all else up to its first line. `microslip modes` alone calls them: they are loaded at
/// its first call, by the name that the linker would have written into the program.

namespace microslip::app {
namespace {

using Mumps = void (*)(DMUMPS_STRUC_C*);

Mumps loaded_mumps() {
  void* library = dlopen(MICROSLIP_MUMPS, RTLD_NOW | RTLD_LOCAL);
  void* function = library == nullptr ? nullptr : dlsym(library, "dmumps_c");
  if (function == nullptr) {
    const char* reason = dlerror();
    throw Error(std::string("MUMPS, which computes the modes of matrices, cannot be loaded: ") +
                (reason == nullptr ? MICROSLIP_MUMPS : reason));
  }
  return reinterpret_cast<Mumps>(function);
}

}  // namespace
}  // namespace microslip::app

/// In place of that of the library, which the linker leaves out as nothing else of it is called.
void MUMPS_CALL dmumps_c(DMUMPS_STRUC_C* mumps) {
  static const microslip::app::Mumps call = microslip::app::loaded_mumps();
  call(mumps);
}
