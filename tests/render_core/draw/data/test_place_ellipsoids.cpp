#include "render_core/draw/data/place_ellipsoids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_place_ellipsoids {
namespace {

using design::ElementUncertainty;
using test_support::ElementOfTest;
using test_support::SolidRoomOfTest;

struct Built {
    explicit Built(const host_sim::LayerDraft& layer, ElementUncertainty uncertainty = ElementUncertainty::ellipsoid)
        : test(layer) {
        test.element.uncertainty = uncertainty;
        count = add_place_ellipsoids(room.batch, room.mesh, test.input());
    }
    ElementOfTest test;
    SolidRoomOfTest room;
    std::uint32_t count = 0;
};

TEST(PlaceEllipsoids, AreAsLargeAsTheAccuracies) {
    host_sim::LayerDraft layer = test_support::small_points();
    layer.position_accuracy_m = 40;
    layer.height_accuracy_m = 15;
    Built built(layer);
    EXPECT_EQ(built.count, 3u);
    const ElementInput input = built.test.input();
    const LocalAxes axes = local_axes(input.layer.points[0].latitude_rad, input.layer.points[0].longitude_rad);
    const SolidPiece& piece = built.room.batch.pieces()[0];
    const glm::dvec3 middle = placed(input, input.layer.points[0]).place;
    double level = 0, upright = 0;
    for (std::uint32_t n = 0; n < piece.vertices; ++n) {
        const glm::dvec3 at = piece.anchor + glm::dvec3(built.room.batch.vertices()[n].place_m) - middle;
        level = std::fmax(level, std::hypot(glm::dot(at, axes.east), glm::dot(at, axes.north)));
        upright = std::fmax(upright, std::abs(glm::dot(at, axes.up)));
    }
    EXPECT_NEAR(level, 40, 0.01);
    EXPECT_NEAR(upright, 15, 0.01);
    EXPECT_TRUE(piece.look.is_mixed);
    EXPECT_LT(piece.look.opacity, 0.31f);
    EXPECT_EQ(test_support::open_edges(built.room.batch, piece), 0u);
}

TEST(PlaceEllipsoids, WithoutAHeightAccuracyTheyAreSpheres) {
    Built built(test_support::small_points());
    EXPECT_EQ(built.count, 3u);
    const double sphere = 4.0 / 3 * base::kPi * 125;
    EXPECT_NEAR(test_support::volume_m3(built.room.batch, built.room.batch.pieces()[0]), sphere, 0.2 * sphere);
}

TEST(PlaceEllipsoids, AreThereOnlyWhereAskedForAndStated) {
    EXPECT_EQ(Built(test_support::small_points(), ElementUncertainty::transparency).count, 0u);
    host_sim::LayerDraft layer = test_support::small_points();
    layer.position_accuracy_m = 0;
    EXPECT_EQ(Built(layer).count, 0u);
    layer = test_support::small_areas();
    layer.position_accuracy_m = 50;
    EXPECT_EQ(Built(layer).count, 0u) << "areas have no one place";
}

TEST(PlaceEllipsoids, GoWithTheTraffic) {
    host_sim::LayerDraft layer = test_support::small_points();
    layer.attributes.clear();
    layer.names.clear();
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::traffic;
    layer.height_datum = scene::HeightDatum::msl;
    layer.starts = {0, 3};
    for (std::size_t n = 0; n < 3; ++n) {
        layer.points[n].height_m = 2000;
        layer.points[n].time_ns = static_cast<std::int64_t>(n) * 10'000'000'000;
    }
    Built built(layer);
    EXPECT_EQ(built.count, 1u);
    const double sure = test_support::volume_m3(built.room.batch, built.room.batch.pieces()[0]);
    built.test.has_date = true;
    built.test.time_ns = 30'000'000'000;
    built.room.batch.clear();
    EXPECT_EQ(add_place_ellipsoids(built.room.batch, built.room.mesh, built.test.input()), 1u);
    EXPECT_GT(test_support::volume_m3(built.room.batch, built.room.batch.pieces()[0]), 1000 * sure)
        << "10 s old, it may be anywhere";
    built.test.time_ns = 200'000'000'000;
    built.room.batch.clear();
    EXPECT_EQ(add_place_ellipsoids(built.room.batch, built.room.mesh, built.test.input()), 0u) << "gone for long";
}

TEST(PlaceEllipsoids, TheOwnShipHasOneAtTheEndOfItsWay) {
    host_sim::LayerDraft layer;
    layer.name = "own_trail";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    for (int n = 0; n < 5; ++n) layer.points.push_back(test_support::scene_point(46.8 + 0.01 * n, 9.8, 2000));
    layer.starts = {0, 2, 5};
    host_sim::AttributeDraft accuracy;
    accuracy.name = "position_accuracy";
    accuracy.of = scene::AttributeOf::point;
    accuracy.values = {900, 900, 900, 900, 120};
    layer.attributes.push_back(accuracy);
    ElementOfTest test(layer);
    test.element.uncertainty = ElementUncertainty::ellipsoid;
    const auto built = [&] {
        SolidRoomOfTest room;
        const std::uint32_t count = add_place_ellipsoids(room.batch, room.mesh, test.input());
        return std::pair<std::uint32_t, double>(count,
                                                count == 0 ? 0 : test_support::volume_m3(room.batch, room.batch.pieces()[0]));
    };
    EXPECT_EQ(built().first, 0u) << "control: a way that is not the own one has no one place";
    test.element.own = design::OwnData::trail;
    const auto [count, volume] = built();
    EXPECT_EQ(count, 1u);
    EXPECT_NEAR(volume, 4.0 / 3 * base::kPi * 120 * 120 * 120, 0.2 * 4.0 / 3 * base::kPi * 120 * 120 * 120);
}

}  // namespace
}  // namespace tedavis::draw::test_place_ellipsoids
