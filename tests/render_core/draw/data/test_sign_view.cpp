#include "render_core/draw/data/sign_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/display/free_view.hpp"

namespace tedavis::draw::test_sign_view {
namespace {

SignView looking_along_x(double half_width_deg) {
    const glm::dmat3 axes(glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
    SignView view{test_support::free_view({7e6, 0, 0}, axes, 800, 600, 1)};
    view.view.focal_px = 400 / std::tan(base::radians(half_width_deg));
    return view;
}

TEST(SignView, PlacesLieWhereTheirTangentsSay) {
    const SignView view = looking_along_x(45);
    const SignSpot spot = view.spot({7e6 + 1000, 250, -100});
    ASSERT_TRUE(spot.is_ahead);
    EXPECT_NEAR(spot.at.x, 400 + 100, 1e-3);
    EXPECT_NEAR(spot.at.y, 300 - 40, 1e-3);
    EXPECT_DOUBLE_EQ(spot.distance_m, 1000);
    EXPECT_FALSE(view.spot({7e6 - 1000, 0, 0}).is_ahead);
    EXPECT_FALSE(view.spot({7e6 + 2, 1000, 0}).is_ahead) << "so far aside that floats do not hold it";
}

TEST(SignView, NarrowViewsBringThingsNearer) {
    EXPECT_NEAR(looking_along_x(30).seen_distance_m(5000), 5000, 1e-9);
    EXPECT_NEAR(looking_along_x(50).seen_distance_m(5000), 5000, 1e-9) << "wide ones do not move them away";
    EXPECT_NEAR(looking_along_x(10).seen_distance_m(5000), 5000 * std::tan(base::radians(10)) / std::tan(base::radians(30)),
                1e-9);
}

}  // namespace
}  // namespace tedavis::draw::test_sign_view
