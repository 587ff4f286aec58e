/// The CIE L*a*b* color of every pixel of a picture, and the gradient of its lightness.
#pragma once

#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim {

class LabPicture {
public:
    /// Ignores alpha.
    explicit LabPicture(const RgbaView& view);

    [[nodiscard]] const design::Lab& at(std::uint32_t x, std::uint32_t y) const { return lab_[std::size_t{y} * width_ + x]; }
    /// Returns the magnitude of the lightness gradient (Sobel), in L* per pixel. Outside the picture the nearest border pixel is
    /// used.
    [[nodiscard]] double gradient(std::uint32_t x, std::uint32_t y) const;

private:
    [[nodiscard]] double lightness(std::int64_t x, std::int64_t y) const;

    std::vector<design::Lab> lab_;
    std::uint32_t width_, height_;
};

}  // namespace tedavis::host_sim
