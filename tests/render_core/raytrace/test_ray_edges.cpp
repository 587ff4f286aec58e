// Rays with components that are zero, on lines of posts, through posts and along diagonals (NUMERICS A18, A19), against the
// reference; and ten million rays aimed from above at edges and posts, none of which may slip through (A26).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/raytrace/trace_agreement.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace::test_ray_edges {
namespace {

using test_support::HeightField;
using test_support::ReferenceHit;
using test_support::ReferenceTracer;
using test_support::TraceAgreement;
using test_support::TracedGround;

constexpr CellSurface kSurfaces[] = {CellSurface::two_triangles, CellSurface::bilinear};
constexpr float kMin = 1e-42F;  // a denormal

/// Both surfaces, every ray.
class EdgeRays {
public:
    explicit EdgeRays(const TracedGround<std::int16_t>& ground) : ground_(ground) {
        for (const CellSurface surface : kSurfaces) references_.emplace_back(ground.field.grid(), surface);
    }
    void add(const Ray& ray) {
        for (std::size_t n = 0; n < 2; ++n) {
            const Hit hit = ground_.trace(ray, kSurfaces[n]);
            agreement.add(references_[n].trace(ray), hit.side == HitSide::above, hit.t);
            below += hit.side == HitSide::below;
        }
    }
    TraceAgreement agreement;
    int below = 0;

private:
    const TracedGround<std::int16_t>& ground_;
    std::vector<ReferenceTracer<std::int16_t>> references_;
};

#define EXPECT_AGREEMENT(rays)                   \
    EXPECT_EQ((rays).agreement.unexplained, 0U); \
    EXPECT_EQ((rays).agreement.misplaced, 0U);   \
    EXPECT_EQ((rays).below, 0);                  \
    EXPECT_LT((rays).agreement.close, (rays).agreement.rays / 50)

TEST(RayEdges, ZeroComponentsOfEverySignAreFollowed) {
    const TracedGround<std::int16_t> ground(test_support::rough_heights(33, 29, 40, 1));
    EdgeRays rays(ground);
    for (const float zero : {0.0F, -0.0F, kMin, -kMin, 1e-31F, -1e-31F}) {
        for (const float other : {0.0F, -0.0F, -kMin}) {
            for (int n = 0; n < 400; ++n) {
                // On lines of posts, midway, and anywhere.
                const double at = n % 29 + (n % 3 == 0 ? 0.0 : n % 3 == 1 ? 0.5 : 0.3711 + 0.001 * n);
                const double z = 3.3 + n % 37, past = at > 27 ? 27.1 : at + 0.0;
                rays.add({{-3, past, z}, {1, zero, other}});
                rays.add({{40, past, z}, {-2, zero, other}});
                rays.add({{past, -3, z}, {zero, 1, other}});
                rays.add({{past, 40, z}, {zero, -0.5F, other}});
                rays.add({{past, 27.99 - past * 0.9, 41.5}, {zero, other, -1}});
            }
        }
    }
    EXPECT_AGREEMENT(rays);
    EXPECT_GT(rays.agreement.hits, 20000U);
}

TEST(RayEdges, VerticalRaysMeetPostsEdgesAndMiddles) {
    const TracedGround<std::int16_t> ground(test_support::rough_heights(65, 47, 3000, 2));
    EdgeRays rays(ground);
    for (std::uint32_t row = 0; row < 46; ++row) {
        for (std::uint32_t column = 0; column < 64; ++column) {
            for (const float zero : {0.0F, -0.0F, 1e-30F}) {
                const Hit hit = ground.trace({{column, row, 3100}, {zero, zero, -1}});
                ASSERT_EQ(hit.side, HitSide::above) << column << " " << row;
                ASSERT_NEAR(hit.t, 3100 - ground.field.at(column, row), 1e-3);
                if (row == 0 || column == 0) continue;
                rays.add({{column + 0.5, row, 3100.25}, {zero, zero, -1}});
                rays.add({{column, row + 0.25, 3100.25}, {zero, zero, -2}});
                rays.add({{column + 0.5, row + 0.5, 3100.25}, {zero, zero, -1}});
                rays.add({{column + 0.125, row + 0.875, 3100.25}, {zero, zero, -1}});
            }
        }
    }
    EXPECT_AGREEMENT(rays);
    EXPECT_EQ(rays.agreement.hits, rays.agreement.rays);
}

TEST(RayEdges, RaysAlongLinesAndDiagonalsOfPostsAreFollowed) {
    const TracedGround<std::int16_t> ground(test_support::rough_heights(61, 61, 90, 3));
    EdgeRays rays(ground);
    for (int line = 1; line < 60; ++line) {
        for (int n = 0; n < 40; ++n) {
            const double z = 91.3 - 2.1 * n, start = n % 2 == 0 ? -5 : 12;
            const float fall = -0.01F * static_cast<float>(n % 5) - 0.003F;
            const double from = start > 0 ? 95 : z;
            rays.add({{start, line, from}, {1, 0, start > 0 ? -3 : fall}});
            rays.add({{line, start, from}, {-0.0F, 1, start > 0 ? -3 : fall}});
            rays.add({{line, 64.5, z}, {0, -1, fall}});
            // Through posts at 45 degrees: across the dividing edges of cells, and along them.
            rays.add({{start + line, start, from}, {1, 1, start > 0 ? -4 : fall}});
            rays.add({{line - start, start, from}, {-1, 1, start > 0 ? -4 : fall}});
            rays.add({{line + 3.0, 57.0, 95.5}, {-0.5F, -0.5F, -1 - 0.1F * static_cast<float>(n)}});
            rays.add({{line - 3.0, 57.0, 95.5}, {0.5F, -0.5F, -1 - 0.1F * static_cast<float>(n)}});
            // Through posts in other whole ratios.
            rays.add({{-6.0, line - 4.0, z}, {2, 1, fall}});
            rays.add({{line, 69.0, z}, {-1, -3, fall}});
        }
    }
    EXPECT_AGREEMENT(rays);
    EXPECT_GT(rays.agreement.hits, 10000U);
}

/// Rays from above all posts, over the grid, that end on an edge, a dividing edge or a post: all must meet the surface, there or
/// before.
class SeamRays {
public:
    SeamRays(const HeightField<std::int16_t>& field, int highest, CellSurface surface)
        : field_(field), highest_(highest), kinds_(surface == CellSurface::two_triangles ? 4 : 3) {}

