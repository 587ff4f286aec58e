#include "render_core/display/display.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_display {
namespace {

using base::radians;
using base::SignalState;
using flight::Signal;
using test_support::aircraft_over_hills;
using test_support::HeadlessDisplay;
using test_support::hills;
using test_support::hills_picture;
using test_support::HillsPicture;
using test_support::kHillsNow;
using test_support::OverHills;

TEST(Display, TheSameStateGivesTheSameBits) {
    const auto first_picture = [] {
        OverHills first;
        return hills_picture(first.display, aircraft_over_hills(2000));
    };
    const HillsPicture a = first_picture();
    OverHills second;
    static_cast<void>(hills_picture(second.display, aircraft_over_hills(3500, 200, -10, 40)));
    EXPECT_EQ(a, hills_picture(second.display, aircraft_over_hills(2000))) << "whatever was drawn before";
    EXPECT_NE(a, hills_picture(second.display, aircraft_over_hills(2001))) << "control";
}

/// Another part of the process rounds otherwise: the next frame is planned as always, and says so.
TEST(Display, ChangedRoundingIsSetBackAndFlagged) {
    OverHills over;
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(2000)));
    const auto frame = [&] {
        over.display.display().plan({aircraft_over_hills(2000), {}, kHillsNow});
        return test_support::drawn_pixels(over.display);
    };
    const std::vector<std::uint8_t> usual = frame();
    EXPECT_FALSE(test_support::has_flag(over.display, "arithmetic.changed"));
    std::fesetround(FE_UPWARD);
    EXPECT_EQ(frame(), usual);
    EXPECT_TRUE(test_support::has_flag(over.display, "arithmetic.changed"));
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    EXPECT_EQ(frame(), usual);
    EXPECT_FALSE(test_support::has_flag(over.display, "arithmetic.changed"));
}

TEST(Display, TheFlightsTimeIsTheBusesAndItsLossIsFlagged) {
    OverHills over;
    display::Display& display = over.display.display();
    flight::AircraftState state = aircraft_over_hills(2000);
    const auto flagged = [&] {
        display.plan({state, {}, kHillsNow});
        return test_support::has_flag(over.display, "utc.lost");
    };
    EXPECT_FALSE(flagged()) << "a bus that has never stated it has not lost it";
    const base::Time date{1'780'315'200'000'000'000};
    state.utc = {date - kHillsNow, SignalState::valid};
    EXPECT_FALSE(flagged());
    EXPECT_EQ(display.record().flight_time.utc, date);
    EXPECT_TRUE(display.record().flight_time.is_confirmed);
    state.utc.state = SignalState::lost;
    EXPECT_TRUE(flagged());
    EXPECT_TRUE(display.record().flight_time.is_date);
    EXPECT_FALSE(display.record().flight_time.is_confirmed);
}

/// Pixels whose colour differs from that of the same picture without warning colours.
std::size_t colored_pixels(const flight::AircraftState& state, bool widened, design::BandWidening* record = nullptr) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.symbology.legend = false;
    design.widening.enabled = widened;
    const auto drawn = [&](bool warning) {
        design.warning_colors = warning;
        test_support::MemoryBytes bytes(hills().image);
        HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes, design);
        HillsPicture picture = hills_picture(display, state);
        if (warning && record != nullptr) *record = display.display().record().bands;
        return picture;
    };
    const HillsPicture with = drawn(true), without = drawn(false);
    std::size_t different = 0;
    for (std::size_t p = 0; p < with.rgba.size(); p += 4)
        different += std::equal(with.rgba.begin() + p, with.rgba.begin() + p + 4, without.rgba.begin() + p) ? 0 : 1;
    return different;
}

