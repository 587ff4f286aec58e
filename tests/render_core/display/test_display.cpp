#include "render_core/display/display.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/built_database.hpp"
#include "tests/support/damaged_terrain.hpp"
#include "tests/support/default_flight.hpp"
#include "tests/support/device_files.hpp"
#include "tests/support/draped_database.hpp"
#include "tests/support/drawn_pixels.hpp"

namespace tedavis::display {
namespace {

using base::radians;
using base::SignalState;
using base::Time;
using flight::Signal;
using test_support::HeadlessDisplay;

constexpr Time kNow{1'700'000'000'000'000'000};

/// Hills of 1000 m at 47.0 N 9.7 E, and a database of them.
const test_support::BuiltDatabase& hills() {
    static const test_support::BuiltDatabase built(test_support::make_rough_raster(241, 241));
    return built;
}

/// In the middle of the hills at a height above MSL, everything valid.
flight::AircraftState aircraft_at(double msl_m, double heading_deg = 30, double pitch_deg = 2, double roll_deg = 0) {
    flight::AircraftState state;
    const auto set = [&](Signal signal, double value) { state[signal] = {value, kNow}; };
    const double latitude = radians(47.0), longitude = radians(9.7);
    const double ellipsoid_m = msl_m + hills().database.undulation(latitude, longitude).m;
    set(Signal::latitude, latitude);
    set(Signal::longitude, longitude);
    set(Signal::ellipsoid_height, ellipsoid_m);
    set(Signal::pitch, radians(pitch_deg));
    set(Signal::roll, radians(roll_deg));
    set(Signal::true_heading, radians(heading_deg));
    set(Signal::true_track, radians(heading_deg));
    set(Signal::ground_speed, 60);
    set(Signal::indicated_airspeed, 60);
    set(Signal::baro_altitude, msl_m);
    set(Signal::vertical_speed, 0);
    set(Signal::height_above_terrain, msl_m - 1000);
    state.own_ship.position = {latitude, longitude, {ellipsoid_m}};
    state.own_ship.velocity_north_mps = 60 * std::cos(radians(heading_deg));
    state.own_ship.velocity_east_mps = 60 * std::sin(radians(heading_deg));
    state.own_ship.height_is_geometric = true;
    state.own_ship.at = kNow;
    state.own_ship.state = SignalState::valid;
    return state;
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    std::uint32_t width = 0, height = 0;
    /// From the top left corner.
    [[nodiscard]] const std::uint8_t* at(std::uint32_t x, std::uint32_t y) const {
        return rgba.data() + (std::size_t{height - 1 - y} * width + x) * 4;
    }
    [[nodiscard]] bool is_sky(std::uint32_t x, std::uint32_t y) const {
        return at(x, y)[2] > at(x, y)[1] && at(x, y)[1] > at(x, y)[0];
    }
};
bool operator==(const Picture& a, const Picture& b) { return a.rgba == b.rgba; }
bool operator!=(const Picture& a, const Picture& b) { return !(a == b); }

/// With all terrain arrived.
Picture picture_of(HeadlessDisplay& display, const flight::AircraftState& state, const flight::PhaseStatus& phase = {},
                   Time now = kNow) {
    return {test_support::settled_pixels(display, state, now, phase), display.surface().width(), display.surface().height()};
}

bool has_flag(const HeadlessDisplay& display, std::string_view name) {
    const auto& flags = const_cast<HeadlessDisplay&>(display).display().record().flags;
    return std::any_of(flags.begin(), flags.end(), [&](const Name& flag) { return flag.view() == name; });
}

/// A display over the hills; the image may be damaged before.
struct OverHills {
    test_support::MemoryBytes bytes;
    HeadlessDisplay display;
    explicit OverHills(const std::vector<std::uint8_t>& image = hills().image, const std::string& device = "es3-mid",
                       std::uint32_t width = 320, std::uint32_t height = 240)
        : bytes(image), display("egl", device, width, height, &bytes) {}
};

TEST(Display, TheSameStateGivesTheSameBits) {
    const auto first_picture = [] {
        OverHills first;
        return picture_of(first.display, aircraft_at(2000));
    };
    const Picture a = first_picture();
    OverHills second;
    static_cast<void>(picture_of(second.display, aircraft_at(3500, 200, -10, 40)));
    EXPECT_EQ(a, picture_of(second.display, aircraft_at(2000))) << "whatever was drawn before";
    EXPECT_NE(a, picture_of(second.display, aircraft_at(2001))) << "control";
}

/// Pixels whose colour differs from that of the same picture without warning colours.
std::size_t coloured_pixels(const flight::AircraftState& state, bool widened, design::BandWidening* record = nullptr) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.symbology.legend = false;
    design.widening.enabled = widened;
    const auto drawn = [&](bool warning) {
        design.warning_colors = warning;
        test_support::MemoryBytes bytes(hills().image);
        HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes, design);
        Picture picture = picture_of(display, state);
        if (warning && record != nullptr) *record = display.display().record().bands;
        return picture;
    };
    const Picture with = drawn(true), without = drawn(false);
    std::size_t different = 0;
    for (std::size_t p = 0; p < with.rgba.size(); p += 4)
        different += std::equal(with.rgba.begin() + p, with.rgba.begin() + p + 4, without.rgba.begin() + p) ? 0 : 1;
    return different;
}

