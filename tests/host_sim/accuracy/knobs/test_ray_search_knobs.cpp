#include "host_sim/accuracy/knobs/ray_search_knobs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "render_core/raytrace/search/trace_surface.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_ray_search_knobs {
namespace {

/// What the knobs state of their reference: within the bound the ray is on both sides of the surface.
TEST(RaySearchKnobs, TheReferenceIsWithinItsBound) {
    const test_support::MadeKnobGround g;
    const TracedSquare square(g.ground);
    const BoundedSurface surface(square, {});
    const double bound = make_ray_steps_knob(g.quick())->facts().reference.error_bound();
    const auto gap = [&](const raytrace::Ray& ray, double t) {
        raytrace::SurfacePoint ground;
        if (!raytrace::find_surface(square.grid(), {}, ray.origin.x + t * ray.direction.x,
                                    ray.origin.y + t * double{ray.direction.y}, ground))
            return std::numeric_limits<double>::quiet_NaN();
        return ray.origin.z + t * double{ray.direction.z} - ground.height;
    };
    int hits = 0;
    for (const raytrace::Ray& ray : rays_over(square, 2000, 1)) {
        const raytrace::SurfaceHit hit = raytrace::trace_surface(surface.maxima(), surface.settings(), ray);
        if (hit.side == raytrace::HitSide::none) continue;
        ++hits;
        EXPECT_GT(gap(ray, hit.t - bound), 0) << ray_text(ray);
        EXPECT_LT(gap(ray, hit.t + bound), 0) << ray_text(ray);
    }
    EXPECT_GT(hits, 1000) << "control: most rays meet something";
}

TEST(RaySearchKnobs, FewStepsLandVisiblyWrong) {
    const test_support::MadeKnobGround g;
    const auto knob = make_ray_steps_knob(g.quick());
    const std::size_t last = knob->facts().levels.size() - 1;
    const ErrorDistribution few = test_support::errors_of(*knob, 0), many = test_support::errors_of(*knob, last);
    EXPECT_GT(few.mean, 10 * many.mean);
    EXPECT_GT(few.max, 1) << "cells";
}

TEST(RaySearchKnobs, EachHalvingHalvesTheError) {
    const test_support::MadeKnobGround g;
    const auto knob = make_ray_halvings_knob(g.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, -1, 0.05);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ray_search_knobs
