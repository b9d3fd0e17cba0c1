// SPDX-License-Identifier: MIT
#include "microslip/algebra/cholesky.hpp"
#undef MICROSLIP_INSTANCE
#define MICROSLIP_INSTANCE
#include "microslip/algebra/qr.hpp"
