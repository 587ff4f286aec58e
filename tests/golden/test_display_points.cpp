// The points that a pilot expects of a primary flight display (P01 .. P40), on three devices and at three sizes: each is shown in
// its place and color, by pixels that are not there without it, and the frame's record says so. Controls: a picture in which the
// element is removed, moved or recolored is not taken for one that shows it.
#include <gtest/gtest.h>

#include <bitset>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/draw/symbology/layout.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/display/point_pictures.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_display_points {
namespace {

using base::radians;
using design::SymbolRole;
using draw::Layout;
using draw::Rect;
using flight::AircraftState;
using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::gained_pixels;
using test_support::kHillsNow;

constexpr double kPitch_deg = 2, kFieldOfView_deg = 60;  // of the scene; of the default design, across the width

design::Color color_of(SymbolRole role) { return design::kDaySymbology.color(role); }

void set(AircraftState& state, Signal signal, double value) { state[signal] = {value, kHillsNow}; }
void remove(AircraftState& state, Signal signal) { state[signal] = {}; }

/// On a final approach over the hills; everything is stated.
AircraftState usual_state() {
    AircraftState state = test_support::aircraft_over_hills(1500, 30, kPitch_deg, 4);
    for (std::size_t n = 0; n < flight::kSignalCount; ++n)
        if (!state.signals[n].received()) state.signals[n] = {0, kHillsNow};
    set(state, Signal::magnetic_variation, 0);
    set(state, Signal::indicated_airspeed, 110 * base::kMpsPerKnot);
    set(state, Signal::calibrated_airspeed, 110 * base::kMpsPerKnot);
    set(state, Signal::true_airspeed, 120 * base::kMpsPerKnot);
    set(state, Signal::airspeed_rate, 1.5);
    set(state, Signal::normal_acceleration, 9.81);
    set(state, Signal::lateral_acceleration, 1.2);
    set(state, Signal::vertical_speed, -4);
    set(state, Signal::baro_setting, 100'900);
    set(state, Signal::radio_height, 480);
    set(state, Signal::flaps_position, 0.4);
    set(state, Signal::wind_speed, 8);
    set(state, Signal::outside_temperature, 281);
    set(state, Signal::navigation_source, static_cast<double>(flight::NavigationSource::radio1));
    set(state, Signal::selected_course, radians(35));
    set(state, Signal::desired_track, radians(35));
    set(state, Signal::ils1_localizer_deviation, radians(0.8));
    set(state, Signal::ils1_glideslope_deviation, radians(-0.2));
    set(state, Signal::selected_glidepath, radians(3));
    set(state, Signal::flight_director_pitch, radians(3));
    set(state, Signal::flight_director_roll, radians(6));
    set(state, Signal::selected_altitude, 1520);
    set(state, Signal::selected_heading, radians(45));
    set(state, Signal::selected_airspeed, 112 * base::kMpsPerKnot);
    set(state, Signal::selected_vertical_speed, -3);
    set(state, Signal::minimum_altitude, 1475);
    set(state, Signal::decision_height, 60);
    return state;
}

struct Screen {
    std::uint32_t width, height;
    Layout layout;
    explicit Screen(host_sim::PictureSize size)
        : width(size.width),
          height(size.height),
          layout(draw::make_layout(size.width, size.height, design::default_design_settings().view.dpi, need_of_key())) {}
    /// The key has the terrain.
    static draw::LegendNeed need_of_key() {
        draw::LegendNeed need;
        need.key_entries = 1;
        return need;
    }
    [[nodiscard]] float share_x(float share) const { return share * static_cast<float>(width); }
    [[nodiscard]] float share_y(float share) const { return share * static_cast<float>(height); }
    [[nodiscard]] Rect middle() const { return {share_x(0.25f), share_y(0.2f), share_x(0.5f), share_y(0.5f)}; }
    /// Where the horizon is, as a pinhole camera sees it, at level wings.
    [[nodiscard]] float horizon_y(double pitch_deg) const {
        const double focal_px = width / 2.0 / std::tan(radians(kFieldOfView_deg / 2));
        return static_cast<float>(height / 2.0 + focal_px * std::tan(radians(pitch_deg)));
    }
};

using Change = std::function<void(AircraftState&)>;
using Place = std::function<Rect(const Screen&)>;
using Record = display::FrameRecord;

struct Point {
    std::string id;
    Change with, without;  ///< from the usual scene
    Place place;
    SymbolRole role;
    float min_texts;                                                           ///< pixels, in pixels of a text's height
    std::function<bool(const Record& with, const Record& without)> is_stated;  ///< by the records
};

ElementShow shown(const Record& record, Element element) { return record.elements[static_cast<std::size_t>(element)]; }
bool has_flag(const Record& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [&](const display::Name& flag) { return flag.view() == name; });
}

/// The element is shown with it, and in another state without it.
auto states(Element element, ElementShow without, ElementShow with = ElementShow::normal) {
    return [=](const Record& a, const Record& b) { return shown(a, element) == with && shown(b, element) == without; };
}
Change missing(const std::vector<Signal>& signals) {
    std::bitset<flight::kSignalCount> is_missing;
    for (const Signal signal : signals) is_missing.set(static_cast<std::size_t>(signal));
    return [is_missing](AircraftState& state) {
        for (std::size_t n = 0; n < flight::kSignalCount; ++n)
            if (is_missing[n]) state.signals[n] = {};
    };
}
Change sets(Signal signal, double value) {
    return [=](AircraftState& state) { set(state, signal, value); };
}
void nothing(AircraftState&) {}

Place box(Rect Layout::*box) {
    return [box](const Screen& screen) { return screen.layout.*box; };
}
Rect middle(const Screen& screen) { return screen.middle(); }
/// Around the scale of bank and what lies below it.
Rect bank_arc(const Screen& screen) {
    const Rect& attitude = screen.layout.attitude;
    const float t = screen.layout.text_px;
    return {screen.share_x(0.5f) - 9 * t, attitude.y, 18 * t, screen.share_y(0.5f) - t - attitude.y};
}
Rect horizon_band(const Screen& screen) {
    const float y = screen.horizon_y(kPitch_deg), half = screen.layout.text_px;
    return {0, y - half, screen.share_x(1), 2 * half};
}
Rect above_horizon(const Screen& screen) {
    const float y = screen.horizon_y(kPitch_deg), t = screen.layout.text_px;
    return {screen.share_x(0.25f), y - 2.5f * t, screen.share_x(0.5f), 2.2f * t};
}
void level(AircraftState& state) { set(state, Signal::roll, 0); }

constexpr ElementShow kAbsent = ElementShow::absent, kFailed = ElementShow::failed;

std::vector<Point> attitude_points() {
    const auto pitched = [](double pitch_deg) {
        return [=](AircraftState& state) {
            level(state);
            set(state, Signal::pitch, radians(pitch_deg));
        };
    };
    const auto is_upset = [](const Record& a, const Record& b) {
        return has_flag(a, "attitude.unusual") && !has_flag(b, "attitude.unusual");
    };
    const auto stale_heading = [](AircraftState& state) {
        level(state);
        for (const Signal heading : {Signal::true_heading, Signal::magnetic_heading})
            state[heading] = {radians(30), kHillsNow - base::Duration::milliseconds(700)};
        remove(state, Signal::true_track);
    };
    return {
        {"P01 horizon line", level, pitched(14), horizon_band, SymbolRole::scale, 12,
         [](const Record& a, const Record& b) { return a.pitch_rad < b.pitch_rad; }},
        {"P04 headings on the horizon", level, stale_heading, above_horizon, SymbolRole::scale, 0.5f,
         states(Element::heading, ElementShow::flagged)},
        {"P05 pitch ladder", nothing, missing({Signal::pitch}), middle, SymbolRole::scale, 5, states(Element::attitude, kFailed)},
        {"P06 chevrons", pitched(45), nothing, middle, SymbolRole::warning, 3, is_upset},
        {"P08 bank scale", nothing, missing({Signal::roll}), bank_arc, SymbolRole::scale, 5, states(Element::attitude, kFailed)},
        {"P09 excessive bank", sets(Signal::roll, radians(50)), nothing, bank_arc, SymbolRole::caution, 2,
         [](const Record& a, const Record& b) { return a.roll_rad > radians(45) && b.roll_rad < radians(45); }},
        {"P10 slip", nothing, missing({Signal::lateral_acceleration}), bank_arc, SymbolRole::reference, 0.5f,
         states(Element::slip, kAbsent)},
        {"P26 flight-path vector", nothing,
         [](AircraftState& state) { state.own_ship.velocity_north_mps = state.own_ship.velocity_east_mps = 1; }, middle,
         SymbolRole::scale, 2, states(Element::flight_path, kAbsent)},
    };
}

std::vector<Point> speed_points() {
    const std::vector<Signal> airspeeds = {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed};
    const auto slow = [](AircraftState& state) {
        for (const Signal speed : {Signal::indicated_airspeed, Signal::calibrated_airspeed}) set(state, speed, 33);
    };
    const Place tape = box(&Layout::airspeed);
    return {
        {"P11 speed tape", nothing, missing(airspeeds), tape, SymbolRole::scale, 5,
         states(Element::airspeed, ElementShow::substituted)},
        {"P12 speed bands", nothing, missing({Signal::indicated_airspeed, Signal::calibrated_airspeed}), tape,
         SymbolRole::engaged, 10, states(Element::airspeed, ElementShow::substituted)},
        {"P13 low-speed cue", slow, missing(airspeeds), tape, SymbolRole::warning, 3,
         states(Element::airspeed, ElementShow::substituted)},
        {"P14 speed trend", nothing, missing({Signal::airspeed_rate}), tape, SymbolRole::scale, 1,
         states(Element::airspeed_trend, kAbsent)},
        {"P17 selected airspeed", nothing, missing({Signal::selected_airspeed}), tape, SymbolRole::selected, 1,
         states(Element::selected_airspeed, kAbsent)},
    };
}

std::vector<Point> height_points() {
    const std::vector<Signal> altitudes = {Signal::baro_altitude, Signal::true_altitude, Signal::standard_altitude,
                                           Signal::ellipsoid_height};
    const Place tape = box(&Layout::altitude), speed = box(&Layout::vertical_speed), foot = box(&Layout::ground_height);
    return {
        {"P15 altitude tape", nothing, missing(altitudes), tape, SymbolRole::scale, 5, states(Element::altitude, kFailed)},
        {"P16 altitude trend", nothing, missing({Signal::vertical_speed}), tape, SymbolRole::scale, 1,
         states(Element::vertical_speed, kFailed)},
        {"P17 selected altitude", nothing, missing({Signal::selected_altitude}), tape, SymbolRole::selected, 1,
         states(Element::selected_altitude, kAbsent)},
        {"P17 selected vertical speed", nothing, missing({Signal::selected_vertical_speed}), speed, SymbolRole::selected, 1,
         states(Element::selected_vertical_speed, kAbsent)},
        {"P18 vertical speed", nothing, missing({Signal::vertical_speed}), speed, SymbolRole::scale, 5,
         states(Element::vertical_speed, kFailed)},
        {"P19 baro setting", nothing, missing({Signal::baro_setting}), box(&Layout::baro_setting), SymbolRole::scale, 3,
         states(Element::baro_setting, kAbsent)},
        {"P19 minimum on the altimeter", nothing, missing({Signal::minimum_altitude}), tape, SymbolRole::selected, 1,
         states(Element::baro_minimum, kAbsent)},
        {"P19 minimum on radio height", nothing, missing({Signal::decision_height}), foot, SymbolRole::selected, 1,
         states(Element::radio_minimum, kAbsent)},
        {"P20 height above ground", nothing, missing({Signal::radio_height, Signal::height_above_terrain}), foot,
         SymbolRole::scale, 2,
         [](const Record& a, const Record& b) {
             return shown(a, Element::ground_height) == ElementShow::normal && shown(b, Element::ground_height) >= kFailed;
         }},
    };
}

std::vector<Point> guidance_points() {
    const Place rose = box(&Layout::heading);
    const auto by_gnss = sets(Signal::navigation_source, static_cast<double>(flight::NavigationSource::gnss));
    const auto by_none = sets(Signal::navigation_source, static_cast<double>(flight::NavigationSource::none));
    const auto lost = [](AircraftState& state) {
        for (const Signal signal : {Signal::latitude, Signal::longitude})
            state[signal] = {state[signal].value_or(0), kHillsNow - base::Duration::seconds(20)};
        state.own_ship.state = base::SignalState::lost;
    };
    return {
        {"P17 selected heading", nothing, missing({Signal::selected_heading}), rose, SymbolRole::selected, 1,
         states(Element::selected_heading, kAbsent)},
        {"P21 rose", nothing, missing({Signal::true_heading, Signal::magnetic_heading, Signal::true_track}), rose,
         SymbolRole::scale, 10, states(Element::heading, kFailed)},
        {"P22 localizer", nothing, missing({Signal::ils1_localizer_deviation}), rose, SymbolRole::engaged, 1,
         states(Element::lateral_deviation, kAbsent)},
        {"P22 glide slope", nothing, missing({Signal::ils1_glideslope_deviation}), box(&Layout::vertical_deviation),
         SymbolRole::engaged, 1, states(Element::vertical_deviation, kAbsent)},
        {"P23 radio source", nothing, by_none, rose, SymbolRole::engaged, 2, states(Element::course, kAbsent)},
        {"P23 GNSS source", by_gnss, by_none, rose, SymbolRole::gnss_course, 2, states(Element::course, kAbsent)},
        {"P24 flight director", nothing, missing({Signal::flight_director_pitch}), middle, SymbolRole::engaged, 5,
         states(Element::flight_director, kAbsent)},
        {"P25 flight-path reference", nothing, missing({Signal::selected_glidepath}), middle, SymbolRole::selected, 1,
         states(Element::flight_path_reference, kAbsent)},
        {"P39 loss of the synthetic view", lost, nothing, box(&Layout::annunciations), SymbolRole::caution, 2,
         [](const Record& a, const Record& b) {
             return has_flag(a, "own_ship.lost") && !has_flag(b, "own_ship.lost") && a.terrain.triangles == 0 &&
                    b.terrain.triangles > 0;
         }},
        {"P40 wind", nothing, missing({Signal::wind_speed, Signal::wind_direction}),
         [](const Screen& screen) { return screen.layout.air; }, SymbolRole::scale, 2, states(Element::wind, kAbsent)},
        {"P40 outside temperature", nothing, missing({Signal::outside_temperature}),
         [](const Screen& screen) { return screen.layout.air; }, SymbolRole::scale, 2,
         states(Element::outside_temperature, kAbsent)},
    };
}

std::vector<Point> all_points() {
    std::vector<Point> points = attitude_points();
    for (const auto& more : {speed_points(), height_points(), guidance_points()})
        points.insert(points.end(), more.begin(), more.end());
    return points;
}

/// A display of the default design over the hills.
class PointDisplay {
public:
    PointDisplay(const std::string& device, host_sim::PictureSize size, const std::string& design = "default")
        : session_(options(device, size, design), false), screen_(size) {}

