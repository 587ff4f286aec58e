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

/// Heights over the ellipsoid by metres north and east of where the track begins.
class MadeGround final : public scene::Ground {
public:
    explicit MadeGround(std::function<double(double, double)> height) : height_(std::move(height)) {}
    double height_m(double latitude_rad, double longitude_rad) override {
        return height_((latitude_rad - kLatitude) * earth::meridian_radius_m(kLatitude),
                       (longitude_rad - kLongitude) * metres_per_longitude());
    }
    double undulation_m(double, double) override { return 0; }

private:
    std::function<double(double, double)> height_;
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

    double seconds(scene::Ground& ground, base::Span<const scene::Layer> layers = {}) const {
        return TerrainWatch(track, phase, layers, ground).seconds_to_terrain();
    }
    TerrainAhead ahead(scene::Ground& ground, base::Span<const scene::Layer> layers = {}) const {
        return TerrainWatch(track, phase, layers, ground).ahead();
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
        MadeGround far = wall(70 * 61), minute = wall(70 * 50), half = wall(70 * 20), plain = wall(1e9);
        EXPECT_EQ(flown.ahead(far), TerrainAhead::none) << int{phase.code()};
        EXPECT_EQ(flown.ahead(minute), TerrainAhead::caution) << int{phase.code()};
        EXPECT_EQ(flown.ahead(half), TerrainAhead::warning) << int{phase.code()};
        EXPECT_EQ(flown.ahead(plain), TerrainAhead::none) << int{phase.code()} << ": control";
        EXPECT_NEAR(flown.seconds(half), 20, 1);
        MadeGround beside([](double, double east_m) { return std::fabs(east_m) > 250 ? 1500.0 : 300.0; });
        EXPECT_EQ(flown.ahead(beside), TerrainAhead::none) << "a valley of 500 m";
    }
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
    MadeGround ridge([](double north_m, double) { return north_m > 3000 ? 1000 - 180 / 3.28084 : 300.0; });  // 180 ft below
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

/// Cones and tracks by chance, against a walk along the track by the metre, which shares nothing with the watch but its rule.
TEST(TerrainAhead, NoMountainIsMissed) {
    std::mt19937 chance(7);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(chance() % 100'001) / 1e5;
    };
    int met = 0, missed = 0, free = 0;
    for (int n = 0; n < 400; ++n) {
        struct Cone {
            double north_m, east_m, top_m, slope;
        };
        std::vector<Cone> cones;
        for (int c = 0; c < 12; ++c)
            cones.push_back({between(-9000, 9000), between(-9000, 9000), between(400, 1600), between(0.15, 0.6)});
        const auto height = [&](double north_m, double east_m) {
            double highest = 200;
            for (const Cone& cone : cones)
                highest = std::fmax(highest, cone.top_m - cone.slope * std::hypot(north_m - cone.north_m, east_m - cone.east_m));
            return highest;
        };
        MadeGround ground(height);
        const double speed = between(40, 200), angle = between(0, 2 * base::kPi);
        Flown flown;
        flown.track = {{kLatitude, kLongitude, {height(0, 0) + between(100, 1000)}},
                       speed * std::cos(angle),
                       speed * std::sin(angle),
                       between(-4, 4)};
        const double clearance_m =
            std::fmin((flown.track.up_mps < -2.54 ? 500 : 700) * 0.3048, 0.75 * (flown.track.from.height.m - height(0, 0)));
        double first_m = 60 * speed + 1;
        for (double along_m = 0; along_m <= 60 * speed; ++along_m)
            for (double aside_m = -200; aside_m <= 200; aside_m += 100) {
                const double north_m = along_m * std::cos(angle) - aside_m * std::sin(angle);
                const double east_m = along_m * std::sin(angle) + aside_m * std::cos(angle);
                if (flown.track.from.height.m + flown.track.up_mps * along_m / speed < height(north_m, east_m) + clearance_m)
                    first_m = std::fmin(first_m, along_m);
            }
        const double seconds = flown.seconds(ground);
        if (first_m > 60 * speed) {
            EXPECT_TRUE(std::isinf(seconds) || seconds > 59) << n;
            ++free;
        } else if (std::isinf(seconds)) {
            ++missed;  // a summit between two steps of 60 m
        } else {
            ++met;
            EXPECT_NEAR(seconds * speed, first_m, 61) << n;
        }
    }
    EXPECT_GT(met, 100);
    EXPECT_GT(free, 50);
    EXPECT_LE(missed, 4) << "grazed by less than two steps can differ";
}

}  // namespace
}  // namespace tedavis::policy::test_terrain_ahead
