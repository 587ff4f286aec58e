#include "host_sim/accuracy/knobs/picture_knobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/accuracy/knobs/small_picture.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_picture_knobs {
namespace {

double worst_difference(const std::vector<glm::vec3>& light, const std::vector<glm::vec3>& other) {
    double worst = 0;
    for (std::size_t n = 0; n < light.size(); ++n) worst = std::max(worst, light_difference(light[n], other[n]));
    return worst;
}

raytrace::TraceSettings two_triangles() {
    raytrace::TraceSettings settings;
    settings.surface.kind = raytrace::SurfaceKind::two_triangles;
    return settings;
}

TEST(PictureKnobs, MoreRaysAreNearerToTheReference) {
    const test_support::MadeKnobGround made;
    const auto knob = make_antialias_rays_knob(made.quick());
    double last = 1;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level) {
        const double mean = test_support::errors_of(*knob, level).mean;
        EXPECT_LT(mean, last) << level;
        last = mean;
    }
    EXPECT_GT(test_support::errors_of(*knob, 0).mean, 1e-3) << "control: one ray is too few";
}

TEST(PictureKnobs, TheReferenceOfRaysIsWithinItsBound) {
    const test_support::ShippedKnobGround shipped;
    const double bound = make_antialias_rays_knob(shipped.quick())->facts().reference.error_bound();
    raytrace::TraceSettings settings = two_triangles();
    settings.antialiasing = raytrace::Antialiasing::supersampling;
    settings.rays_along = 2;
    const std::vector<glm::vec3> exact = light_of_finer(shipped.ground, settings, {12, 9}, 16),
                                 more = light_of_finer(shipped.ground, settings, {12, 9}, 24),
                                 few = light_of_finer(shipped.ground, two_triangles(), {12, 9}, 1);
    EXPECT_LT(worst_difference(exact, more), bound);
    EXPECT_GT(worst_difference(few, more), bound) << "control";
}

/// Over the shipped hills: the made ground is so open that hardly a path meets it again, and the mean error of rare events does
/// not fall with the paths.
TEST(PictureKnobs, MorePathsAreNearerToTheReference) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_light_paths_knob(shipped.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, -0.75, 0.3);
    EXPECT_GT(test_support::errors_of(*knob, 0).max, 10 * knob->facts().reference.error_bound())
        << "control: two paths are too few";
}

TEST(PictureKnobs, TheReferenceOfPathsIsWithinItsBound) {
    const test_support::ShippedKnobGround shipped;
    const double bound = make_light_paths_knob(shipped.quick())->facts().reference.error_bound();
    const auto light = [&](std::uint32_t paths) {
        raytrace::TraceSettings settings = two_triangles();
        settings.paths = paths;
        return light_of_finer(shipped.ground, settings, {6, 5}, 1);
    };
    const std::vector<glm::vec3> more = light(8192);
    EXPECT_LT(worst_difference(light(2048), more), bound);
    EXPECT_GT(worst_difference(light(2), more), bound) << "control: two paths are farther off";
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_knobs