TEST(Display, WarningColoursReachFurtherTheLessIsKnownOfTheHeight) {
    flight::AircraftState state = aircraft_at(2000);  // tops reach the lowest limit, 2000 ft below
    const auto at_accuracy = [&](double metres, design::BandWidening* record = nullptr) {
        state[Signal::vertical_accuracy] = {metres, kNow};
        return coloured_pixels(state, true, record);
    };
    const std::size_t none = coloured_pixels(state, false);
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
    static_cast<void>(coloured_pixels(state, true, &unknown));
    EXPECT_TRUE(unknown.position_assumed);
}

TEST(Display, AnotherDesignsCoverageHoldsFromTheNextFrame) {
    design::DesignSettings design = test_support::shipped_design("default");
    test_support::MemoryBytes bytes(hills().image);
    HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes, design);
    flight::AircraftState state = aircraft_at(2000);
    state[Signal::vertical_accuracy] = {28.0, kNow};
    const auto lowered_m = [&] {
        static_cast<void>(picture_of(display, state));
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
        const Picture picture = picture_of(over.display, aircraft_at(2500, 30, 0));
        // Beside the tapes and above the heading, where no symbol stands.
        EXPECT_TRUE(picture.is_sky(c.width / 2 + c.width / 5, c.height / 4)) << c.device << " " << c.width;
        EXPECT_FALSE(picture.is_sky(c.width / 2 + c.width / 5, c.height * 2 / 3)) << c.device << " " << c.width;
        EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
        EXPECT_EQ(over.display.display().gl().denied().total, 0u);
    }
}

TEST(Display, BytesStayWithinTheBudgetsAndAreTheSameEveryFrame) {
    OverHills over;
    static_cast<void>(picture_of(over.display, aircraft_at(2500)));
    const ByteRecord first = over.display.display().record().bytes;
    for (const double heading : {0.0, 90.0, 180.0, 270.0})
        static_cast<void>(picture_of(over.display, aircraft_at(1500, heading)));
    const ByteRecord last = over.display.display().record().bytes;
    EXPECT_EQ(first.cpu, last.cpu);
    EXPECT_EQ(first.gpu, last.gpu);
    EXPECT_LE(last.cpu, last.cpu_budget);
    std::uint64_t lines = 0;
    for (const base::BudgetLine& line : over.display.display().budget().lines()) {
        EXPECT_LE(line.use.in_use, line.bytes) << line.name.view();
        if (line.kind == base::MemoryKind::cpu) lines += line.use.in_use;
    }
    EXPECT_EQ(lines, last.cpu) << "the table tells the same as the record";
    EXPECT_GT(lines, 1'000'000u);
    EXPECT_LE(last.gpu, last.gpu_budget);
    EXPECT_GT(last.gpu, 0u);
}

