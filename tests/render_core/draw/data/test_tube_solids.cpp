#include "render_core/draw/data/tube_solids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_tube_solids {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr std::int64_t kSecond_ns = 1'000'000'000;

host_sim::LayerDraft lines(const std::vector<std::size_t>& lengths) {
    host_sim::LayerDraft layer;
    layer.name = "flights";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.starts = {0};
    for (std::size_t line = 0; line < lengths.size(); ++line) {
        for (std::size_t n = 0; n < lengths[line]; ++n) {
            const double along = static_cast<double>(n);
            layer.points.push_back(scene_point(46.5 + 0.0005 * along,
                                               9.6 + 0.05 * static_cast<double>(line) + 0.01 * std::sin(0.05 * along),
                                               3000 + 200 * std::sin(0.01f * static_cast<float>(n))));
            layer.points.back().time_ns = static_cast<std::int64_t>(n) * kSecond_ns;
        }
        layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    }
    return layer;
}

void bind(host_sim::LayerDraft& layer, const char* name, float step) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    for (std::size_t n = 0; n < layer.points.size(); ++n) attribute.values.push_back(step * static_cast<float>(n % 100));
    layer.attributes.push_back(attribute);
}

class TubeSolidsOfTest : public ::testing::Test {
protected:
    explicit TubeSolidsOfTest(std::uint32_t rings = 4096) : memory_(TubeSolids::bytes_needed(rings)) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(tubes.start(arena, rings));
    }
    ElementCount add(ElementOfTest& test) { return tubes.add(room.batch, room.mesh, test.input()); }

    TubeSolids tubes;
    SolidRoomOfTest room;

private:
    std::vector<unsigned char> memory_;
};

TEST_F(TubeSolidsOfTest, EveryPointIsCountedOnce) {
    ElementOfTest test(lines({500, 1, 2, 900}));
    const ElementCount count = add(test);
    EXPECT_EQ(count.all(), 1403u);
    EXPECT_EQ(count.hidden, 0u);
    EXPECT_GT(count.drawn, 100u);
    EXPECT_GT(count.aggregated, 100u);
    EXPECT_EQ(room.batch.pieces().size(), 2u) << "one to thirty kilometres, one beyond";
}

TEST_F(TubeSolidsOfTest, TubesEndBeforeTheEye) {
    host_sim::LayerDraft layer = lines({40});
    layer.position_accuracy_m = 30;
    ElementOfTest test(layer);
    test.element.size_m = 12;
    test.element.halo_px = 2;
    test.element.uncertainty = design::ElementUncertainty::widening;
    ASSERT_GT(add(test).drawn, 0u);
    const auto pieces = room.batch.pieces();
    ASSERT_EQ(pieces.size(), 3u) << "sides, rim, margin";
    EXPECT_NEAR(pieces[0].look.near_m, kNearRadii * 12, 1e-3);
    EXPECT_NEAR(pieces[1].look.near_m, kNearRadii * 12, 1e-3);
    EXPECT_NEAR(pieces[2].look.near_m, kNearRadii * 42, 1e-3) << "by its own radius";
}

TEST_F(TubeSolidsOfTest, TheTubeHasItsLengthTimesItsSection) {
    host_sim::LayerDraft layer = lines({});
    layer.points = {scene_point(46.8, 9.8, 3000), scene_point(46.8, 9.9, 3000)};
    layer.starts = {0, 2};
    ElementOfTest test(layer);
    test.element.size_m = 100;
    EXPECT_EQ(add(test).drawn, 2u);
    const auto place = [&](std::size_t n) {
        return earth::to_ecef({layer.points[n].latitude_rad, layer.points[n].longitude_rad, {3050}});
    };
    const double length_m = glm::distance(place(0), place(1));
    EXPECT_NEAR(test_support::volume_m3(room.batch, room.batch.pieces()[0]), 1.5 * std::sqrt(3.0) * 1e4 * length_m, 2e4);
}

