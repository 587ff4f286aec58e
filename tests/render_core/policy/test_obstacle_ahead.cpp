#include "render_core/policy/obstacle_ahead.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::policy::test_obstacle_ahead {
namespace {

using flight::FlightPhase;
using flight::Scenario;
using test_support::LoadedScene;

constexpr double kLatitude = base::radians(46.8), kLongitude = base::radians(9.8);
constexpr double kGround_m = 300;
constexpr double kNever = std::numeric_limits<double>::infinity();

double metres_per_latitude() { return earth::meridian_radius_m(kLatitude); }
double metres_per_longitude() { return earth::prime_vertical_radius_m(kLatitude) * std::cos(kLatitude); }

/// A plain.
class Plain : public scene::Ground, public GroundBound {
public:
    double height_m(double, double) override { return kGround_m; }
    double undulation_m(double, double) override { return 0; }
    double highest_m(double, double, double, double) override { return kGround_m; }
};

scene::ScenePoint point(double north_m, double east_m, double top_m) {
    return {kLatitude + north_m / metres_per_latitude(), kLongitude + east_m / metres_per_longitude(), static_cast<float>(top_m),
            0, scene::kNoTime};
}

/// Tops above MSL; the layer states the accuracies.
host_sim::LayerDraft masts(const std::vector<scene::ScenePoint>& points, double level_m = 0, double height_m = 0) {
    host_sim::LayerDraft layer;
    layer.name = "masts";
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = scene::HeightDatum::msl;
    layer.position_accuracy_m = static_cast<float>(level_m);
    layer.height_accuracy_m = static_cast<float>(height_m);
    layer.points = points;
    return layer;
}

host_sim::LayerDraft cable(const scene::ScenePoint& from, const scene::ScenePoint& to) {
    host_sim::LayerDraft layer = masts({from, to});
    layer.shape = scene::LayerShape::lines;
    layer.starts = {0, 2};
    return layer;
}

host_sim::LayerDraft runway(double from_m, double to_m) {
    host_sim::LayerDraft layer;
    layer.name = "runways";
    layer.role = scene::LayerRole::runway;
    layer.shape = scene::LayerShape::lines;
    layer.height_datum = scene::HeightDatum::ground;
    layer.points = {point(from_m, 0, std::nan("")), point(to_m, 0, std::nan(""))};
    layer.starts = {0, 2};
    return layer;
}

/// To the north at 70 m/s, 700 m over a plain.
struct Flown {
    PredictedTrack track{{kLatitude, kLongitude, {1000}}, 70, 0, 0};
    FlightPhase phase{Scenario::cruise, 0};
    TrackUncertainty uncertainty;

    double seconds(const host_sim::LayerDraft& obstacles, const LoadedScene* runways = nullptr) const {
        Plain plain;
        return seconds_over(plain, obstacles, runways);
    }

