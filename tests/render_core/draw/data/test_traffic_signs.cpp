#include "render_core/draw/data/traffic_signs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/traffic_state.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_traffic_signs {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

constexpr std::int64_t kStart_ns = 1'780'000'000'000'000'000;

/// Two aircraft, reported twice within five seconds: one ahead that flies to the right, one far to the left.
host_sim::LayerDraft traffic() {
    host_sim::LayerDraft layer;
    layer.name = "traffic";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::traffic;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    layer.names = {"N1", "N2"};
    layer.points = {BillboardRoom::point(3000, 0, 800), BillboardRoom::point(3000, 250, 815),
                    BillboardRoom::point(3000, -90'000, 800), BillboardRoom::point(3000, -90'000, 800)};
    for (std::size_t n = 0; n < 4; ++n) layer.points[n].time_ns = kStart_ns + static_cast<std::int64_t>(n % 2) * 5'000'000'000;
    layer.starts = {0, 2, 4};
    layer.position_accuracy_m = 90;
    return layer;
}

struct Signs {
    explicit Signs(double second, const host_sim::LayerDraft& layer = traffic()) : test(layer) {
        test.has_date = true;
        test.time_ns = kStart_ns + static_cast<std::int64_t>(second * 1e9);
        build();
    }
    void build(const QuadBatch* symbology = nullptr) {
        room.begin(symbology);
        ElementInput input = test.input();
        input.eye = room.view.eye;
        count = add_traffic_signs(room.sheet, input);
    }
    /// Of its letters and their halos.
    [[nodiscard]] Rect texts() const {
        return room.bounds([](const QuadVertex& vertex) { return vertex.extent_x < 0; });
    }
    ElementOfTest test;
    BillboardRoom room;
    ElementCount count;
};

/// One without a name: only the height is written.
host_sim::LayerDraft nameless() {
    host_sim::LayerDraft layer = traffic();
    layer.names = {"", ""};
    return layer;
}

/// Where the first one is at second 5.
Point spot_of(const Signs& signs) {
    const scene::ScenePoint at = BillboardRoom::point(3000, 250, 0);
    return signs.room.sheet.spot(earth::to_ecef({at.latitude_rad, at.longitude_rad, {815}})).at;
}

TEST(TrafficSigns, StandAtTheirPlacesWithALineToWhereTheyWillBe) {
    const Signs signs(5);
    EXPECT_EQ(signs.count.drawn, 1u);
    EXPECT_EQ(signs.count.hidden, 1u) << "beyond the farthest";
    const BillboardSheet::Spot now = signs.room.sheet.spot(earth::to_ecef(
        {BillboardRoom::point(3000, 250, 0).latitude_rad, BillboardRoom::point(3000, 250, 0).longitude_rad, {815}}));
    const BillboardSheet::Spot then = signs.room.sheet.spot(earth::to_ecef(
        {BillboardRoom::point(3000, 1750, 0).latitude_rad, BillboardRoom::point(3000, 1750, 0).longitude_rad, {905}}));
    const Rect bounds = signs.room.bounds();
    EXPECT_NEAR(bounds.right(), then.at.x, 4);
    EXPECT_NEAR(bounds.y, then.at.y, 4);
    EXPECT_LT(bounds.x, now.at.x);
    EXPECT_GT(bounds.bottom(), now.at.y + 20) << "the height below";
}

TEST(TrafficSigns, SayHeightClimbAgeAndStaleness) {
    // Name of two letters, height of three and an arrow: "-06^".
    const std::size_t fresh = Signs(5).room.glyph_vertices();
    EXPECT_EQ(fresh, (2 + 3 + 1) * 8u);
    const std::size_t old = Signs(12).room.glyph_vertices();
    EXPECT_GT(old, fresh) << "its age";
    const Signs stale(30);
    EXPECT_EQ(stale.count.drawn, 1u);
    for (const QuadVertex& vertex : stale.room.drawn())
        EXPECT_TRUE(vertex.rgba[0] == vertex.rgba[1] && vertex.rgba[1] == vertex.rgba[2]) << "grey, white and black only";
    EXPECT_EQ(Signs(5 + kRemoved_s + 1).count.drawn, 0u);
    EXPECT_EQ(Signs(-1).count.drawn, 0u);
}

TEST(TrafficSigns, ShowHowSureTheirPlacesAre) {
    Signs signs(5);
    const std::size_t plain = signs.room.drawn().size();
    signs.test.element.uncertainty = design::ElementUncertainty::ellipsoid;
    signs.build();
    EXPECT_EQ(signs.room.drawn().size(), plain + 24 * 2 * 4);
}

