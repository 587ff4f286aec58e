#include "render_core/policy/terrain_ahead.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::policy::test_terrain_ahead {
namespace {

using flight::FlightPhase;
using flight::Scenario;
using test_support::LoadedScene;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLatitude = base::radians(46.8), kLongitude = base::radians(9.8);

const FlightPhase kAllPhases[] = {{},
                                  {Scenario::ground, 0},
                                  flight::kTakeoffStart,
                                  flight::kTakeoffFirstClimb,
                                  flight::kTakeoffSecondClimb,
                                  {Scenario::cruise, 0},
                                  flight::kApproachDescent,
                                  flight::kApproachInitial,
                                  flight::kApproachFinal,
                                  flight::kApproachLanding,
                                  flight::kGoAroundAbort,
                                  flight::kGoAroundReplanning};

double metres_per_longitude() { return earth::prime_vertical_radius_m(kLatitude) * std::cos(kLatitude); }

/// Heights over the ellipsoid by metres north and east of where the track begins. The bound samples a grid; it is one where
/// heights differ by no more than `slack_m` within half a step of it.
class MadeGround final : public scene::Ground, public GroundBound {
public:
    explicit MadeGround(std::function<double(double, double)> height, double slack_m = 0)
        : height_(std::move(height)), slack_m_(slack_m) {}
    double height_m(double latitude_rad, double longitude_rad) override {
        return height_((latitude_rad - kLatitude) * earth::meridian_radius_m(kLatitude),
                       (longitude_rad - kLongitude) * metres_per_longitude());
    }
    double undulation_m(double, double) override { return 0; }
    double highest_m(double latitude_rad, double longitude_rad, double radius_m, double) override {
        const double north_m = (latitude_rad - kLatitude) * earth::meridian_radius_m(kLatitude);
        const double east_m = (longitude_rad - kLongitude) * metres_per_longitude();
        double highest = -std::numeric_limits<double>::infinity();
        const int reach = static_cast<int>(std::ceil(radius_m / kStep_m));
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j)
                if (std::hypot(i, j) * kStep_m < radius_m + kStep_m)
                    highest = std::fmax(highest, height_(north_m + i * kStep_m, east_m + j * kStep_m));
        return highest + slack_m_;
    }

    static constexpr double kStep_m = 30;

private:
    std::function<double(double, double)> height_;
    double slack_m_;
};

scene::ScenePoint point(double north_m, double east_m) {
    return {kLatitude + north_m / earth::meridian_radius_m(kLatitude), kLongitude + east_m / metres_per_longitude(),
            std::numeric_limits<float>::quiet_NaN(), 0, scene::kNoTime};
}

/// From one place north of the track's beginning to another.
LoadedScene runway(double from_m, double to_m) {
    host_sim::LayerDraft layer;
    layer.name = "runways";
    layer.role = scene::LayerRole::runway;
    layer.shape = scene::LayerShape::lines;
    layer.height_datum = scene::HeightDatum::ground;
    layer.points = {point(from_m, 0), point(to_m, 0)};
    layer.starts = {0, 2};
    return LoadedScene({"one", "a test", 1, {layer}});
}

struct Flown {
    PredictedTrack track{{kLatitude, kLongitude, {1000}}, 70, 0, 0};
    FlightPhase phase{Scenario::cruise, 0};
    TrackUncertainty uncertainty;

    TerrainWatch watch(MadeGround& ground, base::Span<const scene::Layer> layers = {}) const {
        return {{track, uncertainty, phase, layers}, ground, ground};
    }
    double seconds(MadeGround& ground, base::Span<const scene::Layer> layers = {}) const {
        return watch(ground, layers).seconds_to_terrain();
    }
    TerrainAhead ahead(MadeGround& ground, base::Span<const scene::Layer> layers = {}) const {
        return watch(ground, layers).ahead();
    }
};

/// A wall across the track from a distance on, over a plain of 300 m.
MadeGround wall(double from_m) {
    return MadeGround([from_m](double north_m, double) { return north_m > from_m ? 1500.0 : 300.0; });
}

