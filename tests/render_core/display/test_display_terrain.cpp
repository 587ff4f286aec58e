// When a display shows terrain, coarse terrain or none, and what it says of it.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/display/hills_display.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"

namespace tedavis::display::test_display_terrain {
namespace {

using base::radians;
using base::SignalState;
using test_support::aircraft_over_hills;
using test_support::has_flag;
using test_support::HeadlessDisplay;
using test_support::hills;
using test_support::hills_picture;
using test_support::HillsPicture;
using test_support::kHillsNow;
using test_support::OverHills;

/// Removed terrain leaves no trace of where the aircraft is: the picture is that of any other place.
TEST(Display, WithoutATrustworthyPositionNothingOfTheTerrainIsSeen) {
    OverHills over;
    const HillsPicture shown = hills_picture(over.display, aircraft_over_hills(2000));
    for (const SignalState bad : {SignalState::missing, SignalState::stale, SignalState::lost, SignalState::invalid}) {
        flight::AircraftState here = aircraft_over_hills(2000), elsewhere = aircraft_over_hills(2000);
        elsewhere.own_ship.position.latitude_rad = radians(47.03);
        here.own_ship.state = elsewhere.own_ship.state = bad;
        const HillsPicture removed = hills_picture(over.display, here);
        EXPECT_NE(removed, shown);
        EXPECT_EQ(removed, hills_picture(over.display, elsewhere));
        EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
    }
    flight::AircraftState elsewhere = aircraft_over_hills(2000);
    elsewhere.own_ship.position.latitude_rad = radians(47.03);
    EXPECT_NE(shown, hills_picture(over.display, elsewhere)) << "control: shown terrain does depend on the place";
}

TEST(Display, StaleAltitudeTakesTheWarningColorsAway) {
    OverHills over;
    over.show_bands();
    flight::AircraftState state = aircraft_over_hills(1100);
    const HillsPicture warned = hills_picture(over.display, state);
    EXPECT_EQ(over.display.display().record().effects[1].state, EffectState::run);
    state.own_ship.height_is_geometric = false;
    const HillsPicture degraded = hills_picture(over.display, state);
    EXPECT_EQ(over.display.display().record().effects[1].state, EffectState::skipped);
    EXPECT_TRUE(has_flag(over.display, "terrain.degraded"));
    EXPECT_NE(warned, degraded);
}

TEST(Display, DamagedChunksLeaveCoarserTerrainAndAreSaid) {
    const auto whole_picture = [] {
        OverHills whole;
        HillsPicture picture = hills_picture(whole.display, aircraft_over_hills(4000, 30, -20));
        EXPECT_FALSE(has_flag(whole.display, "terrain.failing"));
        return picture;
    };
    const HillsPicture whole = whole_picture();
    std::vector<std::uint8_t> image = hills().image;
    test_support::damage_payloads(image);
    OverHills over(image);
    const HillsPicture first = hills_picture(over.display, aircraft_over_hills(4000, 30, -20));
    const FrameRecord& record = over.display.display().record();
    EXPECT_TRUE(has_flag(over.display, "terrain.failing"));
    EXPECT_TRUE(has_flag(over.display, "terrain.tau_raised"));
    EXPECT_GT(record.terrain.triangles, 0u);
    EXPECT_GT(record.terrain.tau_reached_px, record.terrain.tau_px);
    EXPECT_NE(first, whole);
    EXPECT_EQ(first, hills_picture(over.display, aircraft_over_hills(4000, 30, -20)));
}

TEST(Display, TheFirstFramesAreCoarserButWhole) {
    OverHills over;
    Display& display = over.display.display();
    const flight::AircraftState state = aircraft_over_hills(2000, 30, -20);
    double last_error = 1e9;
    for (int frame = 0; frame < 6; ++frame) {
        display.plan({state, {}, kHillsNow});
        display.draw(over.display.surface());
        const TerrainRecord& terrain = display.record().terrain;
        EXPECT_GT(terrain.triangles, 0u) << frame;
        EXPECT_LE(terrain.worst_error_px, last_error) << frame;
        EXPECT_EQ(terrain.pending != 0, terrain.tau_reached_px > terrain.tau_px) << frame;
        if (frame == 0) {
            EXPECT_GT(terrain.pending, 0u) << "control: nothing but the roots is there at first";
        }
        last_error = terrain.worst_error_px;
    }
    EXPECT_EQ(display.record().terrain.pending, 0u);
    EXPECT_EQ(display.record().terrain.tau_reached_px, display.record().terrain.tau_px);
    EXPECT_EQ(display.record().frame, 5u);
}

TEST(Display, StartRefusesADatabaseWhoseCoarsestChunkIsDamaged) {
    std::vector<std::uint8_t> image = hills().image;
    const std::uint32_t levels = hills().database.levels();
    test_support::for_entries(image, [&](const terrain::ChunkEntry& entry, std::uint64_t) {
        if (entry.level + 1u == levels) image[entry.payload.offset + 7] ^= 4;
    });
    test_support::MemoryBytes bytes(image);
    try {
        HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes);
        FAIL() << "a damaged root was accepted";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("the terrain database"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("(offset "), std::string::npos) << error.what();
    }
}

TEST(Display, StartRefusesWhatIsNoDatabase) {
    std::vector<std::uint8_t> image = hills().image;
    image[200] ^= 1;
    test_support::MemoryBytes bytes(image);
    try {
        HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes);
        FAIL() << "a damaged header was accepted";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("terrain database"), std::string::npos) << error.what();
    }
}

