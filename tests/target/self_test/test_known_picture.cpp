#include "target/self_test/known_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "platform/files/memory_byte_source.hpp"
#include "platform/surface_factory.hpp"
#include "render_core/base/ports/async_reader.hpp"
#include "render_core/base/units.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/gl/readback.hpp"
#include "target/self_test.hpp"
#include "target/self_test/known_flight.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::target::test_known_picture {
namespace {

using ::testing::HasSubstr;
using Pixels = std::vector<std::uint8_t>;

constexpr std::uint32_t kWidth = kKnownPictureWidth, kHeight = kKnownPictureHeight;

/// The picture of the embedded flight, drawn as the self-test draws it.
Pixels drawn() {
    display::DisplaySettings settings;
    settings.device = test_support::shipped_device("es2-small");
    settings.design = test_support::shipped_design("default");
    settings.width_px = kWidth;
    settings.height_px = kHeight;
    auto surface = std::move(platform::make_surface("egl", {kWidth, kHeight, platform::ContextLane::es2}).value());
    EXPECT_TRUE(surface->make_current());
    std::vector<std::uint8_t> memory(display::DisplayMemory::bytes_needed(settings.device.budget));
    platform::MemoryByteSource terrain(embedded_inputs().terrain);
    base::SynchronousReader reader(terrain, base::kMaxReadTickets);
    Pixels pixels(std::size_t{4} * kWidth * kHeight);
    {
        display::Display display;
        EXPECT_EQ(
            display.start(settings, {memory.data(), memory.size()}, *surface, {&terrain, &reader, terrain::ArrivalMode::exact})
                .message.view(),
            "");
        const KnownFlight flight = play_known_flight(embedded_inputs().log, bus::BusSettings(), display.planner());
        display::settle(display, {flight.aircraft, flight.phase, flight.now});
        display.plan({flight.aircraft, flight.phase, flight.now});
        display.draw(*surface);
        EXPECT_TRUE(gl::read_pixels(display.gl(), kWidth, kHeight, pixels));
        display.stop();
    }
    surface->release_current();
    return pixels;
}

std::string failures(const Pixels& pixels) {
    SelfTestReport report;
    check_known_picture(pixels, report);
    std::string names;
    for (const SelfCheck& check : report.checks())
        if (!check.holds) names += std::string(check.name.view()) + " ";
    return names;
}

std::uint8_t* row(Pixels& pixels, std::uint32_t y) { return pixels.data() + std::size_t{4} * kWidth * y; }

TEST(KnownPicture, HoldsForThePictureOfTheFlight) { EXPECT_EQ(failures(drawn()), ""); }

TEST(KnownPicture, EveryBrokenFrameIsSeen) {
    const Pixels good = drawn();
    Pixels black(good.size(), 0), upside_down(good), swapped(good), shifted(good), noise(good), half(good);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        std::copy_n(&good[std::size_t{4} * kWidth * (kHeight - 1 - y)], 4 * kWidth, row(upside_down, y));
    for (std::size_t n = 0; n < swapped.size(); n += 4) std::swap(swapped[n], swapped[n + 2]);
    for (std::uint32_t y = 4; y < kHeight; ++y)
        std::copy_n(&good[std::size_t{4} * kWidth * (y - 4)], 4 * kWidth, row(shifted, y));
    for (std::size_t n = 0; n < noise.size(); ++n) noise[n] = static_cast<std::uint8_t>(n * 2654435761u >> 13);
    std::fill_n(half.begin(), half.size() / 2, std::uint8_t{0});
    for (const Pixels* broken : {&black, &upside_down, &swapped, &noise, &half}) EXPECT_NE(failures(*broken), "");
    EXPECT_THAT(failures(shifted), HasSubstr("skyline")) << "four rows too high";
    EXPECT_THAT(failures(black), HasSubstr("picture_colors"));
    EXPECT_THAT(failures(half), HasSubstr("terrain_near_left"));
    EXPECT_THAT(failures(swapped), HasSubstr("sky_low"));
}

TEST(KnownPicture, AMissingTextIsSeenByItself) {
    struct Text {
        const char* check;
        std::uint32_t left, top, right, bottom;
    };
    for (const Text& text : {Text{"text_phase ", 8, 8, 222, 27}, Text{"text_altitude ", 466, 221, 564, 249},
                             Text{"text_advisory ", 240, 456, 400, 474}, Text{"attitude_reference ", 240, 230, 400, 248}}) {
        Pixels pixels = drawn();
        for (std::uint32_t y = text.top; y < text.bottom; ++y)
            std::fill_n(row(pixels, kHeight - 1 - y) + 4 * text.left, 4 * (text.right - text.left), std::uint8_t{0});
        EXPECT_EQ(failures(pixels), text.check);
    }
}

// The skyline cast anew: every point of a fine grid over the terrain, projected by formulas of this test's own (geodesy of
// WGS84, rotations of heading, pitch and roll), so that the highest one in each column is where the terrain begins.
class SkylineOracle {
public:
    SkylineOracle() : memory_(1 << 22), bytes_(embedded_inputs().terrain), arena_(memory_.data(), memory_.size()) {
        database_ = terrain::TerrainDatabase::open(bytes_, arena_).value();
        EXPECT_TRUE(heights_.start(database_, arena_));
        rows_.assign(kWidth, 1e9);
        eye_ = ecef(kLatitude, kLongitude, kEllipsoidHeight_m);
    }
    std::vector<double> rows() {
        constexpr int kSteps = 64 * 24;  // 24 points a cell
        const double step = 64.0 / 1200 / kSteps;
        for (int j = 0; j <= kSteps; ++j)
            for (int i = 0; i <= kSteps; ++i) project(36.625 - j * step * 0.9999999, -84.2025 + 1e-9 + i * step * 0.9999999);
        return rows_;
    }

private:
    struct Vector {
        double x, y, z;
    };
    static constexpr double kLatitude = 36.576585818, kLongitude = -84.189623420, kEllipsoidHeight_m = 589.253;
    static constexpr double kHeading = 20.295503616, kPitch = 1.550300598, kRoll = -0.122181125;

