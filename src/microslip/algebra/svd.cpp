// SPDX-License-Identifier: MIT
#include "microslip/algebra/qr.hpp"
#undef MICROSLIP_INSTANCE
#define MICROSLIP_INSTANCE
#include "microslip/algebra/svd.hpp"