TEST(Display, WarningColorsReachFurtherTheLessIsKnownOfTheHeight) {
    flight::AircraftState state = aircraft_over_hills(2000);  // tops reach the lowest limit, 2000 ft below
    const auto at_accuracy = [&](double metres, design::BandWidening* record = nullptr) {
        state[Signal::vertical_accuracy] = {metres, kHillsNow};
        return colored_pixels(state, true, record);
    };
    const std::size_t none = colored_pixels(state, false);
    design::BandWidening good, poor;
    const std::size_t with_good = at_accuracy(2, &good), with_poor = at_accuracy(28, &poor);
    EXPECT_GT(with_good, none);
    EXPECT_GT(with_poor, with_good);
    EXPECT_TRUE(poor.terrain_assumed) << "the hills' database states no accuracy";
    EXPECT_FALSE(poor.position_assumed);
    EXPECT_NEAR(poor.lowered_m, 1.644854 * std::hypot(28 / 1.959964, 30 / 1.644854), 1e-3);
    EXPECT_LT(good.lowered_m, poor.lowered_m);
    state[Signal::vertical_accuracy] = {};
    design::BandWidening unknown;
    static_cast<void>(colored_pixels(state, true, &unknown));
    EXPECT_TRUE(unknown.position_assumed);
}

TEST(Display, AnotherDesignsCoverageHoldsFromTheNextFrame) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.warning_colors = true;
    test_support::MemoryBytes bytes(hills().image);
    HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes, design);
    flight::AircraftState state = aircraft_over_hills(2000);
    state[Signal::vertical_accuracy] = {28.0, kHillsNow};
    const auto lowered_m = [&] {
        static_cast<void>(hills_picture(display, state));
        return display.display().record().bands.lowered_m;
    };
    const double before_m = lowered_m();
    design.widening.coverage = 0.99;
    ASSERT_TRUE(display.display().set_design(design));
    // Normal quantiles of 0.99 and 0.95.
    EXPECT_NEAR(lowered_m() / before_m, 2.326347874041 / 1.644853626951, 1e-9);
}

TEST(Display, SkyAboveAndTerrainBelowTheHorizonInEverySizeAndLane) {
    struct Case {
        const char* device;
        std::uint32_t width, height;
    };
    for (const Case& c :
         {Case{"es3-mid", 640, 480}, Case{"es3-mid", 1920, 1080}, Case{"es3-mid", 480, 800}, Case{"es2-small", 640, 480}}) {
        OverHills over(hills().image, c.device, c.width, c.height);
        const HillsPicture picture = hills_picture(over.display, aircraft_over_hills(2500, 30, 0));
        // Beside the tapes and above the heading, where no symbol stands.
        EXPECT_TRUE(picture.is_sky(c.width / 2 + c.width / 5, c.height / 4)) << c.device << " " << c.width;
        EXPECT_FALSE(picture.is_sky(c.width / 2 + c.width / 5, c.height * 2 / 3)) << c.device << " " << c.width;
        EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
        EXPECT_EQ(over.display.display().gl().denied().total, 0u);
    }
}

TEST(Display, BytesStayWithinTheBudgetsAndAreTheSameEveryFrame) {
    OverHills over;
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(2500)));
    const ByteRecord first = over.display.display().record().bytes;
    for (const double heading : {0.0, 90.0, 180.0, 270.0})
        static_cast<void>(hills_picture(over.display, aircraft_over_hills(1500, heading)));
    const ByteRecord last = over.display.display().record().bytes;
    EXPECT_EQ(first.cpu, last.cpu);
    EXPECT_EQ(first.gpu, last.gpu);
    EXPECT_LE(last.cpu, last.cpu_budget);
    std::uint64_t lines = 0;
    for (const base::BudgetLine& line : over.display.display().planner().budget().lines()) {
        EXPECT_LE(line.use.in_use, line.bytes) << line.name.view();
        if (line.kind == base::MemoryKind::cpu) lines += line.use.in_use;
    }
    EXPECT_EQ(lines, last.cpu) << "the table tells the same as the record";
    EXPECT_GT(lines, 1'000'000u);
    EXPECT_LE(last.gpu, last.gpu_budget);
    EXPECT_GT(last.gpu, 0u);
}

