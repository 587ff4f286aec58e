#include "render_core/perception/entropy.hpp"

#include <cmath>

namespace tedavis::perception {

double shannon_entropy(base::Span<const std::uint32_t> counts) noexcept {
    std::uint64_t total = 0;
    for (const std::uint32_t count : counts) total += count;
    double bits = 0;
    for (const std::uint32_t count : counts) {
        if (count == 0) continue;
        const double share = static_cast<double>(count) / static_cast<double>(total);
        bits -= share * std::log2(share);
    }
    return bits;
}

double information(std::uint64_t count, std::uint64_t total) noexcept {
    return std::log2(static_cast<double>(total + 2) / static_cast<double>(count + 1));
}

double most_information(std::uint64_t total) noexcept { return information(0, total); }

}  // namespace tedavis::perception
