/// Weights of a sampled Gaussian in 256ths, for sums without rounding.
#pragma once

#include <array>
#include <cstdint>

namespace tedavis::perception {

inline constexpr double kMaxSigma = 3;
inline constexpr int kMaxRadius = 9;

/// Symmetric: `at[k]` is that of both neighbours k away; at[0] + 2 (at[1] + ... + at[radius]) = 256.
struct GaussianWeights {
    int radius = 0;
    std::array<std::uint16_t, kMaxRadius + 1> at{256};
};

/// Cut at three sigma; what rounding leaves goes to the next weight inwards, and so to the middle, as OpenCV does for eight bits.
/// Sigma 0 (nothing is blurred) to kMaxSigma, beyond which it is cut.
[[nodiscard]] GaussianWeights gaussian_weights(double sigma) noexcept;

}  // namespace tedavis::perception