    double seconds_over(Plain& plain, const host_sim::LayerDraft& obstacles, const LoadedScene* runways = nullptr) const {
        const LoadedScene loaded(obstacles);
        const base::Span<const scene::Layer> layers =
            runways == nullptr ? base::Span<const scene::Layer>() : runways->scene().layers();
        TerrainWatch watch({track, uncertainty, phase, layers}, plain, plain);
        return ObstacleWatch(watch, plain).seconds_to(loaded.layer(), 0);
    }
};

TEST(ObstacleAhead, IsMetAtTheTimeOfItsPlaceLessTheTracksWidth) {
    const Flown flown;
    for (const double after_s : {20.0, 40.0, 55.0}) {
        const double told_s = flown.seconds(masts({point(70 * after_s, 0, 990)}));
        EXPECT_LT(told_s, after_s);
        const double width_m = 50 + (1 + 70 * 0.0175) * after_s + 70 * 0.00175 / 2 * after_s * after_s;
        EXPECT_GT(told_s, after_s - (width_m + 3 * 60 + width_m) / 70) << "its own uncertainty, and steps of half its width";
    }
    EXPECT_EQ(flown.seconds(masts({point(70 * 75, 0, 990)})), kNever) << "control: too far";
    EXPECT_EQ(flown.seconds(masts({point(70 * 40, 1500, 990)})), kNever) << "control: aside";
    EXPECT_EQ(flown.seconds(masts({point(-900, 0, 990)})), kNever) << "control: behind";
}

/// 700 ft, the uncertainty of the height, and what the climb may differ by until then.
TEST(ObstacleAhead, ItsTopCountsWithItsAccuracyAgainstTheClearanceOfThePhase) {
    Flown flown;
    const double floor_m = 1000 - 700 * 0.3048 - 20, at_m = 70 * 20, spent_m = 0.3 * 21;
    EXPECT_EQ(flown.seconds(masts({point(at_m, 0, floor_m - spent_m - 1)})), kNever);
    EXPECT_LT(flown.seconds(masts({point(at_m, 0, floor_m)})), 20);
    EXPECT_LT(flown.seconds(masts({point(at_m, 0, floor_m - spent_m - 8)}, 0, 10)), 20) << "stated to be 10 m off";
    flown.phase = flight::kApproachFinal;
    EXPECT_EQ(flown.seconds(masts({point(at_m, 0, floor_m)})), kNever) << "150 ft";
    EXPECT_LT(flown.seconds(masts({point(at_m, 0, 950)})), 20);
}

TEST(ObstacleAhead, ItsPlaceCountsWithItsAccuracy) {
    const Flown flown;
    EXPECT_EQ(flown.seconds(masts({point(70 * 30, 450, 990)})), kNever);
    EXPECT_LT(flown.seconds(masts({point(70 * 30, 450, 990)}, 350)), 30);
}

TEST(ObstacleAhead, ACableIsTheLineBetweenItsTops) {
    const Flown flown;
    EXPECT_LT(flown.seconds(cable(point(2100, -2000, 900), point(2100, 2000, 900))), 30) << "its poles are far aside";
    EXPECT_EQ(flown.seconds(cable(point(2100, -2000, 700), point(2100, 2000, 700))), kNever) << "control: lower";
    EXPECT_EQ(flown.seconds(cable(point(2100, 1000, 900), point(2100, 3000, 900))), kNever) << "control: it ends aside";
    EXPECT_EQ(flown.seconds(cable(point(2100, -3000, 500), point(2100, 3000, 900))), kNever) << "700 m where it is crossed";
    EXPECT_LT(flown.seconds(cable(point(2100, -3000, 700), point(2100, 3000, 900))), 30) << "800 m";
}

TEST(ObstacleAhead, AMastBeforeTheRunwayCountsWithTheClearanceOfTheApproach) {
    Flown flown;
    flown.phase = flight::kApproachFinal;
    const double distance_m = 900;
    flown.track.from.height.m = kGround_m + distance_m * std::tan(base::radians(3));
    flown.track.up_mps = -70 * std::tan(base::radians(3));
    const LoadedScene strip(runway(distance_m, distance_m + 1500));
    Plain plain;
    TerrainWatch watch({flown.track, flown.uncertainty, flown.phase, strip.scene().layers()}, plain, plain);
    ASSERT_FALSE(watch.is_watching()) << "the terrain alert is inhibited";
    EXPECT_LT(flown.seconds(masts({point(450, 0, kGround_m + 30)}), &strip), 10) << "higher than the path is there";
    EXPECT_EQ(flown.seconds(masts({point(450, 0, kGround_m + 2)}), &strip), kNever) << "control: a lamp";
    EXPECT_EQ(flown.seconds(masts({point(distance_m + 2500, 0, kGround_m + 60)}), &strip), kNever) << "beyond the landing";
    EXPECT_LT(flown.seconds(masts({point(distance_m + 2500, 0, kGround_m + 60)})), 60) << "control: without a runway";
}

TEST(ObstacleAhead, AnAircraftThatStandsOrRollsHasNone) {
    Flown flown;
    flown.track.north_mps = 10;
    EXPECT_EQ(flown.seconds(masts({point(200, 0, 2000)})), kNever);
    flown.track.north_mps = 60;
    flown.track.from.height.m = kGround_m + 2;
    const LoadedScene strip(runway(-300, 1200));
    EXPECT_EQ(flown.seconds(masts({point(1800, 0, kGround_m + 40)}), &strip), kNever) << "rolling";
    flown.track.from.height.m = kGround_m + 40;
    flown.track.up_mps = 1;
    EXPECT_LT(flown.seconds(masts({point(1800, 0, kGround_m + 90)}), &strip), 30) << "control: climbing into it";
}

/// Who climbs is not landing, however low.
TEST(ObstacleAhead, AnAircraftThatLiftsOffIsToldOfAMast) {
    Flown flown;
    flown.track.from.height.m = kGround_m + 10;
    const LoadedScene strip(runway(-300, 1200));
    const auto mast = masts({point(1800, 0, kGround_m + 90)});
    for (const auto& [up_mps, is_told] : {std::pair<double, bool>{3, true}, {-1, false}}) {
        flown.track.up_mps = up_mps;
        EXPECT_EQ(flown.seconds(mast, &strip) < 30, is_told) << up_mps;
    }
}

/// A table of 500 m to the north, with a runway on it.
class TableMountain final : public Plain {
public:
    double height_m(double latitude_rad, double) override {
        return (latitude_rad - kLatitude) * metres_per_latitude() > 800 ? 500 : kGround_m;
    }
};

TEST(ObstacleAhead, ARunwayAboveTheTrackHidesNoMast) {
    Flown flown;
    flown.track.from.height.m = 400;
    TableMountain ground;
    const LoadedScene strip(runway(1000, 2500));
    EXPECT_LT(flown.seconds_over(ground, masts({point(600, 0, 470)}), &strip), 10);
    EXPECT_EQ(flown.seconds_over(ground, masts({point(600, 0, 310)}), &strip), kNever) << "control";
}

/// Higher in the north, and known to the west alone.
class HalfKnown final : public Plain {
public:
    double height_m(double latitude_rad, double longitude_rad) override {
        if (longitude_rad > kLongitude + 500 / metres_per_longitude()) return std::nan("");
        return (latitude_rad - kLatitude) * metres_per_latitude() > 1000 ? 870 : kGround_m;
    }
};

TEST(ObstacleAhead, ACableWithOneKnownPoleCounts) {
    const Flown flown;
    HalfKnown ground;
    const auto seconds = [&](double from_east_m, double to_east_m) {
        host_sim::LayerDraft layer = cable(point(2100, from_east_m, std::nan("")), point(2100, to_east_m, std::nan("")));
        layer.height_datum = scene::HeightDatum::ground;
        return flown.seconds_over(ground, layer);
    };
    EXPECT_LT(seconds(-2000, 2000), 30);
    EXPECT_LT(seconds(2000, -2000), 30);
    EXPECT_EQ(seconds(600, 2000), kNever) << "control";
}

/// A track by chance, a true one that differs from it, integrated in steps of a tenth of a second, and an obstacle by chance. It
/// shares nothing with the watch.
struct Chance {
    std::mt19937 chance;
    Flown flown;

