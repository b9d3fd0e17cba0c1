// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace microslip {

/// Progress callback of a long computation: `done` of `total` pieces are finished. Returns true to
/// continue; on false the computation throws Cancelled and leaves nothing behind. It may be called
/// from any thread, but never by two at once. An empty function disables reporting.
using Progress = std::function<bool(std::size_t done, std::size_t total)>;

}  // namespace microslip
