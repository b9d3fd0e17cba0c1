// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace microslip {

/// Consistent units of the input of another program.
struct ExportUnits {
  std::string_view name;       ///< as an option has it: "mm-N-t"
  double newtons;              ///< of its unit of force
  double metres;               ///< of its unit of length
  std::string_view force;      ///< "N"
  std::string_view length;     ///< "mm"
  std::string_view stiffness;  ///< "N/mm"
};

/// SI (N, m), mm-N-t (N, mm) and in-lbf (lbf, in).
[[nodiscard]] std::span<const ExportUnits> all_export_units();

/// Units by name, in capitals or not. @throws InputError  where there are none of this name.
[[nodiscard]] const ExportUnits& export_units(std::string_view name);

}  // namespace microslip