TEST(Display, WithoutADatabaseTheHorizonIsPlain) {
    HeadlessDisplay display("egl", "es3-mid", 320, 240, nullptr);
    const HillsPicture picture = hills_picture(display, aircraft_over_hills(2000, 30, 0));
    EXPECT_TRUE(picture.is_sky(224, 60));
    EXPECT_FALSE(picture.is_sky(224, 160));
    EXPECT_TRUE(has_flag(display, "terrain.missing"));
}

TEST(Display, OutsideTheDatabaseIsSaid) {
    OverHills over;
    flight::AircraftState state = aircraft_over_hills(2000);
    state.own_ship.position.latitude_rad = radians(48.5);
    static_cast<void>(hills_picture(over.display, state));
    EXPECT_TRUE(has_flag(over.display, "terrain.outside_database"));
    EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
}

/// A minute of flight before the border, not two minutes before it, and not along it.
TEST(Display, WhereTheDatabaseEndsAheadIsSaid) {
    OverHills over;
    const terrain::Lattice& lattice = over.display.display().planner().terrain_database()->lattice();
    const double north_rad = lattice.latitude_rad(0);
    const auto ends = [&](double south_of_border_m, double north_mps, double east_mps) {
        flight::AircraftState state = aircraft_over_hills(2000);
        state.own_ship.position.latitude_rad = north_rad - south_of_border_m / 6.37e6;
        state.own_ship.velocity_north_mps = north_mps;
        state.own_ship.velocity_east_mps = east_mps;
        static_cast<void>(hills_picture(over.display, state));
        return has_flag(over.display, "terrain.ends");
    };
    EXPECT_TRUE(ends(3000, 60, 0));
    EXPECT_FALSE(ends(7200, 60, 0)) << "two minutes before it";
    EXPECT_FALSE(ends(3000, -60, 0)) << "away from it";
    EXPECT_FALSE(ends(3000, 0, 30)) << "along it";
    EXPECT_FALSE(ends(300, 10, 0)) << "taxiing";
}

TEST(Display, BelowItsSurfaceTheTerrainIsTakenAway) {
    OverHills over;
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(900)));
    EXPECT_TRUE(has_flag(over.display, "terrain.above_own_ship"));
    EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(1700)));
    EXPECT_FALSE(has_flag(over.display, "terrain.above_own_ship"));
    EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
}

TEST(Display, TerrainBeyondTheDesignsErrorIsSaidToBeCoarse) {
    OverHills over;
    const HillsPicture fine = hills_picture(over.display, aircraft_over_hills(2000));
    EXPECT_FALSE(has_flag(over.display, "terrain.coarse"));
    design::DesignSettings strict = test_support::shipped_design("default");
    strict.degradation.terrain_error_px = 0.5 * strict.terrain.tau_px;
    ASSERT_TRUE(over.display.display().set_design(strict));
    const HillsPicture coarse = hills_picture(over.display, aircraft_over_hills(2000));
    EXPECT_TRUE(has_flag(over.display, "terrain.coarse"));
    EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
    EXPECT_NE(fine, coarse) << "the notice is on the picture";
}

TEST(Display, TerrainThatWouldBeAWrongPictureIsTakenAwayUntilItHasArrived) {
    OverHills over;
    design::DesignSettings strict = test_support::shipped_design("default");
    strict.degradation.terrain_removed_px = 2;
    ASSERT_TRUE(over.display.display().set_design(strict));
    over.display.display().plan({aircraft_over_hills(2000), {}, kHillsNow});
    over.display.display().draw(over.display.surface());
    EXPECT_TRUE(has_flag(over.display, "terrain.too_coarse"));
    EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
    EXPECT_GT(over.display.display().record().terrain.worst_error_px, 2) << "the record says how wrong it would have been";
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(2000)));
    EXPECT_FALSE(has_flag(over.display, "terrain.too_coarse"));
    EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
}

}  // namespace
}  // namespace tedavis::display::test_display_terrain
