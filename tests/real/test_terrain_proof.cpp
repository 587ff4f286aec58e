// Databases of real terrain hold what they state, and a forgery of one metre is found.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/terrain_builder/terrain_check.hpp"
#include "render_core/base/hash.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"

namespace tedavis::host_sim::test_terrain_proof {
namespace {

using namespace terrain;

class RealTerrain : public ::testing::TestWithParam<const char*> {
protected:
    RealTerrain() {
        const std::string name = GetParam();
        const bool shipped = name == "default";
        const std::string file = shipped ? test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif"
                                         : test_support::real_data_dir() + "/terrain/" + name;
        RasterOptions options;
        if (name.rfind("davos", 0) == 0) options.bounds = GeoBounds{9.75, 46.6, 9.95, 46.8};
        if (name.rfind("N42", 0) == 0) options.bounds = GeoBounds{1.0, 42.5, 1.5, 43.0};  // with 2744 voids
        open_ = [file, options] { return std::make_unique<PostSource>(std::vector<std::string>{file}, options); };
        build_terrain(open_, folder_.file("t.tdb"), {});
    }
    [[nodiscard]] TerrainCheck check() const { return check_terrain(folder_.file("t.tdb"), open_, {}); }

    test_support::TemporaryFolder folder_;
    PostReaderFactory open_;
};

TEST_P(RealTerrain, HoldsWhatItStates) {
    const TerrainCheck sound = check();
    EXPECT_EQ(sound.violations, 0u);
    EXPECT_GT(sound.chunks, 100u);
}

TEST_P(RealTerrain, OneHeightChangedByAMetreIsFound) {
    std::string bytes = folder_.read("t.tdb");
    std::uint64_t page_offset = 0;
    std::size_t n = 0;
    test_support::for_entries(bytes, [&](const ChunkEntry& entry, std::uint64_t page) {
        if (entry.level == 0 && n < 40) {  // the last one wins
            page_offset = page;
            ++n;
        }
    });
    DirectoryPage page;
    std::memcpy(&page, bytes.data() + page_offset, sizeof page);
    ChunkEntry& entry = page.entries[0];
    ChunkVertex vertex;
    char* const place = bytes.data() + entry.payload.offset + 500 * sizeof vertex;
    std::memcpy(&vertex, place, sizeof vertex);
    vertex.height_m += 1;
    std::memcpy(place, &vertex, sizeof vertex);
    entry.payload.crc = base::crc32(bytes.data() + entry.payload.offset, entry.payload.bytes);
    page.crc = base::crc32(&page.level, sizeof page - offsetof(DirectoryPage, level));
    std::memcpy(bytes.data() + page_offset, &page, sizeof page);
    folder_.write("t.tdb", bytes);
    const TerrainCheck forged = check();
    EXPECT_EQ(forged.violations, 1u);
    EXPECT_NEAR(forged.worst_excess_m, 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Terrains, RealTerrain,
                         ::testing::Values("default", "davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif",
                                           "N42E001_pyrenees_andorra_srtm3.hgt.zip"),
                         [](const auto& test) {
                             return std::string(test.param).substr(0, std::string(test.param).find_first_of("_."));
                         });

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_proof