    static Vector ecef(double latitude_deg, double longitude_deg, double height) {
        const double p = latitude_deg * M_PI / 180, l = longitude_deg * M_PI / 180, e2 = 6.69437999014131699614e-3;
        const double n = 6378137 / std::sqrt(1 - e2 * std::sin(p) * std::sin(p));
        return {(n + height) * std::cos(p) * std::cos(l), (n + height) * std::cos(p) * std::sin(l),
                (n * (1 - e2) + height) * std::sin(p)};
    }
    void project(double latitude_deg, double longitude_deg) {
        const terrain::HeightAnswer ground = heights_.at(base::radians(latitude_deg), base::radians(longitude_deg));
        if (ground.status != terrain::HeightStatus::land) return;
        const Vector point = ecef(latitude_deg, longitude_deg, ground.height.m + ground.undulation.m);
        const Vector d{point.x - eye_.x, point.y - eye_.y, point.z - eye_.z};
        const double p = kLatitude * M_PI / 180, l = kLongitude * M_PI / 180;
        const double east = -std::sin(l) * d.x + std::cos(l) * d.y;
        const double north = -std::sin(p) * std::cos(l) * d.x - std::sin(p) * std::sin(l) * d.y + std::cos(p) * d.z;
        const double up = std::cos(p) * std::cos(l) * d.x + std::cos(p) * std::sin(l) * d.y + std::sin(p) * d.z;
        const double h = kHeading * M_PI / 180, t = kPitch * M_PI / 180, r = kRoll * M_PI / 180;
        const double ahead = north * std::cos(h) + east * std::sin(h), aside = east * std::cos(h) - north * std::sin(h);
        const double forward = ahead * std::cos(t) + up * std::sin(t), above = up * std::cos(t) - ahead * std::sin(t);
        if (forward < 50) return;
        const double right = aside * std::cos(r) - above * std::sin(r), top = above * std::cos(r) + aside * std::sin(r);
        const double focal = kWidth / 2.0 / std::tan(30 * M_PI / 180);
        const double x = kWidth / 2.0 + focal * right / forward, y = kHeight / 2.0 - focal * top / forward;
        if (x < 0 || x >= kWidth) return;
        double& highest = rows_[static_cast<std::size_t>(x)];
        highest = std::fmin(highest, y);
    }

    std::vector<std::uint8_t> memory_;
    platform::MemoryByteSource bytes_;
    base::Arena arena_;
    terrain::TerrainDatabase database_;
    terrain::HeightQuery heights_;
    std::vector<double> rows_;
    Vector eye_{};
};

TEST(KnownPicture, ItsSkylineIsTheOneThatIsCastFromThePosts) {
    const std::vector<double> rows = SkylineOracle().rows();
    const std::pair<std::size_t, double> known[] = {{180, 285}, {210, 284}, {240, 283}, {280, 282},
                                                    {380, 281}, {420, 279}, {440, 280}};
    for (const auto& [x, y] : known) EXPECT_NEAR(rows[x], y, 1.5) << "column " << x;
}

}  // namespace
}  // namespace tedavis::target::test_known_picture
