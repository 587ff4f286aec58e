#include "host_sim/measure/picture_difference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host_sim/measure/color_difference.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::vector<Lab> lab_picture(const RgbaView& view) {
    std::vector<Lab> all;
    all.reserve(std::size_t{view.width} * view.height);
    for (std::uint32_t y = 0; y < view.height; ++y) {
        const std::uint8_t* const row = view.row(y);
        for (std::uint32_t x = 0; x < view.width; ++x) {
            const std::uint8_t* const p = row + std::size_t{x} * 4;
            const bool is_as_before = x > 0 && std::equal(p, p + 3, p - 4);
            const Lab last = is_as_before ? all.back() : lab_of(linear_rgb({p[0], p[1], p[2]}));
            all.push_back(last);
        }
    }
    return all;
}

/// Of lightness; the picture goes on beyond its border as it ends there.
class Gradient {
public:
    Gradient(const std::vector<Lab>& lab, std::uint32_t width, std::uint32_t height)
        : lab_(lab), width_(width), height_(height) {}
    [[nodiscard]] double length(std::int64_t x, std::int64_t y) const {
        const auto at = [&](std::int64_t dx, std::int64_t dy) { return lightness(x + dx, y + dy); };
        const double across = at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
        const double down = at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
        return std::hypot(across, down) / 8;
    }

private:
    [[nodiscard]] double lightness(std::int64_t x, std::int64_t y) const {
        const auto column = static_cast<std::size_t>(std::clamp<std::int64_t>(x, 0, std::int64_t{width_} - 1));
        const auto row = static_cast<std::size_t>(std::clamp<std::int64_t>(y, 0, std::int64_t{height_} - 1));
        return lab_[row * width_ + column].lightness;
    }
    const std::vector<Lab>& lab_;
    std::uint32_t width_, height_;
};

bool is_equal(const Lab& a, const Lab& b) { return a.lightness == b.lightness && a.a == b.a && a.b == b.b; }

}  // namespace

PictureDifference picture_difference(const RgbaView& first, const RgbaView& second) {
    if (first.width != second.width || first.height != second.height)
        throw UserError("pictures of different sizes cannot be compared; draw both in one size");
    const std::vector<Lab> a = lab_picture(first), b = lab_picture(second);
    const Gradient of_a(a, first.width, first.height), of_b(b, first.width, first.height);
    PictureDifference sum;
    for (std::size_t n = 0; n < a.size(); ++n) {
        const double difference = is_equal(a[n], b[n]) ? 0 : color_difference(a[n], b[n]);
        sum.mean += difference;
        sum.largest = std::max(sum.largest, difference);
        const auto x = static_cast<std::int64_t>(n % first.width), y = static_cast<std::int64_t>(n / first.width);
        sum.edges += std::abs(of_a.length(x, y) - of_b.length(x, y));
    }
    const double pixels = std::max<double>(static_cast<double>(a.size()), 1);
    return {sum.mean / pixels, sum.largest, sum.edges / pixels};
}

}  // namespace tedavis::host_sim