/// Removed terrain leaves no trace of where the aircraft is: the picture is that of any other place.
TEST(Display, WithoutATrustworthyPositionNothingOfTheTerrainIsSeen) {
    OverHills over;
    const Picture shown = picture_of(over.display, aircraft_at(2000));
    for (const SignalState bad : {SignalState::missing, SignalState::stale, SignalState::lost, SignalState::invalid}) {
        flight::AircraftState here = aircraft_at(2000), elsewhere = aircraft_at(2000);
        elsewhere.own_ship.position.latitude_rad = radians(47.03);
        here.own_ship.state = elsewhere.own_ship.state = bad;
        const Picture removed = picture_of(over.display, here);
        EXPECT_NE(removed, shown);
        EXPECT_EQ(removed, picture_of(over.display, elsewhere));
        EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
    }
    flight::AircraftState elsewhere = aircraft_at(2000);
    elsewhere.own_ship.position.latitude_rad = radians(47.03);
    EXPECT_NE(shown, picture_of(over.display, elsewhere)) << "control: shown terrain does depend on the place";
}

TEST(Display, StaleAltitudeTakesTheWarningColoursAway) {
    OverHills over;
    flight::AircraftState state = aircraft_at(1100);
    const Picture warned = picture_of(over.display, state);
    EXPECT_EQ(over.display.display().record().effects[1].state, EffectState::run);
    state.own_ship.height_is_geometric = false;
    const Picture degraded = picture_of(over.display, state);
    EXPECT_EQ(over.display.display().record().effects[1].state, EffectState::skipped);
    EXPECT_TRUE(has_flag(over.display, "terrain.degraded"));
    EXPECT_NE(warned, degraded);
}

TEST(Display, DamagedChunksLeaveCoarserTerrainAndAreSaid) {
    const auto whole_picture = [] {
        OverHills whole;
        Picture picture = picture_of(whole.display, aircraft_at(4000, 30, -20));
        EXPECT_FALSE(has_flag(whole.display, "terrain.failing"));
        return picture;
    };
    const Picture whole = whole_picture();
    std::vector<std::uint8_t> image = hills().image;
    test_support::damage_payloads(image);
    OverHills over(image);
    const Picture first = picture_of(over.display, aircraft_at(4000, 30, -20));
    const FrameRecord& record = over.display.display().record();
    EXPECT_TRUE(has_flag(over.display, "terrain.failing"));
    EXPECT_TRUE(has_flag(over.display, "terrain.tau_raised"));
    EXPECT_GT(record.terrain.triangles, 0u);
    EXPECT_GT(record.terrain.tau_reached_px, record.terrain.tau_px);
    EXPECT_NE(first, whole);
    EXPECT_EQ(first, picture_of(over.display, aircraft_at(4000, 30, -20)));
}

