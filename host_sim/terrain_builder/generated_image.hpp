/// An invented aerial picture for a terrain without a free one. It shows what an image drape looks like, and nothing that exists;
/// programs that show it must say so.
///
/// Derived from the heights: woods on slopes, lakes where the heights are level, light from the north-west, 45 degrees high.
/// Invented: districts of parcels with crops, roads between districts, villages. Equal heights give equal bits on every machine;
/// random numbers come from a counter-based hash of the place (mixing function of Steele, Lea and Flood, "Fast Splittable
/// Pseudorandom Number Generators", OOPSLA 2014).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/raster.hpp"

namespace tedavis::host_sim {

class GeneratedImage {
public:
    static constexpr int kPixelsPerPost = 4;  ///< as fine as drape pages can be

    /// The raster must outlive this object.
    explicit GeneratedImage(const Raster& raster);

    [[nodiscard]] int columns() const { return kPixelsPerPost * static_cast<int>(raster_.columns); }
    [[nodiscard]] int rows() const { return kPixelsPerPost * static_cast<int>(raster_.rows); }
    /// RGB of a pixel; the first kPixelsPerPost columns and rows are centred on the first post.
    [[nodiscard]] std::array<std::uint8_t, 3> pixel(int column, int row) const;

private:
    struct Ground {
        double east_m = 0, south_m = 0;  // from the first post
        double east_slope = 0, north_slope = 0;
        bool is_level = false;
    };
    [[nodiscard]] Ground ground(int column, int row) const;
    [[nodiscard]] double height(int i, int j) const;

    const Raster& raster_;
    double east_m_, south_m_;  ///< spacing of posts
};

/// Writes the picture of a height raster as a GeoTIFF. Throws UserError.
void write_generated_image(const std::string& raster, const std::string& path);

}  // namespace tedavis::host_sim
