// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// One binary for any x86-64: the compiler makes a function marked so for several vector widths,
/// and the loader picks the widest that the processor supports. Not under sanitizers, which are not
/// set up yet at that time, nor with the CMake option MICROSLIP_VECTOR_CLONES off. Internal to the
/// library.

#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(MICROSLIP_NO_VECTOR_CLONES)
#define MICROSLIP_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define MICROSLIP_VECTOR_CLONES
#endif
