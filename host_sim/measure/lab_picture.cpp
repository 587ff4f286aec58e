#include "host_sim/measure/lab_picture.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {

LabPicture::LabPicture(const RgbaView& view) : width_(view.width), height_(view.height) {
    lab_.reserve(std::size_t{width_} * height_);
    for (std::uint32_t y = 0; y < height_; ++y) {
        const std::uint8_t* const row = view.row(y);
        for (std::uint32_t x = 0; x < width_; ++x) {
            const std::uint8_t* const p = row + std::size_t{x} * 4;
            const bool is_as_before = x > 0 && std::equal(p, p + 3, p - 4);
            const design::Lab last = is_as_before ? lab_.back() : lab_of(design::linear_rgb({p[0], p[1], p[2]}));
            lab_.push_back(last);
        }
    }
}

double LabPicture::gradient(std::uint32_t x, std::uint32_t y) const {
    const auto near = [&](int dx, int dy) { return lightness(std::int64_t{x} + dx, std::int64_t{y} + dy); };
    const double across = near(1, -1) + 2 * near(1, 0) + near(1, 1) - near(-1, -1) - 2 * near(-1, 0) - near(-1, 1);
    const double down = near(-1, 1) + 2 * near(0, 1) + near(1, 1) - near(-1, -1) - 2 * near(0, -1) - near(1, -1);
    return std::hypot(across, down) / 8;
}

double LabPicture::lightness(std::int64_t x, std::int64_t y) const {
    const auto column = static_cast<std::uint32_t>(std::clamp<std::int64_t>(x, 0, std::int64_t{width_} - 1));
    const auto row = static_cast<std::uint32_t>(std::clamp<std::int64_t>(y, 0, std::int64_t{height_} - 1));
    return at(column, row).lightness;
}

}  // namespace tedavis::host_sim
