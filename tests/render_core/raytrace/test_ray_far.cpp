// Rays over the widest grids, far from where they began (NUMERICS A21), and with denormals flushed (A45).
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/trace_agreement.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace::test_ray_far {
namespace {

using test_support::HeightField;
using test_support::ReferenceTracer;
using test_support::TraceAgreement;
using test_support::TracedGround;

constexpr std::uint32_t kLength = HeightGrid<std::int16_t>::kMaxPosts, kWidth = 17;

/// A valley as long as a grid can be, or as wide.
HeightField<std::int16_t> valley(bool is_long) {
    HeightField<std::int16_t> field(is_long ? kLength : kWidth, is_long ? kWidth : kLength);
    for (std::uint32_t n = 0; n < kLength; ++n) {
        for (std::uint32_t m = 0; m < kWidth; ++m) {
            const double height = 3000 * std::sin(n * 0.0004) + 400 * std::sin(n * 0.07 + m) + 50 * std::sin(1.3 * n + m * m);
            (is_long ? field.at(n, m) : field.at(m, n)) = static_cast<std::int16_t>(height);
        }
    }
    return field;
}

/// The naive march: the time of a grid line is a sum of steps, in floats. Returns by how much of it the last line's is off.
float summed_steps_off(float direction, std::uint32_t lines) {
    const float step = 1 / direction;
    float t = 0;
    for (std::uint32_t n = 0; n < lines; ++n) t += step;
    const double expected = lines / double{direction};
    return static_cast<float>(std::abs(t - expected) / expected);
}

/// The control of what follows: directions of the same range over as many lines.
TEST(RayFar, SummedStepsWouldBeFarOff) {
    TraceAgreement far, near;
    std::mt19937 bits(3);
    for (int n = 0; n < 1200; ++n) {
        const auto direction = static_cast<float>(0.1 + 2.9 * (bits() * 0x1p-32));
        far.relative_t.push_back(summed_steps_off(direction, kLength - 1));
        near.relative_t.push_back(summed_steps_off(direction, 16));
    }
    EXPECT_LE(near.quantile(0.999), 2e-5) << "which does not show over a few cells";
    EXPECT_GT(far.quantile(0.999), 2e-5);
    EXPECT_GT(far.quantile(0.5), 2e-5);
    test_support::record_control("A21", far.quantile(0.999));
}

TEST(RayFar, ErrorsAreThoseOfFloatsFromTheOriginOn) {
    double worst = 0;
    for (const bool is_long : {true, false}) {
        const TracedGround<std::int16_t> ground(valley(is_long));
        for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear}) {
            const ReferenceTracer<std::int16_t> reference(ground.field.grid(), surface);
            TraceAgreement found;
            std::mt19937 bits(3);
            const auto in = [&](double low, double high) { return low + (high - low) * (bits() * 0x1p-32); };
            for (int n = 0; n < 1200; ++n) {
                // Also from far outside, and a whole grid away from what is met.
                const double from = in(-20000, kLength + 20000.0), side = from < kLength / 2.0 ? 1 : -1;
                const double fall = -std::pow(10, in(-1, 1)), across = in(0.5, 15.5), turn = in(-1e-4, 1e-4);
                const glm::dvec3 origin(from, across, in(3500, 6000));
                const glm::vec3 direction(static_cast<float>(side * in(0.1, 3)), static_cast<float>(turn),
                                          static_cast<float>(fall));
                const Ray ray = is_long ? Ray{origin, direction}
                                        : Ray{{origin.y, origin.x, origin.z}, {direction.y, direction.x, direction.z}};
                const test_support::ReferenceHit expected = reference.trace(ray);
                const Hit hit = ground.trace(ray, surface);
                found.add(expected, hit.side == HitSide::above, hit.t);
            }
            EXPECT_EQ(found.unexplained, 0U);
            EXPECT_EQ(found.misplaced, 0U);
            EXPECT_GT(found.hits, 500U);
            EXPECT_LT(found.close, 100U);
            EXPECT_LE(found.quantile(0.999), 2e-5);
            EXPECT_LE(found.quantile(0.9), 1e-6);
            worst = std::max(worst, found.quantile(0.999));
        }
    }
    test_support::record_worst("A21", worst);
}

#if defined(__x86_64__)
/// What some libraries switch on behind a program's back, and what a NEON unit does.
class FlushedDenormals {
public:
    FlushedDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    ~FlushedDenormals() { _mm_setcsr(before_); }
    FlushedDenormals(const FlushedDenormals&) = delete;
    FlushedDenormals& operator=(const FlushedDenormals&) = delete;

private:
    unsigned before_;
};

TEST(RayFar, FlushedDenormalsChangeNoBit) {
    const TracedGround<std::int16_t> ground(test_support::rough_heights(61, 57, 80, 2),
                                            TracedGround<std::int16_t>::Starts::anywhere);
    std::mt19937 bits(4);
    const auto in = [&](double low, double high) { return low + (high - low) * (bits() * 0x1p-32); };
    const float small[] = {0, 1e-45F, -1e-45F, 1e-40F, -3e-39F, 1e-35F};
    int hits = 0;
    for (int n = 0; n < 200'000; ++n) {
        Ray ray{{in(-5, 65), in(-5, 60), in(-10, 120)},
                {static_cast<float>(in(-1, 1)), static_cast<float>(in(-1, 1)), static_cast<float>(in(-4, 1))}};
        if (n % 3 == 0) ray.direction.x = small[bits() % 6];
        if (n % 4 == 0) ray.direction.y = small[bits() % 6];
        if (n % 5 == 0 && n % 12 != 0) ray.direction.z = small[bits() % 6];
        if (n % 7 == 0) ray.origin = {2e-41, n % 2 == 0 ? 1e-42 : ray.origin.y, 3e-43};
        const CellSurface surface = n % 2 == 0 ? CellSurface::bilinear : CellSurface::two_triangles;
        const Hit plain = ground.trace(ray, surface);
        Hit flushed;
        {
            const FlushedDenormals mode;
            flushed = ground.trace(ray, surface);
        }
        hits += plain.side != HitSide::none;
        ASSERT_EQ(std::memcmp(&plain.t, &flushed.t, sizeof(float)), 0) << n << ": " << plain.t << " and " << flushed.t;
        ASSERT_EQ(plain.side, flushed.side);
        ASSERT_EQ(plain.column, flushed.column);
        ASSERT_EQ(plain.row, flushed.row);
    }
    EXPECT_GT(hits, 50'000);
}

TEST(RayFar, DenormalsAreFlushedWhereTheTestSaysSo) {
    volatile float least = 1e-40F, plain = 0, flushed = 0;
    plain = least * 0.5F;
    {
        const FlushedDenormals mode;
        flushed = least * 0.5F;
    }
    EXPECT_NE(plain, 0);
    EXPECT_EQ(flushed, 0);
}
#endif

}  // namespace
}  // namespace tedavis::raytrace::test_ray_far
