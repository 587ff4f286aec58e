/// A terrain database with an image over it, built in memory from a raster and a formula of colours.
#pragma once

#include <utility>

#include "tests/support/files/image_file.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::test_support {

/// Over a raster and `margin` posts round it, `per_post` pixels to a post, the first ones centred on posts where that is 1.
inline ImageFile image_over(const host_sim::Raster& raster, int per_post, std::function<Rgba(int, int)> color, int margin = 0) {
    ImageFile image;
    const double x = raster.step_lon_deg / per_post, y = raster.step_lat_deg / per_post;
    image.transform = {raster.west_deg - margin * raster.step_lon_deg - 0.5 * x,  x, 0,
                       raster.north_deg + margin * raster.step_lat_deg + 0.5 * y, 0, -y};
    image.columns = static_cast<int>(raster.columns + 2 * static_cast<std::uint32_t>(margin)) * per_post;
    image.rows = static_cast<int>(raster.rows + 2 * static_cast<std::uint32_t>(margin)) * per_post;
    image.bands = 4;
    image.color = std::move(color);
    return image;
}

inline std::vector<std::uint8_t> draped_image(const host_sim::Raster& raster, const ImageFile& image,
                                              const host_sim::BuildOptions& options = {}) {
    const TemporaryFolder folder;
    host_sim::TerrainSources sources(posts_of(raster));
    sources.drape = host_sim::DrapeOptions{image.write(folder.file("i.tif")), {}, {}};
    return build_image(sources, options);
}

}  // namespace tedavis::test_support
