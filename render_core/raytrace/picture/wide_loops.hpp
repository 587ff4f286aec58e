/// Plain loops over arrays, compiled also for the wider vectors of x86; which are taken is found out when the program is loaded.
/// Bits are the same: nothing is fused or reordered.
#pragma once

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TEDAVIS_WIDE_LOOPS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define TEDAVIS_WIDE_LOOPS
#endif
