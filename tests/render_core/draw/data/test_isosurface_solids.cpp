#include "render_core/draw/data/isosurface_solids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_isosurface_solids {
namespace {

using test_support::ElementOfTest;
using test_support::SolidRoomOfTest;

constexpr double kRadius_m = 3000, kMiddle_m = 5000;
constexpr std::int64_t kHour_ns = 3'600'000'000'000, kStart_ns = 438'000 * kHour_ns;

glm::dvec3 middle() { return earth::to_ecef({base::radians(46.75), base::radians(9.8), {kMiddle_m + 50}}); }

/// Metres within a ball round the middle; levels lie unevenly, and their heights are over the sea.
host_sim::LayerDraft ball(std::uint32_t across = 31, std::size_t levels = 25) {
    host_sim::LayerDraft layer;
    layer.name = "air";
    layer.shape = scene::LayerShape::grid;
    const double step_lat = base::radians(0.1) / (across - 1), step_lon = base::radians(0.14) / (across - 1);
    layer.grid = {
        base::radians(9.73), base::radians(46.8), step_lon, step_lat, across, across, static_cast<std::uint32_t>(levels), 1};
    for (std::size_t n = 0; n < levels; ++n) {
        const double share = static_cast<double>(n) / static_cast<double>(levels - 1);
        layer.levels_m.push_back(static_cast<float>(1000 + 8000 * share * (0.8 + 0.2 * share)));
    }
    host_sim::AttributeDraft within;
    within.name = "within";
    for (const float level : layer.levels_m)
        for (std::uint32_t row = 0; row < across; ++row)
            for (std::uint32_t column = 0; column < across; ++column) {
                const glm::dvec3 at = earth::to_ecef({layer.grid.north_rad - row * step_lat,
                                                      layer.grid.west_rad + column * step_lon,
                                                      {static_cast<double>(level) + 50}});
                within.values.push_back(static_cast<float>(kRadius_m - glm::distance(at, middle())));
            }
    layer.attributes.push_back(within);
    return layer;
}

class IsosurfaceSolidsOfTest : public ::testing::Test {
protected:
    IsosurfaceSolidsOfTest() {
        const IsosurfaceRoom memory{65536, 4096, 16384};
        memory_.resize(IsosurfaceSolids::bytes_needed(memory));
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(surfaces.start(arena, memory));
    }
    ElementCount add(ElementOfTest& test) { return surfaces.add(room.batch, room.mesh, test.input()); }
    static ElementOfTest element(const host_sim::LayerDraft& draft, std::initializer_list<double> levels = {0}) {
        ElementOfTest test(draft);
        test.element.technique = design::DataTechnique::isosurface;
        for (const double level : levels) EXPECT_TRUE(test.element.levels.try_push_back(level));
        return test;
    }
    [[nodiscard]] double volume_m3() const {
        double all = 0;
        for (const SolidPiece& piece : room.batch.pieces()) {
            // Pieces are parts of one surface: each is closed towards the middle.
            const glm::dvec3 to_anchor = piece.anchor - middle();
            for (std::uint32_t n = 0; n + 2 < piece.indices; n += 3) {
                const auto at = [&](std::uint32_t k) {
                    const std::uint32_t index = piece.first_vertex + room.batch.indices()[piece.first_index + n + k];
                    return to_anchor + glm::dvec3(room.batch.vertices()[index].place_m);
                };
                all += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
            }
        }
        return all;
    }
    static bool is_line(const SolidPiece& piece) { return piece.look.halo_px > 0; }
    static double ball_m3(double radius_m) { return 4.0 / 3 * base::kPi * radius_m * radius_m * radius_m; }

