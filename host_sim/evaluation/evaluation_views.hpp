/// Pictures of what was measured: saliency as grey and as heat over the picture, edges, and clutter by regions.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/perception/edge_density.hpp"

namespace tedavis::host_sim {

/// A map over a picture, rows from the top: each value stands for some of its pixels, of which the last ones may reach beyond it.
struct FloatMap {
    std::uint32_t width = 0, height = 0;
    float cell_width = 1, cell_height = 1;  ///< pixels of the picture that a value stands for
    std::vector<float> values;              ///< 0..1

    [[nodiscard]] float at(std::uint32_t x, std::uint32_t y) const { return values[std::size_t{y} * width + x]; }
};

/// A value for each of the picture's pixels, bilinearly between the middles of the cells.
[[nodiscard]] FloatMap enlarged(const FloatMap& map, std::uint32_t picture_width, std::uint32_t picture_height);

/// Of a value of 0..1: black, purple, red, yellow, ever lighter, so that it reads without hues as well.
[[nodiscard]] std::array<std::uint8_t, 3> heat_color(float value);

/// White is 1.
[[nodiscard]] RgbaPicture saliency_picture(const FloatMap& map);
/// The picture in dim grey, under the map's colours; the map has the picture's size.
[[nodiscard]] RgbaPicture heat_picture(const RgbaPicture& picture, const FloatMap& map);
/// White on black; a byte a pixel, not 0 for edges.
[[nodiscard]] RgbaPicture edge_picture(const std::vector<std::uint8_t>& edges, std::uint32_t width, std::uint32_t height);
/// The picture in dim grey; each region tinted by its density, with the number in it. `densities` row by row.
[[nodiscard]] RgbaPicture region_picture(const RgbaPicture& picture, const perception::RegionGrid& grid,
                                         const std::vector<double>& densities);

}  // namespace tedavis::host_sim
