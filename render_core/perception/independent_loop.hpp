/// Says before a loop that no turn of it reads what another one writes, so that the compiler may take several turns at once
/// without proving it.
#pragma once

#if defined(__clang__)
#define TEDAVIS_INDEPENDENT_LOOP _Pragma("clang loop vectorize(assume_safety)")
#else
#define TEDAVIS_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#endif