    IsosurfaceSolids surfaces;
    SolidRoomOfTest room{65536, 256};

private:
    std::vector<unsigned char> memory_;
};

TEST_F(IsosurfaceSolidsOfTest, ABallOnTheEarthIsABall) {
    ElementOfTest test = element(ball());
    const ElementCount count = add(test);
    EXPECT_EQ(count.drawn, 31u * 31 * 25);
    EXPECT_EQ(count.all(), count.drawn);
    EXPECT_NEAR(volume_m3(), ball_m3(kRadius_m), 0.015 * ball_m3(kRadius_m)) << "positive: it faces outwards";
    ASSERT_FALSE(room.batch.pieces().empty());
    for (const SolidPiece& piece : room.batch.pieces())
        for (std::uint32_t n = 0; n < piece.vertices; ++n) {
            if (is_line(piece)) continue;
            const SolidVertex& vertex = room.batch.vertices()[piece.first_vertex + n];
            const glm::dvec3 outwards = piece.anchor + glm::dvec3(vertex.place_m) - middle();
            const glm::dvec3 normal(vertex.normal[0] - 127.0, vertex.normal[1] - 127.0, vertex.normal[2] - 127.0);
            EXPECT_NEAR(glm::length(outwards), kRadius_m, 25);
            EXPECT_GT(glm::dot(glm::normalize(normal), glm::normalize(outwards)), 0.99);
        }
}

TEST_F(IsosurfaceSolidsOfTest, InnerSurfacesAreMoreOpaque) {
    ElementOfTest test = element(ball(), {1000, 0, 2000});
    test.element.opacity = 0.6;
    test.element.by_color.attribute = "within";
    test.element.by_color.scale.palette = test_support::grey_palette();
    static_cast<void>(add(test));
    float opacity = 0;
    double radius_m = kRadius_m;
    std::size_t looks = 0;
    for (const SolidPiece& piece : room.batch.pieces()) {
        if (is_line(piece)) continue;
        if (piece.look.opacity != opacity) {
            EXPECT_GT(piece.look.opacity, opacity);
            opacity = piece.look.opacity;
            radius_m = kRadius_m - 1000.0 * static_cast<double>(looks++);
        }
        const SolidVertex& vertex = room.batch.vertices()[piece.first_vertex];
        EXPECT_NEAR(glm::length(piece.anchor + glm::dvec3(vertex.place_m) - middle()), radius_m, 40);
        EXPECT_EQ(vertex.rgba[0], design::scale_color(test.element.by_color.scale, kRadius_m - radius_m).red);
        EXPECT_TRUE(piece.look.is_mixed);
    }
    EXPECT_EQ(looks, 3u);
    EXPECT_FLOAT_EQ(opacity, 0.6f);
}

TEST_F(IsosurfaceSolidsOfTest, LinesLieOnItAtWholeThousandsOfFeet) {
    ElementOfTest test = element(ball());
    static_cast<void>(add(test));
    std::size_t ends = 0;
    double lowest_m = 1e9, highest_m = 0;
    for (const SolidPiece& piece : room.batch.pieces())
        for (std::uint32_t n = 0; is_line(piece) && n < piece.vertices; ++n, ++ends) {
            const glm::dvec3 at = piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m);
            EXPECT_NEAR(glm::distance(at, middle()), kRadius_m, 40);
            const double msl_m = earth::from_ecef(at).height.m - 50;  // as `ball` places them
            EXPECT_LT(std::fabs(std::remainder(msl_m, kIsosurfaceLines_m)), 0.5);
            lowest_m = std::min(lowest_m, msl_m);
            highest_m = std::max(highest_m, msl_m);
        }
    EXPECT_GT(ends, 400u);
    EXPECT_NEAR(lowest_m, 7 * kIsosurfaceLines_m, 0.5) << "from 2000 m";
    EXPECT_NEAR(highest_m, 26 * kIsosurfaceLines_m, 0.5) << "to 8000 m";
    test.element.detail = 0.4;
    room.batch.clear();
    static_cast<void>(add(test));
    for (const SolidPiece& piece : room.batch.pieces()) EXPECT_FALSE(is_line(piece)) << "of little detail it has none";
}

TEST_F(IsosurfaceSolidsOfTest, LittleDetailKeepsTheFirstLevels) {
    const auto volume_of = [&](std::initializer_list<double> levels, double detail) {
        ElementOfTest test = element(ball(), levels);
        test.element.detail = detail;
        room.batch.clear();
        static_cast<void>(add(test));
        return volume_m3();
    };
    EXPECT_EQ(volume_of({1000, 0, 2000}, 0.3), volume_of({1000}, 0.3)) << "as the design orders them";
    EXPECT_EQ(volume_of({1000, 0, 2000}, 0), volume_of({1000}, 0)) << "one always stays";
    EXPECT_NEAR(volume_of({1000, 0, 2000}, 0.6), volume_of({1000}, 0.6) + volume_of({0}, 0.6), 1);
    EXPECT_GT(volume_of({1000, 0, 2000}, 1), volume_of({1000, 0}, 1));
}

TEST_F(IsosurfaceSolidsOfTest, LittleRoomMakesItCoarser) {
    ElementOfTest test = element(ball());
    SolidRoomOfTest small(2000, 64);
    const ElementCount count = surfaces.add(small.batch, small.mesh, test.input());
    EXPECT_EQ(count.all(), 31u * 31 * 25);
    EXPECT_GT(count.aggregated, count.drawn);
    EXPECT_EQ(small.batch.use().refused, 0u);
    EXPECT_GT(small.batch.vertices().size(), 100u);
    test.element.detail = 0;
    EXPECT_GT(add(test).aggregated, 31u * 31 * 25 * 9 / 10);
    EXPECT_NEAR(volume_m3(), ball_m3(kRadius_m), 0.15 * ball_m3(kRadius_m));
    SolidRoomOfTest none(8, 1);
    EXPECT_EQ(surfaces.add(none.batch, none.mesh, test.input()).hidden, 31u * 31 * 25);
}

