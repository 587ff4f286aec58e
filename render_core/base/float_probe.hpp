/// The probes of float_environment.hpp, in a header of their own so that a test can compile them with a compiler's leave to break
/// the rules. Operands are volatile: the processor computes, not the compiler.
#pragma once

#include <cmath>
#include <limits>

namespace tedavis::base::float_probe {

/// A quarter and three quarters of the last place, on both sides of 0: each other way of rounding gets one of the four wrong.
static inline bool rounds_to_nearest() {
    constexpr double kStep = std::numeric_limits<double>::epsilon();
    const volatile double one = 1, quarter = kStep / 4, three_quarters = 3 * kStep / 4;
    return one + quarter == 1 && one + three_quarters == 1 + kStep && -one - quarter == -1 &&
           -one - three_quarters == -(1 + kStep);
}

static inline bool reads_denormals() {
    const volatile float tiny = std::numeric_limits<float>::min() / 2;
    const volatile double tiny_double = std::numeric_limits<double>::min() / 2;
    const volatile float twice = tiny * 2;
    const volatile double twice_double = tiny_double * 2;
    return twice == std::numeric_limits<float>::min() && twice_double == std::numeric_limits<double>::min();
}

static inline bool keeps_tiny_results() {
    const volatile float least = std::numeric_limits<float>::min();
    const volatile double least_double = std::numeric_limits<double>::min();
    const volatile float half = least / 2;
    const volatile double half_double = least_double / 2;
    return half > 0 && half_double > 0;
}

static inline bool knows_nan() {
    const volatile double nothing = std::numeric_limits<double>::quiet_NaN();
    const double read = nothing;
    return std::isnan(read) && !(read == read) && !(read < 1) && !(read >= 1);
}

/// The square of 1 + 2^-27 has one bit more than a double holds; a fused operation keeps it.
static inline bool rounds_products() {
    const volatile double root = 1 + 0x1p-27, rounded_square = 1 + 0x1p-26;
    const double a = root, b = rounded_square;
    return a * a - b == 0;
}

}  // namespace tedavis::base::float_probe