TEST_F(TubeSolidsOfTest, SidesShowTheirScalesAndWhatIsMissing) {
    host_sim::LayerDraft layer = lines({100});
    bind(layer, "first", 0);
    bind(layer, "second", 0);
    for (float& value : layer.attributes[1].values) value = std::numeric_limits<float>::quiet_NaN();
    ElementOfTest test(layer);
    test.element.by_color.attribute = "first";
    test.element.by_color.scale.palette = test_support::grey_palette();
    test.element.by_second_color.attribute = "second";
    test.element.by_second_color.scale.palette = test_support::grey_palette();
    static_cast<void>(add(test));
    const design::Color grey = design::scale_color(test.element.by_color.scale, 0);
    std::size_t shown = 0, missing = 0;
    for (const SolidVertex& vertex : room.batch.vertices()) {
        shown += vertex.rgba[0] == grey.red && vertex.rgba[1] == grey.green && vertex.rgba[2] == grey.blue ? 1 : 0;
        missing += vertex.rgba[0] == 255 && vertex.rgba[1] == 0 && vertex.rgba[2] == 255 ? 1 : 0;
    }
    EXPECT_EQ(shown, missing + 12) << "half of the sides each, and the ends";
    EXPECT_EQ(shown + missing, room.batch.vertices().size());
}

TEST_F(TubeSolidsOfTest, AnOpaqueTubeMayHaveARim) {
    ElementOfTest test(lines({200}));
    test.element.halo_px = 2;
    const ElementCount count = add(test);
    ASSERT_EQ(room.batch.pieces().size(), 2u);
    const SolidPiece &tube = room.batch.pieces()[0], &rim = room.batch.pieces()[1];
    EXPECT_EQ(tube.look.halo_px, 0);
    EXPECT_EQ(rim.look.halo_px, 2);
    EXPECT_FALSE(rim.look.is_mixed);
    EXPECT_EQ(rim.vertices, 6 * count.drawn);
    EXPECT_EQ(test_support::open_edges(room.batch, rim), 0u);
    EXPECT_EQ(test_support::open_edges(room.batch, tube), 0u);
    EXPECT_NEAR(test_support::volume_m3(room.batch, rim), test_support::volume_m3(room.batch, tube),
                1e-3 * test_support::volume_m3(room.batch, tube));
    room.batch.clear();
    test.element.opacity = 0.5;
    static_cast<void>(add(test));
    for (const SolidPiece& piece : room.batch.pieces()) EXPECT_EQ(piece.look.halo_px, 0) << "it would be seen through the tube";
}

TEST_F(TubeSolidsOfTest, WideningIsAsFarAsThePlaceMayBeOff) {
    host_sim::LayerDraft layer = lines({});
    layer.points = {scene_point(46.8, 9.8, 3000), scene_point(46.8, 9.9, 3000)};
    layer.starts = {0, 2};
    ElementOfTest silent(layer);
    silent.element.uncertainty = design::ElementUncertainty::widening;
    static_cast<void>(add(silent));
    EXPECT_EQ(room.batch.pieces().size(), 1u) << "nothing is stated";
    layer.position_accuracy_m = 160;
    const auto widest = [&](const host_sim::LayerDraft& draft) {
        ElementOfTest test(draft);
        test.element.uncertainty = design::ElementUncertainty::widening;
        room.batch.clear();
        static_cast<void>(add(test));
        EXPECT_EQ(room.batch.pieces().size(), 2u);
        const SolidPiece& hull = room.batch.pieces()[1];
        EXPECT_TRUE(hull.look.is_mixed);
        EXPECT_LT(hull.look.opacity, 1);
        double north_m = 0;
        const LocalAxes axes = local_axes(base::radians(46.8), base::radians(9.8));
        for (std::uint32_t n = 0; n < hull.vertices; ++n)
            north_m = std::max(north_m, glm::dot(glm::dvec3(room.batch.vertices()[hull.first_vertex + n].place_m), axes.north));
        return north_m;
    };
    const double corner = std::cos(base::radians(15));
    EXPECT_NEAR(widest(layer), 200 * corner, 7) << "corners beside the axis; the way bends by the meridians";
    host_sim::AttributeDraft own;
    own.name = "position_accuracy";
    own.values = {460, 460};
    layer.attributes.push_back(own);
    layer.height_accuracy_m = 460;
    EXPECT_NEAR(widest(layer), 500 * corner, 7) << "what is stated of the points goes first";
    layer.attributes[0].values = {std::nanf(""), 460};
    EXPECT_NEAR(widest(layer), 500 * corner, 7) << "the other point's";
    layer.position_accuracy_m = 0;
    layer.attributes[0].values = {0, 460};
    const double worst = widest(layer);
    layer.attributes[0].values = {460, 0};
    EXPECT_NEAR(widest(layer), worst, 1) << "what states none is as wide as the worst, at either end";
}