TEST(TrafficSigns, WhereNobodyKnowsThereIsADashedRimAndNoCircle) {
    host_sim::LayerDraft unsure = traffic();
    unsure.position_accuracy_m = 0;
    Signs signs(5, unsure);
    const std::size_t plain = signs.room.drawn().size(), letters = signs.room.glyph_vertices();
    signs.test.element.uncertainty = design::ElementUncertainty::ellipsoid;
    signs.build();
    EXPECT_EQ(signs.room.glyph_vertices(), letters + 8) << "a question mark";
    EXPECT_GT(signs.room.drawn().size(), plain + 8);
    EXPECT_LT(signs.room.drawn().size(), plain + 24 * 2 * 4);
}

TEST(TrafficSigns, TheCircleGrowsWithTheAge) {
    const auto width = [](double second) {
        Signs signs(second);
        signs.test.element.uncertainty = design::ElementUncertainty::ellipsoid;
        signs.build();
        return signs.room.bounds().right() - signs.room.bounds().x;
    };
    // Grey and without its line from 15 s on: only the circle tells them apart.
    EXPECT_GT(width(40), width(25) + 100);
}

TEST(TrafficSigns, ATextGoesWhereItIsSeenWhole) {
    Signs signs(5, nameless());
    const Point at = spot_of(signs);
    const std::size_t letters = signs.room.glyph_vertices();
    EXPECT_GT(signs.texts().y, at.y + 8) << "with nothing in the way below";
    // A line of the symbology cuts where it stood; what takes all the rest but one side sends it there.
    const Rect wide{at.x - 100, at.y + 18, 200, 4};
    const auto symbology_of = [](const std::vector<Rect>& boxes) {
        BillboardRoom symbology;
        for (const Rect& box : boxes) EXPECT_TRUE(symbology.batch.box(box, {}));
        return symbology;
    };
    const BillboardRoom below = symbology_of({wide});
    signs.build(&below.batch);
    EXPECT_EQ(signs.room.glyph_vertices(), letters) << "whole";
    EXPECT_LT(signs.texts().bottom(), at.y - 8) << "above";
    const Rect over{at.x - 100, at.y - 24, 200, 4};
    const BillboardRoom both = symbology_of({wide, over});
    signs.build(&both.batch);
    EXPECT_EQ(signs.room.glyph_vertices(), letters);
    EXPECT_GT(signs.texts().x, at.x + 8) << "right";
    const BillboardRoom three = symbology_of({wide, over, {at.x + 30, at.y - 20, 70, 40}});
    signs.build(&three.batch);
    EXPECT_EQ(signs.room.glyph_vertices(), letters);
    EXPECT_LT(signs.texts().right(), at.x - 8) << "left";
    const BillboardRoom all = symbology_of({wide, over, {at.x + 30, at.y - 20, 70, 40}, {at.x - 100, at.y - 20, 70, 40}});
    signs.build(&all.batch);
    EXPECT_EQ(signs.room.glyph_vertices(), 0u) << "no half of a number";
    EXPECT_EQ(signs.count.drawn, 1u) << "and the diamond stays";
    EXPECT_FALSE(signs.room.batch.vertices().empty());
}

TEST(TrafficSigns, AtTheEdgeOfThePictureADiamondStaysWithoutWhatWouldBeCut) {
    host_sim::LayerDraft layer = nameless();
    for (std::size_t n : {0, 1}) layer.points[n] = BillboardRoom::point(3000, 0, 0);
    for (std::size_t n : {0, 1}) layer.points[n].time_ns = kStart_ns + static_cast<std::int64_t>(n) * 5'000'000'000;
    const double half_high = std::atan(300 / BillboardRoom().view.focal_px);
    const auto high = static_cast<float>(BillboardRoom::kEyeHeight_m + 3000 * std::tan(half_high) - 90);
    layer.points[0].height_m = high - 5;
    layer.points[1].height_m = high;
    const Signs signs(12, layer);
    ASSERT_EQ(signs.count.drawn, 1u) << "its age has no room above it";
    EXPECT_GE(signs.texts().y, 0);
}

TEST(TrafficSigns, NoTextHidesAnotherDiamond) {
    host_sim::LayerDraft layer = traffic();
    layer.points[2] = BillboardRoom::point(3100, 250 + 200, 822);
    layer.points[3] = layer.points[2];
    for (std::size_t n : {2, 3}) layer.points[n].time_ns = kStart_ns + static_cast<std::int64_t>(n % 2) * 5'000'000'000;
    const Signs signs(5, layer);
    EXPECT_EQ(signs.count.drawn, 2u);
    for (std::size_t n : {2, 3}) {
        layer.points[n] = layer.points[1];
        layer.points[n].time_ns = layer.points[n - 2].time_ns;
    }
    EXPECT_EQ(Signs(5, layer).count.drawn, 1u) << "but one right before it does";
}

