// SPDX-License-Identifier: MIT
#include "microslip/identify/assemblies/assemblies_options.hpp"

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestDrawsOfAssemblies = 100;

}  // namespace

void AssembliesOptions::check() const {
  if (coefficients < 10) throw InputError("coefficients", coefficients, "must be 10 or more");
  if (draws < kFewestDrawsOfAssemblies) {
    throw InputError("number of draws", static_cast<double>(draws), "must be 100 or more",
                     "1000 give smooth bands.");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw InputError("confidence", confidence, "must be between 0 and 1");
  }
}

}  // namespace microslip
