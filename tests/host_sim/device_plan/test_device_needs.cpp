#include "host_sim/device_plan/device_needs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "host_sim/terrain_builder/fractal_geotiff.hpp"
#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "platform/files/file_byte_source.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_device_needs {
namespace {

using design::BakedMap;

struct DeviceNeedsTest : ::testing::Test {
    test_support::TemporaryFolder folder;
    PictureOptions options;

    std::string terrain() {
        const std::string raster = folder.file("t.tif");
        std::string database = folder.file("t.tdb");
        write_fractal_geotiff(raster, 129, 3, FractalNumbers::int16);
        build_terrain(PostReaderFactory(
                          [&raster] { return std::make_unique<PostSource>(std::vector<std::string>{raster}, RasterOptions{}); }),
                      database, {});
        return database;
    }
};

TEST_F(DeviceNeedsTest, DesignsStateTheirMaps) {
    options.design = folder.write("plain.toml", "name = 'plain'\n[view]\n");
    const DeviceNeeds plain = device_needs(options);
    EXPECT_FALSE(plain.has_drape || plain.has_shadows || plain.is_traced || plain.measures_clutter ||
                 plain.maps.has(BakedMap::horizon));
    EXPECT_TRUE(plain.has_coast) << "the terrain is not known";
    options.design = folder.write(
        "full.toml", "name = 'full'\n[view]\n[terrain.texture]\ntechnique = 'image'\n[terrain.shade]\ncast_shadows = true\n");
    const DeviceNeeds full = device_needs(options);
    EXPECT_TRUE(full.has_drape && full.maps.has(BakedMap::horizon));
    EXPECT_FALSE(full.terrain || full.scene_file_bytes);
    for (const char* const renderer : {"trace", "auto"}) {
        options.design = folder.write("rays.toml", std::string("name = 'rays'\n[terrain]\nrenderer = '") + renderer + "'\n");
        EXPECT_TRUE(device_needs(options).is_traced) << renderer;
    }
    for (const char* const name : {"effects/clutter_budget", "default"}) {
        options.design = name;
        EXPECT_EQ(device_needs(options).measures_clutter, options.design != "default") << name;
    }
}

TEST_F(DeviceNeedsTest, TerrainAndSceneAreMeasured) {
    options.design = folder.write("image.toml", "name = 'image'\n[view]\n[terrain.texture]\ntechnique = 'image'\n");
    options.terrain = terrain();
    options.scene = folder.write("s.sdb", [] {
        SceneDraft draft;
        draft.layers = {test_support::small_grid()};
        const std::vector<std::uint8_t> bytes = sdb_bytes(draft);
        return std::string(bytes.begin(), bytes.end());
    }());
    const DeviceNeeds needs = device_needs(options);
    ASSERT_TRUE(needs.terrain && needs.scene_file_bytes);
    EXPECT_EQ(*needs.scene_file_bytes, std::filesystem::file_size(options.scene));
    const OpenDatabase open(options.terrain);
    EXPECT_EQ(needs.terrain->roots, open.database().root_count());
    std::vector<unsigned char> block(std::size_t{1} << 20);
    base::Arena arena(block.data(), block.size());
    auto file = platform::open_file(options.terrain.c_str());
    ASSERT_TRUE(file.ok() && terrain::TerrainDatabase::open(file.value(), arena).ok());
    EXPECT_GE(arena.use().in_use, needs.terrain->table_bytes);
    EXPECT_LE(arena.use().in_use, needs.terrain->table_bytes + 16) << "but for what alignment takes";
    EXPECT_FALSE(needs.has_drape) << "the database has no image";
}

TEST_F(DeviceNeedsTest, FilesThatAreNoneAreRefused) {
    options.terrain = folder.write("x.tdb", "none");
    test_support::expect_user_error([&] { static_cast<void>(device_needs(options)); }, "x.tdb: ");
    options.terrain.clear();
    options.scene = folder.write("x.sdb", "none");
    test_support::expect_user_error([&] { static_cast<void>(device_needs(options)); }, "x.sdb: ");
    options.scene.clear();
    options.design = "none";
    test_support::expect_user_error([&] { static_cast<void>(device_needs(options)); }, "none");
}

}  // namespace
}  // namespace tedavis::host_sim::test_device_needs
