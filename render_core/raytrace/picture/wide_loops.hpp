/// Compiles loops over arrays also for the wider vectors of x86; the variant is selected when the program is loaded. All
/// variants give the same bits: operations are neither fused nor reordered.
#pragma once

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TEDAVIS_WIDE_LOOPS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define TEDAVIS_WIDE_LOOPS
#endif