TEST_F(TubeSolidsOfTest, PostsStandUnderBothEnds) {
    host_sim::LayerDraft layer = lines({200});
    ElementOfTest test(layer);
    const auto vertices = [&] {
        room.batch.clear();
        static_cast<void>(add(test));
        return room.batch.vertices().size();
    };
    const std::size_t bare = vertices();
    test.element.link = true;
    EXPECT_EQ(vertices(), bare + 2 * 16);
    test.ground.is_known = false;
    EXPECT_EQ(vertices(), bare);
    test.ground.is_known = true;
    test.element.link = false;
    test.element.technique = design::DataTechnique::space_time;
    test.element.size_m = 3600;
    static_cast<void>(vertices());
    double low = 1e9, high = -1e9;
    for (const SolidVertex& vertex : room.batch.vertices()) {
        const double height_m = earth::from_ecef(room.batch.pieces()[0].anchor + glm::dvec3(vertex.place_m)).height.m;
        low = std::min(low, height_m);
        high = std::max(high, height_m);
    }
    EXPECT_NEAR(low, 600 - kDefaultTubeRadius_m, 6);
    EXPECT_NEAR(high, 600 + 199, kDefaultTubeRadius_m);
}

TEST_F(TubeSolidsOfTest, TheSameSideFacesUpwardsAllAlong) {
    host_sim::LayerDraft layer = lines({});
    for (int n = 0; n < 400; ++n) {
        const double turn = 0.1 * n;  // in circles that climb and sink
        layer.points.push_back(scene_point(46.8 + 0.02 * std::cos(turn), 9.8 + 0.03 * std::sin(turn),
                                           3000 + 500 * static_cast<float>(std::sin(0.37 * turn))));
    }
    for (int n = 1; n < 10; ++n) {  // and straight up
        layer.points.push_back(layer.points[399]);
        layer.points.back().height_m += 100 * static_cast<float>(n);
    }
    layer.starts = {0, 409};
    bind(layer, "even", 0);
    bind(layer, "odd", 0);
    for (float& value : layer.attributes[1].values) value = std::numeric_limits<float>::quiet_NaN();
    ElementOfTest test(layer);
    test.element.by_color.attribute = "even";
    test.element.by_color.scale.palette = test_support::grey_palette();
    test.element.by_second_color = test.element.by_color;
    test.element.by_second_color.attribute = "odd";
    ASSERT_GT(add(test).drawn, 100u);
    const glm::dvec3 up = glm::normalize(room.batch.pieces()[0].anchor);
    std::size_t upper = 0;
    for (const SolidVertex& vertex : room.batch.vertices()) {
        const glm::dvec3 normal((vertex.normal[0] - 127.0) / 127, (vertex.normal[1] - 127.0) / 127,
                                (vertex.normal[2] - 127.0) / 127);
        if (glm::dot(normal, up) < 0.9) continue;
        EXPECT_EQ(vertex.rgba[0], vertex.rgba[1]) << "grey, not the colour of what is missing";
        ++upper;
    }
    EXPECT_GT(upper, 200u);
}

TEST_F(TubeSolidsOfTest, WithoutPlaceNothingIsDrawn) {
    host_sim::LayerDraft layer = lines({30});
    for (scene::ScenePoint& point : layer.points) point.height_m = std::numeric_limits<float>::quiet_NaN();
    ElementOfTest test(layer);
    test.ground.is_known = false;
    const ElementCount count = add(test);
    EXPECT_EQ(count.hidden, 30u);
    EXPECT_EQ(room.batch.pieces().size(), 0u);
    ElementOfTest none(lines({}));
    EXPECT_EQ(add(none).all(), 0u);
}

class SmallTubeSolids : public TubeSolidsOfTest {
protected:
    SmallTubeSolids() : TubeSolidsOfTest(TubeSolids::rings_for(12288)) {}
};

TEST_F(SmallTubeSolids, TenLongFlightsFitTheSmallestDevice) {
    host_sim::LayerDraft layer = lines(std::vector<std::size_t>(10, 10000));
    bind(layer, "speed", 0.5f);
    ElementOfTest test(layer);
    test.element.by_color.attribute = "speed";
    test.element.by_color.scale.palette = test_support::grey_palette();
    test.element.halo_px = 1.5;
    SolidRoomOfTest small(12288, 192);
    const ElementCount count = tubes.add(small.batch, small.mesh, test.input());
    EXPECT_EQ(count.all(), 100'000u);
    EXPECT_EQ(count.hidden, 0u);
    EXPECT_EQ(small.batch.use().refused, 0u);
    EXPECT_LE(small.batch.vertices().size(), 12288 / 2u) << "others find room";
    EXPECT_GT(count.drawn, 200u);
}

}  // namespace
}  // namespace tedavis::draw::test_tube_solids
