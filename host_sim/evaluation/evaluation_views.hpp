/// Draws the measured values: saliency as grey and as colours over the picture, edges, and clutter by regions.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/perception/edge_density.hpp"

namespace tedavis::host_sim {

/// A map of a picture, rows from the top: each value is that of a cell of pixels; the last cells may extend beyond the picture.
struct FloatMap {
    std::uint32_t width = 0, height = 0;
    float cell_width = 1, cell_height = 1;  ///< size of a cell in pixels of the picture
    std::vector<float> values;              ///< 0..1

    [[nodiscard]] float at(std::uint32_t x, std::uint32_t y) const { return values[std::size_t{y} * width + x]; }
};

/// Returns a value for each pixel of the picture, interpolated bilinearly between the centres of the cells.
[[nodiscard]] FloatMap enlarged(const FloatMap& map, std::uint32_t picture_width, std::uint32_t picture_height);

/// Returns the colour of a value of 0..1: black, purple, red, yellow, with increasing lightness, so that it can be read without
/// hues as well.
[[nodiscard]] std::array<std::uint8_t, 3> heat_color(float value);

/// Draws a map in grey; 1 is white.
[[nodiscard]] RgbaPicture saliency_picture(const FloatMap& map);
/// Draws the colours of the map over the picture in dim grey; the map has the picture's size.
[[nodiscard]] RgbaPicture heat_picture(const RgbaPicture& picture, const FloatMap& map);
/// Draws edges white on black. `edges` has one byte per pixel, not 0 at edges.
[[nodiscard]] RgbaPicture edge_picture(const std::vector<std::uint8_t>& edges, std::uint32_t width, std::uint32_t height);
/// Draws the picture in dim grey, with each region tinted by its density and labelled with the number. `densities` are row by
/// row.
[[nodiscard]] RgbaPicture region_picture(const RgbaPicture& picture, const perception::RegionGrid& grid,
                                         const std::vector<double>& densities);

}  // namespace tedavis::host_sim
