#include "render_core/draw/texel_size.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::draw::test_texel_size {
namespace {

/// At 47 N 9 E, 1200 posts a degree.
const terrain::Lattice& lattice_of_hills() {
    static const test_support::WrittenTdb written([] {
        test_support::TdbSpec spec;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 500 + 300 * std::sin(i / 9.0) * std::cos(j / 7.0); };
        return spec;
    }());
    return written.lattice();
}

TEST(TexelSize, IsTheGeodesicDistanceBetweenTexels) {
    const auto& geodesic = GeographicLib::Geodesic::WGS84();
    const terrain::Lattice& lattice = lattice_of_hills();
    for (std::uint32_t level = 1; level < lattice.levels(); ++level) {
        const terrain::ChunkKey owner{level, 0, 0};
        const terrain::PostRange posts = lattice.posts_of(owner);
        const double lat = 47 - 0.5 * (posts.j0 + posts.j1) / 1200, spacing = std::exp2(level - 1.0) / 1200;
        double east = 0, north = 0;
        geodesic.Inverse(lat, 9, lat, 9 + spacing, east);
        geodesic.Inverse(lat, 9, lat + spacing, 9, north);
        const GroundSize size = texel_size(lattice, owner);
        EXPECT_NEAR(size.east_m, east, 1e-3 * east);
        EXPECT_NEAR(size.north_m, north, 1e-3 * north);
    }
}

}  // namespace
}  // namespace tedavis::draw::test_texel_size
