// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/units.hpp"

namespace microslip {

/// Name of a column of a table, without its unit, and its quantity.
struct TableColumn {
  std::string name;     ///< "displacement", "force at tip", "acceleration of table", "lap force"
  Dimension dimension;  ///< of its values
};

}  // namespace microslip