    struct Frame {
        host_sim::RgbaPicture picture;
        Record record;
    };
    Frame frame(const Change& change) {
        AircraftState state = usual_state();
        change(state);
        flight::PhaseStatus phase;
        phase.phase = flight::kApproachFinal;
        phase.source = flight::PhaseSource::switches;
        display::settle(session_.display(), {state, phase, kHillsNow});
        session_.display().plan({state, phase, kHillsNow});
        session_.draw();
        return {upright(session_.pixels()), session_.display().record()};
    }
    [[nodiscard]] const Screen& screen() const { return screen_; }

private:
    host_sim::PictureOptions options(const std::string& device, host_sim::PictureSize size, const std::string& design) {
        const auto& image = test_support::hills().image;
        host_sim::PictureOptions options;
        options.terrain = folder_.write("hills.tdb", {image.begin(), image.end()});
        options.device = device;
        options.design = design;
        options.size = size;
        options.aircraft = "turboprop";
        return options;
    }

    test_support::TemporaryFolder folder_;
    host_sim::DisplaySession session_;
    Screen screen_;
};

using DeviceAndSize = std::tuple<const char*, host_sim::PictureSize>;

class DisplayPoints : public testing::TestWithParam<DeviceAndSize> {
protected:
    DisplayPoints() : display_(std::get<0>(GetParam()), std::get<1>(GetParam())) {}
    PointDisplay display_;
};

TEST_P(DisplayPoints, EachIsShownInItsPlaceAndColorAndStated) {
    for (const Point& point : all_points()) {
        const PointDisplay::Frame with = display_.frame(point.with), without = display_.frame(point.without);
        const test_support::PointPictures pictures{with.picture, without.picture};
        const Rect place = point.place(display_.screen());
        const double needed = point.min_texts * display_.screen().layout.text_px;
        const auto gained = [&](const test_support::PointPictures& of) {
            return static_cast<double>(gained_pixels(of, place, color_of(point.role)));
        };
        EXPECT_GE(gained(pictures), needed) << point.id;
        EXPECT_LT(gained(removed(pictures)), needed) << point.id << ": control, removed";
        EXPECT_LT(gained(moved(pictures, place)), needed) << point.id << ": control, moved";
        EXPECT_LT(gained(recolored(pictures)), needed) << point.id << ": control, recolored";
        EXPECT_TRUE(point.is_stated(with.record, without.record)) << point.id;
        EXPECT_FALSE(point.is_stated(without.record, with.record)) << point.id << ": control of the record";
    }
}

/// Share of the pixels in a part of the picture that are bluer than they are red.
double blue_share(const host_sim::RgbaPicture& picture, const Rect& part) {
    std::size_t blue = 0, all = 0;
    for (auto y = static_cast<std::uint32_t>(part.y); y < static_cast<std::uint32_t>(part.bottom()); ++y)
        for (auto x = static_cast<std::uint32_t>(part.x); x < static_cast<std::uint32_t>(part.right()); ++x) {
            const std::uint8_t* const pixel = &picture.pixels[(std::size_t{y} * picture.width + x) * 4];
            blue += pixel[2] > pixel[0] + 20 ? 1 : 0;
            ++all;
        }
    return static_cast<double>(blue) / static_cast<double>(all);
}

/// The parts of the picture's middle above and below the horizon. Control: upside down they are exchanged.
TEST_P(DisplayPoints, P02SkyAndGroundAreDistinctWithAndWithoutTerrain) {
    const Screen& screen = display_.screen();
    const float y = screen.horizon_y(kPitch_deg), t = screen.layout.text_px;
    const Rect above{screen.share_x(0.3f), y - 5 * t, screen.share_x(0.4f), 3 * t},
        below{screen.share_x(0.3f), y + 2 * t, screen.share_x(0.4f), 3 * t};
    const auto lost = [](AircraftState& state) {
        level(state);
        remove(state, Signal::latitude);
        state.own_ship.state = base::SignalState::missing;
    };
    for (const Change& change : {Change(level), Change(lost)}) {
        const PointDisplay::Frame frame = display_.frame(change);
        EXPECT_GT(blue_share(frame.picture, above), 0.7);
        EXPECT_LT(blue_share(frame.picture, below), 0.1);
        const PointDisplay::Frame turned = display_.frame([&](AircraftState& state) {
            change(state);
            set(state, Signal::roll, radians(180));
            set(state, Signal::pitch, radians(-kPitch_deg));
        });
        EXPECT_LT(blue_share(turned.picture, {above.x, static_cast<float>(screen.height) - y - 5 * t, above.width, 3 * t}), 0.7);
    }
}

/// Whether a part of the horizon line is in the picture, by the sky above it and the ground below it.
bool shows_horizon(const host_sim::RgbaPicture& picture, const Screen& screen) {
    const Rect top{screen.share_x(0.3f), screen.layout.attitude.y, screen.share_x(0.4f), screen.layout.text_px};
    const Rect foot{screen.share_x(0.3f), screen.share_y(1) - 2 * screen.layout.text_px, screen.share_x(0.4f),
                    screen.layout.text_px};
    return blue_share(picture, top) > 0.5 && blue_share(picture, foot) < 0.5;
}

/// Pitch of normal maneuvers, and the margin of AC 25-11B, 5.4.2. Control: 40 degrees are too many for any of the sizes.
TEST_P(DisplayPoints, P03TheHorizonStaysInViewWithAMargin) {
    const auto pitched = [](double pitch_deg) {
        return [=](AircraftState& state) {
            level(state);
            set(state, Signal::pitch, radians(pitch_deg));
        };
    };
    const Screen& screen = display_.screen();
    for (const double pitch_deg : {-5.0 - 5, 5.0 + 5})
        EXPECT_TRUE(shows_horizon(display_.frame(pitched(pitch_deg)).picture, screen)) << pitch_deg;
    EXPECT_FALSE(shows_horizon(display_.frame(pitched(60)).picture, screen)) << "control";
}

TEST_P(DisplayPoints, P07TheRecoveryPictureEndsWithHysteresis) {
    const auto after = [](double pitch_deg, double excursion_deg) {
        return [=](AircraftState& state) {
            level(state);
            set(state, Signal::pitch, radians(pitch_deg));
            state.excursion.step(radians(excursion_deg), 0);
        };
    };
    const PointDisplay::Frame coming = display_.frame(after(28, 28)), going = display_.frame(after(28, 31)),
                              back = display_.frame(after(24, 31));
    EXPECT_FALSE(has_flag(coming.record, "attitude.unusual"));
    EXPECT_TRUE(has_flag(going.record, "attitude.unusual"));
    EXPECT_FALSE(has_flag(back.record, "attitude.unusual"));
    const Rect deviation = display_.screen().layout.vertical_deviation;
    EXPECT_GE(gained_pixels({coming.picture, going.picture}, deviation, color_of(SymbolRole::engaged)), 10u)
        << "what is not needed to recover is removed";
    EXPECT_EQ(gained_pixels({going.picture, coming.picture}, deviation, color_of(SymbolRole::engaged)), 0u);
}

TEST_P(DisplayPoints, P40TheFieldOfViewIsStatedWhereThereIsNoMap) {
    const PointDisplay::Frame with = display_.frame(nothing), without = display_.frame(sets(Signal::pitch, radians(45)));
    const test_support::PointPictures pictures{with.picture, without.picture};
    const Rect place = draw::field_of_view_box(display_.screen().layout);
    const auto needed = static_cast<std::size_t>(display_.screen().layout.text_px);
    EXPECT_GE(gained_pixels(pictures, place, color_of(SymbolRole::scale)), needed);
    EXPECT_LT(gained_pixels(removed(pictures), place, color_of(SymbolRole::scale)), needed) << "control";
    EXPECT_EQ(with.record.view.mode, design::ViewMode::perspective);
}

class MapPoints : public testing::TestWithParam<DeviceAndSize> {
protected:
    MapPoints() : map_(std::get<0>(GetParam()), std::get<1>(GetParam()), "map_north_up") {}
    PointDisplay map_;
};

TEST_P(MapPoints, P40TheMapHasARangeRingWithItsDistance) {
    const auto nothing_known = [](AircraftState& state) {
        for (const Signal signal : {Signal::latitude, Signal::longitude}) remove(state, signal);
        state.own_ship.state = base::SignalState::missing;
    };
    const PointDisplay::Frame with = map_.frame(nothing), without = map_.frame(nothing_known);
    EXPECT_EQ(with.record.view.mode, design::ViewMode::map);
    EXPECT_GE(gained_pixels({with.picture, without.picture}, map_.screen().middle(), color_of(SymbolRole::scale)),
              static_cast<std::size_t>(10 * map_.screen().layout.text_px));
    EXPECT_EQ(shown(with.record, Element::position), ElementShow::normal);
    EXPECT_EQ(shown(without.record, Element::position), ElementShow::failed);
}

std::string name_of_device_and_size(const testing::TestParamInfo<DeviceAndSize>& of) {
    std::string name = std::get<0>(of.param);
    for (char& c : name) c = c == '-' ? '_' : c;
    return name + "_" + std::to_string(std::get<1>(of.param).width);
}

const auto kDevicesAndSizes = testing::Combine(
    testing::Values("es2-small", "es3-mid", "sc2"),
    testing::Values(host_sim::PictureSize{640, 480}, host_sim::PictureSize{800, 450}, host_sim::PictureSize{480, 640}));
INSTANTIATE_TEST_SUITE_P(On, DisplayPoints, kDevicesAndSizes, name_of_device_and_size);
INSTANTIATE_TEST_SUITE_P(On, MapPoints, kDevicesAndSizes, name_of_device_and_size);

}  // namespace
}  // namespace tedavis::test_display_points
