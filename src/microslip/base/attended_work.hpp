// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "microslip/base/progress.hpp"

namespace microslip {

/// Does work on a thread of its own while the calling one attends to something else, such as the
/// signals and locks of an interpreter that belong to it.
/// @param work    called with a progress callback to pass on to the functions it calls.
/// @param attend  called by the calling thread when the work first reports its progress, which
///                waits for the answer, and every 50 ms until it ends, with the last progress
///                reported; false asks the work to stop, as progress does.
/// @throws what the work throws; what `attend` throws in its place, once the work, which is then
///         asked to stop, has ended.
void do_attended(const std::function<void(const Progress& progress)>& work, const Progress& attend);

}  // namespace microslip
