#include "render_core/draw/drawers/traced_codes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "platform/threads/thread_workers.hpp"
#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/raytrace/traced_file.hpp"

namespace tedavis::draw::test_traced_codes {
namespace {

using raytrace::HitSide;
using test_support::TracedFile;

constexpr std::uint32_t kCells = 160;  // across the coast's file

const TracedFile& coast() {
    static const TracedFile file(test_support::coast_file());
    return file;
}

/// Eight pixels in a row, none of them met.
struct Row {
    std::vector<float> t = std::vector<float>(8, std::numeric_limits<float>::infinity()), u = std::vector<float>(8, 0.0f), v = u;
    std::vector<std::int32_t> cell = std::vector<std::int32_t>(8, raytrace::HitPicture::kNoCell);
    std::vector<HitSide> side = std::vector<HitSide>(8, HitSide::none);
    terrain::View view;
    CodedLight light;
    AlertZoneLook alert;

    Row() {
        view.focal_px = 10;
        view.width = 8;
        view.height = 1;
    }
    void meet(std::size_t x, std::uint32_t i, std::uint32_t j, float at_u, float at_v, float depth_m) {
        t[x] = depth_m;
        cell[x] = static_cast<std::int32_t>(j * kCells + i);
        side[x] = HitSide::above;
        u[x] = at_u;
        v[x] = at_v;
    }
    [[nodiscard]] std::vector<std::uint8_t> codes() {
        std::vector<std::uint8_t> all(32);
        base::SerialWorkers workers;
        write_codes({coast().ground, {t, cell, side, u, v}, view, {400, 1200}, light, &alert}, workers, all);
        return all;
    }
};

double height_of(const std::uint8_t* code) { return 400 + 800 * (code[0] + code[1] / 255.0) / 254; }

TEST(TracedCodes, HeightsAreThoseOfTheTriangleThatWasMet) {
    Row row;
    const auto post = [](std::uint32_t i, std::uint32_t j) { return double{coast().ground.heights().at(i, j)}; };
    row.meet(1, 70, 30, 0.25f, 0.5f, 1000);  // upper
    row.meet(2, 70, 30, 0.75f, 0.5f, 1000);  // lower
    row.meet(3, 70, 30, 0.5f, 0.5f, 1000);   // where they meet
    const std::vector<std::uint8_t> codes = row.codes();
    EXPECT_NEAR(height_of(&codes[4]), 0.25 * post(70, 30) + 0.25 * post(71, 30) + 0.5 * post(70, 31), 0.02);
    EXPECT_NEAR(height_of(&codes[8]), 0.5 * post(71, 30) + 0.25 * post(70, 31) + 0.25 * post(71, 31), 0.02);
    EXPECT_NEAR(height_of(&codes[12]), 0.5 * post(71, 30) + 0.5 * post(70, 31), 0.02);
    for (const std::size_t sky : {0u, 4u, 7u})
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(codes[4 * sky + c], kNothingCode);
    EXPECT_EQ(codes[4 + 2], 255) << "fully lit without lights";
}

TEST(TracedCodes, DistancesAreCodedAsShadersCodeThem) {
    Row row;
    const float depths[] = {0.5f, 30, 100, 1234, 9876, 54321, 200000, 4e6f};
    for (std::size_t x = 0; x < 8; ++x) row.meet(x, 70, 30, 0.2f, 0.2f, depths[x]);
    const std::vector<std::uint8_t> codes = row.codes();
    for (std::size_t x = 0; x < 8; ++x) {
        const double distance_m = depths[x] * std::hypot(1.0, (static_cast<double>(x) + 0.5 - 4) / 10);
        const double code = 255 * std::log2(1 + distance_m / kDistanceCodeStart_m) / kDistanceCodeOctaves;
        EXPECT_NEAR(codes[4 * x + 3], std::fmin(code, 254), 0.55) << depths[x];
    }
}

TEST(TracedCodes, LightIsThatOfTheCornersEachLightByItsWeight) {
    design::ShadeSettings shade;
    shade.technique = design::TerrainShade::lights;
    shade.light_count = 2;
    shade.lights[1].weight = 3;
    shade.ambient = 0.2;
    const PostLook& look = coast().ground.looks()[30 * 161 + 70];
    const glm::dvec3 normal(look.normal[0] / 127.0, look.normal[1] / 127.0, look.normal[2] / 127.0);
    const glm::dvec3 towards[2] = {glm::normalize(normal), -normal};
    Row row;
    row.light = coded_light(shade, towards);
    row.meet(0, 70, 30, 0, 0, 100);
    EXPECT_NEAR(row.codes()[2], 255 * (0.2 + 0.8 * 0.25 * glm::length(normal)), 1.01) << "the second one shines from below";
    shade.technique = design::TerrainShade::lambert;
    row.light = coded_light(shade, towards);
    EXPECT_NEAR(row.codes()[2], 255 * (0.2 + 0.8 * std::fmin(glm::length(normal), 1)), 1.01);
    shade.technique = design::TerrainShade::none;
    EXPECT_EQ(coded_light(shade, towards).count, 0u);
}

TEST(TracedCodes, SeaIsWhereMostOfTheCellNearItIsAndUnknownWhateverTouchesAVoid) {
    Row row;
    row.meet(0, 20, 30, 0.5f, 0.5f, 100);   // sea
    row.meet(1, 39, 30, 0.4f, 0.3f, 100);   // nearer to the sea's last post
    row.meet(2, 39, 30, 0.6f, 0.3f, 100);   // nearer to the land's first
    row.meet(3, 140, 90, 0.5f, 0.4f, 100);  // void
    row.meet(4, 120, 90, 0.1f, 0.1f, 100);  // a corner is
    row.meet(5, 119, 90, 0.9f, 0.9f, 100);  // none is
    const std::vector<std::uint8_t> codes = row.codes();
    const auto is_sea = [&](std::size_t x) { return codes[4 * x] == 254 && codes[4 * x + 1] == 0; };
    EXPECT_TRUE(is_sea(0) && is_sea(1));
    EXPECT_FALSE(is_sea(2) || is_sea(3) || is_sea(5));
    EXPECT_EQ(codes[4 * 3 + 2], 0);
    EXPECT_EQ(codes[4 * 4 + 2], 0);
    EXPECT_GT(codes[4 * 2 + 2], 0);
    EXPECT_GT(codes[4 * 5 + 2], 0);
}

/// A circle of 50 m round a place that one pixel looks at 1000 m away.
TEST(TracedCodes, GroundInAnAlertsZoneIsMarked) {
    const double height_m = double{coast().ground.heights().at(70, 30)};
    policy::TerrainAlertZone zone;
    zone.alert = policy::TerrainAhead::caution;
    zone.from = {0.82, 0.17, {900}};
    zone.radius_m = 50;
    zone.until_s = 60;
    zone.floor_msl_m = height_m - 1;
    Row row;
    const glm::dmat3 axes = earth::north_east_down(zone.from.latitude_rad, zone.from.longitude_rad);
    row.view.forward = axes[0];
    row.view.right = axes[1];
    row.view.down = axes[2];
    // The middle of pixel 5 is 1.5 pixels to the right of that of the picture: 150 m at 1000 m.
    row.view.eye = earth::to_ecef(zone.from) - 1000.0 * axes[0] - 150.0 * axes[1];
    row.meet(5, 70, 30, 0, 0, 1000);
    row.meet(4, 70, 30, 0, 0, 1000);
    const auto marks = [&](const policy::TerrainAlertZone& of) {
        row.alert = alert_zone_look(of);
        const std::vector<std::uint8_t> codes = row.codes();
        EXPECT_EQ(codes[4 * 7], kNothingCode);
        const int step = codes[21] / 3;
        EXPECT_NEAR(400 + 800 * (codes[20] + (step + 0.5) / 85) / 254, height_m, 0.05);
        return std::vector<int>{codes[4 * 4 + 1] % 3, codes[4 * 5 + 1] % 3};
    };
    EXPECT_EQ(marks(zone), (std::vector<int>{0, 2})) << "100 m aside and there";
    zone.floor_msl_m = height_m + 1;
    EXPECT_EQ(marks(zone), (std::vector<int>{0, 0})) << "low enough";
    zone.floor_msl_m = height_m - 1;
    zone.radius_m = 150;
    EXPECT_EQ(marks(zone), (std::vector<int>{2, 2}));
}

}  // namespace
}  // namespace tedavis::draw::test_traced_codes