    explicit Chance(unsigned seed) : chance(seed) {
        const double speed = between(40, 200), angle = between(0, 2 * base::kPi);
        flown.track = {{kLatitude, kLongitude, {kGround_m + between(120, 900)}},
                       speed * std::cos(angle),
                       speed * std::sin(angle),
                       between(-4, 4),
                       seed % 3 == 0 ? 0 : between(-0.05, 0.05)};
        if (seed % 2 == 0) flown.phase = flight::kApproachInitial;
    }
    double between(double low, double high) { return low + (high - low) * static_cast<double>(chance() % 100'001) / 1e5; }
    /// As TSO-C151c has it, written down once more, in m.
    [[nodiscard]] double clearance_m() const {
        const bool is_descending = flown.track.up_mps < -2.5;
        if (flown.phase == flight::kApproachInitial) return (is_descending ? 300 : 350) * 0.3048;
        return (is_descending ? 500 : 700) * 0.3048;
    }
    [[nodiscard]] double until_s() const { return std::fmin(60, base::kPi / std::fabs(flown.track.turn_radps)); }
    /// In low flight clearance and vertical uncertainty are smaller.
    [[nodiscard]] double share() const {
        const double all_m = clearance_m() + flown.uncertainty.height_m + flown.uncertainty.climb_mps * until_s();
        return std::fmin(1, 0.75 * (flown.track.from.height.m - kGround_m) / all_m);
    }
};

struct TruePlace {
    double north_m, east_m, height_m;
};

/// Of a true track after a time; `spread` 1: all of the stated uncertainty, more: beyond it.
TruePlace true_place(Chance& world, double spread, double until_s) {
    const TrackUncertainty& u = world.flown.uncertainty;
    const PredictedTrack& track = world.flown.track;
    const bool at_corner = world.between(0, 1) < 0.5;  // extremes of all of them at once, or anything between
    const auto share = [&] { return spread * (at_corner ? (world.between(0, 1) < 0.5 ? -1 : 1) : world.between(-1, 1)); };
    const double angle = share() * base::kPi, off_m = std::fabs(share()) * u.position_m;
    TruePlace at{off_m * std::cos(angle), off_m * std::sin(angle), track.from.height.m + share() * world.share() * u.height_m};
    const double speed_mps = track.ground_speed_mps() + share() * u.speed_mps;
    const double turn_radps = track.turn_radps + share() * u.turn_radps;
    const double climb_mps = track.up_mps + share() * world.share() * u.climb_mps;
    double direction_rad = std::atan2(track.east_mps, track.north_mps) + share() * u.direction_rad;
    constexpr double kStep_s = 0.1;
    for (double seconds = 0; seconds + kStep_s <= until_s; seconds += kStep_s) {
        const double middle_rad = direction_rad + turn_radps * kStep_s / 2;
        at.north_m += speed_mps * std::cos(middle_rad) * kStep_s, at.east_m += speed_mps * std::sin(middle_rad) * kStep_s;
        at.height_m += climb_mps * kStep_s, direction_rad += turn_radps * kStep_s;
    }
    return at;
}

/// Whether an obstacle that a true track comes too close to after `met_s` is told by then. It is stated to stand elsewhere, and
/// to be less high, by its accuracy at most.
bool is_told(Chance& world, double spread, double met_s) {
    constexpr double kLevel_m = 30, kHeight_m = 10;
    const TruePlace at = true_place(world, spread, met_s);
    const double angle = world.between(0, 2 * base::kPi), off_m = world.between(0, kLevel_m);
    const double too_high_m = world.between(0.1, 60);
    const double top_m = at.height_m - world.share() * world.clearance_m() + too_high_m - world.between(0, kHeight_m);
    const scene::ScenePoint stated = point(at.north_m + off_m * std::cos(angle), at.east_m + off_m * std::sin(angle), top_m);
    return world.flown.seconds(masts({stated}, kLevel_m, kHeight_m)) <= met_s;
}

TEST(ObstacleAhead, NoneInTheWayOfATrackWithinTheStatedUncertaintyIsMissed) {
    int beyond = 0, calm = 0;
    constexpr unsigned kWorlds = 1500;
    for (unsigned n = 0; n < kWorlds; ++n) {
        Chance world(n);
        const double met_s = world.between(0.5, world.until_s());
        EXPECT_TRUE(is_told(world, 1, met_s)) << n << " after " << met_s << " s";
        beyond += is_told(world, 8, met_s) ? 0 : 1;
        const double away_m = world.between(2500, 9000), angle = world.between(0, 2 * base::kPi);
        const scene::ScenePoint elsewhere = point(away_m * std::cos(angle), away_m * std::sin(angle), 2000);
        calm += std::isinf(world.flown.seconds(masts({elsewhere}))) ? 1 : 0;
    }
    EXPECT_GT(beyond, 100) << "control: what lies far beyond the stated uncertainty is missed";
    EXPECT_GT(calm, static_cast<int>(kWorlds) / 2) << "control: most of what stands elsewhere is not told";
}

}  // namespace
}  // namespace tedavis::policy::test_obstacle_ahead
