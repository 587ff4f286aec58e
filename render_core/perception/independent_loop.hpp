/// Placed before a loop, states that no iteration reads what another one writes, so that GCC may vectorise it without proof.
/// Other compilers analyse the loop themselves.
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
#define TEDAVIS_INDEPENDENT_LOOP _Pragma("GCC ivdep")
#else
#define TEDAVIS_INDEPENDENT_LOOP
#endif