TEST(Display, ApproachingCountsNoFrameAndSettlingWaitsForAll) {
    OverHills over;
    Display& display = over.display.display();
    preroll(display, {aircraft_over_hills(2000, 30, -20), {}, kHillsNow});
    EXPECT_GT(display.record().terrain.pending, 0u);
    settle(display, {aircraft_over_hills(2000, 30, -20), {}, kHillsNow});
    EXPECT_EQ(display.record().terrain.pending, 0u);
    display.plan({aircraft_over_hills(2000, 30, -20), {}, kHillsNow});
    EXPECT_EQ(display.record().frame, 0u);
    EXPECT_EQ(display.record().terrain.pending, 0u);
}

TEST(Display, AStyleThatNeedsOtherProgramsIsRefusedAndChangesNothing) {
    OverHills over;
    const HillsPicture before = hills_picture(over.display, aircraft_over_hills(2000));
    design::DesignSettings other = test_support::shipped_design("default");
    other.view.horizontal_field_of_view_rad = radians(30);
    other.terrain.style.texture = design::TerrainTexture::slope;
    EXPECT_FALSE(over.display.display().set_design(other));
    EXPECT_EQ(before, hills_picture(over.display, aircraft_over_hills(2000)));
    other.terrain.style = test_support::shipped_design("default").terrain.style;
    EXPECT_TRUE(over.display.display().set_design(other));
    EXPECT_NE(before, hills_picture(over.display, aircraft_over_hills(2000))) << "control";
}

TEST(Display, WithoutAttitudeThereIsNoHorizon) {
    OverHills over(hills().image, "es3-mid", 1024, 768);
    for (const Signal lost : {Signal::pitch, Signal::roll}) {
        flight::AircraftState state = aircraft_over_hills(2000, 30, 0);
        state[lost] = {};
        const HillsPicture picture = hills_picture(over.display, state);
        // In the gap between the tapes, which nothing else covers.
        const std::uint8_t *high = picture.at(148, 150), *low = picture.at(148, 600);
        EXPECT_TRUE(std::equal(high, high + 3, low)) << "one colour above and below";
        EXPECT_LT(high[2], 64);
    }
    EXPECT_TRUE(hills_picture(over.display, aircraft_over_hills(2000, 30, 0)).is_sky(148, 150)) << "control";
}

TEST(Display, AFreeViewHasNoSymbolsAndGivesTheOwnOneBack) {
    OverHills over;
    const HillsPicture own = hills_picture(over.display, aircraft_over_hills(2000));
    const terrain::View same = over.display.display().planned().picture.camera.view;
    over.display.display().planner().set_free_view(same);
    const HillsPicture bare = hills_picture(over.display, aircraft_over_hills(2000));
    std::size_t different = 0;
    for (std::size_t n = 0; n < own.rgba.size(); ++n) different += own.rgba[n] != bare.rgba[n] ? 1 : 0;
    EXPECT_GT(different, own.rgba.size() / 50) << "symbols are gone";
    EXPECT_LT(different, own.rgba.size() * 2 / 3) << "the terrain is the same";
    terrain::View other = same;
    other.forward = -same.forward;
    other.right = -same.right;
    over.display.display().planner().set_free_view(other);
    EXPECT_NE(bare, hills_picture(over.display, aircraft_over_hills(2000)));
    over.display.display().planner().clear_free_view();
    EXPECT_EQ(own, hills_picture(over.display, aircraft_over_hills(2000)));
}

TEST(Display, TheEyeIsWhereTheAircraftAndTheDesignPutIt) {
    OverHills over;
    const flight::AircraftState state = aircraft_over_hills(2000, 90, 0);
    static_cast<void>(hills_picture(over.display, state));
    const glm::dvec3 own = earth::to_ecef(state.own_ship.position);
    EXPECT_LT(glm::length(over.display.display().planned().picture.camera.view.eye - own), 1e-6);
    design::DesignSettings design = test_support::shipped_design("default");
    design.view.eye_forward_m = 3;
    design.view.eye_down_m = -1.5;
    ASSERT_TRUE(over.display.display().set_design(design));
    static_cast<void>(hills_picture(over.display, state));
    const glm::dmat3 ned = earth::north_east_down(radians(47.0), radians(9.7));
    const glm::dvec3 moved = over.display.display().planned().picture.camera.view.eye - own;
    EXPECT_NEAR(glm::dot(moved, ned[1]), 3, 1e-6) << "forward is east";
    EXPECT_NEAR(glm::dot(moved, ned[2]), -1.5, 1e-6);
}

