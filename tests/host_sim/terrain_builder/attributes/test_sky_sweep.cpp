#include "host_sim/terrain_builder/attributes/sky_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/terrain/attribute_terrain.hpp"
#include "tests/support/terrain/fractal_square.hpp"

namespace tedavis::host_sim::test_sky_sweep {
namespace {

using terrain::kHorizonDirections;
using terrain::PostClass;
using test_support::HeightSquare;
using test_support::make_tile;
using test_support::post_of;
using test_support::view_of;

constexpr double kPi = base::kPi;

/// A tile swept at one post, under a light that falls on every post alike unless told otherwise.
class OneTile {
public:
    explicit OneTile(const AttributeTile& tile, const FarView& above = {}) : planes(tile), gradients(planes), above_(above) {
        direct.fill(std::vector<float>(planes.validity.size(), 1.0f));
    }
    [[nodiscard]] SkyLanes at(int column, int row, float level_light = 1) const {
        SkySweep sweep(planes, gradients, direct, level_light, above_);
        sweep.begin_row(row);
        SkyLanes sky;
        sweep.sweep(column, sky);
        return sky;
    }

    const HeightPlanes planes;
    const Gradients gradients;
    HalfPlanes direct;

private:
    const FarView above_;
};

TEST(SkySweep, LevelGroundSeesTheWholeSky) {
    const AttributeTile tile = make_tile(8, 5, 21.3, 30.9, [](int, int) { return 1234.5; });
    const SkyLanes sky = OneTile(tile).at(3, 2);
    for (int n = 0; n < kLanes; ++n) {
        EXPECT_EQ(sky.sky_view[n], 1);
        EXPECT_EQ(sky.aperture_east[n], 0);
        EXPECT_EQ(sky.aperture_north[n], 0);
        EXPECT_EQ(sky.aperture_cosine[n], 0);
        EXPECT_EQ(sky.bounce[n], 0);
        EXPECT_EQ(sky.openness_above[n], static_cast<float>(kPi / 2));
        EXPECT_EQ(sky.openness_below[n], static_cast<float>(kPi / 2));
        for (const Lanes& horizon : sky.horizon) EXPECT_EQ(horizon[n], 0);
    }
}

// An open plane of slope s has (1 + cos s)/2 of the sky; what it does not see of the sky it sees of the ground.
TEST(SkySweep, ATiltedPlaneLosesWhatItsDefinitionSays) {
    for (const double slope_deg : {5.0, 20.0, 45.0, 70.0}) {
        for (const double azimuth_deg : {0.0, 30.0, 45.0, 200.0}) {
            const double rise = std::tan(base::radians(slope_deg)), east = rise * std::sin(base::radians(azimuth_deg)),
                         north = rise * std::cos(base::radians(azimuth_deg));
            const AttributeTile tile = make_tile(1, 1, 30, 30, [&](int i, int j) { return 30 * (i * east - j * north); });
            const SkyLanes sky = OneTile(tile).at(0, 0);
            EXPECT_NEAR(sky.sky_view[0], (1 + std::cos(base::radians(slope_deg))) / 2, 0.004) << slope_deg;
            EXPECT_NEAR(sky.openness_above[0], kPi / 2, 1e-3) << "openness does not know slopes";
            EXPECT_NEAR(sky.openness_below[0], kPi / 2, 1e-3);
            const double away = sky.aperture_east[0] * std::sin(base::radians(azimuth_deg)) +
                                sky.aperture_north[0] * std::cos(base::radians(azimuth_deg));
            EXPECT_LT(away, 0) << "the sky lies downhill";
        }
    }
}

// Oracle: the horizon of an infinite wall of height h at distance d is atan(h sin(azimuth)/d).
TEST(SkySweep, AnInfiniteWallHasItsAnalyticHorizonAndSky) {
    constexpr double kHeight_m = 160, kCell_m = 20;
    constexpr int kWall = 8;
    const AttributeTile tile = make_tile(1, 1, kCell_m, kCell_m, [](int i, int) { return i >= kWall ? kHeight_m : 0.0; });
    OneTile ground(tile);
    for (int row = -kAttributeApron; row < kAttributeApron; ++row)  // the light falls on the wall only
        for (int column = -kHorizonReach; column < kWall; ++column)
            for (auto& plane : ground.direct) plane[ground.planes.at(column, row)] = 0;
    const SkyLanes sky = ground.at(0, 0, 0);
    double closed = 0;
    for (int k = 0; k < kHorizonDirections; ++k) {
        const double sine = std::sin(terrain::horizon_azimuth_rad(k, kCell_m, kCell_m));
        const double tangent =
            k == 1 || k == 7 ? kHeight_m / (kWall * kCell_m) * sine : kHeight_m * std::max(0.0, sine) / (kWall * kCell_m);
        EXPECT_NEAR(sky.horizon[k][0], tangent > 1e-9 ? tangent : 0, 1e-4) << k;
        closed += std::pow(std::sin(std::atan(tangent)), 2) / 16;
    }
    // Lambert's sky view behind an infinite wall whose edge stands at 45 degrees: (1 + cos 45)/2.
    EXPECT_NEAR(sky.sky_view[0], (1 + std::cos(kPi / 4)) / 2, 0.004);
    EXPECT_NEAR(sky.sky_view[0], 1 - closed, 0.01);
    EXPECT_NEAR(sky.bounce[0], 1 - sky.sky_view[0], 1e-5) << "all that is not sky is the lit wall";
    EXPECT_LT(sky.aperture_east[0], -0.1);
    EXPECT_NEAR(sky.aperture_north[0], 0, 1e-6);
}

// Where all ground is lit alike, sky and ground fill the hemisphere.
TEST(SkySweep, SkyAndGroundFillTheHemisphere) {
    const test_support::FractalSquare fractal = test_support::fractal_square(129, 3);
    const AttributeTile tile = make_tile(32, 32, 8, 8, [&](int i, int j) {
        return fractal.at(static_cast<std::uint32_t>(i + 40), static_cast<std::uint32_t>(j + 40));
    });
    const OneTile ground(tile);
    double least = 1;
    for (int row = 0; row < 32; ++row) {
        for (int column = 0; column < 32; column += kLanes) {
            const SkyLanes sky = ground.at(column, row);
            for (int n = 0; n < kLanes; ++n) {
                EXPECT_NEAR(sky.sky_view[n] + sky.bounce[n], 1, 0.01);
                least = std::min(least, static_cast<double>(sky.sky_view[n]));
            }
        }
    }
    EXPECT_LT(least, 0.8) << "or there was nothing to see";
}

TEST(SkySweep, APitOfOnePostAndAPinnacleAreFinite) {
    for (const double depth_m : {5.0, 500.0, 9000.0}) {
        AttributeTile tile = make_tile(5, 5, 1, 1, [](int, int) { return 9000.0; });
        tile.height_m[post_of(tile, 2, 2)] -= static_cast<float>(depth_m);
        const SkyLanes pit = OneTile(tile).at(2, 2);
        EXPECT_GE(pit.sky_view[0], 0);
        EXPECT_LT(pit.sky_view[0], 0.06) << "5 m deep and 1 m wide";
        EXPECT_NEAR(pit.aperture_cosine[0], 1, 0.03);
        EXPECT_NEAR(pit.openness_above[0], 0, 0.25);
        EXPECT_GT(pit.openness_below[0], kPi / 2);
        EXPECT_NEAR(std::hypot(pit.aperture_east[0], pit.aperture_north[0]), 0, 1e-5);
        tile.height_m[post_of(tile, 2, 2)] = static_cast<float>(9000 + depth_m);
        const SkyLanes pinnacle = OneTile(tile).at(2, 2);
        EXPECT_EQ(pinnacle.sky_view[0], 1);
        EXPECT_GT(pinnacle.openness_above[0], kPi / 2);
        EXPECT_LT(pinnacle.openness_below[0], kPi / 2 - 0.2);
    }
}

TEST(SkySweep, APostAloneInTheVoidIsOpen) {
    AttributeTile tile = make_tile(5, 5, 20, 20, [](int, int) { return 700.0; });
    tile.post_class.assign(tile.post_class.size(), PostClass::void_);
    tile.post_class[post_of(tile, 2, 2)] = PostClass::land;
    const SkyLanes sky = OneTile(tile).at(2, 2);
    EXPECT_EQ(sky.sky_view[0], 1);
    EXPECT_EQ(sky.openness_above[0], static_cast<float>(kPi / 2));
    EXPECT_EQ(sky.openness_below[0], static_cast<float>(kPi / 2));
    EXPECT_EQ(sky.aperture_cosine[0], 0);
}

/// Sky view at full resolution: every half post to the edge of the data, in 64 directions, bilinear between posts.
class Exhaustive {
public:
    explicit Exhaustive(const HeightSquare& ground) : ground_(ground) {}

