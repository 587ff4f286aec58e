#include "render_core/perception/gaussian_weights.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::perception {

GaussianWeights gaussian_weights(double sigma) noexcept {
    GaussianWeights weights;
    if (!(sigma > 0)) return weights;
    const double width = std::min(sigma, kMaxSigma);
    weights.radius = static_cast<int>(6 * width + 1.5) / 2;
    std::array<double, kMaxRadius + 1> bell{};
    double sum = 0;
    for (int k = 0; k <= weights.radius; ++k) {
        bell[k] = std::exp(-k * k / (2 * width * width));
        sum += k == 0 ? bell[k] : 2 * bell[k];
    }
    int left = 256;
    double rounded_off = 0;
    for (int k = weights.radius; k > 0; --k) {
        const double exact = 256 * bell[k] / sum + rounded_off;
        weights.at[k] = static_cast<std::uint16_t>(std::lround(exact));
        rounded_off = exact - weights.at[k];
        left -= 2 * weights.at[k];
    }
    weights.at[0] = static_cast<std::uint16_t>(left);
    return weights;
}

}  // namespace tedavis::perception
