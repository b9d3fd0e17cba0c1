// SPDX-License-Identifier: MIT
#include "microslip/algebra/core.hpp"
#undef MICROSLIP_INSTANCE
#define MICROSLIP_INSTANCE
#include "microslip/algebra/lu.hpp"