    [[nodiscard]] double sky_view(int column, int row, double rise_east, double rise_north) const {
        const double up = 1 / std::sqrt(1 + rise_east * rise_east + rise_north * rise_north);
        double sum = 0;
        for (int k = 0; k < kAzimuths; ++k) {
            const double azimuth = 2 * kPi * k / kAzimuths, e = std::sin(azimuth), n = std::cos(azimuth);
            const double rise = rise_east * e + rise_north * n;
            const double zenith = kPi / 2 - std::atan(std::max({0.0, rise, horizon(column, row, e, n)}));
            sum += up * std::pow(std::sin(zenith), 2) - rise * up * (zenith - std::sin(zenith) * std::cos(zenith));
        }
        return sum / kAzimuths;
    }

private:
    static constexpr int kAzimuths = 64;

    [[nodiscard]] double horizon(int column, int row, double east, double north) const {
        double highest = 0;
        const double here_m = ground_.at(column, row);
        for (double d = 1;; d += d < 32 ? 0.5 : 1) {
            const double x = column + d * east, y = row - d * north;
            if (x < 0 || y < 0 || x > ground_.posts - 1 || y > ground_.posts - 1) return highest;
            const double far_m = d * ground_.spacing_m;
            highest = std::max(highest, (bilinear(x, y) - here_m) / far_m - far_m / 2 / 6371000);
        }
    }
    [[nodiscard]] double bilinear(double x, double y) const {
        const int i = std::min(static_cast<int>(x), ground_.posts - 2), j = std::min(static_cast<int>(y), ground_.posts - 2);
        const double u = x - i, v = y - j;
        return (ground_.at(i, j) * (1 - u) + ground_.at(i + 1, j) * u) * (1 - v) +
               (ground_.at(i, j + 1) * (1 - u) + ground_.at(i + 1, j + 1) * u) * v;
    }

