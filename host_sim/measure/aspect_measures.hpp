/// Measures of the aspects in a picture, counted in pixels: edges of the ground, and distinct colours of the data.
#pragma once

#include <cstdint>

#include "host_sim/png_file.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::host_sim {

/// The measures of one picture of a contact sheet.
struct AspectMeasures {
    double edge_density = 0;        ///< of its terrain, drawn without data
    std::uint32_t data_colors = 0;  ///< of its data on the ground, drawn over a plain ground
    std::uint32_t glyphs = 0;       ///< of all elements
};

/// Returns the share of the pixels at which lightness changes by more than 0.5 L* per pixel (Sobel).
[[nodiscard]] double edge_density(const RgbaView& picture);
/// Returns the number of distinct colours of the pixels that have the colour `ground` in `without` and another one in `picture`.
/// Throws UserError where the sizes differ.
[[nodiscard]] std::uint32_t distinct_colors(const RgbaView& picture, const RgbaView& without, design::Color ground);

}  // namespace tedavis::host_sim
