#include "host_sim/terrain_builder/curvature_bound.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "render_core/base/units.hpp"
#include "tests/host_sim/terrain_builder/post_grid.hpp"

namespace tedavis::host_sim::test_curvature_bound {
namespace {

using terrain::Lattice;

Lattice lattice_of(double west, double north, double step, std::uint32_t columns, std::uint32_t rows) {
    return make_build_plan(test_support::post_grid(west, north, step, columns, rows), {}).lattice;
}

struct Corner {
    std::uint32_t i, j;
    double height_m;
};

struct Place {
    double latitude_deg, longitude_deg, height_m;
};

using Point = std::array<double, 3>;

Point in_space(const Place& place) {
    Point p{};
    GeographicLib::Geocentric::WGS84().Forward(place.latitude_deg, place.longitude_deg, place.height_m, p[0], p[1], p[2]);
    return p;
}

struct Miss {
    double up_m = 0, down_m = 0, shift_m = 0;

    void include(const Point& drawn, const Place& expected) {
        Place there{};
        double apart_m = 0;
        GeographicLib::Geocentric::WGS84().Reverse(drawn[0], drawn[1], drawn[2], there.latitude_deg, there.longitude_deg,
                                                   there.height_m);
        GeographicLib::Geodesic::WGS84().Inverse(expected.latitude_deg, expected.longitude_deg, there.latitude_deg,
                                                 there.longitude_deg, apart_m);
        up_m = std::max(up_m, there.height_m - expected.height_m);
        down_m = std::max(down_m, expected.height_m - there.height_m);
        shift_m = std::max(shift_m, apart_m);
    }
};

void expect_within(const Miss& miss, const CurvatureBound& bound) {
    constexpr double kRounding_m = 1e-6;
    EXPECT_LE(miss.up_m, bound.up_m + kRounding_m);
    EXPECT_LE(miss.down_m, bound.down_m + kRounding_m);
    EXPECT_LE(miss.shift_m, bound.shift_m + kRounding_m);
}

Place place_of(const Lattice& lattice, const Corner& corner) {
    return {base::degrees(lattice.latitude_rad(corner.j)), base::degrees(lattice.longitude_rad(corner.i)), corner.height_m};
}

/// Points of the flat triangle in space against the points with the same weights over the lattice.
Miss miss_of(const Lattice& lattice, const std::array<Corner, 3>& corners) {
    std::array<Point, 3> space{};
    for (std::size_t k = 0; k < 3; ++k) space[k] = in_space(place_of(lattice, corners[k]));
    Miss miss;
    for (int a = 0; a <= 8; ++a)
        for (int b = 0; a + b <= 8; ++b) {
            const double w[3] = {a / 8.0, b / 8.0, (8 - a - b) / 8.0};
            Point drawn{};
            Place expected{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Place corner = place_of(lattice, corners[k]);
                for (std::size_t axis = 0; axis < 3; ++axis) drawn[axis] += w[k] * space[k][axis];
                expected.latitude_deg += w[k] * corner.latitude_deg;
                expected.longitude_deg += w[k] * corner.longitude_deg;
                expected.height_m += w[k] * corner.height_m;
            }
            miss.include(drawn, expected);
        }
    return miss;
}

/// Seeded triangles of all sizes; how much of the bound they use at most.
void expect_bound_holds(const Lattice& lattice, std::uint32_t largest, double used_at_least) {
    std::mt19937 random(11);
    double used = 0;
    for (int n = 0; n < 4000; ++n) {
        const std::uint32_t side = 1 + static_cast<std::uint32_t>(random() % largest);
        const std::uint32_t i0 = static_cast<std::uint32_t>(random() % (lattice.columns() - side)),
                            j0 = static_cast<std::uint32_t>(random() % (lattice.rows() - side));
        std::array<Corner, 3> corners;
        for (Corner& c : corners)
            c = {i0 + static_cast<std::uint32_t>(random() % (side + 1)), j0 + static_cast<std::uint32_t>(random() % (side + 1)),
                 static_cast<double>(random() % 8000)};
        const auto [west, east] = std::minmax({corners[0].i, corners[1].i, corners[2].i});
        const auto [north, south] = std::minmax({corners[0].j, corners[1].j, corners[2].j});
        const auto [low, high] = std::minmax({corners[0].height_m, corners[1].height_m, corners[2].height_m});
        if (north == south) continue;
        const CurvatureBound bound = curvature_bound(lattice, east - west, north, south, high - low);
        const Miss miss = miss_of(lattice, corners);
        expect_within(miss, bound);
        used = std::max(used, miss.down_m / bound.down_m);
    }
    EXPECT_GT(used, used_at_least) << "a bound that is never met says little";
}

TEST(CurvatureBound, HoldsAtTheEquator) { expect_bound_holds(lattice_of(10, 4, 0.01, 900, 900), 400, 0.9); }
TEST(CurvatureBound, HoldsAtMiddleLatitudes) { expect_bound_holds(lattice_of(10, 50, 0.01, 900, 900), 400, 0.9); }
TEST(CurvatureBound, HoldsFarNorth) { expect_bound_holds(lattice_of(10, 85, 0.01, 900, 900), 400, 0.5); }
TEST(CurvatureBound, HoldsOverThousandsOfKilometres) { expect_bound_holds(lattice_of(-170, 70, 0.5, 600, 270), 60, 0.5); }

TEST(CurvatureBound, GrowsWithTheSquareOfTheSize) {
    const Lattice lattice = lattice_of(10, 50, 0.001, 3000, 3000);
    const double one = curvature_bound(lattice, 100, 1000, 1100, 0).down_m,
                 two = curvature_bound(lattice, 200, 1000, 1200, 0).down_m;
    EXPECT_NEAR(two / one, 4, 0.02);
    const double side_m = base::radians(0.1) * 6371000;
    EXPECT_NEAR(curvature_bound(lattice, 0, 1000, 1100, 0).down_m, side_m * side_m / (8 * 6371000), 0.02)
        << "the sagitta of a chord";
}

/// Along each meridian from the pole to the ring the true surface is linear.
TEST(CurvatureBound, HoldsBetweenAPoleAndItsRing) {
    const Lattice lattice = lattice_of(-180, 90, 1, 360, 91);
    std::mt19937 random(4);
    double used = 0;
    for (int n = 0; n < 400; ++n) {
        const std::uint32_t columns = 1 + static_cast<std::uint32_t>(random() % 20);
        const double pole_m = random() % 4000, west_m = random() % 4000, east_m = random() % 4000;
        const Place pole{90, 0, pole_m}, west = place_of(lattice, {7, 1, west_m}),
                                         east = place_of(lattice, {7 + columns, 1, east_m});
        const Point apex = in_space(pole), left = in_space(west), right = in_space(east);
        Miss miss;
        for (int a = 0; a <= 8; ++a)
            for (int b = 1; b <= 8; ++b) {
                const double u = a / 8.0, v = b / 8.0;
                Point drawn{};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    drawn[axis] = (1 - v) * apex[axis] + v * ((1 - u) * left[axis] + u * right[axis]);
                miss.include(drawn, {90 - v * (90 - west.latitude_deg), west.longitude_deg + u * columns,
                                     (1 - v) * pole_m + v * ((1 - u) * west_m + u * east_m)});
            }
        const double rise_m = std::max({pole_m, west_m, east_m}) - std::min({pole_m, west_m, east_m});
        const CurvatureBound bound = curvature_bound(lattice, columns, 0, 1, rise_m);
        expect_within(miss, bound);
        used = std::max({used, miss.down_m / bound.down_m, miss.shift_m / bound.shift_m});
    }
    EXPECT_GT(used, 0.5) << "a bound that is never met says little";
}

TEST(CurvatureBound, RowsBesideAPoleCountTheirOwnSpacing) {
    const Lattice half = lattice_of(-179.5, 89.5, 1, 360, 180);  // half a step from the last row to the pole
    const double inner = curvature_bound(half, 1, 1, 3, 0).shift_m, outer = curvature_bound(half, 1, 0, 2, 0).shift_m;
    EXPECT_GT(outer - inner, base::radians(0.5) * 6350000);
    const Lattice tile = lattice_of(10, 60, 0.01, 101, 101);
    EXPECT_LT(curvature_bound(tile, 1, 0, 2, 0).shift_m, 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_curvature_bound