TEST(TerrainAhead, LevelFlightIntoAMountainIsToldInEveryPhase) {
    for (const FlightPhase phase : kAllPhases) {
        Flown flown;
        flown.phase = phase;
        MadeGround far = wall(70 * 60 + 500), minute = wall(70 * 50), half = wall(70 * 20), plain = wall(1e9);
        EXPECT_EQ(flown.ahead(far), TerrainAhead::none) << int{phase.code()};
        EXPECT_EQ(flown.ahead(minute), TerrainAhead::caution) << int{phase.code()};
        EXPECT_EQ(flown.ahead(half), TerrainAhead::warning) << int{phase.code()};
        EXPECT_EQ(flown.ahead(plain), TerrainAhead::none) << int{phase.code()} << ": control";
        EXPECT_LT(flown.seconds(half), 20);
        EXPECT_GT(flown.seconds(half), 20 - (250 + 2 * 60) / 70.0) << "the track's own uncertainty, and two steps";
        MadeGround beside([](double, double east_m) { return std::fabs(east_m) > 550 ? 1500.0 : 300.0; });
        EXPECT_EQ(flown.ahead(beside), TerrainAhead::none) << "a valley of 1100 m";
    }
}

/// Between a valley's walls: turning away from what lies straight ahead, which is a caution within 30 s and a warning within 15
/// s. Control: without the turn it is one within 60 s and 30 s.
TEST(TerrainAhead, InATurnTheTimesOfTheStraightTrackCountTwice) {
    Flown turning, straight;
    turning.track.turn_radps = base::radians(9);  // a radius of 450 m
    const auto counted = [&](double from_m) {
        MadeGround ground = wall(from_m);
        return level_within(counted_s(turning.seconds(ground), straight.seconds(ground)));
    };
    const auto control = [&](double from_m) {
        MadeGround ground = wall(from_m);
        return straight.ahead(ground);
    };
    EXPECT_EQ(counted(70 * 45), TerrainAhead::none);
    EXPECT_EQ(control(70 * 45), TerrainAhead::caution);
    EXPECT_EQ(counted(70 * 25), TerrainAhead::caution);
    EXPECT_EQ(control(70 * 25), TerrainAhead::warning);
    EXPECT_EQ(counted(70 * 14), TerrainAhead::warning);
    EXPECT_EQ(counted_s(20, 50), 20) << "what lies on the predicted track counts as ever";
}

/// TSO-C151c table 3.1.1, in feet, written down once more.
TEST(TerrainAhead, ThePhaseSetsTheClearance) {
    const auto feet = [](FlightPhase phase, double up_mps) { return required_clearance_m(phase, up_mps) / 0.3048; };
    EXPECT_DOUBLE_EQ(feet({Scenario::cruise, 0}, 0), 700);
    EXPECT_DOUBLE_EQ(feet({Scenario::cruise, 0}, -3), 500);
    EXPECT_DOUBLE_EQ(feet(flight::kApproachInitial, 0), 350);
    EXPECT_DOUBLE_EQ(feet(flight::kApproachDescent, -3), 300);
    EXPECT_DOUBLE_EQ(feet(flight::kApproachFinal, 0), 150);
    EXPECT_DOUBLE_EQ(feet(flight::kApproachLanding, -3), 100);
    EXPECT_DOUBLE_EQ(feet(flight::kTakeoffFirstClimb, 0), 100);
    EXPECT_DOUBLE_EQ(feet(flight::kGoAroundAbort, -3), 100);
    for (const FlightPhase phase : kAllPhases) EXPECT_GE(feet(phase, -3), 100) << "none switches it off";
    Flown flown;
    // 180 ft and the uncertainty of the height below
    MadeGround ridge([](double north_m, double) { return north_m > 3000 ? 1000 - 180 / 3.28084 - 20 - 18 : 300.0; });
    EXPECT_EQ(flown.ahead(ridge), TerrainAhead::caution);
    flown.phase = flight::kApproachFinal;
    EXPECT_EQ(flown.ahead(ridge), TerrainAhead::none);
}

TEST(TerrainAhead, LowFlightOverLevelGroundIsNone) {
    for (const double above_m : {30.0, 100.0, 190.0}) {
        Flown flown;
        MadeGround level([above_m](double, double) { return 1000 - above_m; });
        MadeGround rising([above_m](double north_m, double) { return 1000 - above_m + 0.02 * north_m; });
        EXPECT_EQ(flown.ahead(level), TerrainAhead::none) << above_m;
        EXPECT_NE(flown.ahead(rising), TerrainAhead::none) << above_m << ": control";
    }
}

