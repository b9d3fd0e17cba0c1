// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/io/provenance.hpp"

/// @file
/// For programs that include what files say of their origin by the name that its header had.
