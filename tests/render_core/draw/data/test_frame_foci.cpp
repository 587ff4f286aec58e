#include "render_core/draw/data/frame_foci.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/foci_of_test.hpp"

namespace tedavis::draw::test_frame_foci {
namespace {

using test_support::FociOfTest;

TEST(FrameFoci, TheLookFallsFromTheFocusToTheContext) {
    const FociOfTest foci(
        {R"(context.levels = 3, data = {detail = 0.2, brightness = 0.4, saturation = 0.0, size = 0.5, aggregate = 5})"});
    const FrameFoci& frame = foci.frame();
    EXPECT_EQ(frame.least_degree, 0.25);
    const FocusLook whole = look_at(frame, 1), rim = look_at(frame, 0.25), middle = look_at(frame, 0.625);
    EXPECT_EQ(whole.detail + whole.brightness + whole.saturation + whole.size + whole.aggregate, 5);
    EXPECT_DOUBLE_EQ(rim.detail, 0.2);
    EXPECT_DOUBLE_EQ(rim.brightness, 0.4);
    EXPECT_DOUBLE_EQ(rim.saturation, 0);
    EXPECT_DOUBLE_EQ(rim.size, 0.5);
    EXPECT_DOUBLE_EQ(rim.aggregate, 5);
    EXPECT_DOUBLE_EQ(middle.brightness, 0.7);
    EXPECT_DOUBLE_EQ(middle.aggregate, 3);
}

TEST(FrameFoci, DataOfTheContextAreShownDimmedOrHidden) {
    for (const std::string context : {"shown", "as_intermediate", "hidden"}) {
        const FociOfTest foci({"data = {brightness = 0.4, context = \"" + context + "\"}"});
        const FocusLook look = look_at(foci.frame(), 0);
        EXPECT_EQ(look.is_hidden, context == "hidden") << context;
        EXPECT_DOUBLE_EQ(look.brightness, context == "shown" ? 1 : 0.4) << context;
        EXPECT_FALSE(look_at(foci.frame(), 0.5).is_hidden);
    }
}

TEST(FrameFoci, WhereNoFocusIsAnywhereNothingStepsBack) {
    FociOfTest foci({R"(data.brightness = 0.4)"});
    EXPECT_TRUE(foci.frame().changes_data());
    foci.own_ship.state = base::SignalState::lost;
    foci.plan_again();
    EXPECT_FALSE(foci.frame().is_any());
    EXPECT_FALSE(foci.frame().changes_data());
    EXPECT_EQ(look_at(foci.frame(), 0).brightness, 1);
    const FociOfTest plain({R"(terrain.brightness = 0.4)"});
    EXPECT_TRUE(plain.frame().is_any());
    EXPECT_FALSE(plain.frame().changes_data()) << "it changes the ground alone";
}

TEST(FrameFoci, ColorsGetGreyerAndDarkerAndStayAsOpaque) {
    const design::Color color{200, 40, 20, 128};
    EXPECT_EQ(shown_color({}, color), color);
    FocusLook grey;
    grey.saturation = 0;
    const design::Color without = shown_color(grey, color);
    EXPECT_EQ(without.red, without.green);
    EXPECT_EQ(without.green, without.blue);
    FocusLook dark;
    dark.brightness = 0.5;
    EXPECT_EQ(shown_color(dark, color), (design::Color{100, 20, 10, 128}));
}

TEST(FrameFoci, TheKeyTellsFociApart) {
    FociOfTest foci({R"(data.brightness = 0.4)"});
    const std::uint64_t key = key_of(foci.frame(), 0, true);
    EXPECT_NE(key, 0u);
    EXPECT_EQ(key_of(foci.frame(), 90'000'000'000, true), key) << "of space: whatever the time";
    foci.plan_again();
    EXPECT_EQ(key_of(foci.frame(), 0, true), key);
    foci.own_ship.position.latitude_rad += 1e-7;
    foci.plan_again();
    EXPECT_NE(key_of(foci.frame(), 0, true), key);
}

TEST(FrameFoci, ADataFocusMeansLayersThatHaveItsAttribute) {
    const test_support::LoadedScene scene(test_support::small_scene());
    design::FocusOfData data;
    data.layer = "air";
    data.attribute = "temperature";
    EXPECT_TRUE(is_meant(data, *scene.scene().find("air")));
    EXPECT_FALSE(is_meant(data, *scene.scene().find("masts")));
    data.attribute = "pressure";
    EXPECT_FALSE(is_meant(data, *scene.scene().find("air")));
    data.layer.clear();
    data.role = scene::LayerRole::obstacle;
    data.attribute = "kind";
    EXPECT_TRUE(is_meant(data, *scene.scene().find("masts")));
}

}  // namespace
}  // namespace tedavis::draw::test_frame_foci
