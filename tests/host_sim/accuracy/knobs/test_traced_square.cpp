#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_traced_square {
namespace {

struct Squared {
    test_support::FlownFiles files;
    base::SerialWorkers workers;
    TracedGround ground{files.terrain, workers};
    TracedSquare square{ground};
};

TEST(TracedSquare, HasTheHeightsOfTheGroundInMetres) {
    const Squared s;
    const auto grid = s.square.grid();
    ASSERT_TRUE(grid.is_valid());
    const std::uint32_t column0 = (s.ground.columns() - grid.columns) / 2, row0 = (s.ground.rows() - grid.rows) / 2;
    for (const std::uint32_t n : {0u, 5u, grid.rows - 1}) {
        const double expected = s.ground.is_whole()
                                    ? s.ground.grid<std::int16_t>().at(column0 + 3, row0 + n) * s.ground.space().step_m()
                                    : double{s.ground.grid<float>().at(column0 + 3, row0 + n)} * s.ground.space().step_m();
        EXPECT_NEAR(double{grid.at(3, n)}, expected, 1e-3);
    }
    EXPECT_GT(s.square.cell_m(), 1);
}

TEST(TracedSquare, RaysBeginOverTheGroundAndEndAtTheBorder) {
    const Squared s;
    const auto rays = rays_over(s.square, 200, 7);
    const auto same = rays_over(s.square, 200, 7), others = rays_over(s.square, 200, 8);
    int differ = 0;
    for (std::size_t n = 0; n < rays.size(); ++n) {
        const raytrace::Ray& ray = rays[n];
        raytrace::SurfacePoint ground;
        ASSERT_TRUE(raytrace::find_surface(s.square.grid(), {}, ray.origin.x, ray.origin.y, ground));
        EXPECT_GE(ray.origin.z - ground.height, 150);
        EXPECT_LT(ray.direction.z, 0);
        const double end = end_over(s.square, ray), x = ray.origin.x + end * ray.direction.x,
                     y = ray.origin.y + end * double{ray.direction.y};
        EXPECT_TRUE(std::abs(x - (s.square.grid().columns - 1)) < 1e-9 || std::abs(y) < 1e-9 ||
                    std::abs(y - (s.square.grid().rows - 1)) < 1e-9);
        EXPECT_EQ(ray.origin, same[n].origin) << "the same on every run";
        differ += ray.origin != others[n].origin ? 1 : 0;
    }
    EXPECT_EQ(differ, 200) << "control: another seed";
    EXPECT_EQ(ray_text(rays[0]).find("the ray from column 0, row "), 0u);
}

TEST(TracedSquare, BoundsAreThoseOfTheSurface) {
    const Squared s;
    raytrace::SurfaceSettings smooth;
    smooth.kind = raytrace::SurfaceKind::bicubic;
    const BoundedSurface surface(s.square, smooth);
    const auto grid = s.square.grid();
    SeededRandom numbers(1);
    for (int n = 0; n < 1000; ++n) {
        raytrace::SurfacePoint point;
        const double x = numbers.between(0, grid.columns - 1.0), y = numbers.between(0, grid.rows - 1.0);
        if (!raytrace::find_surface(grid, smooth, x, y, point)) continue;
        const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
        EXPECT_LE(point.height, double{surface.maxima().level(0).at(column, row)} + 1e-3);
    }
    EXPECT_GT(surface.bytes(), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_traced_square
