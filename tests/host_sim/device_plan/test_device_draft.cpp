#include "host_sim/device_plan/device_draft.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/device_files.hpp"

namespace tedavis::host_sim::test_device_draft {
namespace {

constexpr const char* kSlotLines[] = {"terrain_chunk_slots", "terrain_heights", "terrain_vertices", "terrain_indices",
                                      "lod_scratch"};

DraftSource source(const char* name = "es2-small") {
    return {test_support::shipped_device(name), {}, {{true, 5000}, {false, 100}}};
}

DeviceAsk ask(PictureSize size = {640, 480}) { return {"x", size, 30, 0, ""}; }

std::uint64_t line(const effects::DeviceSettings& device, std::string_view name) { return device.budget.find(name)->bytes; }

/// The shipped files were made by hand: with their own numbers a draft is about what they state.
TEST(DeviceDraft, OfTheShippedNumbersIsAboutTheShippedDevice) {
    for (const char* const name : {"es2-small", "es3-mid", "desktop"}) {
        const DraftSource from = source(name);
        const effects::DeviceSettings& shipped = from.shipped;
        const DeviceRoom room{shipped.max_chunk_slots, shipped.attribute_pages, shipped.drape_pages, true, false};
        const effects::DeviceSettings draft = draft_device(from, ask({shipped.width_px, shipped.height_px}), {}, room);
        for (const char* const of_slots : {"terrain_heights", "terrain_vertices", "terrain_indices", "terrain_attributes",
                                           "terrain_drape", "terrain_drape_pages"}) {
            const auto stated = static_cast<double>(line(shipped, of_slots));
            EXPECT_NEAR(static_cast<double>(line(draft, of_slots)), stated, 0.1 * stated) << name << ' ' << of_slots;
        }
        EXPECT_EQ(line(draft, "symbology"), line(shipped, "symbology"));
        EXPECT_EQ(draft.budget.find("traced_terrain"), nullptr) << "the design traces nothing";
    }
}

TEST(DeviceDraft, LinesOfSlotsGrowWithTheSlotsAndNoOtherDoes) {
    const DraftSource from = source();
    const DeviceRoom few{50, 24, 49, true, false}, many{100, 24, 49, true, false};
    const effects::DeviceSettings a = draft_device(from, ask(), {}, few), b = draft_device(from, ask(), {}, many);
    for (const base::BudgetLine& of_a : a.budget.lines()) {
        const bool is_of_slots = std::count(std::begin(kSlotLines), std::end(kSlotLines), of_a.name.view()) > 0;
        const std::uint64_t of_b = line(b, of_a.name.view());
        EXPECT_TRUE(is_of_slots ? of_b > of_a.bytes : of_b == of_a.bytes) << of_a.name.view();
        EXPECT_FALSE(of_a.reason.empty() || of_a.reason.cut()) << of_a.name.view();
    }
    EXPECT_EQ(line(b, "terrain_vertices"), 2 * line(a, "terrain_vertices"));
}

TEST(DeviceDraft, TakesNothingOfWhatIsGivenUp) {
    const DraftSource from = source("desktop");
    const effects::DeviceSettings none = draft_device(from, ask(), {}, {50, 0, 0, false, false});
    for (const char* const name : {"terrain_attributes", "terrain_pages", "terrain_drape", "terrain_drape_pages"})
        EXPECT_EQ(line(none, name), 0u) << name;
    EXPECT_EQ(none.capability.off_screen_pictures, 0u);
    EXPECT_EQ(none.capability.shadow_map_px, 0u);
    EXPECT_FALSE(none.capability.depth24_targets || none.affords_antialiasing);
    EXPECT_EQ(line(none, "render_targets"), 4096u);
}

TEST(DeviceDraft, TheWholeRoomFollowsPixelsAndNeeds) {
    const DraftSource from = source();
    DeviceNeeds needs;
    needs.has_coast = false;
    const DeviceRoom plain = whole_room(from, ask(), needs);
    EXPECT_EQ(plain.slots, from.shipped.max_chunk_slots);
    EXPECT_EQ(plain.attribute_pages + plain.drape_pages, 0u) << "the design needs none";
    needs.has_coast = needs.has_drape = true;
    const DeviceRoom full = whole_room(from, ask({1280, 960}), needs);
    EXPECT_EQ(full.slots, 4 * from.shipped.max_chunk_slots);
    EXPECT_EQ(full.attribute_pages, from.shipped.attribute_pages);
    EXPECT_EQ(full.drape_pages, from.shipped.drape_pages);
    EXPECT_EQ(whole_room(from, ask({64, 64}), needs).slots, from.shipped.max_chunk_slots) << "never fewer";
    needs.terrain = TerrainNeeds{1000, 10, 500, 0};
    EXPECT_GT(whole_room(from, ask(), needs).slots, 500u) << "roots are always resident";
}

TEST(DeviceDraft, HoldsTheSceneTwiceAndTheTablesOfTheTerrain) {
    DeviceNeeds needs;
    needs.scene_file_bytes = 10'000'000;
    needs.terrain = TerrainNeeds{3'000'000, 5, 1, 0};
    const effects::DeviceSettings draft = draft_device(source(), ask(), needs, {50, 0, 0, true, false});
    EXPECT_GE(line(draft, "scene_data"), 20'000'000u);
    EXPECT_LT(line(draft, "scene_data"), 21'000'000u);
    EXPECT_GT(line(draft, "terrain_index"), 3'000'000u);
    EXPECT_LT(line(draft, "terrain_index"), 3'300'000u) << "of few pages";
}

TEST(DeviceDraft, HasRoomForTheEdgesOfADesignThatMeasuresClutter) {
    for (const char* const name : {"es2-small", "es3-mid", "desktop"}) {
        const DraftSource from = source(name);
        const PictureSize size{from.shipped.width_px, from.shipped.height_px};
        DeviceNeeds needs;
        EXPECT_EQ(draft_device(from, ask(size), needs, {50, 0, 0, true, false}).budget.find("picture_edges"), nullptr);
        needs.measures_clutter = true;
        const std::uint64_t bytes = line(draft_device(from, ask(size), needs, {50, 0, 0, true, false}), "picture_edges");
        EXPECT_LE(bytes, line(from.shipped, "picture_edges")) << name;
        EXPECT_GT(bytes, std::uint64_t{size.width} * size.height) << name;
        const PictureSize twice{2 * size.width, 2 * size.height};
        EXPECT_GT(line(draft_device(from, ask(twice), needs, {50, 0, 0, true, false}), "picture_edges"), 3 * bytes) << name;
    }
}

TEST(DeviceDraft, ALineIsNeverLessThanAStartHasAskedFor) {
    DraftSource from = source();
    from.raised["font_atlas"] = 1'000'001;
    from.raised["symbology"] = 1;
    const effects::DeviceSettings draft = draft_device(from, ask(), {}, {50, 0, 0, true, false});
    EXPECT_EQ(line(draft, "font_atlas"), 245u * 4096);
    EXPECT_EQ(line(draft, "symbology"), line(from.shipped, "symbology"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_device_draft
