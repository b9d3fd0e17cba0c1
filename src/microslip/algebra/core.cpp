// SPDX-License-Identifier: MIT
#include "microslip/algebra/instance.hpp"
#undef MICROSLIP_INSTANCE
#define MICROSLIP_INSTANCE
#include "microslip/algebra/core.hpp"
