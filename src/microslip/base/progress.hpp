// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// Told now and then by a long computation how far it is: `done` of `total` pieces. Returns true to
/// go on; on false the computation throws Cancelled and leaves nothing behind. It may be called
/// from any thread, but never by two at once. An empty function means: nobody listens.
using Progress = std::function<bool(std::size_t done, std::size_t total)>;

}  // namespace microslip
