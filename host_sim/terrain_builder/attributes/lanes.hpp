/// Four neighbouring posts at once, in the processor's vector registers. Every operation is exact IEEE arithmetic per lane:
/// the results do not depend on the machine or on how posts are grouped.
#pragma once

#include <cmath>
#include <cstring>

namespace tedavis::host_sim {

inline constexpr int kLanes = 4;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));

[[nodiscard]] inline Lanes load(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
inline void store(float* to, Lanes lanes) { std::memcpy(to, &lanes, sizeof lanes); }
[[nodiscard]] inline Lanes all(float value) { return Lanes{value, value, value, value}; }
[[nodiscard]] inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
[[nodiscard]] inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
[[nodiscard]] inline Lanes size_of(Lanes a) { return larger(a, -a); }
[[nodiscard]] inline Lanes root(Lanes a) {
    Lanes result = a;
    for (int n = 0; n < kLanes; ++n) result[n] = std::sqrt(a[n]);
    return result;
}

/// Within 2e-7 rad, odd, 0 at 0 exactly. Source of the polynomial: Abramowitz and Stegun, "Handbook of Mathematical
/// Functions", 4.4.49.
[[nodiscard]] inline Lanes arc_tangent(Lanes t) {
    constexpr float kHalfPi = 1.57079632679f;
    const Lanes size = size_of(t);
    const Lanes x = size > 1.0f ? 1.0f / size : size;
    const Lanes q = x * x;
    Lanes sum = 0.0028662257f * q - 0.0161657367f;
    sum = sum * q + 0.0429096138f;
    sum = sum * q - 0.0752896400f;
    sum = sum * q + 0.1065626393f;
    sum = sum * q - 0.1420889944f;
    sum = sum * q + 0.1999355085f;
    sum = sum * q - 0.3333314528f;
    const Lanes inner = x + x * q * sum;
    const Lanes angle = size > 1.0f ? kHalfPi - inner : inner;
    return t < 0.0f ? -angle : angle;
}

}  // namespace tedavis::host_sim
