#include "render_core/draw/data/trajectory_cues.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_trajectory_cues {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::size_t kPostVertices = 8;
constexpr double kTolerance_m = 5;  // a tenth of a radius: of what points the tube leaves out

struct Place {
    double latitude_deg = 0, longitude_deg = 0, height_m = 0;
};

Place place_of(const glm::dvec3& at) {
    Place result;
    GeographicLib::Geocentric::WGS84().Reverse(at.x, at.y, at.z, result.latitude_deg, result.longitude_deg, result.height_m);
    return result;
}

double distance_m(const Place& a, const Place& b) {
    double distance = 0;
    GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg, b.longitude_deg, distance);
    return distance;
}

/// Hills, wherever the world is turned to.
class Hills final : public scene::Ground {
public:
    explicit Hills(double turned_deg = 0) : turned_rad_(base::radians(turned_deg)) {}
    double height_m(double latitude_rad, double longitude_rad) override {
        return 900 + 300 * std::sin(4000 * latitude_rad) * std::cos(3000 * (longitude_rad - turned_rad_));
    }
    double undulation_m(double, double) override { return 0; }

private:
    double turned_rad_;
};

/// A way to the north and then to the east, a point every 500 m or so.
host_sim::LayerDraft way(double turned_deg = 0, float height_m = 2500) {
    host_sim::LayerDraft layer;
    layer.name = "flights";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    for (int n = 0; n <= 20; ++n) layer.points.push_back(scene_point(46.5 + 0.005 * n, 9.6 + turned_deg, height_m));
    for (int n = 1; n <= 20; ++n) layer.points.push_back(scene_point(46.6, 9.6 + turned_deg + 0.005 * n, height_m));
    layer.starts = {0, static_cast<std::uint32_t>(layer.points.size())};
    return layer;
}

class TrajectoryCuesOfTest : public ::testing::Test {
protected:
    TrajectoryCuesOfTest() : memory_(TrajectoryCues::bytes_needed(1024)) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(cues.start(arena, 1024));
    }

    CueCount add(ElementOfTest& test, Cue cue, scene::Ground& ground, const glm::dvec3& eye = glm::dvec3(0)) {
        room.batch.clear();
        const ElementInput made = test.input();
        const ElementInput input{made.element, made.group, made.layer, ground, made.missing, made.time_ns, made.has_date, eye};
        return cues.add(room.batch, room.mesh, input, cue);
    }

    /// In ECEF, in the order of being added.
    [[nodiscard]] std::vector<glm::dvec3> vertices() const {
        std::vector<glm::dvec3> all;
        for (const SolidPiece& piece : room.batch.pieces())
            for (std::uint32_t n = 0; n < piece.vertices; ++n)
                all.push_back(piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m));
        return all;
    }
    /// Middles of the lines' lower (0) or upper (1) ends.
    [[nodiscard]] std::vector<Place> ends(std::size_t upper) const {
        const std::vector<glm::dvec3> all = vertices();
        std::vector<Place> found;
        for (std::size_t n = 0; n + kPostVertices <= all.size(); n += kPostVertices) {
            glm::dvec3 sum(0);
            for (std::size_t k = 0; k < 4; ++k) sum += all[n + 2 * k + upper];
            found.push_back(place_of(0.25 * sum));
        }
        return found;
    }

    TrajectoryCues cues;
    SolidRoomOfTest room;
    Hills hills;

private:
    std::vector<unsigned char> memory_;
};

TEST_F(TrajectoryCuesOfTest, LinesAreEquidistantAlongTheWay) {
    for (const double spacing_m : {500.0, 1852.0}) {
        ElementOfTest test(way());
        test.element.cues.line_spacing_m = spacing_m;
        const CueCount count = add(test, Cue::vertical_lines, hills);
        const std::vector<Place> lines = ends(0);
        ASSERT_EQ(lines.size(), count.drawn);
        const Place begin{46.5, 9.6}, corner{46.6, 9.6}, end{46.6, 9.7};
        const double first_m = distance_m(begin, corner), all_m = first_m + distance_m(corner, end);
        EXPECT_EQ(lines.size(), 1 + static_cast<std::size_t>(all_m / spacing_m));
        for (std::size_t n = 0; n < lines.size(); ++n) {
            const double along_m =
                lines[n].longitude_deg < 9.6 + 1e-6 ? distance_m(begin, lines[n]) : first_m + distance_m(corner, lines[n]);
            EXPECT_NEAR(along_m, spacing_m * static_cast<double>(n), 0.5);
        }
    }
}

