// SPDX-License-Identifier: MIT
#pragma once

// For programs that include beyond_identification() by the name that its header had.
#include "microslip/joint/covered_range.hpp"
