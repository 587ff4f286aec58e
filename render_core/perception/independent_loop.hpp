/// Says before a loop that no turn of it reads what another one writes, so that GCC may take several turns at once without
/// proving it. Other compilers look for themselves.
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
#define TEDAVIS_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#else
#define TEDAVIS_INDEPENDENT_LOOP
#endif
