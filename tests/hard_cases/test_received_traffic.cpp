/// Another aircraft from a receiver's report to its sign: written as a candump log, replayed, drawn, and looked for where the
/// report says it is. The place in the picture is GeographicLib's, turned by the attitude as written down here.

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "host_sim/flight_log/flight_log_writer.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/sent_traffic.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::host_sim::test_received_traffic {
namespace {

using base::radians;

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr double kHeading_deg = 340, kPitch_deg = -8, kRoll_deg = -15, kFieldOfView_deg = 60;
constexpr double kOwnLatitude_deg = 47.04, kOwnLongitude_deg = 9.68, kOwnHeight_m = 2400;
constexpr double kTargetHeight_m = 2050, kTrack_deg = 70, kSpeed_mps = 60, kClimb_mps = 3;
constexpr double kReceivedUntil_s = 20, kLastReport_s = 20.043 - 1;

/// Where the other aircraft is: from three kilometres ahead it flies to the right.
struct Target {
    double latitude_deg, longitude_deg, height_m;
};
Target target_at(double second) {
    Target target{};
    double ahead_latitude = 0, ahead_longitude = 0;
    const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
    earth.Direct(kOwnLatitude_deg, kOwnLongitude_deg, kHeading_deg - 3, 3000, ahead_latitude, ahead_longitude);
    earth.Direct(ahead_latitude, ahead_longitude, kTrack_deg, kSpeed_mps * (second - 10), target.latitude_deg,
                 target.longitude_deg);
    target.height_m = kTargetHeight_m + kClimb_mps * (second - 10);
    return target;
}

/// A hundred seconds of hovering; the other is heard for the first twenty.
class Hover final : public FlightSource {
public:
    base::Time begin() const override { return base::Time{} + base::Duration::seconds(1'700'000'000); }
    base::Time end() const override { return begin() + base::Duration::seconds(100); }
    std::optional<SignalSample> at(base::Time) const override {
        using flight::Signal;
        SignalSample sample;
        sample[Signal::latitude] = radians(kOwnLatitude_deg);
        sample[Signal::longitude] = radians(kOwnLongitude_deg);
        sample[Signal::ellipsoid_height] = kOwnHeight_m;
        sample[Signal::ground_speed] = 0;
        sample[Signal::true_track] = 0;
        sample[Signal::vertical_speed] = 0;
        sample[Signal::true_heading] = radians(kHeading_deg);
        sample[Signal::pitch] = radians(kPitch_deg);
        sample[Signal::roll] = radians(kRoll_deg);
        sample[Signal::baro_altitude] = 2350;
        return sample;
    }
    std::vector<ReceivedAircraft> traffic(base::Time time) const override {
        const double second = (time - begin()).to_seconds();
        if (second >= kReceivedUntil_s) return {};
        const Target there = target_at(second);
        flight::TrafficReport report = test_support::traffic_report(0x3C6444, time, there.latitude_deg, there.longitude_deg);
        report.place.height_m = static_cast<float>(there.height_m);
        report.ground_speed_mps = kSpeed_mps;
        report.true_track_rad = static_cast<float>(radians(kTrack_deg));
        report.climb_mps = kClimb_mps;
        return {{0, report}};
    }
};

struct Pixel {
    double x, y;  ///< from the top left corner
};
Pixel projected(const Target& target) {
    double east = 0, north = 0, up = 0;
    GeographicLib::LocalCartesian(kOwnLatitude_deg, kOwnLongitude_deg, kOwnHeight_m)
        .Forward(target.latitude_deg, target.longitude_deg, target.height_m, east, north, up);
    const double h = radians(kHeading_deg), p = radians(kPitch_deg), r = radians(kRoll_deg);
    const double level_ahead = east * std::sin(h) + north * std::cos(h), level_right = east * std::cos(h) - north * std::sin(h);
    const double ahead = level_ahead * std::cos(p) + up * std::sin(p), above = up * std::cos(p) - level_ahead * std::sin(p);
    const double right = level_right * std::cos(r) - above * std::sin(r), over = level_right * std::sin(r) + above * std::cos(r);
    const double focal_px = kWidth / 2.0 / std::tan(radians(kFieldOfView_deg / 2));
    return {kWidth / 2.0 + focal_px * right / ahead, kHeight / 2.0 - focal_px * over / ahead};
}

struct Picture {
    std::vector<std::uint8_t> rgba;  ///< bottom row first
    display::FrameRecord record;

    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return rgba.data() +
               (static_cast<std::size_t>(static_cast<int>(kHeight) - 1 - y) * kWidth + static_cast<std::size_t>(x)) * 4;
    }
};

struct Files {
    test_support::TemporaryFolder folder;
    std::string log = folder.file("flight.log"), terrain = folder.file("terrain.tdb");
    std::string without = folder.write("without.toml", "protocol = \"canaerospace\"\n");
    std::string design =
        folder.write("design.toml",
                     "name = \"heard\"\n[terrain]\n[warning]\nenabled = false\n[[data.element]]\nrole = \"traffic\"\n"
                     "technique = \"billboard\"\ncolor = \"#ff00ff\"\n");