TEST(Display, AnAircraftFileMovesTheEyeAndNothingElse) {
    OverHills over;
    const flight::AircraftState state = aircraft_over_hills(2000, 90, 0);
    FramePlanner& planner = over.display.display().planner();
    const HillsPicture without = hills_picture(over.display, state);
    const glm::dvec3 antenna = over.display.display().planned().picture.camera.view.eye;
    const FrameRecord before = over.display.display().record();
    planner.settings().aircraft.eye = {4, -0.5, -300};
    const HillsPicture with = hills_picture(over.display, state);
    const glm::dmat3 ned = earth::north_east_down(radians(47.0), radians(9.7));
    const glm::dvec3 moved = over.display.display().planned().picture.camera.view.eye - antenna;
    EXPECT_NEAR(glm::dot(moved, ned[1]), 4, 1e-6) << "forward is east";
    EXPECT_NEAR(glm::dot(moved, ned[0]), 0.5, 1e-6) << "left is north";
    EXPECT_NEAR(glm::dot(moved, ned[2]), 300, 1e-6);
    EXPECT_NE(with, without) << "hills are higher from below";
    const FrameRecord& after = over.display.display().record();
    EXPECT_EQ(after.altitude_msl_m, before.altitude_msl_m);
    EXPECT_EQ(after.own_ship.position.height.m, before.own_ship.position.height.m);
    EXPECT_EQ(after.flags.size(), before.flags.size()) << "alerts are those of the antenna";
    planner.settings().aircraft = {};
    EXPECT_EQ(hills_picture(over.display, state), without);
}

TEST(Display, TheRecordTellsWhatWasDrawn) {
    OverHills over;
    flight::PhaseStatus phase;
    phase.phase = flight::kApproachFinal;
    phase.source = flight::PhaseSource::switches;
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(1500, 30, 3, 5), phase));
    static_cast<void>(hills_picture(over.display, aircraft_over_hills(1500, 30, 3, 5), phase));
    const FrameRecord& record = over.display.display().record();
    EXPECT_EQ(record.frame, 1u);
    EXPECT_EQ(record.time.ns, kHillsNow.ns);
    EXPECT_EQ(record.phase.phase, flight::kApproachFinal);
    EXPECT_NEAR(record.altitude_msl_m, 1500, 1e-9);
    EXPECT_NEAR(record.heading_rad, radians(30), 1e-12);
    EXPECT_GT(record.terrain.chunks, 0u);
    EXPECT_LE(record.terrain.worst_error_px, record.terrain.tau_px);
    EXPECT_EQ(record.bytes.uploaded > 0, true) << "symbology at least";
    EXPECT_EQ(record.signals[static_cast<std::size_t>(Signal::pitch)], SignalState::valid);
    EXPECT_EQ(record.signals[static_cast<std::size_t>(Signal::radio_height)], SignalState::missing);
}

TEST(Display, HeightAboveTerrainIsFromTheSurfaceThatIsDrawn) {
    OverHills over;
    const flight::AircraftState state = aircraft_over_hills(2600);
    const base::Stamped<double> above = over.display.display().planner().height_above_terrain(state.own_ship, kHillsNow);
    const host_sim::Raster raster = test_support::make_rough_raster(241, 241);
    // 47.0 N, 9.7 E is post 120, 120 of the raster (9.6 E, 47.1 N, 1200 posts a degree).
    EXPECT_NEAR(above.value_or(0), 2600 - double{raster.height_m[raster.at(120, 120)]}, 0.05);
    flight::OwnShipEstimate lost = state.own_ship;
    lost.state = SignalState::stale;
    EXPECT_FALSE(over.display.display().planner().height_above_terrain(lost, kHillsNow).received());
}

}  // namespace
}  // namespace tedavis::display::test_display
