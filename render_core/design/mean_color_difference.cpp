#include "render_core/design/mean_color_difference.hpp"

#include <algorithm>
#include <cstring>

#include "render_core/design/color_difference.hpp"

namespace tedavis::design {
namespace {

constexpr std::size_t kPixelBytes = 4, kColorBytes = 3;

double difference_of(const std::uint8_t* first, const std::uint8_t* second) {
    if (std::memcmp(first, second, kColorBytes) == 0) return 0;
    return color_difference(lab_of(linear_rgb({first[0], first[1], first[2]})),
                            lab_of(linear_rgb({second[0], second[1], second[2]})));
}

}  // namespace

double mean_color_difference(base::Span<const std::uint8_t> first, base::Span<const std::uint8_t> second) noexcept {
    const std::size_t pixels = std::min(first.size(), second.size()) / kPixelBytes;
    double sum = 0, last = 0;
    for (std::size_t n = 0; n < pixels; ++n) {
        const std::uint8_t* const a = first.data() + n * kPixelBytes;
        const std::uint8_t* const b = second.data() + n * kPixelBytes;
        const bool is_as_before =
            n > 0 && std::memcmp(a, a - kPixelBytes, kColorBytes) == 0 && std::memcmp(b, b - kPixelBytes, kColorBytes) == 0;
        if (!is_as_before) last = difference_of(a, b);
        sum += last;
    }
    return pixels == 0 ? 0 : sum / static_cast<double>(pixels);
}

}  // namespace tedavis::design
