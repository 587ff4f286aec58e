/// An invented picture of the ground from above, for a terrain of which there is no free one: it shows what an image drape looks
/// like, and nothing that exists. Whoever shows it says so.
///
/// From the heights: woods on slopes, lakes where the heights are level, a low sun from the north-west. Invented: districts of
/// parcels with crops, roads between districts, villages. Equal heights give equal bits on every machine; chance comes from a
/// counter-based hash of the place (mixing function of Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators",
/// OOPSLA 2014).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/raster.hpp"

namespace tedavis::host_sim {

class GeneratedImage {
public:
    static constexpr int kPixelsPerPost = 4;  ///< as fine as drape pages can be

    /// The raster must live as long.
    explicit GeneratedImage(const Raster& raster);

    [[nodiscard]] int columns() const { return kPixelsPerPost * static_cast<int>(raster_.columns); }
    [[nodiscard]] int rows() const { return kPixelsPerPost * static_cast<int>(raster_.rows); }
    /// RGB of a pixel; the first ones lie round the first post.
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
    double east_m_, south_m_;  ///< of a post
};

/// The picture of a height raster as a GeoTIFF. Throws UserError.
void write_generated_image(const std::string& raster, const std::string& path);

}  // namespace tedavis::host_sim