TEST(TerrainAhead, WhatIsNotKnownOrNotFlownIsNone) {
    Flown flown;
    MadeGround nothing([](double, double) { return kNaN; }), half = wall(700);
    EXPECT_EQ(flown.ahead(nothing), TerrainAhead::none);
    flown.track.north_mps = 10;
    EXPECT_EQ(flown.ahead(half), TerrainAhead::none) << "taxiing";
    flown.track.north_mps = 20;
    EXPECT_NE(flown.ahead(half), TerrainAhead::none) << "control";
    MadeGround unknown_here([](double north_m, double) { return north_m < 100 ? kNaN : 1500; });
    EXPECT_NE(flown.ahead(unknown_here), TerrainAhead::none) << "the own ship's ground need not be known";
}

TEST(TerrainAhead, ALandingOnAKnownRunwayIsNone) {
    for (const double distance_m : {4000.0, 2500.0, 1200.0, 500.0, 100.0, -300.0}) {
        Flown flown;
        flown.phase = distance_m > 3000 ? flight::kApproachInitial : flight::kApproachFinal;
        flown.track.from.height.m = 300 + std::fmax(distance_m, 10) * std::tan(base::radians(3));
        flown.track.up_mps = distance_m > 0 ? -70 * std::tan(base::radians(3)) : 0;
        MadeGround plain([&](double north_m, double east_m) {
            return north_m > distance_m + 3600 ? 900 : 300 + 5 * std::sin(east_m / 100);  // a mountain behind the runway
        });
        const LoadedScene known = runway(distance_m, distance_m + 1500), elsewhere = runway(distance_m + 20'000, 30'000);
        EXPECT_EQ(flown.ahead(plain, known.scene().layers()), TerrainAhead::none) << distance_m;
        if (distance_m > 0) EXPECT_NE(flown.ahead(plain), TerrainAhead::none) << distance_m << ": control, no runway is known";
        if (distance_m > 0) EXPECT_NE(flown.ahead(plain, elsewhere.scene().layers()), TerrainAhead::none) << distance_m;
        if (distance_m < 1500) continue;
        MadeGround hill([&](double north_m, double) {
            return std::fabs(north_m - 0.6 * distance_m) < 200 ? flown.track.from.height.m : 300;
        });
        EXPECT_NE(flown.ahead(hill, known.scene().layers()), TerrainAhead::none) << distance_m << ": a hill before the runway";
    }
}

TEST(TerrainAhead, ATakeOffIsNoneUntilAMountainIsInItsWay) {
    Flown flown;
    flown.phase = flight::kTakeoffStart;
    const LoadedScene strip = runway(-300, 1200);
    MadeGround plain([](double north_m, double) { return 300 + 0.004 * north_m; });
    MadeGround mountain([](double north_m, double) { return north_m > 2500 ? 1500.0 : 300.0; });
    flown.track.from.height.m = 303;
    EXPECT_EQ(flown.ahead(plain, strip.scene().layers()), TerrainAhead::none) << "rolling";
    EXPECT_EQ(flown.ahead(mountain, strip.scene().layers()), TerrainAhead::none) << "inhibited near the runway";
    flown.track.up_mps = 5;
    flown.track.from.height.m = 400;
    EXPECT_EQ(flown.ahead(plain, strip.scene().layers()), TerrainAhead::none);
    EXPECT_NE(flown.ahead(mountain, strip.scene().layers()), TerrainAhead::none) << "above 200 ft";
}

constexpr double kMaxSlope = 0.6;

/// Mountains and a track over them by chance.
struct Chance {
    struct Cone {
        double north_m, east_m, top_m, slope;
    };
    std::mt19937 chance;
    std::vector<Cone> cones;
    Flown flown;