    const HeightSquare& ground_;
};

struct Comparison {
    double rms = 0, bias = 0, darkest = 1;
};

Comparison compare(const HeightSquare& ground, const FarView& above) {
    const AttributeTile tile = ground.tile();
    const OneTile swept(tile, above);
    const Exhaustive truth(ground);
    Comparison result;
    int count = 0;
    for (int row = 5; row < ground.posts; row += 17) {
        for (int column = 3; column < ground.posts; column += 13, ++count) {
            const std::size_t at = swept.planes.at(column, row);
            const double expected = truth.sky_view(column, row, static_cast<double>(swept.gradients.east[at]),
                                                   static_cast<double>(swept.gradients.north[at]));
            const double error = swept.at(column, row).sky_view[0] - expected;
            result.rms += error * error;
            result.bias += error;
            result.darkest = std::min(result.darkest, expected);
        }
    }
    result.rms = std::sqrt(result.rms / count);
    result.bias /= count;
    return result;
}

TEST(SkySweep, ThePyramidSeesWhatAnExhaustiveSearchSees) {
    const test_support::FractalSquare fractal = test_support::fractal_square(256, 11);
    HeightSquare ground{256, {fractal.height_m.begin(), fractal.height_m.end()}, 20};
    const FarHorizons above = ground.halved().far_horizons();
    const Comparison whole = compare(ground, view_of(above)), near_only = compare(ground, {});
    EXPECT_LT(whole.rms, 1.0 / 255);
    EXPECT_GT(near_only.rms, 3 * whole.rms) << "far horizons must matter, or the test shows nothing";
    EXPECT_LT(whole.darkest, 0.75);
}

/// Light that the ground returns, gathered every quarter of a post in 64 directions.
double gathered(const AttributeTile& tile, const HalfPlanes& direct, const HeightPlanes& planes, int column, int row,
                double rise_east, double rise_north, double level_light) {
    constexpr int kAzimuths = 64;
    const double up = 1 / std::sqrt(1 + rise_east * rise_east + rise_north * rise_north);
    const auto bilinear = [&](const auto& value, double x, double y) {
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const double u = x - i, v = y - j;
        return (value(i, j) * (1 - u) + value(i + 1, j) * u) * (1 - v) +
               (value(i, j + 1) * (1 - u) + value(i + 1, j + 1) * u) * v;
    };
    const auto height_m = [&](int i, int j) { return static_cast<double>(tile.height_m[post_of(tile, i, j)]); };
    const auto lit = [&](int i, int j) { return static_cast<double>(direct[at_post][planes.at(i, j)]); };
    double sum = 0;
    for (int k = 0; k < kAzimuths; ++k) {
        const double azimuth = 2 * kPi * k / kAzimuths, e = std::sin(azimuth), n = std::cos(azimuth);
        const double rise = rise_east * e + rise_north * n;
        const auto arriving = [&](double tangent) {
            const double zenith = kPi / 2 - std::atan(tangent);
            return up * std::pow(std::sin(zenith), 2) - rise * up * (zenith - std::sin(zenith) * std::cos(zenith));
        };
        double highest = rise;
        for (double d = 0.25; d <= kHorizonReach / std::max(std::abs(e), std::abs(n)) - 1e-9; d += 0.25) {
            const double x = column + d * e, y = row - d * n, far_m = d * tile.north_m;
            const double tangent = (bilinear(height_m, x, y) - height_m(column, row)) / far_m - far_m / 2 / 6371000;
            if (tangent <= highest) continue;
            sum += bilinear(lit, x, y) * (arriving(highest) - arriving(tangent));
            highest = tangent;
        }
        if (highest < 0) sum += level_light * (arriving(highest) - arriving(0));
    }
    return sum / kAzimuths;
}

TEST(SkySweep, BounceIsWhatAFineGatherFinds) {
    const test_support::FractalSquare fractal = test_support::fractal_square(129, 3);
    const AttributeTile tile = make_tile(48, 48, 12, 12, [&](int i, int j) {
        return fractal.at(static_cast<std::uint32_t>(i + 36), static_cast<std::uint32_t>(j + 36));
    });
    OneTile ground(tile);
    FixedLight light;
    light.elevation_rad = base::radians(25);
    ground.direct = direct_light(ground.planes, ground.gradients, light, {});
    OneTile opposite(tile);
    light.azimuth_rad += kPi;
    opposite.direct = direct_light(ground.planes, ground.gradients, light, {});
    const auto level_light = static_cast<float>(std::sin(light.elevation_rad));
    double squares = 0, opposite_squares = 0, brightest = 0, darkest = 1;
    int count = 0;
    for (int row = 1; row < 48; row += 5) {
        for (int column = 2; column < 48; column += 5, ++count) {
            const std::size_t at = ground.planes.at(column, row);
            const double truth =
                gathered(tile, ground.direct, ground.planes, column, row, static_cast<double>(ground.gradients.east[at]),
                         static_cast<double>(ground.gradients.north[at]), static_cast<double>(level_light));
            const double error = ground.at(column, row, level_light).bounce[0] - truth;
            squares += error * error;
            opposite_squares += std::pow(opposite.at(column, row, level_light).bounce[0] - truth, 2);
            brightest = std::max(brightest, truth);
            darkest = std::min(darkest, truth);
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.012) << "16 directions, and strips that end at posts";
    EXPECT_GT(opposite_squares, 4 * squares) << "of light from the other side";
    EXPECT_GT(brightest, 0.1);
    EXPECT_LT(darkest, 0.01);
}

}  // namespace
}  // namespace tedavis::host_sim::test_sky_sweep