TEST_F(TrajectoryCuesOfTest, LinesStandOnTheGroundWhereTheyAreToReachIt) {
    ElementOfTest test(way());
    test.element.size_m = 50;
    test.element.cues.line_spacing_m = 700;
    static_cast<void>(add(test, Cue::vertical_lines, hills));
    for (const Place& low : ends(0)) EXPECT_NEAR(low.height_m, 2500 - 50 * kTickRadii, kTolerance_m) << "control";
    for (const Place& high : ends(1)) EXPECT_NEAR(high.height_m, 2500 + 50 * kTickRadii, kTolerance_m);
    test.element.cues.lines_to_ground = true;
    EXPECT_GT(add(test, Cue::vertical_lines, hills).drawn, 20u);
    for (const Place& low : ends(0))
        EXPECT_NEAR(low.height_m, hills.height_m(base::radians(low.latitude_deg), base::radians(low.longitude_deg)), 0.1);
    EXPECT_EQ(test_support::open_edges(room.batch, room.batch.pieces()[0]), 0u);
    EXPECT_GT(test_support::volume_m3(room.batch, room.batch.pieces()[0]), 0);
    test.ground.is_known = false;
    static_cast<void>(add(test, Cue::vertical_lines, test.ground));
    for (const Place& low : ends(0)) EXPECT_NEAR(low.height_m, 2500 - 50 * kTickRadii, kTolerance_m) << "no ground to reach";
}

/// Curtains are not shaded, but say how they hang: level, across their way.
TEST_F(TrajectoryCuesOfTest, CurtainsHaveNormalsTooShortToBeShaded) {
    ElementOfTest test(way());
    test.element.cues.curtain = 0.5;
    test.element.grid = true;
    ASSERT_GT(add(test, Cue::curtain, hills).drawn, 50u);
    int eastwards = 0, southwards = 0;
    for (const SolidPiece& piece : room.batch.pieces()) {
        EXPECT_TRUE(piece.look.has_grid);
        for (std::uint32_t n = 0; n < piece.vertices; ++n) {
            const SolidVertex& vertex = room.batch.vertices()[piece.first_vertex + n];
            const glm::dvec3 normal = glm::dvec3(vertex.normal[0], vertex.normal[1], vertex.normal[2]) / 127.0 - 1.0;
            EXPECT_NEAR(glm::length(normal), kUnshaded, 0.01);
            EXPECT_LT(glm::length(normal), 0.5) << "or it would be shaded";
            const earth::Geodetic at = earth::from_ecef(piece.anchor + glm::dvec3(vertex.place_m));
            const glm::dmat3 ned = earth::north_east_down(at.latitude_rad, at.longitude_rad);
            EXPECT_NEAR(glm::dot(normal, ned[2]), 0, 0.01);
            eastwards += glm::dot(normal, ned[1]) > 0.99 * kUnshaded ? 1 : 0;    // of the leg to the north
            southwards += glm::dot(normal, ned[0]) < -0.99 * kUnshaded ? 1 : 0;  // of that to the east
        }
    }
    EXPECT_GT(eastwards, 50);
    EXPECT_GT(southwards, 50);
    test.element.cues.line_spacing_m = 500;
    static_cast<void>(add(test, Cue::vertical_lines, hills));
    for (const SolidPiece& piece : room.batch.pieces()) EXPECT_FALSE(piece.look.has_grid) << "they are lines themselves";
}

TEST_F(TrajectoryCuesOfTest, LinesTravelByTheFlightsTime) {
    ElementOfTest test(way());
    test.element.cues.line_spacing_m = 1000;
    const auto first_m = [&](std::int64_t time_ns) {
        test.time_ns = time_ns;
        static_cast<void>(add(test, Cue::vertical_lines, hills));
        return distance_m({46.5, 9.6}, ends(0).at(0));
    };
    EXPECT_EQ(first_m(0), first_m(7 * kSecond_ns)) << "control: they stand";
    test.element.cues.lines_move = design::LineMotion::along;
    test.element.cues.line_speed_mps = 50;
    for (const std::int64_t seconds : {0, 3, 19, 20, 23})
        EXPECT_NEAR(first_m(seconds * kSecond_ns), static_cast<double>(seconds % 20) * 50, 0.1);
    constexpr std::int64_t kFlight_ns = 1'780'000'000 * kSecond_ns;
    EXPECT_EQ(first_m(kFlight_ns + 5 * kSecond_ns), first_m(kFlight_ns + 25 * kSecond_ns)) << "bit for bit after a period";
    EXPECT_NEAR(first_m(kFlight_ns + 6 * kSecond_ns) - first_m(kFlight_ns + 5 * kSecond_ns), 50, 0.1);
}

