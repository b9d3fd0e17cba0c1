// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Compiles a source file of C to a shared object by `cc`, the C compiler of the machine, with
/// optimisation but without fused multiply-adds, and without symbols for a debugger, the name of
/// the compiler or that of a file. The same source and compiler give the same bytes. Symbols are
/// hidden unless the source exports them.
/// @param source       C99. @param definitions  of macros: "NAME".
/// @return the bytes of the shared object.
/// @throws Error  where there is no such compiler, with its message where it refuses the source,
///                where it writes nothing, and where the system has no place for temporary files.
[[nodiscard]] std::string shared_object_of(std::string_view source,
                                           const std::vector<std::string>& definitions);

}  // namespace microslip
