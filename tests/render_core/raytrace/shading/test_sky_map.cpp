#include "render_core/raytrace/shading/sky_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/shading/arc_functions.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_sky_map {
namespace {

using test_support::Dice;
using test_support::HeldHeights;

template <class Height>
struct BuiltSky {
    std::vector<unsigned char> memory;
    base::Arena arena;
    SkyMap<Height> map;
    BuiltSky(const HeightGrid<Height>& grid, const SkyMapSettings& settings, base::Workers& workers)
        : memory(SkyMap<Height>::bytes_needed(grid.columns, grid.rows, settings.has_apertures)),
          arena(memory.data(), memory.size()) {
        EXPECT_TRUE(map.start(grid, settings, arena));
        map.build(workers);
    }
};

TEST(SkyMap, FlatGroundSeesAllOfTheSkyExactly) {
    for (const std::uint32_t azimuths : {4u, 7u, 16u, 128u}) {
        const HeldHeights<std::int16_t> heights(20, 13, 4321);
        SkyMapSettings settings;
        settings.azimuths = azimuths;
        settings.has_apertures = true;
        base::SerialWorkers alone;
        const BuiltSky<std::int16_t> sky(heights.grid(), settings, alone);
        for (const double x : {0.0, 3.3, 19.0}) {
            EXPECT_EQ(sky_seen_at(heights.grid(), settings, static_cast<std::uint32_t>(x), 12).view, 1);
            EXPECT_EQ(sky.map.view_at(x, 12), 1);
            EXPECT_EQ(sky.map.aperture_at(x, 5, {}).axis, glm::dvec3(0, 0, 1));
            EXPECT_EQ(sky.map.aperture_at(x, 5, {}).cos_radius, 0);
        }
    }
}

TEST(SkyMap, ATiltedPlaneSeesWhatItsTiltLeaves) {
    for (const double slope : {0.1, 0.5, 1.0, 1.7320508}) {
        const auto heights =
            HeldHeights<float>(129, 129).fill([&](double x, double y) { return 1000 + 30 * slope * (0.6 * x + 0.8 * y); });
        SkyMapSettings settings;
        settings.scale = {30, 30, 1};
        settings.azimuths = 64;
        EXPECT_NEAR(sky_seen_at(heights.grid(), settings, 64, 64).view, (1 + std::cos(std::atan(slope))) / 2, 2e-3) << slope;
    }
}

TEST(SkyMap, BesideALongWall) {
    for (const double wall : {20.0, 120.0, 1000.0}) {
        const auto heights = HeldHeights<float>(80, 801).fill([&](int x, int) { return x >= 44 ? wall : 0; });
        SkyMapSettings settings;
        settings.scale = {30, 30, 1};
        settings.azimuths = 128;
        settings.radius = 400;
        const double angle = std::atan(wall / (4 * 30));
        const SkySeen seen = sky_seen_at(heights.grid(), settings, 40, 400);
        EXPECT_NEAR(seen.view, (1 + std::cos(angle)) / 2, 3e-3) << wall;
        EXPECT_LT(seen.aperture.axis.x, 0) << "away from the wall";
        EXPECT_NEAR(seen.aperture.axis.y, 0, 1e-9);
    }
}

TEST(SkyMap, OnCliffsAndInPitsItIsANumber) {
    HeldHeights<std::int16_t> heights(9, 9, 30000);
    heights.at(4, 4) = -30000;
    SkyMapSettings settings;
    settings.scale = {1e-3, 1e-3, 1};
    const SkySeen pit = sky_seen_at(heights.grid(), settings, 4, 4);
    EXPECT_GE(pit.view, 0);
    EXPECT_LT(pit.view, 1e-6);
    EXPECT_GT(pit.aperture.cos_radius, 0.999);
    const SkySeen cliff = sky_seen_at(heights.grid(), settings, 3, 4);
    EXPECT_TRUE(cliff.view >= 0 && cliff.view <= 1);
}

TEST(SkyMap, TheApertureIsTheMeanOfTheSkySeen) {
    // By random directions above the same horizon.
    const auto heights = test_support::hilly_heights<std::int16_t>(64, 64, 3, 900);
    SkyMapSettings settings;
    settings.scale = {30, 30, 1};
    settings.azimuths = 128;
    SkyMapSettings near = settings;
    near.azimuths = 4;
    near.radius = 4;
    double worst = 0, naive = 0;
    Dice dice(4);
    for (const auto& [column, row] : {std::pair(20u, 30u), std::pair(40u, 11u), std::pair(33u, 50u)}) {
        const SkySeen seen = sky_seen_at(heights.grid(), settings, column, row);
        double horizon[128];
        for (int n = 0; n < 128; ++n)
            horizon[n] = horizon_slope(heights.grid(), settings.scale, column, row, direction_of_angle(2 * kArcPi * n / 128),
                                       settings.radius);
        const double dzdx = (heights.grid().at(column + 1, row) - heights.grid().at(column - 1, row)) / 60.0;
        const double dzdy = (heights.grid().at(column, row + 1) - heights.grid().at(column, row - 1)) / 60.0;
        const glm::dvec3 normal = normal_of({0, dzdx, dzdy}, {});
        glm::dvec3 mean(0);
        double light = 0;
        int open = 0;
        constexpr int kRays = 400000;
        for (int k = 0; k < kRays; ++k) {
            const double z = dice.unit(), turn = dice.unit() * 128, flat = std::sqrt(1 - z * z);
            const int n = static_cast<int>(turn + 0.5) % 128;
            const glm::dvec3 ray(flat * std::cos(turn * 2 * kArcPi / 128), flat * std::sin(turn * 2 * kArcPi / 128), z);
            const double facing = glm::dot(ray, normal);
            if (z <= horizon[n] * flat || facing <= 0) continue;
            mean += ray;
            light += facing;
            ++open;
        }
        EXPECT_NEAR(seen.view, 2 * light / kRays, 6e-3);
        worst = std::max(worst, std::abs(seen.view - 2 * light / kRays));
        naive = std::max(naive, std::abs(sky_seen_at(heights.grid(), near, column, row).view - 2 * light / kRays));
        EXPECT_NEAR(seen.aperture.cos_radius, 1 - open / double{kRays}, 6e-3);
        EXPECT_LT(glm::length(seen.aperture.axis - glm::normalize(mean)), 1e-2);
    }
    EXPECT_GT(naive, 6e-3) << "control: four azimuths, as far as four posts";
    test_support::record_worst("A28", worst);
    test_support::record_control("A28", naive);
}

TEST(SkyMap, MoreAzimuthsAndALongerRadiusComeCloser) {
    const auto heights = test_support::hilly_heights<std::int16_t>(96, 96, 6, 900);
    const auto rms = [&](std::uint32_t azimuths, std::uint32_t radius, double& bias) {
        SkyMapSettings exact, near;
        exact.scale = near.scale = {30, 30, 1};
        exact.azimuths = 128;
        near.azimuths = azimuths;
        near.radius = radius;
        double sum = 0;
        int posts = 0;
        bias = 0;
        for (std::uint32_t row = 4; row < 96; row += 6)
            for (std::uint32_t column = 5; column < 96; column += 6, ++posts) {
                const double off =
                    sky_seen_at(heights.grid(), near, column, row).view - sky_seen_at(heights.grid(), exact, column, row).view;
                sum += off * off;
                bias += off;
            }
        bias /= posts;
        return std::sqrt(sum / posts);
    };
    double bias = 0;
    const double four = rms(4, 64, bias), eight = rms(8, 64, bias), sixteen = rms(16, 64, bias);
    EXPECT_LT(eight, four / 1.5);
    EXPECT_LT(sixteen, eight / 1.5);
    const double short_radius = rms(128, 8, bias);
    EXPECT_GT(bias, 0) << "a short radius is too light";
    EXPECT_GT(short_radius, sixteen) << "the radius decides";
}

TEST(SkyMap, AnyNumberOfWorkersMakesTheSame) {
    const auto heights = test_support::hilly_heights<std::int16_t>(50, 41, 7, 500);
    SkyMapSettings settings;
    settings.has_apertures = true;
    base::SerialWorkers alone;
    const BuiltSky<std::int16_t> one(heights.grid(), settings, alone);
    platform::ThreadWorkersSettings threads;
    threads.concurrency = 3;
    auto workers = platform::make_thread_workers(threads);
    const BuiltSky<std::int16_t> three(heights.grid(), settings, *workers.value());
    EXPECT_EQ(one.memory, three.memory);
}

TEST(SkyMap, VoidsHideNothing) {
    HeldHeights<float> flat(20, 20, 100.f);
    flat.at(10, 8) = HeightGrid<float>::kVoid;
    EXPECT_EQ(sky_seen_at(flat.grid(), {}, 10, 10).view, 1);
    EXPECT_EQ(sky_seen_at(flat.grid(), {}, 10, 7).view, 1) << "nor do they tilt their neighbours";
}

}  // namespace
}  // namespace tedavis::raytrace::test_sky_map
