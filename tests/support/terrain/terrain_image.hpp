/// Terrain databases from rasters in memory, as the bytes of the file that the builder writes.
#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_support {

/// A raster in memory as the builder reads one. The raster must live as long.
class RasterPosts final : public host_sim::PostReader {
public:
    explicit RasterPosts(const host_sim::Raster& raster) : raster_(raster) {}

    [[nodiscard]] const host_sim::PostGrid& grid() const override { return raster_; }
    void read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
              base::Span<terrain::PostClass> classes) override {
        for (std::uint32_t b = 0; b < rows; ++b)
            for (std::uint32_t a = 0; a < columns; ++a) {
                heights_m[std::size_t{b} * columns + a] = raster_.height_m[raster_.at(i + a, j + b)];
                classes[std::size_t{b} * columns + a] = raster_.post_class[raster_.at(i + a, j + b)];
            }
    }

private:
    const host_sim::Raster& raster_;
};

inline host_sim::PostReaderFactory posts_of(const host_sim::Raster& raster) {
    return [&raster] { return std::make_unique<RasterPosts>(raster); };
}

inline std::vector<std::uint8_t> build_image(const host_sim::TerrainSources& sources,
                                             const host_sim::BuildOptions& options = {}) {
    const TemporaryFolder folder;
    host_sim::build_terrain(sources, folder.file("t.tdb"), options);
    std::ifstream file(folder.file("t.tdb"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}
inline std::vector<std::uint8_t> build_image(const host_sim::PostReaderFactory& open,
                                             const host_sim::BuildOptions& options = {}) {
    return build_image(host_sim::TerrainSources(open), options);
}
inline std::vector<std::uint8_t> build_image(const host_sim::Raster& raster, const host_sim::BuildOptions& options = {}) {
    return build_image(posts_of(raster), options);
}
inline std::vector<std::uint8_t> build_image_of_file(const std::string& raster, const host_sim::BuildOptions& options = {}) {
    return build_image(host_sim::PostReaderFactory([&raster] {
                           return std::make_unique<host_sim::PostSource>(std::vector<std::string>{raster},
                                                                         host_sim::RasterOptions());
                       }),
                       options);
}

}  // namespace tedavis::test_support
