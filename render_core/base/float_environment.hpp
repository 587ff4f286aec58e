/// What all arithmetic of this program relies on, for the calling thread: IEEE 754 with denormal numbers, rounding to nearest,
/// NaN, and no fused operations. A driver or a library in the same process can change it; then the same flight gives other
/// pictures.
///
/// Compilers are held to it by -ffp-contract=off and, in what includes this header, by the lines below. The control state of the
/// processor is set at the start of the program and of each thread that computes, and looked at before every frame. After
/// Goldberg, "What Every Computer Scientist Should Know About Floating-Point Arithmetic", ACM Computing Surveys 1991; IEEE
/// 754-2019, sections 4.3 and 7.
///
/// Memory  none. Thread  any; the state is the calling thread's. Failure  see FloatFault.
#pragma once

#include <cstdint>
#include <string_view>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this program needs IEEE 754 arithmetic: compile without -ffast-math and -ffinite-math-only"
#endif

namespace tedavis::base {

/// What does not hold; the first one that is found.
enum class FloatFault : std::uint8_t {
    none,
    rounding,         ///< results are not rounded to nearest
    denormal_inputs,  ///< denormal numbers are read as 0
    tiny_results,     ///< results below the least normal number become 0
    nan,              ///< a NaN is not recognized
    fused,            ///< a product and a sum are computed in one operation
};

/// Sets the control state of the calling thread to IEEE 754's defaults: to nearest, with denormal numbers, without traps.
void set_float_environment() noexcept;

/// Finds out by some twenty operations what holds for the calling thread. Traps are not looked at.
[[nodiscard]] FloatFault float_fault() noexcept;

/// "arithmetic is that of IEEE 754" where there is none; else what is wrong, as a clause.
[[nodiscard]] std::string_view words_of(FloatFault fault) noexcept;

}  // namespace tedavis::base