/// The sign in the middle of the first aircraft, which is `over_m` over the own ship and `away_m` ahead of it.
bool is_filled(double over_m, double away_m, bool is_own_known = true) {
    Signs signs(5, nameless());
    signs.room.begin();
    ElementInput input = signs.test.input();
    input.eye = signs.room.view.eye;
    const scene::ScenePoint own = BillboardRoom::point(3000 - away_m, 250, 0);
    input.own_ship = {{own.latitude_rad, own.longitude_rad, {815 - over_m}}, is_own_known, is_own_known};
    EXPECT_EQ(add_traffic_signs(signs.room.sheet, input).drawn, 1u);
    test_support::Picture picture(800, 600, {90, 120, 90});
    rasterize(signs.room.batch, picture);
    const Point at = spot_of(signs);
    const design::Color middle = picture.at(static_cast<int>(at.x), static_cast<int>(at.y) + 3);
    return middle.red != 90 || middle.green != 120;
}

/// FAA, Introduction to TCAS II: other traffic, and proximate traffic within 6 NM and 1200 ft.
TEST(TrafficSigns, P34TheDiamondIsFilledWithinSixMilesAndTwelveHundredFeet) {
    const double mile = 1852, foot = 0.3048;
    EXPECT_TRUE(is_filled(0, 3 * mile));
    EXPECT_TRUE(is_filled(1190 * foot, 5.9 * mile));
    EXPECT_TRUE(is_filled(-1190 * foot, -5.9 * mile)) << "below and behind";
    EXPECT_FALSE(is_filled(1210 * foot, 3 * mile)) << "too high";
    EXPECT_FALSE(is_filled(-1210 * foot, 3 * mile)) << "too low";
    EXPECT_FALSE(is_filled(0, 6.1 * mile)) << "too far away";
    EXPECT_FALSE(is_filled(0, 3 * mile, false)) << "nobody knows where the own ship is";
}

/// By where its letters are.
TEST(TrafficSigns, P34TheRelativeHeightStandsOnItsSideAndHasAnArrowFrom500FeetAMinute) {
    struct Built {
        Rect texts;
        std::size_t letters;
        float y;
    };
    const auto built = [](double over_m, float climb_m, base::DisplayUnits units = base::DisplayUnits::feet_and_knots) {
        host_sim::LayerDraft layer = nameless();
        layer.points[0].height_m = 815 - climb_m;
        Signs signs(5, layer);
        signs.room.begin();
        ElementInput input = signs.test.input();
        input.eye = signs.room.view.eye;
        input.units = units;
        const scene::ScenePoint own = BillboardRoom::point(0, 0, 0);
        input.own_ship = {{own.latitude_rad, own.longitude_rad, {815 - over_m}}, true, true};
        static_cast<void>(add_traffic_signs(signs.room.sheet, input));
        return Built{signs.texts(), signs.room.glyph_vertices(), spot_of(signs).y};
    };
    EXPECT_LT(built(300, 0).texts.bottom(), built(300, 0).y) << "+10, though the eye is higher";
    EXPECT_GT(built(-300, 0).texts.y, built(-300, 0).y) << "-10";
    const std::size_t level = built(300, 0).letters;
    EXPECT_EQ(built(300, 12.5f).letters, level) << "492 ft/min";
    EXPECT_EQ(built(300, 13).letters, level + 8) << "512 ft/min up";
    EXPECT_EQ(built(300, -13).letters, level + 8) << "and down";
    EXPECT_EQ(built(300, 0, base::DisplayUnits::metric).letters, level + 16) << "+300M for +10";
    EXPECT_EQ(built(11'000, 0, base::DisplayUnits::metric).letters, level + 32) << "+11000M";
}

TEST(TrafficSigns, ALinkLeadsDown) {
    host_sim::LayerDraft layer = traffic();
    for (scene::ScenePoint& point : layer.points) point.height_m += 400;  // over the eye: its text is above it
    Signs signs(0, layer);
    const float bottom = signs.room.bounds().bottom();
    signs.test.element.link = true;
    signs.build();
    EXPECT_GT(signs.room.bounds().bottom(), bottom + 20);
    signs.test.ground.is_known = false;
    signs.build();
    EXPECT_NEAR(signs.room.bounds().bottom(), bottom, 0.1);
}

}  // namespace
}  // namespace tedavis::draw::test_traffic_signs
