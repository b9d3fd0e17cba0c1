// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/base/error.hpp"

namespace microslip {

/// A solver found nothing at all, so that nothing is written; ends the program with kNotConverged.
/// Where something was found, a command writes it and returns that status itself.
class NothingFound : public Error {
 public:
  using Error::Error;
};

}  // namespace microslip
