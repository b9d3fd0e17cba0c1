// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/units.hpp"

namespace microslip {

/// What a column of a table is called, without its unit, and measures.
struct TableColumn {
  std::string name;     ///< "displacement", "force at tip", "acceleration of table", "lap force"
  Dimension dimension;  ///< of its values
};

}  // namespace microslip
