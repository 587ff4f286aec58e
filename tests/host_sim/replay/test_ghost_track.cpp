#include "host_sim/replay/ghost_track.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_ghost_track {
namespace {

constexpr std::int64_t kBegin_s = 1'780'000'000;
constexpr double kNorth_rad_per_m = 1 / 6.37e6;

base::Time at_s(double seconds) { return base::Time{kBegin_s * 1'000'000'000} + base::Duration::from_seconds(seconds); }

/// Stands for `standing_s`, then flies north at 50 m/s until `end_s`; `east_m` beside the meridian of 10 E, 0 N.
ScannedFlight flown(const std::string& log, int standing_s, int end_s, double east_m = 0) {
    ScannedFlight flight;
    flight.log = log;
    flight.first = at_s(0);
    flight.last = at_s(end_s);
    flight.is_dated = true;
    for (int n = 0; n <= end_s; ++n)
        flight.places.push_back({at_s(n), 50.0 * std::max(0, n - standing_s) * kNorth_rad_per_m,
                                 base::radians(10) + east_m * kNorth_rad_per_m, 500.0 + n, true});
    return flight;
}

ScannedFlight later(ScannedFlight flight, double seconds) {
    const base::Duration by = base::Duration::from_seconds(seconds);
    flight.first = flight.first + by;
    flight.last = flight.last + by;
    for (ScannedPlace& place : flight.places) place.time = place.time + by;
    return flight;
}

void expect_equal(const std::vector<ScannedPlace>& found, const std::vector<ScannedPlace>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t n = 0; n < found.size(); ++n) {
        EXPECT_NEAR((found[n].time - expected[n].time).to_seconds(), 0, 1e-6);
        EXPECT_NEAR(found[n].latitude_rad, expected[n].latitude_rad, 1e-12);
        EXPECT_NEAR(found[n].longitude_rad, expected[n].longitude_rad, 1e-12);
        EXPECT_NEAR(found[n].height_m, expected[n].height_m, 1e-6);
        EXPECT_EQ(found[n].joins_next, expected[n].joins_next);
    }
}

TEST(GhostTrack, ByTimeTheOwnLogIsWhereTheOwnShipIs) {
    const ScannedFlight own = flown("own.log", 10, 100);
    const GhostTrack track = ghost_track(own, own, GhostAlign::time);
    expect_equal(track.places, own.places);
    EXPECT_EQ(track.shift_s, 0);
}

TEST(GhostTrack, AMinuteLaterItIsWhereTheOwnShipWasAMinuteBefore) {
    const ScannedFlight own = flown("own.log", 10, 100);
    const GhostTrack track = ghost_track(own, later(own, 60), GhostAlign::time);
    EXPECT_EQ(track.shift_s, 0) << "the times stay as they were recorded";
    for (std::size_t n = 0; n < own.places.size(); ++n) {
        EXPECT_EQ(track.places[n].time, own.places[n].time + base::Duration::seconds(60));
        EXPECT_EQ(track.places[n].latitude_rad, own.places[n].latitude_rad);
    }
}

/// UTC decides, not the stamps of the log: here those of the ghost are an hour wrong, and its bus says so.
TEST(GhostTrack, ByTimeUtcOfTheBusDecides) {
    const ScannedFlight own = flown("own.log", 10, 100);
    ScannedFlight ghost = later(own, 3600);
    ghost.ahead = base::Duration::seconds(-3600);
    const GhostTrack track = ghost_track(own, ghost, GhostAlign::time);
    expect_equal(track.places, own.places);
    EXPECT_EQ(track.shift_s, 0);
}

TEST(GhostTrack, WithoutDatesBothBeginTogether) {
    ScannedFlight own = flown("own.log", 10, 100), ghost = later(own, 86'400);
    own.is_dated = ghost.is_dated = false;
    const GhostTrack track = ghost_track(own, ghost, GhostAlign::time);
    expect_equal(track.places, own.places);
    EXPECT_EQ(track.shift_s, -86'400);
    ghost.is_dated = true;
    test_support::expect_user_error([&] { (void)ghost_track(own, ghost, GhostAlign::time); }, "own.log does not know the date");
}

/// It stood half a minute longer, a day later.
TEST(GhostTrack, ByTakeOffBothTakeOffTogether) {
    const ScannedFlight own = flown("own.log", 10, 100), ghost = later(flown("other.log", 40, 130), 86'400);
    const GhostTrack track = ghost_track(own, ghost, GhostAlign::takeoff);
    EXPECT_EQ(track.shift_s, -86'400 - 30);
    for (const ScannedPlace& place : track.places) {
        const auto second = static_cast<std::size_t>(std::max(0.0, (place.time - own.first).to_seconds()));
        EXPECT_NEAR(place.latitude_rad, own.places[second].latitude_rad, 1e-12);
    }
}

/// It flew the same way at half the speed, 400 m to the east.
TEST(GhostTrack, ByPlaceItIsBesideTheOwnShipWhateverItsSpeed) {
    const ScannedFlight own = flown("own.log", 0, 100);
    ScannedFlight ghost = flown("other.log", 0, 200, 400);
    for (std::size_t n = 0; n < ghost.places.size(); ++n)
        ghost.places[n].latitude_rad = 25.0 * static_cast<double>(n) * kNorth_rad_per_m;
    const GhostTrack track = ghost_track(own, ghost, GhostAlign::place);
    ASSERT_EQ(track.places.size(), own.places.size());
    EXPECT_EQ(track.shift_s, std::nullopt);
    for (std::size_t n = 0; n < own.places.size(); ++n) {
        EXPECT_EQ(track.places[n].time, own.places[n].time);
        EXPECT_NEAR(track.places[n].latitude_rad, own.places[n].latitude_rad, 1 * kNorth_rad_per_m);
        EXPECT_NEAR(track.places[n].longitude_rad - own.places[n].longitude_rad, 400 * kNorth_rad_per_m, kNorth_rad_per_m);
        EXPECT_NEAR(track.places[n].height_m, 500 + 2 * static_cast<double>(n), 0.1) << "its own height there";
    }
}

/// Beyond 3 km there is none, and the line has a gap there.
TEST(GhostTrack, ByPlaceItIsThereWhereItIsNear) {
    const ScannedFlight own = flown("own.log", 0, 400);
    ScannedFlight ghost = flown("other.log", 0, 400, 500);
    for (std::size_t n = 100; n < 300; ++n) ghost.places[n].longitude_rad += 50'000 * kNorth_rad_per_m;
    const GhostTrack track = ghost_track(own, ghost, GhostAlign::place);
    std::size_t gaps = 0;
    for (std::size_t n = 0; n + 1 < track.places.size(); ++n) gaps += track.places[n].joins_next ? 0 : 1;
    EXPECT_EQ(gaps, 1u);
    EXPECT_LT(track.places.size(), own.places.size());
}

TEST(GhostTrack, WhatCannotBeAlignedSaysWhatCan) {
    const ScannedFlight own = flown("own.log", 10, 100);
    const auto refused = [&](const ScannedFlight& ghost, GhostAlign align, const char* text) {
        test_support::expect_user_error([&] { (void)ghost_track(own, ghost, align); }, text);
    };
    refused(later(flown("a.log", 10, 100), 86'400), GhostAlign::time, "--ghost a.log: it shares no time with own.log");
    refused(later(flown("a.log", 10, 100), 86'400), GhostAlign::time, "--ghost-align place or takeoff aligns them");
    refused(later(flown("far.log", 10, 100, 90'000), 86'400), GhostAlign::place, "nowhere within 3000 m of own.log");
    refused(later(flown("far.log", 10, 100, 90'000), 86'400), GhostAlign::place, "--ghost-align takeoff aligns them");
    refused(flown("airborne.log", -1, 100), GhostAlign::takeoff, "it shows no take-off; --ghost-align time or place");
    refused(later(flown("far.log", -1, 100, 90'000), 86'400), GhostAlign::time, "no other --ghost-align aligns them either");
    ScannedFlight nowhere = own;
    nowhere.places.clear();
    refused(nowhere, GhostAlign::time, "it has no position");
}

}  // namespace
}  // namespace tedavis::host_sim::test_ghost_track
