// Rays of cameras over hills, needles and steps: ours against the reference in long double and, where that agrees, Embree.
// bench_raytrace compares ten million (--reference 10).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/raytrace/embree_grid.hpp"
#include "tests/support/raytrace/trace_agreement.hpp"
#include "tests/support/raytrace/trace_cameras.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace::test_ray_agreement {
namespace {

using test_support::EmbreeGrid;
using test_support::HeightField;
using test_support::ReferenceTracer;
using test_support::TraceAgreement;
using test_support::TraceCamera;
using test_support::TracedGround;

constexpr std::uint32_t kWidth = 144, kHeight = 81;

TraceAgreement agreement_of(const TracedGround<std::int16_t>& ground, double steps, CellSurface surface, TraceAgreement* embree) {
    const ReferenceTracer<std::int16_t> reference(ground.field.grid(), surface);
    const EmbreeGrid other(ground.field.grid(), static_cast<float>(1 / steps), test_support::EmbreeMesh::grid, 1);
    TraceAgreement ours;
    for (const TraceCamera& camera : test_support::trace_cameras(ground.field.columns, kWidth, kHeight)) {
        const TraceCamera stepped = camera.in_steps(steps);
        const float eye[3] = {static_cast<float>(camera.eye.x), static_cast<float>(camera.eye.y),
                              static_cast<float>(camera.eye.z)};
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                const Ray ray = stepped.ray(x, y);
                const auto expected = reference.trace(ray);
                const Hit hit = ground.trace(ray, surface);
                ours.add(expected, hit.side == HitSide::above, hit.t);
                if (embree == nullptr) continue;
                const glm::vec3 direction = camera.ray(x, y).direction;
                const float t = other.trace(eye, {direction.x, direction.y, direction.z});
                embree->add(expected, t < INFINITY, t);
            }
        }
    }
    return ours;
}

void expect_agreement(TraceAgreement& found, const char* what) {
    SCOPED_TRACE(what);
    EXPECT_EQ(found.unexplained, 0U);
    EXPECT_EQ(found.misplaced, 0U);
    EXPECT_LE(found.quantile(0.999), 1e-6);
    EXPECT_GT(found.hits, found.rays / 4);
    EXPECT_LT(found.close, found.rays / 1000);
}

TEST(RayAgreement, HoldsOverHillsNeedlesAndSteps) {
    HeightField<std::int16_t> hills = test_support::fractal_heights(257);
    const double steps = test_support::steps_a_cell(257);
    HeightField<std::int16_t> needles = hills, terraces = hills;
    test_support::add_needles(needles);
    for (std::int16_t& post : terraces.posts) post = static_cast<std::int16_t>(post / 2048 * 2048);
    struct Case {
        const char* name;
        const HeightField<std::int16_t>& field;
    };
    for (const Case& one : {Case{"hills", hills}, Case{"needles", needles}, Case{"terraces", terraces}}) {
        const TracedGround<std::int16_t> ground(one.field);
        TraceAgreement embree;
        TraceAgreement ours = agreement_of(ground, steps, CellSurface::two_triangles, &embree);
        expect_agreement(ours, one.name);
        // The other tracer is not held to this; it is known to differ in a few rays of a million.
        EXPECT_LT(embree.different, embree.rays / 10000) << one.name;
        TraceAgreement bilinear = agreement_of(ground, steps, CellSurface::bilinear, nullptr);
        expect_agreement(bilinear, one.name);
    }
}

TEST(RayAgreement, IsLostWithTheBoundsOfABorder) {
    TracedGround<std::int16_t> ground(test_support::fractal_heights(257));
    ground.lose_border(3);
    const double steps = test_support::steps_a_cell(257);
    EXPECT_GT(agreement_of(ground, steps, CellSurface::two_triangles, nullptr).unexplained, 20U);
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_agreement
