// Displays with foci: pictures and records over a small scene, on both lanes.
#include <gtest/gtest.h>

#include "tests/support/display/foci_of_test.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_foci_pictures {
namespace {

using test_support::HeadlessDisplay;
using test_support::HillsPicture;

constexpr std::uint32_t kWidth = 320, kHeight = 240;

/// Air over the hills, 2 km over the ground, a post a kilometre: values from 0 in the west to 20 in the east.
host_sim::SceneDraft air_draft() {
    host_sim::LayerDraft layer;
    layer.name = "air";
    layer.shape = scene::LayerShape::grid;
    layer.grid = {base::radians(9.57), base::radians(47.1), base::radians(0.013), base::radians(0.009), 20, 20, 1, 1};
    layer.levels_m = {1900};
    host_sim::AttributeDraft gust;
    gust.name = "gust";
    for (int n = 0; n < 400; ++n) gust.values.push_back(static_cast<float>(n % 20));
    layer.attributes.push_back(gust);
    return {"air", "a test", 1, {layer}};
}

design::DesignSettings with_foci(std::initializer_list<std::string> lines) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.data.elements.clear();
    design::DataElement element;
    element.layer = "air";
    element.technique = design::DataTechnique::spheres;
    element.color = {240, 40, 40};
    element.size_m = 500;
    EXPECT_TRUE(design.data.elements.try_push_back(element));
    for (const std::string& line : lines) EXPECT_TRUE(design.foci.try_push_back(test_support::focus_of(line)));
    return design;
}

struct Shown {
    explicit Shown(const design::DesignSettings& design, const char* device = "es3-mid")
        : scene(host_sim::sdb_bytes(air_draft())),
          display("egl", test_support::shipped_device(device), kWidth, kHeight, &bytes, design, test_support::as_it_is, &scene) {}
    HillsPicture picture() { return test_support::hills_picture(display, state); }
    const FrameRecord& record() { return display.display().record(); }
    std::uint32_t shown() { return record().data.empty() ? 0 : record().data[0].drawn + record().data[0].aggregated; }

    test_support::MemoryBytes bytes{test_support::hills().image};
    test_support::FlakyBytes scene;
    flight::AircraftState state = test_support::aircraft_over_hills(2600, 30, -8);
    HeadlessDisplay display;
};

/// One display at a time: its surface is current.
struct Without {
    explicit Without(const char* device) {
        Shown bare(with_foci({}), device);
        picture = bare.picture();
        shown = bare.shown();
        EXPECT_TRUE(bare.record().foci.empty());
    }
    HillsPicture picture;
    std::uint32_t shown = 0;
};

const char* const kAhead =
    R"(name = "AHEAD", at = "position", position_deg = [47.03, 9.725], radius_m = 1500, context.width_m = 1500, data = {brightness = 0.3, saturation = 0.0, size = 0.5, context = "hidden"})";

TEST(FociPictures, AFocusThatChangesNothingIsNoDifference) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const Without without(device);
        Shown plain(with_foci({R"(at = "own_ship", radius_m = 500)"}), device);
        EXPECT_EQ(plain.picture(), without.picture) << device;
        ASSERT_EQ(plain.record().foci.size(), 1u);
        EXPECT_TRUE(plain.record().foci[0].is_shown);
        EXPECT_EQ(plain.record().foci[0].sight.view(), "around");
    }
}

TEST(FociPictures, WhatIsBesideAFocusStepsBack) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const Without without(device);
        Shown focused(with_foci({kAhead}), device);
        EXPECT_NE(focused.picture(), without.picture);
        EXPECT_LT(focused.shown(), without.shown / 2) << device;
        EXPECT_GT(focused.shown(), 3u) << device;
        const FocusRecord& focus = focused.record().foci[0];
        EXPECT_EQ(focus.in_focus + focus.intermediate + focus.context, 400u);
        EXPECT_GT(focus.in_focus, 3u);
        EXPECT_GT(focus.intermediate, focus.in_focus);
        EXPECT_EQ(focused.display.display().gl().denied().total, 0u);
    }
}

TEST(FociPictures, ALostPositionTakesTheFocusAndItsContextAway) {
    Shown focused(with_foci({R"(at = "own_ship", radius_m = 1000, data.context = "hidden")"}));
    static_cast<void>(focused.picture());
    EXPECT_TRUE(focused.record().foci[0].is_shown);
    focused.state.own_ship.state = base::SignalState::lost;
    static_cast<void>(focused.picture());
    EXPECT_FALSE(focused.record().foci[0].is_shown);
    EXPECT_NE(focused.record().foci[0].reason.view().find("not known"), std::string_view::npos);
}

TEST(FociPictures, ACueLeadsToWhatIsBehind) {
    Shown focused(with_foci({R"(name = "LAKE", at = "position", position_deg = [46.95, 9.65], radius_m = 300)"}));
    static_cast<void>(focused.picture());
    EXPECT_EQ(focused.record().foci[0].sight.view(), "out of view");
    EXPECT_GT(focused.record().foci[0].distance_m, 5000);
}

}  // namespace
}  // namespace tedavis::display::test_foci_pictures
