#include "host_sim/scene_builder/open_scene.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_open_scene {
namespace {

using test_support::expect_user_error;

TEST(OpenScene, HoldsWhatWasWritten) {
    const test_support::TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes = sdb_bytes(test_support::small_scene());
    const std::string sound(bytes.begin(), bytes.end());
    const OpenScene open(folder.write("s.sdb", sound));
    EXPECT_STREQ(open.scene().header().name, "small");
    ASSERT_EQ(open.scene().layers().size(), 4u);
    EXPECT_EQ(open.scene().find("masts")->name_of(0), "Mast A");
    EXPECT_EQ(open.scene().find("air")->find("temperature")->values[47], 307);
    const scene::Layer* const zones = open.scene().find("zones");
    EXPECT_EQ(zones->points_of(1).count, 4u);
}

TEST(OpenScene, TheLargestNumberOfLayersAndAttributesFits) {
    SceneDraft draft;
    draft.name = "many";
    for (std::uint32_t n = 0; n < scene::kMaxLayers; ++n) {
        LayerDraft layer = test_support::small_points();
        layer.name += std::to_string(n);
        layer.attributes.resize(3, layer.attributes[0]);
        for (std::size_t a = 0; a < 3; ++a) layer.attributes[a].name += std::to_string(a);
        draft.layers.push_back(layer);
    }
    const std::vector<std::uint8_t> bytes = sdb_bytes(draft);
    const test_support::TemporaryFolder folder;
    const OpenScene open(folder.write("m.sdb", std::string(bytes.begin(), bytes.end())));
    EXPECT_EQ(open.scene().layers().size(), scene::kMaxLayers);
}

TEST(OpenScene, FaultsAreSentences) {
    const test_support::TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes = sdb_bytes(test_support::small_scene());
    std::string damaged(bytes.begin(), bytes.end());
    expect_user_error([&] { const OpenScene open(folder.file("none.sdb")); }, "none.sdb");
    expect_user_error([&] { const OpenScene open(folder.path()); }, folder.path());
    expect_user_error([&] { const OpenScene open(folder.write("e.sdb", "")); }, "e.sdb: is not a scene database (offset 0)");
    expect_user_error([&] { const OpenScene open(folder.write("c.sdb", damaged.substr(0, damaged.size() - 9))); },
                      "c.sdb: is not as long as its header says");
    damaged[damaged.size() - 3] ^= 1;
    expect_user_error([&] { const OpenScene open(folder.write("d.sdb", damaged)); }, "d.sdb: is damaged (offset ");
}

}  // namespace
}  // namespace tedavis::host_sim::test_open_scene
