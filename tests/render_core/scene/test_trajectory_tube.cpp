#include "render_core/scene/trajectory_tube.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/render_core/scene/curve_frames.hpp"

namespace tedavis::scene::test_trajectory_tube {
namespace {

using base::kPi;
using base::radians;
using test_support::is_orthonormal;
using test_support::KnotCurve;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const glm::dvec3 kUp(0, 0, 1);

using Places = std::vector<glm::dvec3>;

std::vector<TubePoint> points_at(const Places& places, float radius_m = 1) {
    std::vector<TubePoint> points;
    for (const glm::dvec3& place : places)
        points.push_back({place, base::Time{static_cast<std::int64_t>(points.size()) * 1'000'000'000}, radius_m});
    return points;
}

struct MadeTube {
    std::vector<TubeRing> rings;
    TubeCounts counts;
};

MadeTube tube_of(const std::vector<TubePoint>& points, const glm::dvec3& up = kUp, std::size_t room = 10000) {
    MadeTube made;
    made.rings.resize(room);
    made.counts = make_tube(points, up, made.rings);
    made.rings.resize(made.counts.rings);
    return made;
}

/// Within a piece.
double most_twist_deg(const MadeTube& tube) {
    double most = 0;
    for (std::size_t n = 1; n < tube.rings.size(); ++n)
        if (tube.rings[n].piece == tube.rings[n - 1].piece)
            most = std::max(most, std::abs(test_support::twist_between(tube.rings[n - 1].frame, tube.rings[n].frame)));
    return base::degrees(most);
}

void expect_sound(const MadeTube& tube) {
    for (std::size_t n = 0; n < tube.rings.size(); ++n) {
        ASSERT_TRUE(is_orthonormal(tube.rings[n].frame)) << "ring " << n;
        if (n == 0) continue;
        EXPECT_LE(tube.rings[n].piece - tube.rings[n - 1].piece, 1u);
        EXPECT_GE(tube.rings[n].source, tube.rings[n - 1].source);
    }
    EXPECT_LT(most_twist_deg(tube), 1);
}

Places straight(int count) {
    Places places;
    for (int n = 0; n < count; ++n) places.emplace_back(10.0 * n, 5.0 * n, 2.0 * n);
    return places;
}

Places u_turn() {
    Places places;
    for (int n = 0; n < 10; ++n) places.emplace_back(20 * n, 0, 100 + n);
    for (int n = 1; n < 12; ++n)
        places.emplace_back(180 + 50 * std::sin(kPi * n / 12), 50 - 50 * std::cos(kPi * n / 12), 110 + n);
    for (int n = 0; n < 10; ++n) places.emplace_back(180 - 20 * n, 100, 122 + n);
    return places;
}

TEST(TrajectoryTube, AStraightWayHasOneFrameWithTheNormalUp) {
    const MadeTube tube = tube_of(points_at(straight(8)));
    expect_sound(tube);
    ASSERT_EQ(tube.rings.size(), 8u);
    EXPECT_EQ(tube.counts.pieces, 1u);
    const glm::dvec3 tangent = glm::normalize(glm::dvec3(10, 5, 2));
    for (const TubeRing& ring : tube.rings) {
        EXPECT_LT(glm::length(ring.frame.tangent - tangent), 1e-14);
        EXPECT_LT(std::abs(glm::dot(ring.frame.binormal(), kUp)), 1e-14) << "across up, so that the flat side lies up";
        EXPECT_GT(glm::dot(ring.frame.normal, kUp), 0.9);
        EXPECT_FALSE(ring.folds);
    }
}

TEST(TrajectoryTube, StraightUpHasANormalToo) {
    const MadeTube tube = tube_of(points_at({{0, 0, 0}, {0, 0, 10}, {0, 0, 20}}));
    expect_sound(tube);
    EXPECT_EQ(tube.rings.size(), 3u);
}

TEST(TrajectoryTube, ACircleGivesExactTangents) {
    Places places;
    std::mt19937 random(1);
    for (double turn = 0; turn < 5; turn += 0.05 + 0.2 * static_cast<double>(random() % 1000) / 1000)
        places.emplace_back(300 * std::cos(turn), 300 * std::sin(turn), 50);
    const MadeTube tube = tube_of(points_at(places));
    expect_sound(tube);
    for (std::size_t n = 1; n + 1 < tube.rings.size(); ++n) {
        EXPECT_LT(std::abs(glm::dot(tube.rings[n].frame.tangent, glm::normalize(places[n] - glm::dvec3(0, 0, 50)))), 1e-12);
        EXPECT_LT(glm::length(tube.rings[n].frame.normal - kUp), 1e-12);
    }
}

TEST(TrajectoryTube, RepeatedPointsChangeNothing) {
    const Places once = u_turn();
    Places repeated;
    std::mt19937 random(2);
    for (const glm::dvec3& place : once)
        for (unsigned n = 0; n <= random() % 3; ++n) repeated.push_back(place + glm::dvec3(0, 0, 1e-4 * n));
    const MadeTube clean = tube_of(points_at(once)), tube = tube_of(points_at(repeated));
    expect_sound(tube);
    ASSERT_EQ(tube.rings.size(), clean.rings.size());
    EXPECT_EQ(tube.counts.close_points, repeated.size() - once.size());
    for (std::size_t n = 0; n < clean.rings.size(); ++n) {
        EXPECT_EQ(tube.rings[n].centre, clean.rings[n].centre);
        EXPECT_EQ(tube.rings[n].frame.normal, clean.rings[n].frame.normal);
        EXPECT_EQ(repeated[tube.rings[n].source], once[n]);
    }
}

TEST(TrajectoryTube, CloseMeansAMillimetreOrATenMillionthOfTheDistance) {
    EXPECT_EQ(tube_of(points_at({{0, 0, 0}, {0.0009, 0, 0}, {1, 0, 0}})).counts.close_points, 1u);
    EXPECT_EQ(tube_of(points_at({{0, 0, 0}, {0.0011, 0, 0}, {1, 0, 0}})).counts.close_points, 0u);
    const glm::dvec3 place = earth::to_ecef({radians(46), radians(9), {2000}}), way = glm::normalize(glm::dvec3(1, 2, 3));
    EXPECT_EQ(tube_of(points_at({place, place + 0.6 * way, place + 5.0 * way})).counts.close_points, 1u);
    EXPECT_EQ(tube_of(points_at({place, place + 0.7 * way, place + 5.0 * way})).counts.close_points, 0u);
}

TEST(TrajectoryTube, AUTurnIsOneTube) {
    const MadeTube tube = tube_of(points_at(u_turn()));
    expect_sound(tube);
    EXPECT_EQ(tube.counts.pieces, 1u);
    EXPECT_EQ(tube.counts.cusps, 0u);
    EXPECT_GT(glm::dot(tube.rings.back().frame.normal, kUp), 0.96) << "a climbing turn hardly tips it";
    EXPECT_LT(glm::dot(tube.rings.back().frame.tangent, glm::dvec3(1, 0, 0)), -0.99);
}

TEST(TrajectoryTube, WhereTheWayTurnsBackOnItselfItIsSplit) {
    const MadeTube tube = tube_of(points_at({{0, 0, 0}, {10, 0, 1}, {20, 0, 2}, {10, 0, 1}, {0, 0, 0.1}, {10, 0, 1}}));
    expect_sound(tube);
    EXPECT_EQ(tube.counts.cusps, 2u);
    EXPECT_EQ(tube.counts.pieces, 3u);
    ASSERT_EQ(tube.rings.size(), 8u);
    EXPECT_EQ(tube.rings[2].source, 2u);
    EXPECT_EQ(tube.rings[3].source, 2u);
    EXPECT_EQ(tube.rings[3].piece, 1u);
    EXPECT_LT(glm::length(tube.rings[2].frame.tangent + tube.rings[3].frame.tangent), 1e-12);
    EXPECT_LT(glm::length(tube.rings[2].frame.normal - tube.rings[3].frame.normal), 1e-12) << "a half turn about it";
    // Just less of a turn is none.
    const double turn = std::acos(kCuspCosine) - 1e-3, wider = turn + 2e-3;
    EXPECT_EQ(tube_of(points_at({{-10, 0, 0}, {0, 0, 0}, {10 * std::cos(turn), 10 * std::sin(turn), 0}})).counts.cusps, 0u);
    EXPECT_EQ(tube_of(points_at({{-10, 0, 0}, {0, 0, 0}, {10 * std::cos(wider), 10 * std::sin(wider), 0}})).counts.cusps, 1u);
}

TEST(TrajectoryTube, FewPoints) {
    const MadeTube two = tube_of(points_at({{0, 0, 0}, {3, 4, 0}}));
    expect_sound(two);
    ASSERT_EQ(two.rings.size(), 2u);
    EXPECT_LT(glm::length(two.rings[0].frame.normal - kUp), 1e-15);
    for (const Places& places : {Places{{1, 2, 3}}, Places{{1, 2, 3}, {1, 2, 3}}, Places{{0, 0, 0}}}) {
        const MadeTube one = tube_of(points_at(places), {0, 0, 0});
        expect_sound(one);
        ASSERT_EQ(one.rings.size(), 1u);
        EXPECT_TRUE(one.rings[0].is_marker);
        EXPECT_EQ(one.rings[0].centre, places[0]);
        EXPECT_EQ(one.counts.markers, 1u);
        EXPECT_EQ(one.counts.pieces, 1u);
    }
    const MadeTube none = tube_of({});
    EXPECT_EQ(none.counts.rings + none.counts.pieces + none.counts.points_left_out, 0u);
}

TEST(TrajectoryTube, PointsThatAreNoPlacesEndAPiece) {
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e13}) {
        Places places = straight(9);
        places[3].y = bad;
        places[7].x = bad;
        const MadeTube tube = tube_of(points_at(places));
        expect_sound(tube);
        EXPECT_EQ(tube.counts.missing_points, 2u);
        EXPECT_EQ(tube.counts.pieces, 3u);
        EXPECT_EQ(tube.counts.markers, 1u) << "the last stands alone";
        ASSERT_EQ(tube.rings.size(), 7u);
        EXPECT_EQ(tube.rings[3].source, 4u);
        EXPECT_EQ(tube.rings[3].piece, 1u);
        EXPECT_TRUE(tube.rings[6].is_marker);
        EXPECT_FALSE(tube.rings[5].is_marker);
    }
    for (const float radius : {std::numeric_limits<float>::quiet_NaN(), 0.0f, -1.0f, std::numeric_limits<float>::infinity()}) {
        std::vector<TubePoint> points = points_at(straight(6));
        points[0].radius_m = points[5].radius_m = radius;
        const MadeTube tube = tube_of(points);
        EXPECT_EQ(tube.counts.missing_points, 2u);
        EXPECT_EQ(tube.counts.pieces, 1u);
        EXPECT_EQ(tube.rings.size(), 4u);
    }
    const MadeTube none = tube_of(points_at(Places(4, glm::dvec3(kNan))));
    EXPECT_EQ(none.counts.missing_points, 4u);
    EXPECT_EQ(none.counts.pieces, 0u);
}

TEST(TrajectoryTube, TimeThatRunsBackEndsAPieceAndTimeThatStandsDoesNot) {
    std::vector<TubePoint> points = points_at(straight(8));
    points[3].time = points[2].time;
    for (int n = 5; n < 8; ++n) points[n].time = points[n].time - base::Duration::seconds(3);
    const MadeTube tube = tube_of(points);
    expect_sound(tube);
    EXPECT_EQ(tube.counts.times_back, 1u);
    EXPECT_EQ(tube.counts.pieces, 2u);
    ASSERT_EQ(tube.rings.size(), 8u);
    EXPECT_EQ(tube.rings[5].piece, 1u);
    EXPECT_EQ(tube.rings[5].source, 5u);
}

TEST(TrajectoryTube, ABendTighterThanTheTubeIsWideIsFlagged) {
    Places places;
    for (int n = 0; n < 20; ++n) places.emplace_back(50 * std::cos(n * 0.2), 50 * std::sin(n * 0.2), 0);
    const MadeTube wide = tube_of(points_at(places, 50.1f)), narrow = tube_of(points_at(places, 49.9f));
    EXPECT_EQ(wide.counts.folds, 18u) << "all but the ends, which have no bend";
    EXPECT_TRUE(wide.rings[5].folds);
    EXPECT_FALSE(wide.rings[0].folds || wide.rings[19].folds);
    EXPECT_EQ(narrow.counts.folds, 0u);
}

TEST(TrajectoryTube, RadiiAreThoseOfTheirPoints) {
    std::vector<TubePoint> points = points_at(straight(5));
    for (int n = 0; n < 5; ++n) points[n].radius_m = 1 + static_cast<float>(n);
    const MadeTube tube = tube_of(points);
    for (int n = 0; n < 5; ++n) EXPECT_EQ(tube.rings[n].radius_m, 1 + static_cast<float>(n));
}

/// Between the tube's last frame and the integrated one.
double end_twist_rad(int segments) {
    const KnotCurve curve{1000};
    const double end = 2 * kPi * 0.9;
    Places places;
    for (int n = 0; n <= segments; ++n) places.push_back(curve.at(end * n / segments));
    const MadeTube tube = tube_of(points_at(places), kUp);
    const glm::dvec3 begin = test_support::least_rotated(tube.rings[0].frame, curve.tangent(0));
    const TubeFrame truth{curve.tangent(end), test_support::integrated_normal(curve, begin, end, 100 * segments)};
    return std::abs(test_support::twist_between(truth, tube.rings.back().frame));
}

TEST(TrajectoryTube, ErrorFromPointsAloneFallsWithMoreThanTheirNumberCubed) {
    double last = end_twist_rad(40);
    EXPECT_LT(last, radians(2));
    for (const int segments : {80, 160, 320}) {
        const double error = end_twist_rad(segments);
        EXPECT_GT(std::log2(last / error), 3.3) << segments << " segments: " << error;
        last = error;
    }
}

TEST(TrajectoryTube, AWorldTurnedTurnsTheTube) {
    const glm::dmat3 turn = earth::body_axes(radians(30), radians(70), radians(50), radians(20), radians(110));
    const Places places = u_turn();
    Places turned;
    for (const glm::dvec3& place : places) turned.push_back(turn * place);
    const MadeTube tube = tube_of(points_at(places)), other = tube_of(points_at(turned), turn * kUp);
    ASSERT_EQ(tube.rings.size(), other.rings.size());
    for (std::size_t n = 0; n < tube.rings.size(); ++n) {
        EXPECT_LT(glm::length(turn * tube.rings[n].frame.tangent - other.rings[n].frame.tangent), 1e-12);
        EXPECT_LT(glm::length(turn * tube.rings[n].frame.normal - other.rings[n].frame.normal), 1e-12);
        EXPECT_LT(glm::length(turn * tube.rings[n].frame.binormal() - other.rings[n].frame.binormal()), 1e-12) << "and no mirror";
    }
}

TEST(TrajectoryTube, WithoutUpItIsAwayFromTheOrigin) {
    Places places;
    for (int n = 0; n < 5; ++n) places.push_back(earth::to_ecef({radians(46), radians(9 + 0.001 * n), {2000}}));
    const MadeTube tube = tube_of(points_at(places), {0, 0, 0});
    expect_sound(tube);
    const glm::dvec3 down = earth::north_east_down(radians(46), radians(9))[2];
    EXPECT_LT(glm::dot(tube.rings[0].frame.normal, down), -0.9999);
}

TEST(TrajectoryTube, WhereRoomEndsSoDoesTheTubeAndTheRestIsCounted) {
    Places places = straight(6);
    places[3] = glm::dvec3(kNan);
    places.push_back(places[4]);  // a cusp
    const std::vector<TubePoint> points = points_at(places);
    const MadeTube whole = tube_of(points);
    ASSERT_EQ(whole.rings.size(), 7u);
    ASSERT_EQ(whole.counts.cusps, 1u);
    for (std::size_t room = 0; room < 7; ++room) {
        const MadeTube tube = tube_of(points, kUp, room);
        expect_sound(tube);
        const std::size_t shown = tube.rings.size();
        EXPECT_EQ(shown, room == 1 ? 0 : room == 4 ? 3 : room == 6 ? 5 : room) << "no piece of a single ring";
        EXPECT_EQ(tube.counts.points_left_out, points.size() - (shown == 0 ? 0 : whole.rings[shown - 1].source + 1));
        EXPECT_EQ(tube.counts.pieces, shown == 0 ? 0 : whole.rings[shown - 1].piece + 1);
        for (std::size_t n = 0; n < shown; ++n) EXPECT_EQ(tube.rings[n].frame.normal, whole.rings[n].frame.normal);
    }
    EXPECT_EQ(tube_of(points, kUp, 7).counts.points_left_out, 0u);
}

TEST(TrajectoryTube, AnyRecordingGivesFiniteFrames) {
    std::mt19937 random(9);
    for (int run = 0; run < 300; ++run) {
        std::vector<TubePoint> points = points_at(Places(60));
        for (TubePoint& point : points) {
            for (int axis = 0; axis < 3; ++axis) point.position[axis] = static_cast<double>(random() % 5) - 2;
            if (random() % 12 == 0) point.position.x = kNan;
            if (random() % 12 == 0) point.time = {};
        }
        const MadeTube tube = tube_of(points);
        EXPECT_EQ(tube.counts.points_left_out, 0u);
        EXPECT_EQ(tube.counts.rings + tube.counts.close_points + tube.counts.missing_points, points.size() + tube.counts.cusps);
        for (const TubeRing& ring : tube.rings) ASSERT_TRUE(is_orthonormal(ring.frame));
    }
}

TEST(TrajectoryTube, TheTwistOfASeededFrameIsFound) {
    MadeTube tube = tube_of(points_at(u_turn()));
    ASSERT_LT(most_twist_deg(tube), 1);
    TubeFrame& frame = tube.rings[5].frame;
    frame.normal = std::cos(0.05) * frame.normal + std::sin(0.05) * frame.binormal();
    EXPECT_GT(most_twist_deg(tube), 2);
}

}  // namespace
}  // namespace tedavis::scene::test_trajectory_tube
