#include "host_sim/scene_builder/sdb_writer.hpp"

#include <gtest/gtest.h>

#include "host_sim/user_error.hpp"
#include "tests/support/scene/loaded_scene.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_sdb_writer {
namespace {

std::string message_of(const SceneDraft& draft) {
    try {
        (void)sdb_bytes(draft);
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

TEST(SdbWriter, EqualDraftsGiveEqualBytes) {
    EXPECT_EQ(sdb_bytes(test_support::small_scene()), sdb_bytes(test_support::small_scene()));
    SceneDraft later = test_support::small_scene();
    later.revision = 2;
    EXPECT_NE(sdb_bytes(later), sdb_bytes(test_support::small_scene()));
}

TEST(SdbWriter, SaysOfWhichLayersValuesAnAttributeWasMade) {
    SceneDraft draft = test_support::small_scene();
    const auto entry_of = [&](const std::string& from, std::optional<std::int64_t> time_ns) {
        draft.layers[1].attributes[0].derived_from = from;
        draft.layers[1].attributes[0].derived_time_ns = time_ns;
        const test_support::LoadedScene loaded(draft);
        const scene::AttributeEntry& entry = *loaded.scene().layers()[1].attributes[0].entry;
        return std::pair<int, std::uint32_t>(entry.derived_from, entry.derived_minute);
    };
    constexpr std::int64_t kMinute_ns = 60'000'000'000;
    EXPECT_EQ(entry_of("", {}), (std::pair<int, std::uint32_t>(0, 0)));
    EXPECT_EQ(entry_of(draft.layers[2].name, {}), (std::pair<int, std::uint32_t>(3, 0))) << "its number, from 1";
    EXPECT_EQ(entry_of(draft.layers[0].name, 26'000'000 * kMinute_ns + 5), (std::pair<int, std::uint32_t>(1, 26'000'000)));
    EXPECT_EQ(entry_of("no such layer", 0), (std::pair<int, std::uint32_t>(0, 0)));
}

TEST(SdbWriter, WhatDoesNotFitIsSaidWithItsLayer) {
    SceneDraft draft = test_support::small_scene();
    draft.layers[1].name = std::string(40, 'm');
    EXPECT_NE(message_of(draft).find("its name"), std::string::npos);
    draft = test_support::small_scene();
    draft.layers[0].attributes[0].unit = "furlongs per fortnight";
    EXPECT_EQ(message_of(draft).rfind("air: the attribute's unit 'furlongs per fortnight' is longer than 11 bytes", 0), 0u);
    draft = test_support::small_scene();
    draft.layers[1].attributes[0].classes.assign(scene::kMaxClasses + 1, "c");
    EXPECT_NE(message_of(draft).find("17 classes"), std::string::npos);
    draft = test_support::small_scene();
    draft.layers.resize(scene::kMaxLayers + 1);
    EXPECT_NE(message_of(draft).find("at most 32 layers"), std::string::npos);
    draft = test_support::small_scene();
    draft.layers[0].attributes.resize(scene::kMaxAttributes + 1, draft.layers[0].attributes[0]);
    EXPECT_NE(message_of(draft).find("at most 96 attributes"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::host_sim::test_sdb_writer
