#include "host_sim/terrain_builder/tdb_image.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/built_database.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::ChunkEntry;
using terrain::ChunkIndex;
using terrain::ChunkVertex;
using test_support::BuiltDatabase;

Raster with_hole() {
    Raster raster = test_support::make_rough_raster(129, 129);
    for (std::uint32_t j = 40; j < 60; ++j) {
        for (std::uint32_t i = 50; i < 75; ++i) {
            raster.height_m[raster.at(i, j)] = NAN;
            raster.post_class[raster.at(i, j)] = terrain::PostClass::void_;
        }
    }
    raster.void_posts = 20 * 25;
    return raster;
}

TEST(TdbImage, SharedVerticesAreBitEqualInEveryChunkThatHasThem) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 193));
    std::map<test_support::LatticePost, std::array<double, 3>> positions;
    std::size_t shared = 0;
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk) {
        const ChunkEntry& e = built.database.entry(chunk);
        const std::int64_t side = std::int64_t{terrain::kChunkCells} << e.level;
        for (const ChunkVertex& v : built.vertices(chunk)) {
            const std::array<double, 3> p{e.centre_m[0] + v.x, e.centre_m[1] + v.y, e.centre_m[2] + v.z};
            const auto [found, inserted] = positions.try_emplace({e.i * side + v.i, e.j * side + v.j}, p);
            EXPECT_EQ(found->second, p);
            shared += inserted ? 0 : 1;
        }
    }
    EXPECT_GT(shared, 1000u);
}

// Oracle: the geodetic formula of each post, in double; a vertex is on a grid of at most a centimetre at this size.
TEST(TdbImage, VerticesLieWhereTheirPostsAre) {
    const Raster raster = test_support::make_rough_raster(129, 97);
    const BuiltDatabase built(raster);
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk) {
        const ChunkEntry& e = built.database.entry(chunk);
        const std::int64_t side = std::int64_t{terrain::kChunkCells} << e.level;
        for (const ChunkVertex& v : built.vertices(chunk)) {
            const auto i = static_cast<std::uint32_t>(e.i * side + v.i), j = static_cast<std::uint32_t>(e.j * side + v.j);
            if (i >= raster.columns || j >= raster.rows) continue;
            const double latitude = base::radians(raster.north_deg - raster.step_lat_deg * j),
                         longitude = base::radians(raster.west_deg + raster.step_lon_deg * i);
            const double msl_m = raster.height_m[raster.at(i, j)];
            const auto undulation = built.database.undulation(latitude, longitude);
            const glm::dvec3 expected = earth::to_ecef({latitude, longitude, earth::to_ellipsoid({msl_m}, undulation)});
            const glm::dvec3 stored(e.centre_m[0] + v.x, e.centre_m[1] + v.y, e.centre_m[2] + v.z);
            EXPECT_LT(glm::length(stored - expected), 0.01) << i << "," << j;
            EXPECT_EQ(v.height_m, raster.height_m[raster.at(i, j)]);
        }
    }
}

TEST(TdbImage, LevelZeroIsTheTrueSurfaceAndCoarserLevelsKeepTheirTolerance) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 257));
    const auto& h = built.database.header();
    ASSERT_GE(h.levels, 3u);
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk) {
        const ChunkEntry& e = built.database.entry(chunk);
        const std::uint32_t cells = terrain::kChunkCells << e.level;
        EXPECT_LE(e.above_m, h.tolerance_m[e.level] + 0.02f);
        EXPECT_LE(e.below_m, h.tolerance_m[e.level] + 0.02f);
        EXPECT_LE(std::max(e.above_m, e.below_m), e.bound_m + 0.001f);
        EXPECT_LE(e.triangle_count, 2 * cells * cells - (e.level > 0 ? 1 : 0));
    }
}

TEST(TdbImage, ChunksWithVoidsSaySo) {
    const BuiltDatabase hole(with_hole());
    EXPECT_EQ(hole.database.header().void_posts, 500u);
    const BuiltDatabase whole(test_support::make_rough_raster(129, 129));
    std::uint32_t flagged = 0, flagged_whole = 0;
    for (ChunkIndex chunk = 0; chunk < hole.database.chunk_count(); ++chunk) {
        flagged += hole.database.entry(chunk).flags & terrain::kChunkHasVoid;
        flagged_whole += whole.database.entry(chunk).flags & terrain::kChunkHasVoid;
    }
    EXPECT_GT(flagged, 0u);
    EXPECT_EQ(flagged_whole, 0u);
}

TEST(TdbImage, KeepsWhatTheOptionsSayOfTheSource) {
    BuildOptions options;
    options.le90_m = 16;
    options.vertical_datum = VerticalDatum::ellipsoid;
    const std::vector<std::uint8_t> image = make_tdb(make_model(test_support::make_rough_raster(40, 40), options), options);
    terrain::FileHeader header;
    std::memcpy(&header, image.data(), sizeof header);
    EXPECT_EQ(header.le90_m, 16.0f);
    EXPECT_STREQ(header.vertical_datum, "ellipsoid");
    EXPECT_STREQ(header.source, "synthetic");
    EXPECT_EQ(header.file_bytes, image.size());
}

TEST(TdbImage, SaysHowFarItIsAndStopsWhenToldTo) {
    struct Stop {};
    std::uint64_t calls = 0, last = 0, total = 0;
    BuildOptions options;
    options.progress = [&](std::uint64_t done, std::uint64_t all) {
        ++calls;
        last = done;
        total = all;
    };
    const TerrainModel model = make_model(test_support::make_rough_raster(129, 129), options);
    (void)make_tdb(model, options);
    EXPECT_GT(calls, 10u);
    EXPECT_EQ(last, total);
    options.progress = [](std::uint64_t done, std::uint64_t) {
        if (done > 3) throw Stop{};
    };
    EXPECT_THROW((void)make_tdb(model, options), Stop);
}

}  // namespace
}  // namespace tedavis::host_sim
