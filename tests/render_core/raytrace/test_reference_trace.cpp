// The oracle itself, before anything is held against it: planes whose answer is a formula, and every cell of a small grid by
// another method.
#include "tests/support/raytrace/reference_trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/terrain/fractal_heights.hpp"

namespace tedavis::raytrace::test_reference_trace {
namespace {

using test_support::FromBelow;
using test_support::HeightField;
using test_support::ReferenceHit;
using test_support::ReferenceTracer;

struct Rays {
    std::mt19937 bits{7};
    double in(double low, double high) { return low + (high - low) * (bits() * 0x1p-32); }
    Ray next(double side, double z) {
        return {{in(-0.2 * side, 1.2 * side), in(-0.2 * side, 1.2 * side), in(-z, 3 * z)},
                {static_cast<float>(in(-1, 1)), static_cast<float>(in(-1, 1)), static_cast<float>(in(-2, 2) * z / side)}};
    }
};

TEST(ReferenceTrace, MeetsAPlaneWhereAFormulaSays) {
    HeightField<float> field(40, 30);
    for (std::uint32_t row = 0; row < 30; ++row)
        for (std::uint32_t column = 0; column < 40; ++column) field.at(column, row) = 5 + 0.25F * column - 0.5F * row;
    Rays rays;
    int hits = 0;
    for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear}) {
        const ReferenceTracer<float> tracer(field.grid(), surface);
        for (int n = 0; n < 20000; ++n) {
            const Ray ray = rays.next(35, 20);
            const glm::dvec3 o = ray.origin, d = ray.direction;
            const double over = o.z - (5 + 0.25 * o.x - 0.5 * o.y), rate = d.z - 0.25 * d.x + 0.5 * d.y, t = -over / rate;
            const glm::dvec3 at = o + t * d;
            const bool meets = over > 0 && rate < 0 && at.x > 0 && at.y > 0 && at.x < 39 && at.y < 29;
            const ReferenceHit hit = tracer.trace(ray);
            ASSERT_EQ(hit.side == HitSide::above, meets) << n;
            if (!meets) continue;
            ++hits;
            ASSERT_NEAR(static_cast<double>(hit.t), t, 1e-9 * (1 + t)) << n;
            ASSERT_EQ(hit.column, std::floor(at.x));
            ASSERT_EQ(hit.row, std::floor(at.y));
        }
    }
    EXPECT_GT(hits, 1000);
}

/// The first time at which a ray goes through one half of a cell, by the plane's equation and an inside test; or at which it
/// meets a patch, by ten thousand steps.
double first_in_cell(const HeightField<std::int16_t>& field, std::uint32_t c, std::uint32_t r, const Ray& ray,
                     CellSurface surface) {
    const auto grid = field.grid();
    const double h00 = grid.at(c, r), h10 = grid.at(c + 1, r), h01 = grid.at(c, r + 1), h11 = grid.at(c + 1, r + 1);
    const glm::dvec3 o = ray.origin - glm::dvec3(c, r, 0), d = ray.direction;
    double first = INFINITY;
    if (surface == CellSurface::bilinear) {
        const auto over = [&](double t) {
            const glm::dvec3 p = o + t * d;
            return p.z - ((h00 * (1 - p.x) + h10 * p.x) * (1 - p.y) + (h01 * (1 - p.x) + h11 * p.x) * p.y);
        };
        const double a = std::min(-o.x / d.x, (1 - o.x) / d.x), b = std::max(-o.x / d.x, (1 - o.x) / d.x);
        const double e = std::min(-o.y / d.y, (1 - o.y) / d.y), f = std::max(-o.y / d.y, (1 - o.y) / d.y);
        const double begin = std::max({a, e, 0.0}), end = std::min(b, f);
        for (int n = 0; n < 10000 && begin < end; ++n) {
            const double t = begin + (end - begin) * n / 10000, u = begin + (end - begin) * (n + 1) / 10000;
            if (over(t) > 0 && over(u) <= 0) return t;
        }
        return first;
    }
    for (const bool upper : {false, true}) {
        const double along = upper ? h11 - h01 : h10 - h00, down = upper ? h11 - h10 : h01 - h00;
        const double base = upper ? h11 - along - down : h00, rate = d.z - along * d.x - down * d.y;
        const double t = -(o.z - base - along * o.x - down * o.y) / rate;
        const glm::dvec3 at = o + t * d;
        const bool inside = upper ? at.x <= 1 && at.y <= 1 && at.x + at.y >= 1 : at.x >= 0 && at.y >= 0 && at.x + at.y <= 1;
        if (inside && t >= 0 && rate < 0) first = std::min(first, t);
    }
    return first;
}

