/// A picture as the eye weighs it: L*a*b* of every pixel, and how steep its lightness is.
#pragma once

#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim {

class LabPicture {
public:
    /// Alpha is not looked at.
    explicit LabPicture(const RgbaView& view);

    [[nodiscard]] const design::Lab& at(std::uint32_t x, std::uint32_t y) const { return lab_[std::size_t{y} * width_ + x]; }
    /// Of lightness (Sobel), in L* a pixel; the picture goes on beyond its border as it ends there.
    [[nodiscard]] double gradient(std::uint32_t x, std::uint32_t y) const;

private:
    [[nodiscard]] double lightness(std::int64_t x, std::int64_t y) const;

    std::vector<design::Lab> lab_;
    std::uint32_t width_, height_;
};

}  // namespace tedavis::host_sim
