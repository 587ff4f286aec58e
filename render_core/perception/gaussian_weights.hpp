/// Weights of a sampled Gaussian in 256ths, for sums without rounding.
#pragma once

#include <array>
#include <cstdint>

namespace tedavis::perception {

inline constexpr double kMaxSigma = 3;
inline constexpr int kMaxRadius = 9;

/// Symmetric weights: `at[k]` is that of both neighbours at distance k; at[0] + 2 (at[1] + ... + at[radius]) = 256.
struct GaussianWeights {
    int radius = 0;
    std::array<std::uint16_t, kMaxRadius + 1> at{256};
};

/// Returns weights cut at three sigma. Rounding errors are carried to the next weight inwards and end in the middle, as OpenCV
/// does for eight bits. Sigma is 0 (no blur) .. kMaxSigma; larger values are clamped.
[[nodiscard]] GaussianWeights gaussian_weights(double sigma) noexcept;

}  // namespace tedavis::perception
