/// Generated terrain of any size as the builder reads posts: one second of arc a post, from 10 E 47 N on.
#pragma once

#include "host_sim/terrain_builder/fractal_geotiff.hpp"
#include "host_sim/terrain_builder/fractal_terrain.hpp"
#include "host_sim/terrain_builder/post_reader.hpp"

namespace tedavis::test_support {

class FractalPosts final : public host_sim::PostReader {
public:
    explicit FractalPosts(std::uint32_t side) {
        grid_.columns = grid_.rows = side;
        grid_.west_deg = host_sim::kFractalWest_deg;
        grid_.north_deg = host_sim::kFractalNorth_deg;
        grid_.step_lon_deg = grid_.step_lat_deg = host_sim::kFractalStep_deg;
        grid_.source = "fractal";
    }
    [[nodiscard]] const host_sim::PostGrid& grid() const override { return grid_; }
    void read(std::uint32_t i, std::uint32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m,
              base::Span<terrain::PostClass> classes) override {
        terrain_.read(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), columns, rows, heights_m);
        for (std::size_t n = 0; n < heights_m.size(); ++n)
            classes[n] = heights_m[n] == 0 ? terrain::PostClass::sea : terrain::PostClass::land;
    }

private:
    host_sim::FractalTerrain terrain_{1};
    host_sim::PostGrid grid_;
};

inline host_sim::PostReaderFactory fractal_posts(std::uint32_t side) {
    return [side] { return std::make_unique<FractalPosts>(side); };
}

}  // namespace tedavis::test_support