TEST(ReferenceTrace, AgreesWithAllCellsOneByOne) {
    const HeightField<std::int16_t> field = test_support::rough_heights(13, 9, 12, 3);
    Rays rays;
    for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear}) {
        const ReferenceTracer<std::int16_t> tracer(field.grid(), surface);
        const bool is_bent = surface == CellSurface::bilinear;
        int hits = 0, unclear = 0;
        for (int n = 0; n < (is_bent ? 400 : 20000); ++n) {
            Ray ray = rays.next(11, 12);
            ray.origin.z = 12.5 + std::abs(ray.origin.z);
            ray.direction.z = -std::abs(ray.direction.z);
            double first = INFINITY;
            for (std::uint32_t r = 0; r < 8; ++r)
                for (std::uint32_t c = 0; c < 12; ++c) first = std::min(first, first_in_cell(field, c, r, ray, surface));
            // Whoever comes in below the border leaves through the surface from below, and may come back from above.
            const ReferenceHit hit = tracer.trace(ray, FromBelow::passes);
            hits += hit.side == HitSide::above;
            // The bent cells are sampled only.
            if (hit.clearance < (is_bent ? 1e-2 : 1e-9)) {
                ++unclear;
                continue;
            }
            ASSERT_EQ(hit.side == HitSide::above, first < INFINITY) << n;
            if (hit.side == HitSide::none) continue;
            ASSERT_NEAR(static_cast<double>(hit.t), first, is_bent ? 0.01 : 1e-9 * (1 + first)) << n;
        }
        EXPECT_GT(hits, is_bent ? 40 : 2000);
        EXPECT_LT(unclear, is_bent ? 20 : 2);
    }
}

TEST(ReferenceTrace, TellsBelowFromAboveAndPassesVoids) {
    HeightField<std::int16_t> field(6, 6, 10);
    const Ray rising{{2.2, 2.3, 4}, {0.1F, 0, 1}};
    const ReferenceTracer<std::int16_t> flat(field.grid(), CellSurface::two_triangles);
    EXPECT_EQ(flat.trace(rising).side, HitSide::none);
    const ReferenceHit out = flat.trace(rising, FromBelow::meets);
    EXPECT_EQ(out.side, HitSide::below);
    EXPECT_NEAR(static_cast<double>(out.t), 6, 1e-6);
    const Ray falling{{2.2, 2.3, 14}, {0.1F, 0, -1}};
    EXPECT_EQ(flat.trace(falling).side, HitSide::above);
    EXPECT_EQ(flat.trace({falling.origin, falling.direction, 0, 3.9F}).side, HitSide::none);
    EXPECT_EQ(flat.trace({falling.origin, falling.direction, 4.1F}).side, HitSide::none);
    // In through the border below the height, out, and down again from above.
    HeightField<std::int16_t> dip(12, 6, 10);
    for (std::uint32_t row = 0; row < 6; ++row) dip.at(5, row) = dip.at(6, row) = 2;
    const ReferenceTracer<std::int16_t> valley(dip.grid(), CellSurface::bilinear);
    const Ray level{{-1, 2.5, 6}, {1, 0, 0}};
    EXPECT_EQ(valley.trace(level, FromBelow::ends).side, HitSide::none);
    EXPECT_NEAR(static_cast<double>(valley.trace(level, FromBelow::meets).t), 5.5, 1e-9);
    EXPECT_NEAR(static_cast<double>(valley.trace(level, FromBelow::passes).t), 7.5, 1e-9);
    field.at(3, 3) = HeightGrid<std::int16_t>::kVoid;
    EXPECT_EQ(flat.trace(falling).side, HitSide::none);
    EXPECT_EQ(flat.trace({{1.2, 1.3, 14}, {0.1F, 0, -1}}).side, HitSide::above);
}

TEST(ReferenceTrace, SaysHowCloseARayComesToAnotherAnswer) {
    HeightField<std::int16_t> field(9, 9);
    field.at(4, 4) = 100;
    for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear}) {
        const ReferenceTracer<std::int16_t> tracer(field.grid(), surface);
        const ReferenceHit over = tracer.trace({{-2, 4, 100.25}, {1, 0, 0}});
        EXPECT_EQ(over.side, HitSide::none);
        EXPECT_NEAR(static_cast<double>(over.clearance), 0.25, 1e-12);
        const ReferenceHit under = tracer.trace({{-2, 4, 99.75}, {1, 0, 0}});
        EXPECT_EQ(under.side, HitSide::above);
        EXPECT_NEAR(static_cast<double>(under.clearance), 0.25, 1e-12);
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_reference_trace