    explicit Chance(unsigned seed) : chance(seed) {
        for (int c = 0; c < 8; ++c)
            cones.push_back({between(-9000, 9000), between(-9000, 9000), between(400, 1600), between(0.15, kMaxSlope)});
        const double speed = between(40, 200), angle = between(0, 2 * base::kPi);
        flown.track = {{kLatitude, kLongitude, {height(0, 0) + between(250, 900)}},
                       speed * std::cos(angle),
                       speed * std::sin(angle),
                       between(-4, 4),
                       seed % 3 == 0 ? 0 : between(-0.05, 0.05)};
        if (seed % 2 == 0) flown.phase = flight::kApproachInitial;
    }
    double between(double low, double high) { return low + (high - low) * static_cast<double>(chance() % 100'001) / 1e5; }
    [[nodiscard]] double height(double north_m, double east_m) const {
        double highest = 200;
        for (const Cone& cone : cones)
            highest = std::fmax(highest, cone.top_m - cone.slope * std::hypot(north_m - cone.north_m, east_m - cone.east_m));
        return highest;
    }
    [[nodiscard]] MadeGround ground() const {
        return MadeGround([this](double north_m, double east_m) { return height(north_m, east_m); },
                          kMaxSlope * MadeGround::kStep_m * std::sqrt(0.5));
    }
    /// As TSO-C151c has it, written down once more, in m.
    [[nodiscard]] double clearance_m() const {
        const bool is_descending = flown.track.up_mps < -2.5;
        if (flown.phase == flight::kApproachInitial) return (is_descending ? 300 : 350) * 0.3048;
        return (is_descending ? 500 : 700) * 0.3048;
    }
    /// In low flight clearance and vertical uncertainty are smaller.
    [[nodiscard]] double share() const {
        const double all_m = clearance_m() + flown.uncertainty.height_m + flown.uncertainty.climb_mps * until_s();
        return std::fmin(1, 0.75 * (flown.track.from.height.m - height(0, 0)) / all_m);
    }
    [[nodiscard]] double until_s() const { return std::fmin(60, base::kPi / std::fabs(flown.track.turn_radps)); }
};

/// A track that differs from the predicted one, integrated in steps of a tenth of a second; shares nothing with the watch.
struct TrueTrack {
    double north_m, east_m, height_m, speed_mps, direction_rad, turn_radps, climb_mps;

    /// By shares -1..1 of each uncertainty.
    TrueTrack(const Chance& world, const double (&share)[7]) {
        const Flown& flown = world.flown;
        const TrackUncertainty& u = flown.uncertainty;
        const double angle = share[0] * base::kPi, off_m = std::fabs(share[1]) * u.position_m;
        north_m = off_m * std::cos(angle), east_m = off_m * std::sin(angle);
        height_m = flown.track.from.height.m + share[2] * world.share() * u.height_m;
        speed_mps = flown.track.ground_speed_mps() + share[3] * u.speed_mps;
        direction_rad = std::atan2(flown.track.east_mps, flown.track.north_mps) + share[4] * u.direction_rad;
        turn_radps = flown.track.turn_radps + share[5] * u.turn_radps;
        climb_mps = flown.track.up_mps + share[6] * world.share() * u.climb_mps;
    }
    /// Time until it is closer to the ground than the clearance, or infinity.
    double seconds_to(const Chance& world, double clearance_m, double until_s) {
        constexpr double kStep_s = 0.1;
        for (double seconds = 0; seconds < until_s; seconds += kStep_s) {
            if (height_m < world.height(north_m, east_m) + clearance_m) return seconds;
            const double middle_rad = direction_rad + turn_radps * kStep_s / 2;
            north_m += speed_mps * std::cos(middle_rad) * kStep_s, east_m += speed_mps * std::sin(middle_rad) * kStep_s;
            height_m += climb_mps * kStep_s, direction_rad += turn_radps * kStep_s;
        }
        return std::numeric_limits<double>::infinity();
    }
};

/// The soonest of many true tracks; `spread` 1: all of the stated uncertainty, more: beyond it.
double soonest_true_s(Chance& world, double spread, int tracks) {
    double soonest = std::numeric_limits<double>::infinity();
    for (int n = 0; n < tracks; ++n) {
        double share[7];
        const bool at_corner = n % 2 == 0;  // extremes of all of them at once, or anything between
        for (double& one : share) one = spread * (at_corner ? (world.between(0, 1) < 0.5 ? -1 : 1) : world.between(-1, 1));
        soonest =
            std::fmin(soonest, TrueTrack(world, share).seconds_to(world, world.share() * world.clearance_m(), world.until_s()));
    }
    return soonest;
}

TEST(TerrainAhead, NoViolationOfATrackWithinTheStatedUncertaintyIsMissed) {
    int met = 0, warned = 0, calm = 0, needless = 0, beyond = 0;
    for (unsigned n = 0; n < 300; ++n) {
        Chance world(n);
        MadeGround ground = world.ground();
        const double told_s = world.flown.seconds(ground), true_s = soonest_true_s(world, 1, 60);
        if (std::isfinite(true_s)) {
            ++met;
            EXPECT_LE(told_s, true_s) << n << ": told later than a true track has it, or not at all";
            if (true_s <= 30) {
                ++warned;
                EXPECT_EQ(world.flown.ahead(ground), TerrainAhead::warning) << n;
            }
        } else if (std::isinf(told_s)) {
            ++calm;
            if (std::isfinite(soonest_true_s(world, 8, 60))) ++beyond;
        } else {
            ++needless;
        }
    }
    EXPECT_GT(met, 80);
    EXPECT_GT(warned, 30);
    EXPECT_GT(calm, 80);
    EXPECT_LT(needless, 45) << "the bound is tight: most alerts are for a track that is possible";
    EXPECT_GT(beyond, 5) << "control: what lies far beyond the stated uncertainty is missed";
}

/// The track as the zone has it, and as the watch has it.
TEST(TerrainAhead, ItsZoneHoldsTheGroundThatItFound) {
    int found = 0;
    for (unsigned n = 0; n < 200; ++n) {
        Chance world(n);
        MadeGround ground = world.ground();
        TerrainWatch watch = world.flown.watch(ground);
        const TerrainAlertZone zone = watch.zone(TerrainAhead::caution);
        EXPECT_GE(zone.until_s, world.until_s());
        EXPECT_LT(zone.until_s, world.until_s() + 15);
        const earth::Geodetic middle = world.flown.track.at(zone.until_s / 2);
        const TrackPassage passage = passage_of(zone, (middle.latitude_rad - kLatitude) * earth::meridian_radius_m(kLatitude),
                                                (middle.longitude_rad - kLongitude) * metres_per_longitude());
        EXPECT_NEAR(passage.seconds, zone.until_s / 2, 0.05) << n;
        EXPECT_LT(passage.aside_m, 2) << n;
        if (std::isinf(watch.seconds_to_terrain())) continue;
        const double slack_m = kMaxSlope * MadeGround::kStep_m * std::sqrt(0.5);  // the bound's own
        bool holds = false;
        for (double north_m = -13000; north_m < 13000 && !holds; north_m += 50)
            for (double east_m = -13000; east_m < 13000 && !holds; east_m += 50)
                holds = violation_at(zone, north_m, east_m, world.height(north_m, east_m) + slack_m) != TerrainAhead::none;
        EXPECT_TRUE(holds) << n << ": an alert without colored ground";
        ++found;
    }
    EXPECT_GT(found, 50);
}

TEST(TerrainAhead, AZoneEndsAtTheRunwayAndLeavesOutItsGround) {
    Flown flown;
    flown.phase = flight::kApproachFinal;
    flown.track.from.height.m = 300 + 2500 * std::tan(base::radians(3));
    flown.track.up_mps = -70 * std::tan(base::radians(3));
    const LoadedScene strip = runway(2500, 4000);
    MadeGround plain([](double, double) { return 300.0; });
    const TerrainAlertZone zone = flown.watch(plain, strip.scene().layers()).zone(TerrainAhead::warning);
    EXPECT_LT(zone.until_s, 36);
    EXPECT_GT(zone.until_s, 25);
    EXPECT_EQ(violation_at(zone, 2000, 0, 300), TerrainAhead::none);
    EXPECT_EQ(violation_at(zone, 1500, 0, 345), TerrainAhead::warning) << "a mast on a hill before it";
    const TerrainAlertZone without = flown.watch(plain).zone(TerrainAhead::warning);
    EXPECT_EQ(violation_at(without, 2450, 0, 300), TerrainAhead::caution) << "control";
}

}  // namespace
}  // namespace tedavis::policy::test_terrain_ahead
