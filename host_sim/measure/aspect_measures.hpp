/// What a picture tells of each aspect, counted in pixels: how many edges the ground has, and how many colours data have.
#pragma once

#include <cstdint>

#include "host_sim/png_file.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::host_sim {

/// Of one picture of a contact sheet.
struct AspectMeasures {
    double edge_density = 0;        ///< of its terrain, drawn without data
    std::uint32_t data_colors = 0;  ///< of its data on the ground, drawn over a plain ground
    std::uint32_t glyphs = 0;       ///< of all elements
};

/// Share of the pixels at which lightness changes by more than half an L* from one pixel to the next (Sobel).
[[nodiscard]] double edge_density(const RgbaView& picture);
/// Different colours of the pixels that have the ground's colour in `without`, and another one in the picture. Throws UserError
/// where the sizes differ.
[[nodiscard]] std::uint32_t distinct_colors(const RgbaView& picture, const RgbaView& without, design::Color ground);

}  // namespace tedavis::host_sim