TEST_F(TrajectoryCuesOfTest, LinesGoAwayFromTheViewerBothWays) {
    ElementOfTest test(way());
    test.element.cues.line_spacing_m = 1000;
    test.element.cues.lines_move = design::LineMotion::away;
    test.element.cues.line_speed_mps = 50;
    const Place nearest{46.55, 9.6};
    const glm::dvec3 eye = earth::to_ecef({base::radians(46.55), base::radians(9.55), {2500}});
    const auto distances = [&](std::int64_t time_ns, bool northwards) {
        test.time_ns = time_ns;
        static_cast<void>(add(test, Cue::vertical_lines, hills, eye));
        std::vector<double> found;
        for (const Place& line : ends(0))
            if (line.longitude_deg < 9.6001 && (line.latitude_deg > 46.55) == northwards)
                found.push_back(distance_m(nearest, line));
        if (!northwards) std::reverse(found.begin(), found.end());
        return found;
    };
    for (const bool northwards : {true, false}) {
        const std::vector<double> before = distances(5 * kSecond_ns, northwards), after = distances(6 * kSecond_ns, northwards);
        ASSERT_GE(before.size(), 4u);
        ASSERT_GE(after.size(), 4u);
        for (std::size_t n = 0; n < 4; ++n) EXPECT_NEAR(after[n] - before[n], 50, 0.5) << northwards;
    }
}

TEST_F(TrajectoryCuesOfTest, LinesOfOtherAircraftAreCountedFromWhereTheyAre) {
    host_sim::LayerDraft layer = way();
    layer.role = scene::LayerRole::traffic;
    ElementOfTest test(layer);
    test.element.cues.line_spacing_m = 1000;
    static_cast<void>(add(test, Cue::vertical_lines, hills));
    const std::vector<Place> lines = ends(0);
    ASSERT_GT(lines.size(), 5u);
    EXPECT_NEAR(distance_m(lines.back(), {46.6, 9.7}), 0, 0.1);
    EXPECT_NEAR(distance_m(lines[lines.size() - 2], {46.6, 9.7}), 1000, 0.2);
}