    /// It reaches the edge at t = 1.
    Ray next() {
        const std::uint32_t c = 9 + bits_() % (field_.columns - 19), r = 9 + bits_() % (field_.rows - 19),
                            kind = bits_() % kinds_;
        // In 64ths, so that every number here is exact in floats.
        const double part = (bits_() % 65) / 64.0, corner_u = bits_() % 2, corner_v = bits_() % 2;
        const double u = kind == 0 ? corner_u : kind == 1 ? 0 : part;
        const double v = kind == 0 ? corner_v : kind == 1 ? part : kind == 2 ? 0 : 1 - part;
        const double h00 = field_.at(c, r), h10 = field_.at(c + 1, r), h01 = field_.at(c, r + 1), h11 = field_.at(c + 1, r + 1);
        const double along = kind == 3 ? h01 + u * (h10 - h01) : u == 0 ? h00 + v * (h01 - h00) : h00 + u * (h10 - h00);
        const glm::dvec3 target(c + u, r + v, kind != 0 ? along : v == 0 ? along : u == 0 ? h01 : h11);
        const glm::dvec3 away((bits_() % 4097) / 256.0 - 8, (bits_() % 4097) / 256.0 - 8,
                              highest_ - std::floor(target.z) + 1 + (bits_() % 4096) / 256.0);
        return {target + away, glm::vec3(-away)};
    }

private:
    const HeightField<std::int16_t>& field_;
    int highest_;
    std::uint32_t kinds_;
    std::mt19937 bits_{17};
};

/// How many of `count` rays slip through. One that grazes a ridge may go on over it, as the reference does a little higher.
std::uint64_t slipped(const TracedGround<std::int16_t>& ground, int highest, CellSurface surface, std::uint64_t count) {
    const ReferenceTracer<std::int16_t> reference(ground.field.grid(), surface);
    SeamRays rays(ground.field, highest, surface);
    std::uint64_t lost = 0;
    for (std::uint64_t n = 0; n < count; ++n) {
        Ray ray = rays.next();
        const Hit hit = ground.trace(ray, surface);
        if (hit.side == HitSide::above && hit.t <= 1.00001F) continue;
        ray.origin.z += 1e-5 * (highest + 1);
        const ReferenceHit over = reference.trace(ray);
        lost += hit.side != over.side || (hit.side == HitSide::above && hit.t > over.t * 1.0001L);
    }
    return lost;
}

TEST(RayEdges, NoneOfTenMillionRaysSlipsThroughASeam) {
    const TracedGround<std::int16_t> low(test_support::rough_heights(87, 84, 1, 5)),
        steep(test_support::rough_heights(87, 84, 200, 6));
    EXPECT_EQ(slipped(low, 1, CellSurface::two_triangles, 3'500'000), 0U);
    EXPECT_EQ(slipped(low, 1, CellSurface::bilinear, 1'500'000), 0U);
    EXPECT_EQ(slipped(steep, 200, CellSurface::two_triangles, 3'500'000), 0U);
    EXPECT_EQ(slipped(steep, 200, CellSurface::bilinear, 1'500'000), 0U);
}

TEST(RayEdges, RaysSlipThroughABoundThatMissesTheBorder) {
    TracedGround<std::int16_t> ground(test_support::rough_heights(87, 84, 1, 5));
    ground.lose_border(5);
    EXPECT_GT(slipped(ground, 1, CellSurface::two_triangles, 20'000), 100U);
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_edges
