// SPDX-License-Identifier: MIT
#pragma once

// For programs that include what files say of their origin by the name that its header had.
#include "microslip/io/provenance.hpp"