TEST_F(TrajectoryCuesOfTest, CurtainsHangFromTheWayToTheGround) {
    ElementOfTest test(way());
    test.element.cues.curtain = 0.3;
    const CueCount count = add(test, Cue::curtain, hills);
    EXPECT_GT(count.drawn, 15'000 / kLongestStep_m);
    const std::vector<glm::dvec3> all = vertices();
    ASSERT_GT(all.size(), 0u);
    for (std::size_t n = 0; n + 1 < all.size(); n += 2) {
        const Place low = place_of(all[n]), high = place_of(all[n + 1]);
        EXPECT_NEAR(low.height_m, hills.height_m(base::radians(low.latitude_deg), base::radians(low.longitude_deg)), 0.1);
        EXPECT_NEAR(high.height_m, 2500, kTolerance_m);
        EXPECT_LT(distance_m(low, high), 0.05) << "upright";
    }
    for (const SolidPiece& piece : room.batch.pieces()) {
        EXPECT_TRUE(piece.look.is_mixed);
        EXPECT_FLOAT_EQ(piece.look.opacity, 0.3f);
        EXPECT_GT(piece.look.near_m, 0) << "nobody's view is filled by it";
    }
    test.ground.is_known = false;
    EXPECT_EQ(add(test, Cue::curtain, test.ground).drawn, 0u);
}

TEST_F(TrajectoryCuesOfTest, ProjectionsLieOnTheGroundBelow) {
    ElementOfTest test(way());
    test.element.size_m = 50;
    test.element.cues.projection = 0.5;
    EXPECT_GT(add(test, Cue::projection, test.ground).drawn, 15'000 / kLongestStep_m);
    const std::vector<glm::dvec3> all = vertices();
    ASSERT_GT(all.size(), 8u);
    for (const glm::dvec3& at : all) EXPECT_NEAR(place_of(at).height_m, test.ground.height + kStripLift_m, 0.1);
    EXPECT_NEAR(distance_m(place_of(all[0]), place_of(all[1])), 100, 0.1) << "as wide as the tube";
    const Place left = place_of(all[0]), right = place_of(all[1]);
    EXPECT_NEAR(distance_m({0.5 * (left.latitude_deg + right.latitude_deg), 0.5 * (left.longitude_deg + right.longitude_deg)},
                           {46.5, 9.6}),
                0, 0.1);
    const SolidVertex& shown = room.batch.vertices()[0];
    EXPECT_LT(shown.rgba[0], test.element.color.red) << "like a shadow";
    EXPECT_GT(room.batch.pieces()[0].look.raised_px, 0);
}

TEST_F(TrajectoryCuesOfTest, NothingHangsFromWhatIsOnTheGround) {
    ElementOfTest test(way(0, 603));
    test.element.cues = {500, true, design::LineMotion::still, 0, 0.5, 0.3};
    for (const Cue cue : {Cue::vertical_lines, Cue::projection, Cue::curtain}) {
        const CueCount count = add(test, cue, test.ground);
        EXPECT_EQ(count.drawn + count.hidden, 0u);
    }
    test.ground.height = 590;
    for (const Cue cue : {Cue::vertical_lines, Cue::projection, Cue::curtain})
        EXPECT_GT(add(test, cue, test.ground).drawn, 0u) << "control";
}

TEST_F(TrajectoryCuesOfTest, WhatIsUnsureLooksUnsure) {
    host_sim::LayerDraft layer = way();
    layer.position_accuracy_m = 150;
    host_sim::AttributeDraft speed;
    speed.name = "speed";
    speed.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    speed.uncertainty_full = 4;
    for (std::size_t n = 0; n < layer.points.size(); ++n) {
        speed.values.push_back(10);
        speed.uncertainties.push_back(scene::Uncertainty::from_level(0.75));
    }
    layer.attributes.push_back(speed);
    ElementOfTest test(layer);
    test.element.size_m = 50;
    test.element.cues = {500, true, design::LineMotion::still, 0, 1, 1};
    test.element.uncertainty = design::ElementUncertainty::transparency;
    for (const Cue cue : {Cue::vertical_lines, Cue::projection, Cue::curtain}) {
        static_cast<void>(add(test, cue, hills));
        const SolidLook look = room.batch.pieces()[0].look, tube = look_of(test.input());
        EXPECT_EQ(look.fading, SolidFading::transparency);
        EXPECT_EQ(look.fading_strength, tube.fading_strength);
        for (const SolidVertex& vertex : room.batch.vertices())
            EXPECT_EQ(vertex.uncertainty, scene::Uncertainty::from_level(0.75).code());
    }
    test.element.uncertainty = design::ElementUncertainty::widening;
    for (const Cue cue : {Cue::vertical_lines, Cue::projection, Cue::curtain}) {
        static_cast<void>(add(test, cue, hills));
        EXPECT_LE(room.batch.pieces()[0].look.opacity, kMarginShare) << "no surer than the hull";
        EXPECT_TRUE(room.batch.pieces()[0].look.is_mixed);
        if (cue != Cue::projection) continue;
        EXPECT_NEAR(distance_m(place_of(vertices()[0]), place_of(vertices()[1])), 2 * (50 + 150), 0.5);
    }
}

TEST_F(TrajectoryCuesOfTest, WhatHasNoRoomIsCounted) {
    ElementOfTest test(way());
    test.element.cues = {100, true, design::LineMotion::still, 0, 0.5, 0.3};
    for (const Cue cue : {Cue::vertical_lines, Cue::projection, Cue::curtain}) {
        const CueCount all = add(test, cue, hills);
        EXPECT_EQ(all.hidden, 0u);
        room = SolidRoomOfTest(192);
        const CueCount some = add(test, cue, hills);
        EXPECT_GT(some.drawn, 0u);
        EXPECT_GT(some.hidden, 0u);
        EXPECT_EQ(some.drawn + some.hidden, all.drawn);
        EXPECT_GT(room.batch.use().refused, 0u);
        room = SolidRoomOfTest();
    }
}

TEST_F(TrajectoryCuesOfTest, ATurnedWorldHasTheSameCues) {
    constexpr double kTurned_deg = 77;
    const double c = std::cos(base::radians(kTurned_deg)), s = std::sin(base::radians(kTurned_deg));
    for (const Cue cue : {Cue::vertical_lines, Cue::projection, Cue::curtain}) {
        std::vector<glm::dvec3> seen[2];
        for (const double turned_deg : {0.0, kTurned_deg}) {
            ElementOfTest test(way(turned_deg));
            test.element.cues = {500, true, design::LineMotion::still, 0, 0.5, 0.3};
            Hills ground(turned_deg);
            static_cast<void>(add(test, cue, ground));
            seen[turned_deg > 0 ? 1 : 0] = vertices();
        }
        ASSERT_EQ(seen[0].size(), seen[1].size());
        ASSERT_GT(seen[0].size(), 100u);
        for (std::size_t n = 0; n < seen[0].size(); ++n) {
            const glm::dvec3& at = seen[0][n];
            EXPECT_LT(glm::distance(glm::dvec3(c * at.x - s * at.y, s * at.x + c * at.y, at.z), seen[1][n]), 0.05);
        }
    }
}

}  // namespace
}  // namespace tedavis::draw::test_trajectory_cues
