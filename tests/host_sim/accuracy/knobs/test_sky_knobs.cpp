#include "host_sim/accuracy/knobs/sky_knobs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/raytrace/shading/sky_map.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_sky_knobs {
namespace {

TEST(SkyKnobs, ErrorsFallWithTheAzimuths) {
    const test_support::MadeKnobGround made;
    const auto knob = make_sky_azimuths_knob(made.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_LT(law.exponent, -1);
    EXPECT_GT(test_support::errors_of(*knob, 0).mean, 3e-4) << "control: four azimuths are too few";
}

TEST(SkyKnobs, ErrorsFallWithTheRadiusToNothingAtTheBorder) {
    const test_support::MadeKnobGround made;
    const auto knob = make_sky_radius_knob(made.quick());
    double last = 1;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level) {
        const double mean = test_support::errors_of(*knob, level).mean;
        EXPECT_LE(mean, last) << level;
        last = mean;
    }
    EXPECT_GT(test_support::errors_of(*knob, 0).mean, 1e-3) << "control: eight posts are too few";
}

/// Against four times as many azimuths, at random posts.
TEST(SkyKnobs, TheReferenceOfAzimuthsIsWithinItsBound) {
    const test_support::ShippedKnobGround shipped;
    const TracedSquare square(shipped.ground);
    const double bound = make_sky_azimuths_knob(shipped.quick())->facts().reference.error_bound();
    raytrace::SkyMapSettings many, more, few;
    many.scale = more.scale = few.scale = square.scale();
    many.azimuths = 2048;
    more.azimuths = 8192;
    few.azimuths = 32;
    SeededRandom numbers(5);
    double worst = 0, worst_of_few = 0;
    for (int n = 0; n < 40; ++n) {
        const auto column = static_cast<std::uint32_t>(numbers.between(square.grid().columns / 4.0, square.grid().columns / 2.0));
        const auto row = static_cast<std::uint32_t>(numbers.between(square.grid().rows / 4.0, square.grid().rows / 2.0));
        const auto view = [&](const auto& settings) { return raytrace::sky_seen_at(square.grid(), settings, column, row).view; };
        worst = std::max(worst, std::abs(view(many) - view(more)));
        worst_of_few = std::max(worst_of_few, std::abs(view(few) - view(more)));
    }
    EXPECT_LT(worst, bound);
    EXPECT_GT(worst_of_few, bound) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_sky_knobs
