#include "host_sim/accuracy/ground_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host_sim/replay/posed_frame.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_ground_errors {
namespace {

constexpr AircraftPose kPose{47.03, 9.68, 2500, 40, -6, 12};
constexpr std::uint32_t kCell_px = 16;

/// A frame over a terrain, and its ground.
struct Frame {
    base::SerialWorkers workers;
    TracedGround ground;
    DisplaySession session;
    FrameResult result;

    Frame(const PictureOptions& options, const AircraftPose& pose)
        : ground(options.terrain, workers), session(options, false), result(posed_frame(session, pose, {})) {}
    [[nodiscard]] GroundErrors errors() { return ground_errors(ground, session.display(), kCell_px); }
};

PictureOptions options_over(const test_support::FlownFiles& files, double tau_px) {
    PictureOptions options = files.options("unused").picture;
    options.tau_px = tau_px;
    return options;
}

/// The mean place of the measured cells on the colors' scale, 0..1.
double mean_share(const GroundErrors& errors, double full_px) {
    double sum = 0, count = 0;
    for (const double px : errors.px)
        if (!std::isnan(px)) {
            sum += std::min(px / full_px, 1.0);
            ++count;
        }
    return sum / count;
}

/// Terrain of one height everywhere.
PictureOptions flat_options(const test_support::FlownFiles& files, double tau_px) {
    PictureOptions options = options_over(files, tau_px);
    options.terrain = files.folder.file("flat.tdb");
    const Raster flat = test_support::make_raster(193, 193, [](std::uint32_t, std::uint32_t) { return 700.0f; });
    build_terrain(test_support::posts_of(flat), options.terrain, {});
    return options;
}

TEST(GroundErrors, FlatTerrainHasNone) {
    constexpr double kTau_px = 0.01, kReference_px = 2e-3;
    const test_support::FlownFiles files;
    Frame frame(flat_options(files, kTau_px), kPose);
    const GroundErrors errors = frame.errors();
    EXPECT_GT(errors.summary().places, 50u);
    EXPECT_LE(errors.summary().max_px, kTau_px + kReference_px);
    RgbaPicture picture = upright(frame.session.pixels());
    const RgbaPicture before = picture;
    draw_ground_errors(picture, errors, 100, ErrorMapStyle::dots);
    const std::array<std::uint8_t, 3> none = error_color(0, 100);
    std::size_t changed = 0;
    for (std::size_t n = 0; n < picture.pixels.size(); n += 4)
        if (!std::equal(&picture.pixels[n], &picture.pixels[n] + 3, &before.pixels[n])) {
            ++changed;
            ASSERT_TRUE(std::equal(none.begin(), none.end(), &picture.pixels[n])) << "dark blue alone";
        }
    EXPECT_GT(changed, 50 * kCell_px);
}

/// Its few large triangles lie below the curved Earth: the error is the sag of a chord, at most that over the whole terrain.
TEST(GroundErrors, CoarseFlatTerrainSagsBelowTheEarth) {
    constexpr double kRadius_m = 6.36e6, kAcross_m = 22e3, kSag_m = kAcross_m * kAcross_m / 8 / kRadius_m;
    const test_support::FlownFiles files;
    Frame frame(flat_options(files, 16), kPose);
    const double above_m = kPose.altitude_msl_m - 700 - kSag_m;
    const double most_px = frame.session.display().planned().picture.camera.view.focal_px * kSag_m / above_m;
    const MeasuredError error = frame.errors().summary();
    EXPECT_LE(error.max_px, most_px);
    EXPECT_LE(error.max_px, frame.result.record.terrain.worst_error_px);
    EXPECT_GT(error.max_px, 0.02) << "control: it is found";
}

TEST(GroundErrors, StayBelowTheProvenBoundAndShowAForgedTau) {
    const test_support::FlownFiles files;
    double honest = 0;
    {
        Frame fine(options_over(files, 1), kPose);
        const GroundErrors errors = fine.errors();
        EXPECT_LE(errors.summary().max_px, fine.result.record.terrain.worst_error_px);
        EXPECT_LE(errors.summary().mean_px, errors.summary().max_px);
        honest = mean_share(errors, 1);
    }
    Frame coarse(options_over(files, 32), kPose);
    const GroundErrors forged = coarse.errors();
    EXPECT_LE(forged.summary().max_px, coarse.result.record.terrain.worst_error_px);
    EXPECT_GT(forged.summary().max_px, 1) << "it breaks the bound that it claims";
    EXPECT_GT(mean_share(forged, 1), 0.5) << "drawn with 32 px on the scale of 1 px";
    EXPECT_LT(honest, 0.5) << "control: drawn with the 1 px that it claims";
}

TEST(GroundErrors, SkyAndAPoseFarAwayHaveNone) {
    const test_support::FlownFiles files;
    AircraftPose up = kPose, away = kPose;
    up.pitch_deg = 80;
    away.latitude_deg = -40;
    for (const AircraftPose& pose : {up, away}) {
        Frame frame(options_over(files, 4), pose);
        EXPECT_EQ(frame.errors().summary().places, 0u);
        EXPECT_EQ(frame.errors().summary().max_px, 0);
    }
}

TEST(GroundErrors, TheCellsCoverThePictureAroundItsMiddle) {
    GroundErrors grid;
    grid.picture = {100, 64};
    grid.cell_px = 16;
    grid.across = 7;
    grid.down = 4;
    EXPECT_EQ(grid.left(0), -6);
    EXPECT_EQ(grid.left(6), 90);
    EXPECT_EQ(grid.top(0), 0);
    grid.px.assign(28, 5);
    grid.px[0] = std::nan("");
    RgbaPicture picture{100, 64, std::vector<std::uint8_t>(std::size_t{100} * 64 * 4, 100)};
    draw_ground_errors(picture, grid, 5, ErrorMapStyle::half);
    const std::array<std::uint8_t, 3> full = error_color(5, 5);
    const auto byte = [&](std::size_t x, std::size_t y) { return picture.pixels[(y * 100 + x) * 4]; };
    EXPECT_EQ(byte(9, 15), 100) << "the cell that was not measured";
    EXPECT_EQ(byte(10, 15), (100 + full[0] + 1) / 2);
    EXPECT_EQ(byte(9, 16), (100 + full[0] + 1) / 2);
    EXPECT_EQ(byte(99, 63), (100 + full[0] + 1) / 2);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ground_errors
