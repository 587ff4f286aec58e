#include "render_core/draw/view_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw::test_view_frame {
namespace {

using base::radians;

ViewFrame view_of(double heading_deg, double pitch_deg, double roll_deg) {
    return make_view_frame(640, 480, radians(60), radians(heading_deg), radians(pitch_deg), radians(roll_deg));
}

TEST(ViewFrame, AxesAgreeWithTheEarthModule) {
    for (double heading : {0.0, 77.0, 250.0})
        for (double pitch : {-60.0, 0.0, 25.0, 90.0})
            for (double roll : {-170.0, 0.0, 45.0}) {
                const glm::dmat3 ecef = earth::body_axes(0.8, 0.2, radians(heading), radians(pitch), radians(roll));
                const glm::dmat3 expected = glm::transpose(earth::north_east_down(0.8, 0.2)) * ecef;
                const ViewFrame view = view_of(heading, pitch, roll);
                for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(view.body_axes[i], expected[i]), 1e-12);
            }
}

TEST(ViewFrame, IsTheTerrainsView) {
    terrain::View view;
    const double latitude = radians(-33), longitude = radians(151);
    view.eye = earth::to_ecef({latitude, longitude, {2500}});
    const glm::dmat3 body = earth::body_axes(latitude, longitude, radians(77), radians(-12), radians(30));
    view.forward = body[0];
    view.right = body[1];
    view.down = body[2];
    view.width = 640;
    view.height = 480;
    view.focal_px = 320 / std::tan(radians(30));
    const ViewFrame from_terrain = make_view_frame(view), expected = view_of(77, -12, 30);
    EXPECT_NEAR(from_terrain.focal_px, expected.focal_px, 1e-9);
    EXPECT_EQ(from_terrain.center_x, expected.center_x);
    EXPECT_EQ(from_terrain.center_y, expected.center_y);
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(from_terrain.body_axes[i], expected.body_axes[i]), 1e-9);
}

TEST(ViewFrame, TheFieldOfViewSpansTheWidth) {
    const ViewFrame view = view_of(0, 0, 0);
    EXPECT_NEAR(project(view, direction_of(radians(30), 0)).at.x, 640, 1e-3);
    EXPECT_NEAR(project(view, direction_of(radians(-30), 0)).at.x, 0, 1e-3);
    EXPECT_NEAR(project(view, direction_of(0, 0)).at.y, 240, 1e-4);
}

TEST(ViewFrame, ProjectsWhereTheRayGoes) {
    const ViewFrame view = view_of(123, -17, 33);
    for (double x : {0.0, 320.0, 611.5})
        for (double y : {0.5, 240.0, 479.0}) {
            const ProjectedPoint back = project(view, ray_of(view, x, y));
            EXPECT_TRUE(back.in_front);
            EXPECT_NEAR(back.at.x, x, 1e-3);
            EXPECT_NEAR(back.at.y, y, 1e-3);
        }
}

TEST(ViewFrame, RightBankRaisesTheRightHorizonOnScreen) {
    const ViewFrame view = view_of(0, 0, 20);  // right wing down: the right part of the screen looks below the horizon
    EXPECT_LT(project(view, direction_of(radians(10), 0)).at.y, project(view, direction_of(radians(-10), 0)).at.y);
    EXPECT_GT(ray_of(view, 600, 240).z, 0);
}

TEST(ViewFrame, NothingBehindTheEyeProjects) {
    const ViewFrame view = view_of(0, 0, 0);
    EXPECT_FALSE(project(view, direction_of(radians(180), 0)).in_front);
    EXPECT_FALSE(project(view, direction_of(radians(90), 0)).in_front);
    EXPECT_FALSE(project(view, {0, 0, 0}).in_front);
}

TEST(HorizonDip, AgreesWithTheTriangle) {
    EXPECT_EQ(horizon_dip_rad(0), 0);
    EXPECT_EQ(horizon_dip_rad(-5), 0);
    for (double height : {1.0, 100.0, 12'000.0, 400'000.0}) {
        const long double radius = 6'371'008.8L;
        const long double expected = std::acos(radius / (radius + static_cast<long double>(height)));
        EXPECT_NEAR(horizon_dip_rad(height), static_cast<double>(expected), 1e-11);
    }
    EXPECT_NEAR(base::degrees(horizon_dip_rad(10'000)), 3.2, 0.05);
}

}  // namespace
}  // namespace tedavis::draw::test_view_frame
