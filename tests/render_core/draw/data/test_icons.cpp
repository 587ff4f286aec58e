#include "render_core/draw/data/icons.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_icons {
namespace {

using test_support::BillboardRoom;
using test_support::LoadedScene;

TEST(Icons, EveryOneStaysWithinItsSizeAndLooksLikeNoOther) {
    std::set<std::vector<std::uint8_t>> pictures;
    for (int n = 0; n < static_cast<int>(Icon::count); ++n) {
        BillboardRoom room;
        ASSERT_TRUE(draw_icon(room.batch, static_cast<Icon>(n), {30, 30}, 12, {255, 255, 255}));
        const Rect bounds = room.bounds();
        EXPECT_GT(bounds.x, 30 - 12 - 6) << n;
        EXPECT_LT(bounds.right(), 30 + 12 + 6) << n;
        EXPECT_GT(bounds.y, 30 - 12 - 6) << n;
        EXPECT_LT(bounds.bottom(), 30 + 12 + 6) << n;
        test_support::Picture picture(60, 60, {90, 120, 90});
        rasterize(room.batch, picture);
        pictures.insert(picture.rgb);
    }
    EXPECT_EQ(pictures.size(), static_cast<std::size_t>(Icon::count) - 1) << "traffic's sign is the generic diamond";
}

/// A quarter turn takes each point (x, y) from the middle to (-y, x); a whole one changes nothing.
TEST(Icons, TurnAboutTheirMiddle) {
    const auto bounds = [](float turn_rad) {
        BillboardRoom room;
        EXPECT_TRUE(draw_icon(room.batch, Icon::airport, {30, 30}, 12, {255, 255, 255}, turn_rad));
        EXPECT_TRUE(draw_icon(room.batch, Icon::ghost, {30, 30}, 12, {255, 255, 255}, turn_rad));
        return room.bounds();
    };
    const Rect upright = bounds(0), turned = bounds(static_cast<float>(base::kPi / 2)),
               whole = bounds(static_cast<float>(2 * base::kPi));
    EXPECT_NEAR(turned.right() - 30, 30 - upright.y, 0.01) << "its nose is to the right";
    EXPECT_NEAR(turned.y, upright.x, 0.01);
    EXPECT_NEAR(whole.y, upright.y, 0.01);
    EXPECT_NE(turned.y, upright.y);
}

TEST(Icons, AreChosenByKindThenByRole) {
    host_sim::LayerDraft layer = test_support::small_points();
    EXPECT_EQ(icon_of(LoadedScene(layer).layer(), 0), Icon::mast);
    EXPECT_EQ(icon_of(LoadedScene(layer).layer(), 1), Icon::turbine);
    layer.attributes[0].classes[1] = "antenna";
    EXPECT_EQ(icon_of(LoadedScene(layer).layer(), 1), Icon::obstacle) << "no icon of that name";
    layer.attributes[0].values[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(icon_of(LoadedScene(layer).layer(), 0), Icon::obstacle) << "not known";
    layer.role = scene::LayerRole::place;
    EXPECT_EQ(icon_of(LoadedScene(layer).layer(), 0), Icon::place);
    EXPECT_EQ(icon_of(LoadedScene(test_support::small_areas()).layer(), 0), Icon::no_go);
    EXPECT_EQ(icon_of(LoadedScene(test_support::small_meshes()).layer(), 0), Icon::model);
}

TEST(Icons, SummitsAndAirportsHaveTheirOwn) {
    host_sim::LayerDraft layer = test_support::small_points();
    layer.role = scene::LayerRole::place;
    const auto icon = [&](const char* kind) {
        layer.attributes[0].classes[1] = kind;
        return icon_of(LoadedScene(layer).layer(), 1);
    };
    EXPECT_EQ(icon("summit"), Icon::summit);
    EXPECT_EQ(icon("peak"), Icon::summit);
    EXPECT_EQ(icon("airport"), Icon::airport);
    EXPECT_EQ(icon("aerodrome"), Icon::airport);
    EXPECT_EQ(icon("village"), Icon::village) << "control";
    EXPECT_EQ(icon("hamlet"), Icon::place) << "control";
    const auto is_lit = [](Icon shown, int x, int y) {
        BillboardRoom room;
        EXPECT_TRUE(draw_icon(room.batch, shown, {30, 30}, 12, {255, 255, 255}));
        test_support::Picture picture(60, 60, {90, 120, 90});
        rasterize(room.batch, picture);
        return picture.at(x, y).red > 200;
    };
    for (const auto& [x, y] : {std::pair(30, 26), std::pair(30, 33), std::pair(26, 34), std::pair(34, 34)}) {
        EXPECT_TRUE(is_lit(Icon::summit, x, y)) << x << " " << y << ": it is filled";
        EXPECT_FALSE(is_lit(Icon::place, x, y)) << x << " " << y << ": control";
    }
    EXPECT_FALSE(is_lit(Icon::summit, 22, 24)) << "nothing beside its tip";
    EXPECT_TRUE(is_lit(Icon::airport, 30, 30)) << "a runway through the middle";
    EXPECT_TRUE(is_lit(Icon::airport, 30, 22)) << "and the circle";
    EXPECT_FALSE(is_lit(Icon::airport, 30, 26));
    EXPECT_FALSE(is_lit(Icon::place, 30, 30)) << "control";
}

TEST(Icons, P33AnObstacleFromAThousandFeetOnHasAnother) {
    for (const Icon icon : {Icon::obstacle, Icon::mast, Icon::chimney, Icon::crane, Icon::pole}) {
        EXPECT_EQ(icon_by_height(icon, 304), icon);
        EXPECT_EQ(icon_by_height(icon, 305), Icon::high_obstacle);
        EXPECT_EQ(icon_by_height(icon, std::nan("")), icon) << "not known";
    }
    for (const Icon icon : {Icon::turbine, Icon::cable, Icon::place}) EXPECT_EQ(icon_by_height(icon, 400), icon) << "control";
}

TEST(Icons, ADashedRimIsHalfACircle) {
    BillboardRoom room;
    ASSERT_TRUE(draw_dashed_rim(room.batch, {50, 50}, 20, {255, 255, 255}, 0.55f));
    test_support::Picture picture(100, 100, {0, 0, 0});
    rasterize(room.batch, picture);
    int lit = 0, turns = 0;
    bool was = false;
    for (int n = 0; n < 720; ++n) {
        const double angle = base::radians(n / 2.0);
        const double x = 50 + 19.6 * std::cos(angle), y = 50 + 19.6 * std::sin(angle);
        const bool is = picture.at(static_cast<int>(x), static_cast<int>(y)).red > 60;
        lit += is ? 1 : 0;
        turns += is != was ? 1 : 0;
        was = is;
    }
    EXPECT_GT(lit, 720 * 0.4);
    EXPECT_LT(lit, 720 * 0.8);
    EXPECT_GE(turns, 16) << "eight dashes";
}

TEST(Icons, AFullBatchSaysSo) {
    BillboardRoom room(16);
    EXPECT_FALSE(draw_icon(room.batch, Icon::town, {30, 30}, 12, {255, 255, 255}));
    EXPECT_GT(room.batch.use().refused, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_icons