    Files() {
        std::ofstream stream(log, std::ios::binary);
        FlightLogSettings settings;
        settings.bus = test_support::traffic_bus();
        write_flight_log(Hover(), settings, stream, [](double) { return true; });
        build_terrain(test_support::posts_of(test_support::make_rough_raster(193, 193)), terrain, {});
    }
};

const Files& files() {
    static const Files kFiles;
    return kFiles;
}

/// Replays with one bus file, and draws instants of it.
class Replayed {
public:
    explicit Replayed(const std::string& bus, const std::string& device = "es3-mid")
        : session_(options(bus, device), false), player_({files().log, bus, "", "one_hot"}, session_.display()) {}

    Picture at(double second) {
        const base::Time time = Hover().begin() + base::Duration::from_seconds(second);
        const flight::FrameInput instant = player_.at(time);
        display::settle(session_.display(), {instant.state, instant.phase, time});
        session_.display().plan({instant.state, instant.phase, time, instant.trail});
        session_.draw();
        const RgbaView pixels = session_.pixels();
        return {{pixels.pixels, pixels.pixels + std::size_t{kWidth} * kHeight * 4}, session_.display().record()};
    }
    [[nodiscard]] bus::TrafficCounts counts() { return player_.facts().counters.traffic; }

private:
    static PictureOptions options(const std::string& bus, const std::string& device) {
        PictureOptions o;
        o.terrain = files().terrain;
        o.design = files().design;
        o.device = device;
        o.bus = bus;
        o.size = PictureSize{kWidth, kHeight};
        o.symbology = false;
        return o;
    }
    DisplaySession session_;
    FlightPlayer player_;
};

/// The element's colour, and what it has turned to when it is stale.
bool is_sign(const std::uint8_t* pixel) { return pixel[0] > 200 && pixel[1] < 90 && pixel[2] > 200; }
bool is_grey(const std::uint8_t* pixel) {
    return std::abs(pixel[0] - 150) < 12 && std::abs(pixel[1] - 150) < 12 && std::abs(pixel[2] - 150) < 12;
}

template <class Is>
int count_about(const Picture& picture, const Pixel& at, int reach, Is is) {
    int count = 0;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            count += is(picture.at(static_cast<int>(std::floor(at.x)) + x, static_cast<int>(std::floor(at.y)) + y)) ? 1 : 0;
    return count;
}

/// The middle of a diamond that is looked for round a place: below its upper corner, above its lower one. NaN: there is none.
/// The line that leads from it to the right is flatter than its sides.
Pixel diamond_near(const Picture& picture, const Pixel& at) {
    constexpr int kReach = 14, kMin = 5;
    int top = -1, bottom = -1, corner = 0;
    double corner_x = 0;
    for (int y = static_cast<int>(at.y) - kReach; y <= static_cast<int>(at.y) + kReach; ++y)
        for (int x = static_cast<int>(at.x) - kReach; x <= static_cast<int>(at.x) + kReach; ++x) {
            if (!is_sign(picture.at(x, y))) continue;
            top = top < 0 ? y : top;
            bottom = y;
            if (y > top) continue;
            corner_x += x + 0.5;
            ++corner;
        }
    if (bottom - top < kMin) return {std::nan(""), std::nan("")};
    return {corner_x / corner, 0.5 * (top + bottom + 1)};
}

const display::DataRecord* traffic_in(const display::FrameRecord& record) {
    for (const display::DataRecord& data : record.data)
        if (data.type.view() == "traffic") return &data;
    return nullptr;
}

TEST(ReceivedTraffic, StandsWhereItsReportsSayItIs) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        Replayed replayed("canaerospace", device);
        for (const double second : {5.9, 12.9, 18.9}) {
            const Picture picture = replayed.at(second);
            ASSERT_NE(traffic_in(picture.record), nullptr);
            EXPECT_EQ(traffic_in(picture.record)->drawn, 1u);
            const Pixel here = projected(target_at(second)), found = diamond_near(picture, here);
            EXPECT_NEAR(found.x, here.x, 1.5) << device << " " << second;
            EXPECT_NEAR(found.y, here.y, 1.5) << device << " " << second;
            const Pixel reported = projected(target_at(std::floor(second) + 0.043));
            EXPECT_GT(here.x - reported.x, 6) << "control: it is told from where the report had it";
            EXPECT_EQ(count_about(picture, projected(target_at(second - 4)), 8, is_sign), 0) << "control: nothing behind";
        }
        EXPECT_EQ(replayed.counts().reports, 20u);
        EXPECT_EQ(replayed.counts().incomplete + replayed.counts().refused + replayed.counts().repeated, 0u);
    }
}

