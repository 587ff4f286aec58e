#include "host_sim/accuracy/knobs/ray_search_knobs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/accuracy/statistics.hpp"
#include "render_core/raytrace/search/trace_surface.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_ray_search_knobs {
namespace {

struct Grounded {
    test_support::FlownFiles files;
    base::SerialWorkers workers;
    TracedGround ground{files.terrain, workers};
};

ErrorDistribution errors_of(Knob& knob, std::size_t level) {
    std::vector<double> all, errors;
    for (std::size_t sample = 0; sample < knob.samples(); ++sample) {
        errors.clear();
        knob.find_errors(level, sample, errors);
        all.insert(all.end(), errors.begin(), errors.end());
    }
    return distribution_of(all);
}

/// What the knobs state of their reference: within the bound the ray is on both sides of the surface.
TEST(RaySearchKnobs, TheReferenceIsWithinItsBound) {
    const Grounded g;
    const TracedSquare square(g.ground);
    const BoundedSurface surface(square, {});
    const double bound = make_ray_steps_knob({g.ground, true})->facts().reference.error_bound();
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
    const Grounded g;
    const auto knob = make_ray_steps_knob({g.ground, true});
    const std::size_t last = knob->facts().levels.size() - 1;
    const ErrorDistribution few = errors_of(*knob, 0), many = errors_of(*knob, last);
    EXPECT_GT(few.mean, 10 * many.mean);
    EXPECT_GT(few.max, 1) << "cells";
}

TEST(RaySearchKnobs, EachHalvingHalvesTheError) {
    const Grounded g;
    const auto knob = make_ray_halvings_knob({g.ground, true});
    std::vector<LawPoint> points;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level)
        points.push_back({knob->facts().levels[level].amount, errors_of(*knob, level).mean});
    const FittedLaw law = fit_law(points);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, -1, 0.05);
}

}  // namespace
}  // namespace tedavis::host_sim::test_ray_search_knobs