TEST_F(IsosurfaceSolidsOfTest, GridsWithTimesAreOfTheMinute) {
    host_sim::LayerDraft layer = ball(17, 13);
    layer.times_ns = {kStart_ns, kStart_ns + kHour_ns};
    layer.grid.times = 2;
    std::vector<float>& values = layer.attributes[0].values;
    const std::size_t posts = values.size();
    for (std::size_t n = 0; n < posts; ++n) values.push_back(values[n] - 1000);
    ElementOfTest test = element(layer);
    EXPECT_TRUE(isosurfaces_move(test.input().layer));
    const auto volume_at = [&](std::int64_t time_ns, bool has_date) {
        test.time_ns = time_ns;
        test.has_date = has_date;
        room.batch.clear();
        static_cast<void>(add(test));
        return volume_m3();
    };
    EXPECT_NEAR(volume_at(kStart_ns, true), ball_m3(3000), 0.05 * ball_m3(3000));
    const double half = volume_at(kStart_ns + kHour_ns / 2, true);
    EXPECT_NEAR(half, ball_m3(2500), 0.05 * ball_m3(2500));
    EXPECT_EQ(volume_at(kStart_ns + kHour_ns / 2 + 59'000'000'000, true), half) << "within the minute";
    EXPECT_LT(volume_at(kStart_ns + kHour_ns / 2 + 61'000'000'000, true), half);
    EXPECT_EQ(volume_at(5, false), volume_at(kStart_ns, true)) << "without a date the first time";
    EXPECT_EQ(volume_at(kStart_ns + kHour_ns / 2, true), half) << "whatever was shown before";
}

TEST_F(IsosurfaceSolidsOfTest, WhatIsMissingIsOpenAndCounted) {
    host_sim::LayerDraft layer = ball();
    layer.attributes[0].values[31 * 31 * 12 + 31 * 15 + 25] = std::numeric_limits<float>::quiet_NaN();
    ElementOfTest test = element(layer);
    const ElementCount count = add(test);
    EXPECT_EQ(count.hidden, 1u);
    EXPECT_EQ(count.all(), 31u * 31 * 25);
    ElementOfTest no_levels = element(layer, {});
    EXPECT_EQ(add(no_levels).hidden, count.all());
    ElementOfTest no_attribute = element(layer);
    no_attribute.element.by_color.attribute = "pressure";
    EXPECT_EQ(add(no_attribute).hidden, count.all());
}

TEST_F(IsosurfaceSolidsOfTest, VerticesKnowHowUnsureTheFieldIs) {
    host_sim::LayerDraft layer = ball();
    layer.attributes[0].uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    layer.attributes[0].uncertainty_full = 1;
    for (std::size_t n = 0; n < layer.attributes[0].values.size(); ++n)
        layer.attributes[0].uncertainties.push_back(scene::Uncertainty::from_level(n < 31 * 31 * 12 ? 0 : 1));
    ElementOfTest test = element(layer);
    static_cast<void>(add(test));
    const glm::dvec3 up = glm::normalize(middle());
    std::size_t sure = 0, unsure = 0;
    for (const SolidPiece& piece : room.batch.pieces())
        for (std::uint32_t n = 0; n < piece.vertices; ++n) {
            const SolidVertex& vertex = room.batch.vertices()[piece.first_vertex + n];
            if (is_line(piece)) continue;
            const double above_m = glm::dot(piece.anchor + glm::dvec3(vertex.place_m) - middle(), up);
            sure += above_m < -1000 && vertex.uncertainty == 0 ? 1 : 0;
            unsure += above_m > 1000 && vertex.uncertainty == scene::Uncertainty::kFull ? 1 : 0;
            EXPECT_FALSE(above_m > 1000 && vertex.uncertainty == 0);
        }
    EXPECT_GT(sure, 100u);
    EXPECT_GT(unsure, 100u);
}

TEST_F(IsosurfaceSolidsOfTest, FlatGridsHaveNone) {
    host_sim::LayerDraft layer = ball(5, 2);
    layer.levels_m.clear();
    layer.grid.levels = 1;
    layer.attributes[0].values.resize(25);
    ElementOfTest flat(layer), deep(ball(5, 2)), points(test_support::small_points());
    EXPECT_FALSE(shows_isosurfaces(flat.input().layer));
    EXPECT_TRUE(shows_isosurfaces(deep.input().layer));
    EXPECT_FALSE(shows_isosurfaces(points.input().layer));
    EXPECT_FALSE(isosurfaces_move(deep.input().layer));
}

}  // namespace
}  // namespace tedavis::draw::test_isosurface_solids