TEST(ReceivedTraffic, GoesOnThenStandsStaleThenIsGone) {
    const double stale = kLastReport_s + 10;
    std::vector<Picture> with, without;
    for (std::vector<Picture>* const pictures : {&with, &without}) {
        Replayed replayed(pictures == &with ? "canaerospace" : files().without);  // one surface at a time
        for (const double age : {9.9, 40.0, 59.9, 60.1}) pictures->push_back(replayed.at(kLastReport_s + age));
    }
    const Pixel last = projected(target_at(stale));
    EXPECT_NEAR(diamond_near(with[0], last).x, last.x, 1.5) << "it goes on";
    EXPECT_GE(count_about(with[1], last, 8, is_grey), 20) << "there it stood last, crossed out";
    EXPECT_EQ(count_about(with[1], last, 14, is_sign), 0) << "nothing stale looks valid";
    EXPECT_NE(with[2].rgba, without[2].rgba);
    EXPECT_EQ(traffic_in(with[2].record)->drawn, 1u);
    EXPECT_EQ(with[3].rgba, without[3].rgba) << "as if it had never been";
}

TEST(ReceivedTraffic, IsAbsentWhereTheBusDoesNotCarryIt) {
    Replayed without(files().without);
    const Picture picture = without.at(12.9);
    EXPECT_EQ(traffic_in(picture.record), nullptr);
    EXPECT_EQ(count_about(picture, projected(target_at(12.9)), 12, is_sign), 0);
    EXPECT_EQ(without.counts().reports, 0u);
}

TEST(ReceivedTraffic, IsTheSameWhateverWasPlayedBefore) {
    Replayed replayed("canaerospace");
    const Picture first = replayed.at(10.4), second = replayed.at(30.2);
    EXPECT_NE(first.rgba, second.rgba);
    EXPECT_EQ(replayed.at(10.4).rgba, first.rgba);
    EXPECT_EQ(replayed.at(30.2).rgba, second.rgba);
}

}  // namespace
}  // namespace tedavis::host_sim::test_received_traffic