TEST(Display, TheFirstFramesAreCoarserButWhole) {
    OverHills over;
    Display& display = over.display.display();
    const flight::AircraftState state = aircraft_at(2000, 30, -20);
    double last_error = 1e9;
    for (int frame = 0; frame < 6; ++frame) {
        display.update(state, {}, kNow);
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

TEST(Display, ApproachingCountsNoFrameAndSettlingWaitsForAll) {
    OverHills over;
    Display& display = over.display.display();
    display.approach(aircraft_at(2000, 30, -20), {}, kNow);
    EXPECT_GT(display.record().terrain.pending, 0u);
    display.settle(aircraft_at(2000, 30, -20), {}, kNow);
    EXPECT_EQ(display.record().terrain.pending, 0u);
    display.update(aircraft_at(2000, 30, -20), {}, kNow);
    EXPECT_EQ(display.record().frame, 0u);
    EXPECT_EQ(display.record().terrain.pending, 0u);
}

TEST(Display, AStyleThatNeedsOtherProgramsIsRefusedAndChangesNothing) {
    OverHills over;
    const Picture before = picture_of(over.display, aircraft_at(2000));
    design::DesignSettings other = test_support::shipped_design("default");
    other.view.horizontal_field_of_view_rad = radians(30);
    other.terrain.style.texture = design::TerrainTexture::material;
    EXPECT_FALSE(over.display.display().set_design(other));
    EXPECT_EQ(before, picture_of(over.display, aircraft_at(2000)));
    other.terrain.style = test_support::shipped_design("default").terrain.style;
    EXPECT_TRUE(over.display.display().set_design(other));
    EXPECT_NE(before, picture_of(over.display, aircraft_at(2000))) << "control";
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
    const Picture picture = picture_of(display, aircraft_at(2000, 30, 0));
    EXPECT_TRUE(picture.is_sky(224, 60));
    EXPECT_FALSE(picture.is_sky(224, 160));
    EXPECT_TRUE(has_flag(display, "terrain.missing"));
}

TEST(Display, WithoutAttitudeThereIsNoHorizon) {
    OverHills over(hills().image, "es3-mid", 1024, 768);
    for (const Signal lost : {Signal::pitch, Signal::roll}) {
        flight::AircraftState state = aircraft_at(2000, 30, 0);
        state[lost] = {};
        const Picture picture = picture_of(over.display, state);
        // In the gap between the tapes, which nothing else covers.
        const std::uint8_t *high = picture.at(148, 150), *low = picture.at(148, 600);
        EXPECT_TRUE(std::equal(high, high + 3, low)) << "one colour above and below";
        EXPECT_LT(high[2], 64);
    }
    EXPECT_TRUE(picture_of(over.display, aircraft_at(2000, 30, 0)).is_sky(148, 150)) << "control";
}

TEST(Display, OutsideTheDatabaseIsSaid) {
    OverHills over;
    flight::AircraftState state = aircraft_at(2000);
    state.own_ship.position.latitude_rad = radians(48.5);
    static_cast<void>(picture_of(over.display, state));
    EXPECT_TRUE(has_flag(over.display, "terrain.outside_database"));
    EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
}

TEST(Display, BelowItsSurfaceTheTerrainIsTakenAway) {
    OverHills over;
    static_cast<void>(picture_of(over.display, aircraft_at(900)));
    EXPECT_TRUE(has_flag(over.display, "terrain.above_own_ship"));
    EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
    static_cast<void>(picture_of(over.display, aircraft_at(1700)));
    EXPECT_FALSE(has_flag(over.display, "terrain.above_own_ship"));
    EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
}

TEST(Display, TerrainBeyondTheDesignsErrorIsSaidToBeCoarse) {
    OverHills over;
    const Picture fine = picture_of(over.display, aircraft_at(2000));
    EXPECT_FALSE(has_flag(over.display, "terrain.coarse"));
    design::DesignSettings strict = test_support::shipped_design("default");
    strict.degradation.terrain_error_px = 0.5 * strict.terrain.tau_px;
    ASSERT_TRUE(over.display.display().set_design(strict));
    const Picture coarse = picture_of(over.display, aircraft_at(2000));
    EXPECT_TRUE(has_flag(over.display, "terrain.coarse"));
    EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
    EXPECT_NE(fine, coarse) << "the notice is on the picture";
}

TEST(Display, TerrainThatWouldBeAWrongPictureIsTakenAwayUntilItHasArrived) {
    OverHills over;
    design::DesignSettings strict = test_support::shipped_design("default");
    strict.degradation.terrain_removed_px = 2;
    ASSERT_TRUE(over.display.display().set_design(strict));
    over.display.display().update(aircraft_at(2000), {}, kNow);
    over.display.display().draw(over.display.surface());
    EXPECT_TRUE(has_flag(over.display, "terrain.too_coarse"));
    EXPECT_EQ(over.display.display().record().terrain.triangles, 0u);
    EXPECT_GT(over.display.display().record().terrain.worst_error_px, 2) << "the record says how wrong it would have been";
    static_cast<void>(picture_of(over.display, aircraft_at(2000)));
    EXPECT_FALSE(has_flag(over.display, "terrain.too_coarse"));
    EXPECT_GT(over.display.display().record().terrain.triangles, 0u);
}

TEST(Display, AFreeViewHasNoSymbolsAndGivesTheOwnOneBack) {
    OverHills over;
    const Picture own = picture_of(over.display, aircraft_at(2000));
    const terrain::View same = over.display.display().view();
    over.display.display().set_free_view(same);
    const Picture bare = picture_of(over.display, aircraft_at(2000));
    std::size_t different = 0;
    for (std::size_t n = 0; n < own.rgba.size(); ++n) different += own.rgba[n] != bare.rgba[n] ? 1 : 0;
    EXPECT_GT(different, own.rgba.size() / 50) << "symbols are gone";
    EXPECT_LT(different, own.rgba.size() * 2 / 3) << "the terrain is the same";
    terrain::View other = same;
    other.forward = -same.forward;
    other.right = -same.right;
    over.display.display().set_free_view(other);
    EXPECT_NE(bare, picture_of(over.display, aircraft_at(2000)));
    over.display.display().clear_free_view();
    EXPECT_EQ(own, picture_of(over.display, aircraft_at(2000)));
}

TEST(Display, TheEyeIsWhereTheAircraftAndTheDesignPutIt) {
    OverHills over;
    const flight::AircraftState state = aircraft_at(2000, 90, 0);
    static_cast<void>(picture_of(over.display, state));
    const glm::dvec3 own = earth::to_ecef(state.own_ship.position);
    EXPECT_LT(glm::length(over.display.display().view().eye - own), 1e-6);
    design::DesignSettings design = test_support::shipped_design("default");
    design.view.eye_forward_m = 3;
    design.view.eye_down_m = -1.5;
    ASSERT_TRUE(over.display.display().set_design(design));
    static_cast<void>(picture_of(over.display, state));
    const glm::dmat3 ned = earth::north_east_down(radians(47.0), radians(9.7));
    const glm::dvec3 moved = over.display.display().view().eye - own;
    EXPECT_NEAR(glm::dot(moved, ned[1]), 3, 1e-6) << "forward is east";
    EXPECT_NEAR(glm::dot(moved, ned[2]), -1.5, 1e-6);
}

TEST(Display, TheRecordTellsWhatWasDrawn) {
    OverHills over;
    flight::PhaseStatus phase;
    phase.phase = flight::kApproachFinal;
    phase.source = flight::PhaseSource::switches;
    static_cast<void>(picture_of(over.display, aircraft_at(1500, 30, 3, 5), phase));
    static_cast<void>(picture_of(over.display, aircraft_at(1500, 30, 3, 5), phase));
    const FrameRecord& record = over.display.display().record();
    EXPECT_EQ(record.frame, 1u);
    EXPECT_EQ(record.time.ns, kNow.ns);
    EXPECT_EQ(record.phase.phase, flight::kApproachFinal);
    EXPECT_NEAR(record.altitude_msl_m, 1500, 1e-9);
    EXPECT_NEAR(record.heading_rad, radians(30), 1e-12);
    EXPECT_GT(record.terrain.chunks, 0u);
    EXPECT_LE(record.terrain.worst_error_px, record.terrain.tau_px);
    EXPECT_EQ(record.bytes.uploaded > 0, true) << "symbology at least";
    EXPECT_EQ(record.signals[static_cast<std::size_t>(Signal::pitch)], SignalState::valid);
    EXPECT_EQ(record.signals[static_cast<std::size_t>(Signal::radio_height)], SignalState::missing);
}

design::DesignSettings image_design() {
    design::DesignSettings design = test_support::shipped_design("styles/aerial_image");
    design.sky.haze_distance_m = 0;
    return design;
}

const EffectRecord* effect_of(HeadlessDisplay& display, std::string_view name) {
    for (const EffectRecord& effect : display.display().record().effects)
        if (effect.name.view() == name) return &effect;
    return nullptr;
}

/// How many pixels are as blue as the image.
std::size_t image_pixels(const Picture& picture) {
    std::size_t count = 0;
    for (std::size_t n = 0; n < picture.rgba.size(); n += 4)
        count += picture.rgba[n] < 30 && picture.rgba[n + 1] < 60 && picture.rgba[n + 2] > 200 ? 1 : 0;
    return count;
}

TEST(Display, AnImageIsShownWithinItsBudgetOnEveryDevice) {
    const host_sim::Raster raster = test_support::make_rough_raster(241, 241);
    const std::vector<std::uint8_t> image = test_support::draped_image(raster, test_support::image_over(raster, 2, [](int, int) {
                                                                           return test_support::Rgba{10, 40, 250, 255};
                                                                       }));
    test_support::MemoryBytes bytes(image);
    for (const char* device : {"es2-small", "es3-mid", "desktop"}) {
        HeadlessDisplay display("egl", device, 320, 240, &bytes, image_design());
        const Picture picture = picture_of(display, aircraft_at(2500, 30, -15));
        EXPECT_GT(image_pixels(picture), 10000u) << device;
        ASSERT_NE(effect_of(display, "drape"), nullptr);
        EXPECT_EQ(effect_of(display, "drape")->state, EffectState::run);
        EXPECT_EQ(display.display().record().terrain_aspect.technique.view(), "image");
        for (const base::BudgetLine& line : display.display().budget().lines())
            EXPECT_LE(line.use.in_use, line.bytes) << device << ": " << line.name.view();
        EXPECT_GT(display.display().budget().find(effects::kTerrainDrape)->use.in_use, 0u);
        EXPECT_GT(display.display().budget().find(effects::kTerrainDrapePages)->use.in_use, 0u);
    }
}

TEST(Display, WhereTheDatabaseHasNoImageThePlainColourIsDrawnAndSaid) {
    test_support::MemoryBytes bytes(hills().image);
    HeadlessDisplay display("egl", "es3-mid", 320, 240, &bytes, image_design());
    const Picture picture = picture_of(display, aircraft_at(2500, 30, -15));
    EXPECT_EQ(image_pixels(picture), 0u);
    const EffectRecord* const drape = effect_of(display, "drape");
    ASSERT_NE(drape, nullptr);
    EXPECT_EQ(drape->state, EffectState::skipped);
    EXPECT_EQ(drape->reason.view(), "the terrain database has no image; the plain colour is drawn");
    EXPECT_EQ(display.display().record().terrain_aspect.technique.view(), "plain");
    EXPECT_TRUE(has_flag(display, "terrain.no_image"));
    EXPECT_EQ(display.display().budget().find(effects::kTerrainDrape)->use.in_use, 0u) << "nothing is read for it";
}

TEST(Display, OtherStylesReadNoImage) {
    const host_sim::Raster raster = test_support::make_rough_raster(241, 241);
    const std::vector<std::uint8_t> image = test_support::draped_image(raster, test_support::image_over(raster, 2, [](int, int) {
                                                                           return test_support::Rgba{10, 40, 250, 255};
                                                                       }));
    test_support::MemoryBytes bytes(image);
    const auto shown = [](test_support::MemoryBytes& database) {
        HeadlessDisplay display("egl", "es3-mid", 320, 240, &database);
        const Picture picture = picture_of(display, aircraft_at(2500));
        EXPECT_EQ(effect_of(display, "drape"), nullptr);
        EXPECT_FALSE(has_flag(display, "terrain.no_image"));
        return std::pair(picture.rgba, display.display().record().bytes.gpu);
    };
    test_support::MemoryBytes without(hills().image);
    EXPECT_EQ(shown(bytes), shown(without));
}

TEST(Display, HeightAboveTerrainIsFromTheSurfaceThatIsDrawn) {
    OverHills over;
    const flight::AircraftState state = aircraft_at(2600);
    const base::Stamped<double> above = over.display.display().height_above_terrain(state.own_ship, kNow);
    const host_sim::Raster raster = test_support::make_rough_raster(241, 241);
    // 47.0 N, 9.7 E is post 120, 120 of the raster (9.6 E, 47.1 N, 1200 posts a degree).
    EXPECT_NEAR(above.value_or(0), 2600 - double{raster.height_m[raster.at(120, 120)]}, 0.05);
    flight::OwnShipEstimate lost = state.own_ship;
    lost.state = SignalState::stale;
    EXPECT_FALSE(over.display.display().height_above_terrain(lost, kNow).received());
}

}  // namespace
}  // namespace tedavis::display
